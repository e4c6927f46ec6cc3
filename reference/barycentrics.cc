#include "reference/barycentrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "reference/barycentric_forms.h"
#include "reference/bounds.h"
#include "reference/edge_forms.h"
#include "reference/running_error.h"

namespace rasterproof::reference {
namespace {

using Triangle2 = std::array<Point2, 3>;

constexpr double kNothingStated = std::numeric_limits<double>::quiet_NaN();

/// A bound that came out infinite says nothing.
double Stated(double bound) { return std::isfinite(bound) ? bound : kNothingStated; }

template <class T>
bool IsValueOf(double x) {
  return std::isfinite(x) && static_cast<double>(static_cast<T>(x)) == x;
}

template <class T>
bool AreValuesOf(const Triangle2& v, Point2 p) {
  const auto holds = [](Point2 q) { return IsValueOf<T>(q.x) && IsValueOf<T>(q.y); };
  return std::ranges::all_of(v, holds) && holds(p);
}

/// The numbers that the forms below are written in: T itself, or T with its running error.
template <class N>
struct NumberOf;

template <class T>
struct NumberOf<RunningError<T>> {
  static RunningError<T> Edge(Point2 a, Point2 b, Point2 p);
  static RunningError<T> Difference(double x, double y) {
    return RunningError<T>::Difference(static_cast<T>(x), static_cast<T>(y));
  }
  static RunningError<T> Exact(double x) { return static_cast<T>(x); }
};

template <class T>
  requires std::is_floating_point_v<T>
struct NumberOf<T> {
  static T Edge(Point2 a, Point2 b, Point2 p) {
    using Form = DirectForm<T>;
    const auto at = Form::Convert(p);
    return Form(Form::Convert(a), Form::Convert(b), false).At(at.x, at.y);
  }
  static T Difference(double x, double y) { return static_cast<T>(x) - static_cast<T>(y); }
  static T Exact(double x) { return static_cast<T>(x); }
};

template <class T>
RunningError<T> NumberOf<RunningError<T>>::Edge(Point2 a, Point2 b, Point2 p) {
  return {NumberOf<T>::Edge(a, b, p),
          EdgeErrorBound(EdgeArithmetic::kDirect, RunningError<T>::kPrecision, a, b, p)};
}

/// Entry i: E of the edge opposite vertex i.
template <class N>
std::array<N, 3> OppositeEdges(const Triangle2& v, Point2 p) {
  return {NumberOf<N>::Edge(v[1], v[2], p), NumberOf<N>::Edge(v[2], v[0], p),
          NumberOf<N>::Edge(v[0], v[1], p)};
}

template <class N>
N Area(const Triangle2& v) {
  return NumberOf<N>::Edge(v[0], v[1], v[2]);
}

template <class N>
std::array<N, 3> BarycentricsIn(BarycentricForm form, const Triangle2& v, Point2 p) {
  const std::array<N, 3> e = OppositeEdges<N>(v, p);
  const N area = Area<N>(v);
  switch (form) {
    case BarycentricForm::kSum:
      return OverTheirSum(e);
    case BarycentricForm::kOneMinus: {
      const N l0 = e[0] / area;
      const N l1 = e[1] / area;
      return {l0, l1, LastOfOne(NumberOf<N>::Exact(1), l0, l1)};
    }
    case BarycentricForm::kUnsignedArea:
      return {Abs(e[0]) / Abs(area), Abs(e[1]) / Abs(area), Abs(e[2]) / Abs(area)};
    case BarycentricForm::kVertexArea:
      break;
  }
  return {e[0] / area, e[1] / area, e[2] / area};
}

template <class N>
N InterpolateIn(InterpolationForm form, const std::array<Corner, 3>& v,
                const std::array<double, 3>& attribute, Point2 p) {
  const std::array<N, 3> l =
      BarycentricsIn<N>(BarycentricForm::kVertexArea, {v[0].at, v[1].at, v[2].at}, p);
  const auto z = [&](std::size_t i) { return NumberOf<N>::Exact(attribute[i]); };
  const auto delta = [&](std::size_t i) {
    return NumberOf<N>::Difference(attribute[i], attribute[0]);
  };
  switch (form) {
    case InterpolationForm::kDeltas:
      return (z(0) + l[1] * delta(1)) + l[2] * delta(2);
    case InterpolationForm::kPerspective: {
      const auto over_w = [&](std::size_t i) { return l[i] / NumberOf<N>::Exact(v[i].w); };
      const std::array<N, 3> r{over_w(0), over_w(1), over_w(2)};
      return ((r[0] * z(0) + r[1] * z(1)) + r[2] * z(2)) / ((r[0] + r[1]) + r[2]);
    }
    case InterpolationForm::kBarycentrics:
      break;
  }
  return (l[0] * z(0) + l[1] * z(1)) + l[2] * z(2);
}

/// The differences (dX, dY) along the side opposite vertex i.
template <class N>
std::array<N, 2> Side(const Triangle2& v, std::size_t i) {
  const Point2 a = v[(i + 1) % 3];
  const Point2 b = v[(i + 2) % 3];
  return {NumberOf<N>::Difference(b.x, a.x), NumberOf<N>::Difference(b.y, a.y)};
}

/// |dX| + |dY| (kDerivative) or the length (kHeight) of the side opposite vertex i.
template <class N>
N SideMeasure(WireframeForm form, const Triangle2& v, std::size_t i) {
  const auto [dx, dy] = Side<N>(v, i);
  return form == WireframeForm::kDerivative ? Abs(dx) + Abs(dy) : Sqrt(dx * dx + dy * dy);
}

/// What a barycentric is scaled with to be a distance: 1 / fwidth(l_i), or the height over side i.
template <class T>
T DistancePerBarycentric(WireframeForm form, const Triangle2& v, std::size_t i) {
  return Abs(Area<T>(v)) / SideMeasure<T>(form, v, i);
}

template <class T>
double QuotientRounding(T quotient) {
  return RunningError<T>::Rounded(quotient, 0, true).error;
}

/// Whether the computed edge values prove a sample inside (1), outside (-1), or leave it open (0).
template <class T>
int ProvedSide(const RunningError<T>& edge, const RunningError<T>& area) {
  if (edge.Magnitude() <= edge.error && edge.error > 0) return 0;
  return edge.value == 0 || (edge.value > 0) == (area.value > 0) ? 1 : -1;
}

template <class T>
class BarycentricsOf final : public BarycentricEvaluator {
 public:
  using Running = RunningError<T>;
  using Barycentrics3 = std::array<double, 3>;

  Barycentrics3 Barycentrics(BarycentricForm form, const Triangle2& v, Point2 p) const override {
    const std::array<T, 3> l = BarycentricsIn<T>(form, v, p);
    return {l[0], l[1], l[2]};
  }

  Barycentrics3 BarycentricErrorBounds(BarycentricForm form, const Triangle2& v,
                                       Point2 p) const override {
    if (!AreValuesOf<T>(v, p)) return {kNothingStated, kNothingStated, kNothingStated};
    const auto l = BarycentricsIn<Running>(form, v, p);
    Barycentrics3 bounds{l[0].error, l[1].error, l[2].error};
    if (form == BarycentricForm::kUnsignedArea) {
      for (std::size_t i = 0; i < 3; ++i) bounds[i] += UnsignedExcess(v, p, i);
      // Outside, at least one barycentric has lost its sign; which one, the form cannot say.
      if (std::isnan(bounds[0] + bounds[1] + bounds[2])) bounds.fill(kNothingStated);
    }
    for (double& bound : bounds) bound = Stated(bound);
    return bounds;
  }

  double SumErrorBound(BarycentricForm form, const Triangle2& v, Point2 p) const override {
    if (!AreValuesOf<T>(v, p)) return kNothingStated;
    const std::array<T, 3> l = BarycentricsIn<T>(form, v, p);
    if (!std::isfinite(l[0]) || !std::isfinite(l[1]) || !std::isfinite(l[2])) return kNothingStated;
    switch (form) {
      case BarycentricForm::kSum:
        return NormalizedSumError(v, p, l);
      case BarycentricForm::kOneMinus:
        return OneMinusSumError(l);
      case BarycentricForm::kVertexArea:
      case BarycentricForm::kUnsignedArea:
        return AreaSumError(form, v, p, l);
    }
    return kNothingStated;
  }

  double Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                     const Barycentrics3& attribute, Point2 p) const override {
    return InterpolateIn<T>(form, v, attribute, p);
  }

  double InterpolationErrorBound(InterpolationForm form, const std::array<Corner, 3>& v,
                                 const Barycentrics3& attribute, Point2 p) const override {
    if (!AreValuesOf<T>({v[0].at, v[1].at, v[2].at}, p)) return kNothingStated;
    for (std::size_t i = 0; i < 3; ++i) {
      if (!IsValueOf<T>(attribute[i]) || !IsValueOf<T>(v[i].w)) return kNothingStated;
    }
    return Stated(InterpolateIn<Running>(form, v, attribute, p).error);
  }

  Barycentrics3 EdgeDistances(WireframeForm form, const Triangle2& v, Point2 p) const override {
    std::array<T, 3> l = BarycentricsIn<T>(BarycentricForm::kVertexArea, v, p);
    if (form != WireframeForm::kBarycentric) {
      for (std::size_t i = 0; i < 3; ++i) l[i] *= DistancePerBarycentric<T>(form, v, i);
    }
    return {l[0], l[1], l[2]};
  }

  Barycentrics3 EdgeDistanceErrorBounds(WireframeForm form, const Triangle2& v, Point2 p) const {
    if (form == WireframeForm::kBarycentric) {
      return BarycentricErrorBounds(BarycentricForm::kVertexArea, v, p);
    }
    if (!AreValuesOf<T>(v, p)) return {kNothingStated, kNothingStated, kNothingStated};
    return {DistanceError(form, v, p, 0), DistanceError(form, v, p, 1),
            DistanceError(form, v, p, 2)};
  }

 private:
  /// What | |E_i| / |A| - lambda_i | can be beyond the rounding: nothing where the sign is proved
  /// right; twice the barycentric's magnitude where it is not known; NaN where it is proved wrong.
  static double UnsignedExcess(const Triangle2& v, Point2 p, std::size_t i) {
    const Running edge = OppositeEdges<Running>(v, p)[i];
    const Running area = Area<Running>(v);
    const int side = ProvedSide(edge, area);
    if (side != 0) return side > 0 ? 0 : kNothingStated;
    const double divisor = area.Magnitude() - area.error;
    return divisor > 0 ? RoundBoundUp(2 * (edge.Magnitude() + edge.error) / divisor)
                       : kNothingStated;
  }

  /// sum e_i'/A' - 1 = (sum (e_i' - e_i) - (A' - A)) / A', and each quotient is rounded once.
  static double AreaSumError(BarycentricForm form, const Triangle2& v, Point2 p,
                             const std::array<T, 3>& l) {
    const auto e = OppositeEdges<Running>(v, p);
    const Running area = Area<Running>(v);
    if (!(area.Magnitude() > area.error)) return kNothingStated;
    double bound = (e[0].error + e[1].error + e[2].error + area.error) / area.Magnitude();
    for (std::size_t i = 0; i < 3; ++i) {
      bound += QuotientRounding(l[i]);
      if (form == BarycentricForm::kUnsignedArea) bound += UnsignedExcess(v, p, i);
    }
    return Stated(RoundBoundUp(bound));
  }

  /// For edge values of one sign the constant; else what the two sums and three quotients round.
  static double NormalizedSumError(const Triangle2& v, Point2 p, const std::array<T, 3>& l) {
    const std::array<T, 3> e = OppositeEdges<T>(v, p);
    const T first = e[0] + e[1];
    const T sum = first + e[2];
    if (sum == 0 || !std::isfinite(sum)) return kNothingStated;
    const auto [least, largest] = std::ranges::minmax(e);
    constexpr double kUnderflow = 2 * double{std::numeric_limits<T>::denorm_min()};
    if (least >= 0 || largest <= 0) {
      return RoundBoundUp(kNormalizedSumErrorMultiplier<T> * rounding_epsilon<T>() + kUnderflow);
    }
    const Running rounded_first = Running::Rounded(first, 0, false);
    const Running rounded_sum = Running::Rounded(sum, 0, false);
    double bound = (rounded_first.error + rounded_sum.error) / rounded_sum.Magnitude();
    for (const T barycentric : l) bound += QuotientRounding(barycentric);
    return Stated(RoundBoundUp(bound));
  }

  static double OneMinusSumError(const std::array<T, 3>& l) {
    if (l[0] >= 0 && l[0] <= 1 && l[1] >= 0 && l[2] >= 0) return kOneMinusSumError<T>;
    return Running::Rounded(T{1} - l[0], 0, false).error + Running::Rounded(l[2], 0, false).error;
  }

  /// l_i (|A| / m_i) = sign(A) (E_i / m_i) but for three roundings: the area cancels.
  static double DistanceError(WireframeForm form, const Triangle2& v, Point2 p, std::size_t i) {
    const Running edge = OppositeEdges<Running>(v, p)[i];
    const Running area = Area<Running>(v);
    const Running measure = SideMeasure<Running>(form, v, i);
    if (!(area.Magnitude() > area.error)) return kNothingStated;
    const T barycentric = edge.value / area.value;
    const T scale = DistancePerBarycentric<T>(form, v, i);
    if (!std::isnormal(scale) || !(std::isnormal(barycentric) || edge.value == 0))
      return kNothingStated;
    const double quotient = RoundBoundUp(edge.Magnitude() / measure.Magnitude());
    const double bound = Running::QuotientError(edge, measure) +
                         kEdgeDistanceErrorMultiplier<T> * rounding_epsilon<T>() * quotient;
    // The last product may underflow.
    return Stated(RoundBoundUp(bound + double{std::numeric_limits<T>::denorm_min()}));
  }
};

template <class T>
const BarycentricsOf<T>& Evaluator() {
  static const BarycentricsOf<T> evaluator;
  return evaluator;
}

template <class T>
std::array<double, 3> HeightsIn(const Triangle2& v) {
  return {DistancePerBarycentric<T>(WireframeForm::kHeight, v, 0),
          DistancePerBarycentric<T>(WireframeForm::kHeight, v, 1),
          DistancePerBarycentric<T>(WireframeForm::kHeight, v, 2)};
}

}  // namespace

const BarycentricEvaluator& ReferenceBarycentrics(Precision precision) {
  if (precision == Precision::kFloat32) return Evaluator<float>();
  return Evaluator<double>();
}

std::array<double, 3> EdgeDistanceErrorBounds(Precision precision, WireframeForm form,
                                              const std::array<Point2, 3>& v, Point2 p) {
  return precision == Precision::kFloat32 ? Evaluator<float>().EdgeDistanceErrorBounds(form, v, p)
                                          : Evaluator<double>().EdgeDistanceErrorBounds(form, v, p);
}

std::array<double, 3> Heights(Precision precision, const std::array<Point2, 3>& v) {
  return precision == Precision::kFloat32 ? HeightsIn<float>(v) : HeightsIn<double>(v);
}

}  // namespace rasterproof::reference
