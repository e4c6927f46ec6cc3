// Whether a floating-point mode could change what a scene covers.
#ifndef RASTERPROOF_PROPS_JUDGING_SUBNORMALS_H_
#define RASTERPROOF_PROPS_JUDGING_SUBNORMALS_H_

#include "core/float_mode.h"
#include "core/scene.h"

namespace rasterproof::props {

/// True if the processor has the mode and the mode could change a draw. Modes that flush subnormal
/// numbers could only where a coordinate is so small that a product of two differences may
/// underflow in the subject's precision: below 2^-40 in float32, whose differences are then
/// multiples of 2^-63 or more and whose products of 2^-126; below 2^-459 in float64.
bool CanTouch(FloatMode mode, const Scene& scene, Precision input);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_SUBNORMALS_H_
