// What a method of reference/value_methods.h should give, in the oracle's rationals, and how near
// it comes to its bound.
#ifndef RASTERPROOF_TESTS_REFERENCE_VALUE_TRUTH_H_
#define RASTERPROOF_TESTS_REFERENCE_VALUE_TRUTH_H_

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/channel.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "core/value_rule.h"
#include "core/vertex.h"
#include "exact/rational.h"
#include "exact/values.h"
#include "reference/value_methods.h"

namespace rasterproof::reference::truth {

using exact::HomogeneousPoint;
using exact::HomogeneousTriangle;
using exact::Rational;
using RationalPoint = std::array<Rational, 2>;

template <class T>
inline constexpr bool kIsFloat = sizeof(T) == sizeof(float);
template <class T>
inline constexpr Precision kPrecisionOf = kIsFloat<T> ? Precision::kFloat32 : Precision::kFloat64;

template <class T>
T ShownBy(const ValueMethod& method, const ValueTask<T>& task) {
  if constexpr (kIsFloat<T>) {
    return method.float32(task);
  } else {
    return method.float64(task);
  }
}

template <class T>
HomogeneousTriangle CornersOf(const ValueTask<T>& task) {
  const auto corner = [&](std::size_t i) {
    const ValueCorner<T>& v = task.v[i];
    return HomogeneousPoint{Rational(v.x), Rational(v.y), Rational(v.w)};
  };
  return {corner(0), corner(1), corner(2)};
}

template <class T>
exact::Attribute NumbersOf(const ValueTask<T>& task) {
  return exact::ToAttribute({task.a[0], task.a[1], task.a[2]});
}

/// A value with its condition, and the denominator's relative one.
struct Truth {
  Rational value;
  Rational condition;
  Rational denominator;
};

inline HomogeneousPoint MovedBy(const HomogeneousPoint& v, const RationalPoint& q) {
  return {v.x - q[0] * v.w, v.y - q[1] * v.w, v.w};
}

/// The magnitudes of the products in beta_i, counted from q.
inline Rational MagnitudesAbout(const RationalPoint& q, const HomogeneousTriangle& v, std::size_t i,
                                const RationalPoint& p) {
  const HomogeneousPoint j = MovedBy(v[(i + 1) % 3], q);
  const HomogeneousPoint k = MovedBy(v[(i + 2) % 3], q);
  return ((j.y * k.w).Abs() + (j.w * k.y).Abs()) * (p[0] - q[0]).Abs() +
         ((j.w * k.x).Abs() + (j.x * k.w).Abs()) * (p[1] - q[1]).Abs() + (j.x * k.y).Abs() +
         (j.y * k.x).Abs();
}

/// At (x, y) of the task, and nothing on the horizon or without an area. In the window corners are
/// their own places.
template <class T>
std::optional<Truth> TruthAt(const ValueTask<T>& task, double x, ConditionAbout about) {
  const HomogeneousTriangle v = CornersOf(task);
  const double y = task.y;
  const exact::Interpolant interpolant(v, Point2{x, y});
  const exact::Attribute a = NumbersOf(task);
  const auto weights = interpolant.Weights(Interpolation::kInverseW);  // beta_i / D
  const auto value = interpolant.Value(Interpolation::kPerspective, a);
  if (!weights || !value) return std::nullopt;
  const Rational determinant = v[0].x * (v[1].y * v[2].w - v[1].w * v[2].y) -
                               v[0].y * (v[1].x * v[2].w - v[1].w * v[2].x) +
                               v[0].w * (v[1].x * v[2].y - v[1].y * v[2].x);
  const Rational sum = ((*weights)[0] + (*weights)[1] + (*weights)[2]) * determinant;
  const RationalPoint p{x, y};
  Truth truth{*value, 0, 0};
  for (std::size_t i = 0; i < 3; ++i) {
    const HomogeneousPoint& from = v[about == ConditionAbout::kEdgeStart ? (i + 1) % 3 : 0];
    RationalPoint q;
    if (about != ConditionAbout::kOrigin) q = {from.x, from.y};
    const Rational share = MagnitudesAbout(q, v, i, p) / sum.Abs();
    truth.condition += share * (a[i].Abs() + value->Abs());
    truth.denominator += share;
  }
  return truth;
}

/// Of the number that the row is about.
template <class T>
std::optional<Truth> TruthOf(const ValueMethod& method, const ValueTask<T>& task) {
  const double x = task.x;
  const auto here = TruthAt(task, x, method.about);
  if (!here || method.target == ValueTarget::kValue) return here;
  const bool is_stepped = method.target == ValueTarget::kAfterSteps;
  const auto there = TruthAt(task, is_stepped ? x + task.steps : x + 1, method.about);
  if (!there) return std::nullopt;
  const Rational denominator = std::max(here->denominator, there->denominator);
  if (is_stepped) {
    return Truth{there->value, std::max(here->condition, there->condition), denominator};
  }
  return Truth{there->value - here->value, here->condition + there->condition, denominator};
}

/// The stated error as it is judged, grown as props/judging/values does; nothing where it is not.
template <class T>
std::optional<ValueError> Judged(const ValueMethod& method, const ValueTask<T>& task,
                                 const Truth& truth) {
  ValueError error{.ulps = method.ulps, .absolute = 0, .conditions = 0};
  error.conditions = method.ConditionsOf(kIsFloat<T>, task.steps);
  const double share = error.conditions * rounding_epsilon<T>() * truth.denominator.ToDoubleUp();
  if (!(share < 0.5)) return std::nullopt;
  error.conditions /= 1 - share;
  return error;
}

/// error / bound. The verdict is exact::IsWithin's; `scale` times the bound is what it is held to.
template <class T>
double ShareOfBound(const ValueMethod& method, const ValueTask<T>& task, double scale = 1) {
  const auto truth = TruthOf(method, task);
  if (!truth) return 0;
  auto error = Judged(method, task, *truth);
  if (!error) return 0;
  const double shown = ShownBy(method, task);
  error->ulps *= scale;
  error->conditions *= scale;
  const bool holds =
      exact::IsWithin(shown, truth->value, truth->condition, *error, kPrecisionOf<T>);
  if (!std::isfinite(shown)) {
    ADD_FAILURE() << method.name << ": not finite";
    return 2;
  }
  const Rational allowed =
      Rational(error->ulps) * exact::Ulp(truth->value, kPrecisionOf<T>) +
      Rational(error->conditions) * double{rounding_epsilon<T>()} * truth->condition;
  const Rational off = (truth->value - shown).Abs();
  EXPECT_EQ(holds, off <= allowed) << method.name;
  return off.Sign() == 0 ? 0 : (off / allowed).ToDouble();
}

}  // namespace rasterproof::reference::truth

#endif  // RASTERPROOF_TESTS_REFERENCE_VALUE_TRUTH_H_
