// What was measured of the methods of value_methods.h.
#ifndef RASTERPROOF_REFERENCE_VALUE_FIGURES_H_
#define RASTERPROOF_REFERENCE_VALUE_FIGURES_H_

#include <array>
#include <string_view>

namespace rasterproof::reference {

/// The largest error / bound known of a method, in float32 and float64, rounded down to 0.001;
/// NaN where none is.
/// Measured:   ValueWitnesses.AreTheFiguresOfTheirMethods, on the inputs of value_witnesses.cc.
std::array<double, 2> LargestRatiosOf(std::string_view method);

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_VALUE_FIGURES_H_
