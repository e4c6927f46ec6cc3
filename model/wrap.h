// Wrapping: the stage that takes a coordinate into the range of a fixed-point input.
#ifndef RASTERPROOF_MODEL_WRAP_H_
#define RASTERPROOF_MODEL_WRAP_H_

#include "core/fixed_input.h"

namespace rasterproof {

/// Returns the coordinate that a rasterizer of this input computes with: x modulo 2^n, in range. x
/// itself where the format does not wrap. Exact.
///
/// Domain:     FixedInput::IsGiven(x); infinity and NaN come back unchanged.
double Wrapped(double x, const FixedInput& fixed);

}  // namespace rasterproof

#endif  // RASTERPROOF_MODEL_WRAP_H_
