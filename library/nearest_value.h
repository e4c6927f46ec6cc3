// The interpolated value that is nearest, exactly: the last tier of the library's values.
#ifndef RASTERPROOF_LIBRARY_NEAREST_VALUE_H_
#define RASTERPROOF_LIBRARY_NEAREST_VALUE_H_

#include <array>

namespace rasterproof::library {

/// sum beta_i c_i / sum beta_i e_i of exact/values.h, by corners (x, y, w).
struct ValueQuotient {
  std::array<double, 3> x, y, w;
  std::array<double, 3> c, e;
};

/// The nearest float32 at the centre (x, y), ties to even, by sums that lose nothing.
///
/// Domain:     x, y, w and e float32 numbers, c a product of two; a denominator that is not 0.
/// Returns:    +0 for 0; beyond float32's largest number that one.
/// Cost:       100 operations in double; for few that these do not tell some microseconds.
float NearestValue(const ValueQuotient& q, double x, double y);

}  // namespace rasterproof::library

#endif  // RASTERPROOF_LIBRARY_NEAREST_VALUE_H_
