#include "library/exact_sum.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/own_precision.h"
#include "library/decode.h"

namespace rasterproof::library {
namespace {

__extension__ using Uint128 = unsigned __int128;

constexpr int kUnitExponent = -2148;  // twice the exponent of the smallest subnormal

bool Bit(std::span<const std::uint64_t> words, int n) {
  return n >= 0 && ((words[static_cast<std::size_t>(n) / 64] >> (n % 64)) & 1) != 0;
}

/// Whether any bit below n is set.
bool AnyBelow(std::span<const std::uint64_t> words, int n) {
  const std::size_t whole = static_cast<std::size_t>(n) / 64;
  const bool low = std::ranges::any_of(words.first(whole), [](std::uint64_t w) { return w != 0; });
  const std::uint64_t mask = (std::uint64_t{1} << (n % 64)) - 1;
  return low || (words[whole] & mask) != 0;
}

/// The magnitude rounded to nearest, ties to even.
double RoundToDouble(std::span<const std::uint64_t> words) {
  std::size_t top_word = words.size();
  while (top_word > 0 && words[top_word - 1] == 0) --top_word;
  if (top_word == 0) return 0;
  const int top = static_cast<int>(top_word) * 64 - 1 - std::countl_zero(words[top_word - 1]);
  // Keep 53 bits, but none below 2^-1074: there doubles have fewer.
  const int cut = std::max(top - 52, -1074 - kUnitExponent);
  std::uint64_t kept = 0;
  for (int n = top; n >= cut; --n) kept = kept * 2 + (Bit(words, n) ? 1 : 0);
  const bool half = Bit(words, cut - 1);
  if (half && ((kept & 1) != 0 || AnyBelow(words, cut - 1))) ++kept;
  return std::ldexp(static_cast<double>(kept), cut + kUnitExponent);
}

}  // namespace

void ExactSum::AddSigned(double x, double y, bool negate) {
  const Decoded a = Decode(x);
  const Decoded b = Decode(y);
  const Uint128 product = Uint128{a.significand} * b.significand;
  if (product == 0) return;
  const int shift = a.exponent + b.exponent - kUnitExponent;
  const int offset = shift % 64;
  const std::array<std::uint64_t, 3> parts{
      static_cast<std::uint64_t>(product << offset),
      static_cast<std::uint64_t>((product << offset) >> 64),
      offset == 0 ? 0 : static_cast<std::uint64_t>(product >> 64 >> (64 - offset))};
  Words& sum = (std::signbit(x) != std::signbit(y)) != negate ? negative_ : positive_;
  std::uint64_t carry = 0;
  std::size_t word = static_cast<std::size_t>(shift) / 64;
  for (const std::uint64_t part : parts) {
    const Uint128 next = Uint128{sum[word]} + part + carry;
    sum[word++] = static_cast<std::uint64_t>(next);
    carry = static_cast<std::uint64_t>(next >> 64);
  }
  for (; carry != 0; ++word) carry = ++sum[word] == 0 ? 1 : 0;
}

int ExactSum::Compare(const Words& a, const Words& b) {
  for (std::size_t n = kWords; n-- > 0;) {
    if (a[n] != b[n]) return a[n] < b[n] ? -1 : 1;
  }
  return 0;
}

int ExactSum::Sign() const { return Compare(positive_, negative_); }

double ExactSum::ToDouble() const {
  const int sign = Sign();
  const Words& larger = sign < 0 ? negative_ : positive_;
  const Words& smaller = sign < 0 ? positive_ : negative_;
  Words difference;
  std::uint64_t borrow = 0;
  for (std::size_t n = 0; n < kWords; ++n) {
    const Uint128 next = Uint128{larger[n]} - smaller[n] - borrow;
    difference[n] = static_cast<std::uint64_t>(next);
    borrow = static_cast<std::uint64_t>(next >> 64) != 0 ? 1 : 0;
  }
  return sign * RoundToDouble(difference);
}

}  // namespace rasterproof::library
