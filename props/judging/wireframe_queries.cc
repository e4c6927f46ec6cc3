#include "props/judging/wireframe_queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/ulp.h"
#include "exact/attributes.h"
#include "props/judging/exact_comparison.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

using exact::Rational;

// A distance is lambda_i times area over a length. The weight brings its own bound; the area in the
// scale brings |lambda_i| times the area's relative error, which the weight's bound contains
// already (so: twice). What remains is the length and the products. Edge components: one rounding
// each, u. Squares: 2u + u. Their sum: u more. Root: half of that and u: 3u. Quotient and product:
// 2u. Second-order terms are below u. 16 u leaves room for forms that add a step or two.
constexpr double kWireframeErrorMultiplier = 16;

double UnitRoundoff(Precision precision) {
  return precision == Precision::kFloat32 ? double{rounding_epsilon<float>()}
                                          : rounding_epsilon<double>();
}

double LeastSubnormal(Precision precision) {
  return precision == Precision::kFloat32 ? double{std::numeric_limits<float>::denorm_min()}
                                          : std::numeric_limits<double>::denorm_min();
}

// Compares by squares: |observed - sqrt(square)| <= bound.
bool IsWithin(double observed, const Rational& square, double bound) {
  const Rational low = Rational(observed) - Rational(bound);
  const Rational high = Rational(observed) + Rational(bound);
  return high.Sign() >= 0 && high * high >= square && (low.Sign() <= 0 || low * low <= square);
}

}  // namespace

double RoundedRoot(const Rational& square) {
  const double rounded = square.ToDouble();
  const bool in_range = rounded >= std::numeric_limits<double>::min() && std::isfinite(rounded);
  return in_range ? std::sqrt(rounded) : exact::NearestSquareRoot(square);
}

Verdict DistancesMean(Subject& subject, const Case& c, WireframeForm form, WireframeMeaning meaning,
                      const std::string& claim) {
  if (std::optional<Verdict> refusal = CannotAskWeights(subject, c)) return *refusal;
  const WeightEvaluator& evaluator = *subject.Weights();
  const Precision precision = subject.Info().input;
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const WeightQuery& q : SomeWeightQueries(c)) {
    if (!q.inside) continue;
    const Point2 p = q.place.at;
    const std::array<double, 3> weight_bounds =
        evaluator.WeightErrorBounds(BarycentricForm::kVertexArea, q.v, p);
    const std::array<double, 3> observed = evaluator.EdgeDistances(form, q.v, p);
    for (int i = 0; i < 3; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const std::optional<WireframeScale> exact = meaning(q, i);
      if (!exact || !Claims(weight_bounds[k])) continue;
      const double expected = RoundedRoot(exact->exact_square);
      const double bound = 2 * weight_bounds[k] * exact->scale +
                           kWireframeErrorMultiplier * UnitRoundoff(precision) * expected +
                           LeastSubnormal(precision);
      if (!Claims(bound)) continue;
      ++exercised;
      if (!std::isfinite(observed[k]) || !IsWithin(observed[k], exact->exact_square, bound)) {
        return WeightViolation(q, i, exercised, claim, HexText(observed[k]),
                               HexText(expected) + " within " + HexText(bound));
      }
      worst = std::max(worst, std::fabs(observed[k] - expected) / bound);
    }
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace rasterproof::props
