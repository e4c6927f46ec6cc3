// Rational numbers over Boost's arbitrary-precision integers, and their correct rounding.
#include <algorithm>
#include <bit>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>

#include "exact/rational.h"

namespace rasterproof::exact {
namespace fractions {

namespace mp = boost::multiprecision;

// Most numerators and denominators fit 512 bits: those are held without an allocation.
using Integer = mp::number<mp::cpp_int_backend<512, 0>, mp::et_off>;

// n 2^e / d: powers of two, all that differences and products of doubles are divided by, cost
// shifts and no gcd. d is odd and positive, and 1 for zero.
struct Fraction {
  Integer n = 0;
  Integer d = 1;
  int e = 0;

  void Reduce() {
    if (n.is_zero()) *this = {};
    if (d == 1) return;
    const Integer common = gcd(n, d);
    n /= common;
    d /= common;
  }
};

}  // namespace fractions

namespace {

using fractions::Fraction;
using fractions::Integer;

// A denominator of more bits than this is reduced; shorter ones cost less than a gcd.
constexpr unsigned kMostUnreducedBits = 512;

unsigned BitsOf(const Integer& x) { return x.is_zero() ? 0 : static_cast<unsigned>(msb(x)) + 1; }

void Settle(Fraction& x) {
  if (x.n.is_zero() || BitsOf(x.d) > kMostUnreducedBits) x.Reduce();
}

Integer Shifted(const Integer& n, int by) { return by == 0 ? n : n << static_cast<unsigned>(by); }

Integer Times(const Integer& n, const Integer& d) { return d == 1 ? n : n * d; }

// Numerators of a and b over d_a d_b 2^-e, with the smaller exponent e.
struct Aligned {
  Integer a;
  Integer b;
  int e = 0;
  bool share_denominator = false;  // which is then not multiplied
};

Aligned Align(const Fraction& a, const Fraction& b) {
  if (a.n.is_zero() || b.n.is_zero()) {
    return {a.n, b.n, a.n.is_zero() ? b.e : a.e, false};
  }
  Aligned aligned{.a = {}, .b = {}, .e = std::min(a.e, b.e), .share_denominator = a.d == b.d};
  aligned.a = Shifted(a.n, a.e - aligned.e);
  aligned.b = Shifted(b.n, b.e - aligned.e);
  if (aligned.share_denominator) return aligned;
  aligned.a = Times(aligned.a, b.d);
  aligned.b = Times(aligned.b, a.d);
  return aligned;
}

void Add(Fraction& a, const Fraction& b, bool subtract) {
  const Aligned aligned = Align(a, b);
  a.n = subtract ? Integer(aligned.a - aligned.b) : Integer(aligned.a + aligned.b);
  if (!aligned.share_denominator) a.d = Times(a.d, b.d);
  a.e = aligned.e;
  Settle(a);
}

void Multiply(Fraction& a, const Fraction& b) {
  a.n *= b.n;
  a.d = Times(a.d, b.d);
  a.e += b.e;
  Settle(a);
}

void Divide(Fraction& a, const Fraction& b) {
  if (b.n.is_zero()) throw std::overflow_error("division by zero");
  const auto zeros = static_cast<int>(lsb(Integer(abs(b.n))));
  const Integer odd = abs(b.n) >> static_cast<unsigned>(zeros);
  const bool negative = b.n < 0;
  const int exponent = b.e + zeros;
  a.n = Times(a.n, b.d);
  if (negative) a.n = -a.n;
  a.d = Times(odd, a.d);
  a.e -= exponent;
  Settle(a);
}

Fraction FromDouble(double x) {
  if (!std::isfinite(x)) throw std::domain_error("a rational must be finite");
  if (x == 0) return {};
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));  // exact: 53 bits
  const int zeros = std::countr_zero(static_cast<std::uint64_t>(mantissa));
  return {.n = mantissa / (std::int64_t{1} << zeros), .d = 1, .e = exponent - 53 + zeros};
}

enum class Rounding : std::uint8_t { kNearestEven, kDown, kUp };

// n / d > 0 rounded to T. The quotient is cut at the place of T's last bit, so that subnormals are
// rounded once; the remainder says which way to round.
template <class T>
T RoundMagnitude(Integer n, Integer d, Rounding rounding) {
  using Limits = std::numeric_limits<T>;
  // floor(log2(n / d)) is log or log - 1.
  int log = static_cast<int>(msb(n)) - static_cast<int>(msb(d));
  if (log >= 0 ? n < (d << static_cast<unsigned>(log)) : (n << static_cast<unsigned>(-log)) < d)
    --log;
  const int least_unit = Limits::min_exponent - Limits::digits;  // of subnormals
  const int unit = std::max(log + 1 - Limits::digits, least_unit);
  if (log >= Limits::max_exponent) {
    return rounding == Rounding::kDown ? Limits::max() : Limits::infinity();
  }
  (unit >= 0 ? d : n) <<= static_cast<unsigned>(std::abs(unit));
  Integer quotient;
  Integer remainder;
  divide_qr(n, d, quotient, remainder);
  const int half = Integer(remainder * 2).compare(d);
  const bool odd = bit_test(quotient, 0);
  const bool up = rounding == Rounding::kUp
                      ? !remainder.is_zero()
                      : rounding == Rounding::kNearestEven && (half > 0 || (half == 0 && odd));
  if (up) ++quotient;
  // At most 2^digits: exact; ldexp overflows to infinity as nearest and up demand.
  return std::ldexp(static_cast<T>(quotient.convert_to<std::uint64_t>()), unit);
}

template <class T>
T Round(const Fraction& value, Rounding rounding) {
  if (value.n.is_zero()) return 0;
  const bool negative = value.n < 0;
  if (negative && rounding == Rounding::kUp) rounding = Rounding::kDown;
  const T magnitude = RoundMagnitude<T>(Shifted(abs(value.n), std::max(value.e, 0)),
                                        Shifted(value.d, std::max(-value.e, 0)), rounding);
  return negative ? -magnitude : magnitude;
}

}  // namespace

struct Rational::Storage {
  Fraction value;
};

Rational::Rational() : storage_(std::make_unique<Storage>()) {}
Rational::Rational(double value)
    : storage_(std::make_unique<Storage>(Storage{FromDouble(value)})) {}
Rational::Rational(const Rational& other) : storage_(std::make_unique<Storage>(*other.storage_)) {}
Rational::Rational(Rational&& other) noexcept = default;
Rational& Rational::operator=(const Rational& other) {
  storage_ = std::make_unique<Storage>(*other.storage_);
  return *this;
}
Rational& Rational::operator=(Rational&& other) noexcept = default;
Rational::~Rational() = default;

Rational Rational::operator-() const {
  Rational negated(*this);
  negated.storage_->value.n = -negated.storage_->value.n;
  return negated;
}
Rational& Rational::operator+=(const Rational& other) {
  Add(storage_->value, other.storage_->value, /*subtract=*/false);
  return *this;
}
Rational& Rational::operator-=(const Rational& other) {
  Add(storage_->value, other.storage_->value, /*subtract=*/true);
  return *this;
}
Rational& Rational::operator*=(const Rational& other) {
  Multiply(storage_->value, other.storage_->value);
  return *this;
}
Rational& Rational::operator/=(const Rational& other) {
  Divide(storage_->value, other.storage_->value);
  return *this;
}

int Rational::Sign() const { return storage_->value.n.sign(); }
Rational Rational::Abs() const { return Sign() < 0 ? -*this : *this; }
int Rational::Compare(const Rational& a, const Rational& b) {
  const Fraction& x = a.storage_->value;
  const Fraction& y = b.storage_->value;
  if (x.n.sign() != y.n.sign()) return x.n.sign() < y.n.sign() ? -1 : 1;
  const Aligned aligned = Align(x, y);
  return aligned.a.compare(aligned.b);
}

double Rational::ToDouble() const { return Round<double>(storage_->value, Rounding::kNearestEven); }
float Rational::ToFloat() const { return Round<float>(storage_->value, Rounding::kNearestEven); }
double Rational::ToDoubleUp() const { return Round<double>(storage_->value, Rounding::kUp); }

std::string Rational::ToString() const {
  Fraction reduced = storage_->value;
  reduced.Reduce();
  if (reduced.e < 0 && !reduced.n.is_zero()) {
    const auto zeros = static_cast<int>(lsb(Integer(abs(reduced.n))));
    const int by = std::min(zeros, -reduced.e);
    reduced.n /= Shifted(1, by);
    reduced.e += by;
  }
  const Integer d = Shifted(reduced.d, std::max(-reduced.e, 0));
  std::string text = Shifted(reduced.n, std::max(reduced.e, 0)).str();
  if (d != 1) text += "/" + d.str();
  return text;
}

}  // namespace rasterproof::exact
