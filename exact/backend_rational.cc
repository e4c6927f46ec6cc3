// Rational numbers over Boost's arbitrary-precision integers, and their correct rounding.
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
namespace {

using Integer = boost::multiprecision::cpp_int;
using BoostRational = boost::multiprecision::cpp_rational;

Integer PowerOfTwo(int exponent) { return Integer(1) << static_cast<unsigned>(exponent); }

BoostRational FromDouble(double x) {
  if (!std::isfinite(x)) throw std::domain_error("a rational must be finite");
  if (x == 0) return {};
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const auto mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));  // exact: 53 bits
  exponent -= 53;
  if (exponent >= 0) return Integer(mantissa) * PowerOfTwo(exponent);
  return {Integer(mantissa), PowerOfTwo(-exponent)};
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
T Round(const BoostRational& value, Rounding rounding) {
  if (value.is_zero()) return 0;
  const bool negative = value < 0;
  if (negative && rounding == Rounding::kUp) rounding = Rounding::kDown;
  const T magnitude = RoundMagnitude<T>(abs(numerator(value)), denominator(value), rounding);
  return negative ? -magnitude : magnitude;
}

}  // namespace

struct Rational::Storage {
  BoostRational value;
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
  negated.storage_->value = -negated.storage_->value;
  return negated;
}
Rational& Rational::operator+=(const Rational& other) {
  storage_->value += other.storage_->value;
  return *this;
}
Rational& Rational::operator-=(const Rational& other) {
  storage_->value -= other.storage_->value;
  return *this;
}
Rational& Rational::operator*=(const Rational& other) {
  storage_->value *= other.storage_->value;
  return *this;
}
Rational& Rational::operator/=(const Rational& other) {
  storage_->value /= other.storage_->value;
  return *this;
}

int Rational::Sign() const { return storage_->value.sign(); }
Rational Rational::Abs() const { return Sign() < 0 ? -*this : *this; }
int Rational::Compare(const Rational& a, const Rational& b) {
  return a.storage_->value.compare(b.storage_->value);
}

double Rational::ToDouble() const { return Round<double>(storage_->value, Rounding::kNearestEven); }
float Rational::ToFloat() const { return Round<float>(storage_->value, Rounding::kNearestEven); }
double Rational::ToDoubleUp() const { return Round<double>(storage_->value, Rounding::kUp); }

std::string Rational::ToString() const {
  const Integer d = denominator(storage_->value);
  std::string text = numerator(storage_->value).str();
  if (d != 1) text += "/" + d.str();
  return text;
}

}  // namespace rasterproof::exact
