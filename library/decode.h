// A double as an integer times a power of two.
#ifndef RASTERPROOF_LIBRARY_DECODE_H_
#define RASTERPROOF_LIBRARY_DECODE_H_

#include <bit>
#include <cstdint>

namespace rasterproof::library {

/// |x| = significand 2^exponent.
struct Decoded {
  std::uint64_t significand;  ///< below 2^53
  int exponent;               ///< -1074 to 971
};

/// Domain:     finite x.
inline Decoded Decode(double x) {
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const int biased = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & ((std::uint64_t{1} << 52) - 1);
  if (biased == 0) return {fraction, -1074};
  return {fraction | (std::uint64_t{1} << 52), biased - 1075};
}

}  // namespace rasterproof::library

#endif  // RASTERPROOF_LIBRARY_DECODE_H_
