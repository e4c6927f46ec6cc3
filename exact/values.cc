#include "exact/values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "core/channel.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/rational.h"

namespace rasterproof::exact {
namespace {

using Three = std::array<Rational, 3>;

// The two products of each component of a cross product V_j x V_k over (x, y, w).
struct CrossProducts {
  std::array<Rational, 2> x;
  std::array<Rational, 2> y;
  std::array<Rational, 2> w;
};

CrossProducts ProductsOf(const HomogeneousTriangle& v, std::size_t i) {
  const HomogeneousPoint& a = v[(i + 1) % 3];
  const HomogeneousPoint& b = v[(i + 2) % 3];
  return {{{a.y * b.w, a.w * b.y}}, {{a.w * b.x, a.x * b.w}}, {{a.x * b.y, a.y * b.x}}};
}

// beta_i and its gradient, which is the same at every p.
ValueAndDerivatives Beta(const CrossProducts& n, const std::array<Rational, 2>& p) {
  ValueAndDerivatives beta{{}, n.x[0] - n.x[1], n.y[0] - n.y[1]};
  beta.value = beta.dx * p[0] + beta.dy * p[1] + n.w[0] - n.w[1];
  return beta;
}

// The same with the magnitudes of all products added.
ValueAndDerivatives Magnitudes(const CrossProducts& n, const std::array<Rational, 2>& p) {
  ValueAndDerivatives m{{}, n.x[0].Abs() + n.x[1].Abs(), n.y[0].Abs() + n.y[1].Abs()};
  m.value = m.dx * p[0].Abs() + m.dy * p[1].Abs() + n.w[0].Abs() + n.w[1].Abs();
  return m;
}

Rational Dot(const Three& a, const Three& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// log2 of the binade that holds |value|, held to the normal ones of T.
template <class T>
int BinadeOf(const Rational& value) {
  using Limits = std::numeric_limits<T>;
  const Rational magnitude = value.Abs();
  double below = std::min(magnitude.ToDouble(), std::numeric_limits<double>::max());
  if (Rational(below) > magnitude) below = std::nextafter(below, 0.0);
  if (below < double{Limits::min()}) return Limits::min_exponent - 1;
  return std::min(std::ilogb(below), Limits::max_exponent - 1);
}

template <class T>
Rational UlpOf(const Rational& value) {
  return std::ldexp(1.0, BinadeOf<T>(value) + 1 - std::numeric_limits<T>::digits);
}

}  // namespace

HomogeneousTriangle ClipTriangle(const std::array<Vertex, 3>& v) {
  const auto corner = [](const Vertex& at) { return HomogeneousPoint{at.x, at.y, at.w}; };
  return {corner(v[0]), corner(v[1]), corner(v[2])};
}

HomogeneousTriangle WindowTriangle(const std::array<Point2, 3>& v, const std::array<double, 3>& w) {
  const auto corner = [&](std::size_t i) {
    return HomogeneousPoint{Rational(v[i].x) * w[i], Rational(v[i].y) * w[i], w[i]};
  };
  return {corner(0), corner(1), corner(2)};
}

Interpolant::Interpolant(HomogeneousTriangle corners, Point2 p)
    : v_(std::move(corners)), p_{p.x, p.y} {
  for (std::size_t i = 0; i < 3; ++i) {
    beta_[i] = Beta(ProductsOf(v_, i), p_);
    determinant_ += beta_[i].value * v_[i].w;
  }
}

std::optional<Interpolant::Quotient> Interpolant::QuotientOf(Interpolation interpolation,
                                                             const Attribute& a) const {
  if (interpolation == Interpolation::kFlat || determinant_.Sign() == 0) return std::nullopt;
  const Three w{v_[0].w, v_[1].w, v_[2].w};
  if (interpolation == Interpolation::kInverseW) return Quotient{a, w, determinant_};
  if (interpolation == Interpolation::kLinear) {
    return Quotient{{w[0] * a[0], w[1] * a[1], w[2] * a[2]}, w, determinant_};
  }
  const Rational sum = beta_[0].value + beta_[1].value + beta_[2].value;
  if (sum.Sign() == 0) return std::nullopt;
  return Quotient{a, Ones(), sum};
}

ValueAndDerivatives Interpolant::Sums(const Three& factors) const {
  return {Dot({beta_[0].value, beta_[1].value, beta_[2].value}, factors),
          Dot({beta_[0].dx, beta_[1].dx, beta_[2].dx}, factors),
          Dot({beta_[0].dy, beta_[1].dy, beta_[2].dy}, factors)};
}

ValueAndDerivatives Interpolant::DerivativesOf(const Quotient& q) const {
  const ValueAndDerivatives n = Sums(q.c);
  const ValueAndDerivatives d = Sums(q.e);
  const Rational value = n.value / q.d;
  return {value, (n.dx - value * d.dx) / q.d, (n.dy - value * d.dy) / q.d};
}

std::optional<Three> Interpolant::Weights(Interpolation interpolation) const {
  const auto q = QuotientOf(interpolation, Ones());
  if (!q) return std::nullopt;
  return Three{beta_[0].value * q->c[0] / q->d, beta_[1].value * q->c[1] / q->d,
               beta_[2].value * q->c[2] / q->d};
}

std::optional<Rational> Interpolant::Value(Interpolation interpolation, const Attribute& a) const {
  const auto q = QuotientOf(interpolation, a);
  if (!q) return std::nullopt;
  return Dot({beta_[0].value, beta_[1].value, beta_[2].value}, q->c) / q->d;
}

std::optional<ValueAndDerivatives> Interpolant::Derivatives(Interpolation interpolation,
                                                            const Attribute& a) const {
  const auto q = QuotientOf(interpolation, a);
  if (!q) return std::nullopt;
  return DerivativesOf(*q);
}

std::optional<ValueAndDerivatives> Interpolant::Conditions(Interpolation interpolation,
                                                           const Attribute& a) const {
  const auto q = QuotientOf(interpolation, a);
  if (!q) return std::nullopt;
  const ValueAndDerivatives exact = DerivativesOf(*q);
  const ValueAndDerivatives d = Sums(q->e);
  ValueAndDerivatives reach;  // of n - value d, and of its derivatives
  Rational reach_of_d;
  for (std::size_t i = 0; i < 3; ++i) {
    const ValueAndDerivatives m = Magnitudes(ProductsOf(v_, i), p_);
    const Rational factor = q->c[i].Abs() + (exact.value * q->e[i]).Abs();
    reach.value += m.value * factor;
    reach.dx += m.dx * factor;
    reach.dy += m.dy * factor;
    reach_of_d += m.value * q->e[i].Abs();
  }
  const Rational divisor = q->d.Abs();
  const Rational c = reach.value / divisor;
  return ValueAndDerivatives{c, (reach.dx + c * d.dx.Abs() + exact.dx.Abs() * reach_of_d) / divisor,
                             (reach.dy + c * d.dy.Abs() + exact.dy.Abs() * reach_of_d) / divisor};
}

Rational Ulp(const Rational& value, Precision precision) {
  return precision == Precision::kFloat32 ? UlpOf<float>(value) : UlpOf<double>(value);
}

Rational Allowed(const Rational& value, const Rational& condition, const ValueError& error,
                 Precision precision) {
  const double roundoff = precision == Precision::kFloat32 ? double{rounding_epsilon<float>()}
                                                           : rounding_epsilon<double>();
  return Rational(error.ulps) * Ulp(value, precision) + error.absolute +
         Rational(error.conditions) * roundoff * condition;
}

bool IsWithin(double shown, const Rational& value, const Rational& condition,
              const ValueError& error, Precision precision) {
  if (!std::isfinite(shown)) return false;
  return (value - shown).Abs() <= Allowed(value, condition, error, precision);
}

UnormCodes ToUnorm(const Rational& value, int bits) {
  const Rational largest = std::ldexp(1.0, bits) - 1;
  const Rational scaled = std::clamp(value, Rational(0), Rational(1)) * largest;
  double floor = std::floor(scaled.ToDouble());  // below 2^32: exact, or rounded up to a code
  if (Rational(floor) > scaled) --floor;
  const auto code = static_cast<std::uint32_t>(floor);
  const Rational rest = scaled - floor;
  if (rest.Sign() == 0) return {code, code, 0};
  const auto to_half = rest <=> Rational(0.5);
  return {code, code + 1, to_half < 0 ? -1 : to_half > 0 ? 1 : 0};
}

}  // namespace rasterproof::exact
