#include "exact/wide_integer.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <limits>

namespace rasterproof::exact {
namespace {

__extension__ using Uint128 = unsigned __int128;

}  // namespace

Decoded::Decoded(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  constexpr std::uint64_t kFraction = (std::uint64_t{1} << 52) - 1;
  const int field = static_cast<int>((bits >> 52) & 0x7ff);
  negative = (bits >> 63) != 0;
  mantissa = (bits & kFraction) | (field != 0 ? kFraction + 1 : 0);
  if (mantissa == 0) return;
  // The least subnormal, field 0, is 2^-1074; field 1 has the same unit.
  const int zeros = std::countr_zero(mantissa);
  mantissa >>= zeros;
  exponent = std::max(field, 1) - 1075 + zeros;
}

int CommonUnit(const std::array<double, 3>& values) {
  int unit = std::numeric_limits<int>::max();
  for (const double value : values) {
    const Decoded d(value);
    if (d.mantissa != 0) unit = std::min(unit, d.exponent);
  }
  return unit == std::numeric_limits<int>::max() ? 0 : unit;
}

WideInteger::WideInteger(double x, int unit) {
  const Decoded d(x);
  if (d.mantissa == 0) return;
  const auto shift = static_cast<unsigned>(d.exponent - unit);
  const unsigned whole = shift / 64;
  const unsigned part = shift % 64;
  std::fill_n(limb_.begin(), whole, std::uint64_t{0});
  limb_[whole] = d.mantissa << part;
  size_ = static_cast<int>(whole) + 1;
  if (part > 11) {  // a mantissa has 53 bits
    limb_[whole + 1] = d.mantissa >> (64 - part);
    ++size_;
    Trim();
  }
  negative_ = d.negative;
}

int WideInteger::CompareMagnitudes(const WideInteger& a, const WideInteger& b) {
  if (a.size_ != b.size_) return a.size_ < b.size_ ? -1 : 1;
  for (int k = a.size_ - 1; k >= 0; --k) {
    const auto i = static_cast<unsigned>(k);
    if (a.limb_[i] != b.limb_[i]) return a.limb_[i] < b.limb_[i] ? -1 : 1;
  }
  return 0;
}

int Compare(const WideInteger& a, const WideInteger& b) {
  if (a.Sign() != b.Sign()) return a.Sign() < b.Sign() ? -1 : 1;
  return a.Sign() * WideInteger::CompareMagnitudes(a, b);
}

// a + b, or a - b: only the sign that b counts with differs.
WideInteger WideInteger::AddSigned(const WideInteger& a, const WideInteger& b, bool b_negative) {
  WideInteger sum;
  const bool a_larger = CompareMagnitudes(a, b) >= 0;
  const WideInteger& large = a_larger ? a : b;
  const WideInteger& small = a_larger ? b : a;
  const bool subtract = a.negative_ != b_negative;
  sum.negative_ = a_larger ? a.negative_ : b_negative;
  std::uint64_t carry = 0;
  for (int k = 0; k < large.size_; ++k) {
    const auto i = static_cast<unsigned>(k);
    const Uint128 addend = Uint128{k < small.size_ ? small.limb_[i] : 0} + carry;
    const Uint128 value = subtract ? large.limb_[i] - addend : large.limb_[i] + addend;
    sum.limb_[i] = static_cast<std::uint64_t>(value);
    carry = (value >> 64) != 0 ? 1 : 0;  // a borrow shows as all ones
  }
  sum.size_ = large.size_;
  if (!subtract && carry != 0) sum.limb_[static_cast<unsigned>(sum.size_++)] = 1;
  sum.Trim();
  return sum;
}

WideInteger operator+(const WideInteger& a, const WideInteger& b) {
  return WideInteger::AddSigned(a, b, b.negative_);
}

WideInteger operator-(const WideInteger& a, const WideInteger& b) {
  return WideInteger::AddSigned(a, b, !b.negative_);
}

WideInteger operator*(const WideInteger& a, const WideInteger& b) {
  WideInteger product;
  if (a.size_ == 0 || b.size_ == 0) return product;
  product.size_ = a.size_ + b.size_;
  std::fill_n(product.limb_.begin(), product.size_, std::uint64_t{0});
  for (int i = 0; i < a.size_; ++i) {
    const std::uint64_t factor = a.limb_[static_cast<unsigned>(i)];
    if (factor == 0) continue;  // far apart exponents leave long runs of zero limbs
    std::uint64_t carry = 0;
    for (int j = 0; j < b.size_; ++j) {
      std::uint64_t& limb = product.limb_[static_cast<unsigned>(i + j)];
      const Uint128 value = Uint128{factor} * b.limb_[static_cast<unsigned>(j)] + limb + carry;
      limb = static_cast<std::uint64_t>(value);
      carry = static_cast<std::uint64_t>(value >> 64);
    }
    product.limb_[static_cast<unsigned>(i + b.size_)] = carry;
  }
  product.negative_ = a.negative_ != b.negative_;
  product.Trim();
  return product;
}

}  // namespace rasterproof::exact
