#include "bench/values/value_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/channel.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "exact/values.h"

namespace rasterproof::bench {
namespace {

constexpr double kTexels = 4096;  // of the unit of a number

// sum M_i (|a_i| + |v|) and sum M_i with coordinates counted from (qx, qy), or for each corner from
// its edge's start.
struct Reach {
  double of_value = 0;
  double of_one = 0;
};
Reach ReachAbout(const ValueTriangle& t, double px, double py, double value, std::size_t about) {
  Reach reach;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    // Of the window: a corner is its place.
    const std::size_t from = about == 2 ? j : 0;
    const double qx = about == 0 ? 0 : double{t.x[from]};
    const double qy = about == 0 ? 0 : double{t.y[from]};
    const double jx = t.x[j] - qx * t.w[j];
    const double jy = t.y[j] - qy * t.w[j];
    const double kx = t.x[k] - qx * t.w[k];
    const double ky = t.y[k] - qy * t.w[k];
    const double m = (std::fabs(jy * t.w[k]) + std::fabs(t.w[j] * ky)) * std::fabs(px - qx) +
                     (std::fabs(t.w[j] * kx) + std::fabs(jx * t.w[k])) * std::fabs(py - qy) +
                     std::fabs(jx * ky) + std::fabs(jy * kx);
    reach.of_one += m;
    reach.of_value += m * (std::fabs(double{t.a[i]}) + std::fabs(value));
  }
  return reach;
}

// The 99.9 % point.
double Quantile999(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto at =
      static_cast<std::size_t>(std::ceil(0.999 * static_cast<double>(values.size()))) - 1;
  std::ranges::nth_element(values, values.begin() + static_cast<std::ptrdiff_t>(at));
  return values[at];
}

}  // namespace

std::optional<ExactValue> ExactValueAt(const ValueTriangle& t, int x, int y) {
  using exact::Rational;
  const auto corner = [&](std::size_t k) {
    return exact::HomogeneousPoint{Rational(t.x[k]), Rational(t.y[k]), Rational(t.w[k])};
  };
  const exact::Interpolant interpolant({corner(0), corner(1), corner(2)}, {x + 0.5, y + 0.5});
  const exact::Attribute a = exact::ToAttribute({t.a[0], t.a[1], t.a[2]});
  const auto found = interpolant.Derivatives(Interpolation::kPerspective, a);
  const auto condition = interpolant.Conditions(Interpolation::kPerspective, a);
  const auto ones = interpolant.Conditions(Interpolation::kPerspective, exact::Ones());
  if (!found || !condition || !ones) return std::nullopt;
  ExactValue exact{t, x, y, x, 0, found->value, found->dx, {}, {}, condition->dx.ToDouble()};
  const double value = found->value.ToDouble();
  // |d| = 2 sum M_i over the condition of ones.
  const double d = 2 * ReachAbout(t, x + 0.5, y + 0.5, 0, 0).of_one / ones->value.ToDouble();
  for (std::size_t about = 0; about < 3; ++about) {
    const Reach reach = ReachAbout(t, x + 0.5, y + 0.5, value, about);
    exact.condition[about] = reach.of_value / d;
    exact.share[about] = reach.of_one / d;
  }
  return exact;
}

void ValueErrors::Add(const ExactValue& exact, float shown) {
  if (!std::isfinite(shown)) {
    ++row_.not_finite;
    return;
  }
  const exact::Rational& truth = is_derivative_ ? exact.dx : exact.value;
  const exact::Rational off = (exact::Rational(shown) - truth).Abs();
  const exact::Rational ulp = exact::Ulp(truth, Precision::kFloat32);
  const double absolute = off.ToDouble();
  const double ulps = (off / ulp).ToDouble();
  ulps_.push_back(ulps);
  texels_.push_back(absolute * kTexels);
  if (ulps_.size() == 1 || ulps > row_.ulps) {
    row_.ulps = ulps;
    row_.worst = {{}, exact.x + 0.5, exact.y + 0.5, shown, truth.ToDouble()};
    for (std::size_t k = 0; k < 3; ++k) {
      const ValueTriangle& t = exact.triangle;
      row_.worst.corners[k] = {t.x[k], t.y[k], t.w[k], t.a[k]};
    }
  }
  row_.texels = std::max(row_.texels, absolute * kTexels);
  if (!bound_.is_stated) return;
  const double share = bound_.conditions * bound_.unit * exact.share[bound_.about];
  if (!(share < 0.5)) {
    ++row_.unbounded;
    return;
  }
  const double grown = bound_.is_of_derivative ? (1 - share) * (1 - share) : 1 - share;
  const double condition =
      bound_.is_of_derivative ? exact.dx_condition : exact.condition[bound_.about];
  const double allowed =
      bound_.conditions * bound_.unit * condition / grown + bound_.ulps * ulp.ToDouble();
  const double part = absolute == 0 ? 0 : absolute / allowed;
  if (!(part <= row_.share_of_bound)) row_.share_of_bound = part;
}

void ValueErrors::WriteTo(ValueBenchRow& row) {
  row.ulps = row_.ulps;
  row.ulps_999 = Quantile999(ulps_);
  row.texels = row_.texels;
  row.texels_999 = Quantile999(texels_);
  row.share_of_bound = row_.share_of_bound;
  row.unbounded = row_.unbounded;
  row.not_finite = row_.not_finite;
  row.worst = row_.worst;
}

}  // namespace rasterproof::bench
