// What was measured of the methods of value_methods.h.
#ifndef RASTERPROOF_REFERENCE_VALUE_FIGURES_H_
#define RASTERPROOF_REFERENCE_VALUE_FIGURES_H_

#include <array>
#include <string_view>

namespace rasterproof::reference {

/// The largest error / bound known of a method, in float32 and float64; NaN where none is.
/// Measured:   ValueMethods.NoSearchExceedsTheirBounds, 2026-11-28, as value_methods.h says.
std::array<double, 2> LargestRatiosOf(std::string_view method);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_VALUE_FIGURES_H_
