// Numbers of triangles as a rasterizer with few bits keeps them.
#ifndef RASTERPROOF_SUBJECTS_MUTANTS_LIST_NUMBERS_H_
#define RASTERPROOF_SUBJECTS_MUTANTS_LIST_NUMBERS_H_

#include <bit>
#include <cstddef>

namespace rasterproof::subjects::mutants {

/// The low bits of a number.
///
/// Domain:     1 to 63 bits.
inline std::size_t CutTo(std::size_t number, int bits) {
  return number & ((std::size_t{1} << bits) - 1);
}

/// The number in a float of so many significant bits, rounded to nearest, ties to even: 24 bits
/// are float32.
///
/// Domain:     1 to 63 bits; numbers below 2^63.
inline std::size_t InAFloat(std::size_t number, int bits) {
  const int over = static_cast<int>(std::bit_width(number)) - bits;
  if (over <= 0) return number;
  const std::size_t unit = std::size_t{1} << over;
  const std::size_t below = number / unit;
  const std::size_t rest = number % unit;
  const bool goes_up = rest > unit / 2 || (rest == unit / 2 && below % 2 == 1);
  return (below + (goes_up ? 1 : 0)) * unit;
}

}  // namespace rasterproof::subjects::mutants

#endif  // RASTERPROOF_SUBJECTS_MUTANTS_LIST_NUMBERS_H_
