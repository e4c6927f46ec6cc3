// The integer decider: every finite double is an integer number of 2^-1074, every value of the
// float32 range one of 2^-149. Doubles are taken apart bit by bit: no floating-point instruction
// runs, so no rounding mode, flush to zero or contraction can touch the answer.
#include <algorithm>
#include <array>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cstdint>
#include <initializer_list>

#include "core/vertex.h"
#include "exact/deciders.h"

namespace rasterproof::exact {
namespace {

namespace mp = boost::multiprecision;

// Checked: an overflow of these widths would throw std::overflow_error, not wrap.
template <unsigned kBits>
using Checked =
    mp::number<mp::cpp_int_backend<kBits, kBits, mp::signed_magnitude, mp::checked, void>,
               mp::et_off>;

// float32 range, unit 2^-149: coordinates below 2^128, hence 277 bits; differences 278, products
// 556, E 557. float64, unit 2^-1074: coordinates 2098 bits, differences 2099, products 4198, E
// 4199.
using NarrowEdge = Checked<640>;
using WideEdge = Checked<4352>;
// 3x3 determinants, a sum of six products of three coordinates: 3 * 277 + 3 = 834 and
// 3 * 2098 + 3 = 6297 bits.
using NarrowDeterminant = Checked<1024>;
using WideDeterminant = Checked<8192>;

constexpr int kNarrowUnit = -149;
constexpr int kNarrowTop = 128;
constexpr int kWideUnit = -1074;

struct Bits {
  bool negative;
  std::uint64_t mantissa;
  int exponent;  // of the mantissa's last bit
};

Bits TakeApart(double x) {
  const auto bits = std::bit_cast<std::uint64_t>(x);
  const auto field = static_cast<int>((bits >> 52) & 0x7ff);
  const std::uint64_t fraction = bits & 0xfffffffffffff;
  const bool negative = (bits >> 63) != 0;
  if (field == 0) return {negative, fraction, -1074};
  return {negative, fraction | 0x10000000000000, field - 1075};
}

// Whether x is a multiple of 2^-149 below 2^128 in magnitude (it need not be a float32).
bool IsNarrow(double x) {
  const Bits b = TakeApart(x);
  if (b.mantissa == 0) return true;
  return b.exponent + std::countr_zero(b.mantissa) >= kNarrowUnit &&
         b.exponent + static_cast<int>(std::bit_width(b.mantissa)) <= kNarrowTop;
}

template <class Integer>
Integer InUnits(double x, int unit) {
  const Bits b = TakeApart(x);
  Integer value = b.mantissa;
  if (b.exponent >= unit) {
    value <<= static_cast<unsigned>(b.exponent - unit);
  } else if (b.mantissa != 0) {
    value >>= static_cast<unsigned>(unit - b.exponent);  // IsNarrow: the bits shifted out are zero
  }
  return b.negative ? Integer(-value) : value;
}

template <class Integer>
int EdgeSignInUnits(Point2 a, Point2 b, Point2 p, int unit) {
  const auto ax = InUnits<Integer>(a.x, unit);
  const auto ay = InUnits<Integer>(a.y, unit);
  const Integer e = (InUnits<Integer>(p.x, unit) - ax) * (InUnits<Integer>(b.y, unit) - ay) -
                    (InUnits<Integer>(p.y, unit) - ay) * (InUnits<Integer>(b.x, unit) - ax);
  return e.sign();
}

template <class Integer>
int DeterminantSignInUnits(const Rows3& rows, int unit) {
  std::array<std::array<Integer, 3>, 3> m;
  for (unsigned i = 0; i < 3; ++i) {
    for (unsigned k = 0; k < 3; ++k) m[i][k] = InUnits<Integer>(rows[i][k], unit);
  }
  // Sarrus.
  const Integer plus =
      m[0][0] * m[1][1] * m[2][2] + m[0][1] * m[1][2] * m[2][0] + m[0][2] * m[1][0] * m[2][1];
  const Integer minus =
      m[0][2] * m[1][1] * m[2][0] + m[0][0] * m[1][2] * m[2][1] + m[0][1] * m[1][0] * m[2][2];
  return plus.compare(minus) > 0 ? 1 : (plus.compare(minus) < 0 ? -1 : 0);
}

}  // namespace

int IntegerEdgeSign(Point2 a, Point2 b, Point2 p) {
  const bool narrow =
      std::ranges::all_of(std::initializer_list<double>{a.x, a.y, b.x, b.y, p.x, p.y}, IsNarrow);
  return narrow ? EdgeSignInUnits<NarrowEdge>(a, b, p, kNarrowUnit)
                : EdgeSignInUnits<WideEdge>(a, b, p, kWideUnit);
}

int IntegerDeterminantSign(const Rows3& rows) {
  const bool narrow = std::ranges::all_of(
      rows, [](const std::array<double, 3>& row) { return std::ranges::all_of(row, IsNarrow); });
  return narrow ? DeterminantSignInUnits<NarrowDeterminant>(rows, kNarrowUnit)
                : DeterminantSignInUnits<WideDeterminant>(rows, kWideUnit);
}

}  // namespace rasterproof::exact
