#include "library/triple_sum.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "library/decode.h"

namespace rasterproof::library {
namespace {

__extension__ using Uint128 = unsigned __int128;

constexpr int kTripleUnitExponent = -3222;  // three times the exponent of the smallest subnormal
constexpr std::uint64_t kLimbMask = 0xffffffff;

/// The limbs of a * b * c, each factor below 2^53.
std::array<std::uint64_t, 5> LimbsOfProduct(std::uint64_t a, std::uint64_t b, std::uint64_t c) {
  const Uint128 ab = Uint128{a} * b;
  const Uint128 low = Uint128{static_cast<std::uint64_t>(ab)} * c;
  const Uint128 high = (ab >> 64) * c + (low >> 64);
  const auto word = [](Uint128 x, int shift) {
    return static_cast<std::uint64_t>(x >> shift) & kLimbMask;
  };
  return {word(low, 0), word(low, 32), word(high, 0), word(high, 32), word(high, 64)};
}

}  // namespace

void TripleSum::Add(double x, double y, double z) {
  const Decoded a = Decode(x);
  const Decoded b = Decode(y);
  const Decoded c = Decode(z);
  const bool negative = std::signbit(x) != (std::signbit(y) != std::signbit(z));
  const int shift = a.exponent + b.exponent + c.exponent - kTripleUnitExponent;
  std::size_t limb = static_cast<std::size_t>(shift) / 32;
  std::uint64_t carried = 0;  // the bits that the shift pushes into the next limb
  for (const std::uint64_t part : LimbsOfProduct(a.significand, b.significand, c.significand)) {
    const std::uint64_t shifted = (part << (shift % 32)) | carried;
    carried = shifted >> 32;
    const auto digit = static_cast<std::int64_t>(shifted & kLimbMask);
    limbs_[limb++] += negative ? -digit : digit;
  }
  limbs_[limb] +=
      negative ? -static_cast<std::int64_t>(carried) : static_cast<std::int64_t>(carried);
}

int TripleSum::Sign() const {
  // Move the carries up: then every limb but the last is in [0, 2^32) and the last has the sign.
  std::int64_t carry = 0;
  bool any = false;
  for (const std::int64_t limb : limbs_) {
    const std::int64_t sum = limb + carry;
    any = any || (sum & static_cast<std::int64_t>(kLimbMask)) != 0;
    carry = sum >> 32;  // floor
  }
  if (carry < 0) return -1;
  return any || carry > 0 ? 1 : 0;
}

}  // namespace rasterproof::library
