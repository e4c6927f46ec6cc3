// Whether a floating-point mode could change what a scene covers.
#ifndef RASTERPROOF_PROPS_COMPARE_CAN_TOUCH_H_
#define RASTERPROOF_PROPS_COMPARE_CAN_TOUCH_H_

#include "core/float_mode.h"
#include "core/scene.h"

namespace rasterproof::props {

/// Returns true if the processor has the mode and the mode could change a draw by a subject that
/// computes in `input`'s precision. A directed rounding and traps always could.
///
/// A mode that flushes subnormal numbers could in clip space, and if a coordinate is not finite.
/// Else it could only where an edge value, the reciprocal of an area or the product of the two may
/// be subnormal. Let s be the smallest coordinate that is not 0 (at most 2^-8, for samples are
/// points too), L the largest (at least the target's size), and p the bits of a significand.
/// Differences are multiples of 2^(1-p) s, so that products are 0 or at least 2^(2-2p) s^2, edge
/// values 0 or at least 2^(3-3p) s^2, and areas at most 8 L^2.
bool CanTouch(FloatMode mode, const Scene& scene, Precision input);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_COMPARE_CAN_TOUCH_H_
