// Unit roundoff, neighbours and bit patterns.
#ifndef RASTERPROOF_CORE_ULP_H_
#define RASTERPROOF_CORE_ULP_H_

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>

namespace rasterproof {

/// The unit roundoff u = 2^-p of T: half the distance from 1 to its upper neighbour.
template <class T>
constexpr T rounding_epsilon() {
  return static_cast<T>(std::numeric_limits<T>::epsilon() / 2);
}

/// An unsigned integer as wide as T.
template <class T>
using BitsOf = std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>;

/// Returns x moved by n steps along the ordered floats of T (0 counts once: -0 and +0 are one
/// place).
///
/// Domain:     finite x. Saturates at the largest finite value.
template <class T>
T MoveByUlps(T x, std::int64_t n) {
  using S = std::make_signed_t<BitsOf<T>>;
  constexpr S kLargest = std::bit_cast<S>(std::numeric_limits<T>::max());
  const S bits = std::bit_cast<S>(std::fabs(x));
  std::int64_t place = std::signbit(x) ? -std::int64_t{bits} : std::int64_t{bits};
  if (n > 0 && place > kLargest - n) {
    place = kLargest;
  } else if (n < 0 && place < -kLargest - n) {
    place = -kLargest;
  } else {
    place += n;
  }
  const T magnitude = std::bit_cast<T>(static_cast<S>(place < 0 ? -place : place));
  return place < 0 ? -magnitude : magnitude;
}

/// Returns whether x is a float32 value (NaN and infinities are).
inline bool IsFloat32(double x) {
  return std::isnan(x) || static_cast<double>(static_cast<float>(x)) == x;
}

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_ULP_H_
