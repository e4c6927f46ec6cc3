#include "props/judging/values/wireframe_queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/verdict.h"
#include "exact/attributes.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

using exact::Rational;

// A distance is lambda_i times area over a length. The barycentric brings its own bound; the area
// in the scale brings |lambda_i| times the area's relative error, which the barycentric's bound
// contains already (so: twice). What remains is the length and the products. Edge components: one
// rounding each, u. Squares: 2u + u. Their sum: u more. Root: half of that and u: 3u. Quotient and
// product: 2u. Second-order terms are below u. 16 u leaves room for forms that add a step or two.
// Where the larger square is a normal number, the other adds u at most if it underflows.
constexpr double kWireframeErrorMultiplier = 16;

// Whether the squares of a side's components are of the precision: nothing is stated of others.
bool HasSquares(Point2 from, Point2 to, Precision precision) {
  const bool single = precision == Precision::kFloat32;
  const double least = single ? 0x1p-63 : 0x1p-511;  // its square is the smallest normal number
  const double most = single ? 0x1p63 : 0x1p511;     // two of its squares do not overflow
  const double largest = std::max(std::fabs(to.x - from.x), std::fabs(to.y - from.y));
  return largest >= least && largest <= most;
}

// The expected distance of one edge at a query.
struct ExpectedDistance {
  BarycentricQuery query;
  int edge = 0;
  std::size_t question = 0;  // the number of the query's question
  WireframeMeaning meaning;  // says the exact distance
  double rounded = 0;        // the exact distance, for the reader
  double bound = 0;          // how far off it may be
};

bool IsAsExpected(const ExpectedDistance& e, double observed) {
  return IsSurelyWithin(observed, e.rounded, e.bound) ||
         IsWithin(observed, e.meaning.exact(e.query, e.edge).square, e.bound);
}

double BoundOf(double scale, double barycentric_bound, double distance, Precision precision) {
  return 2 * barycentric_bound * scale +
         kWireframeErrorMultiplier * UnitRoundoff(precision) * distance +
         SmallestSubnormal(precision);
}

Verdict AreAsExpected(const std::vector<ExpectedDistance>& expected, const Answers& answers,
                      const std::string& property) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (const ExpectedDistance& e : expected) {
    const double observed = answers.distances[e.question][static_cast<std::size_t>(e.edge)];
    ++exercised;
    if (!std::isfinite(observed) || !IsAsExpected(e, observed)) {
      return BarycentricViolation(e.query, e.edge, exercised, property, {observed},
                                  {e.rounded, " within ", e.bound});
    }
    worst = std::max(worst, std::fabs(observed - e.rounded) / e.bound);
  }
  return Verdict::Held(exercised, worst);
}

}  // namespace

double Nearest(const Rational& x) { return x.ToDouble(); }

double Nearest(const Estimate& x) {
  const double off = (std::fabs(x.low()) + x.error()) * (1 + 0x1p-40);
  const bool settled = x.high() + off == x.high() && x.high() - off == x.high();
  return settled ? x.high() : std::numeric_limits<double>::quiet_NaN();
}

double RoundedRoot(const Estimate& square) {
  const double rounded = Nearest(square);
  const bool in_range = rounded == 0 || rounded >= std::numeric_limits<double>::min();
  return in_range ? std::sqrt(rounded) : std::numeric_limits<double>::quiet_NaN();
}

double RoundedRoot(const Rational& square) {
  const double rounded = square.ToDouble();
  const bool in_range = rounded >= std::numeric_limits<double>::min() && std::isfinite(rounded);
  return in_range ? std::sqrt(rounded) : exact::NearestSquareRoot(square);
}

bool IsSurelyWithin(double observed, double rounded_root, double bound) {
  const double off = std::fabs(observed - rounded_root);
  return off + 0x1p-51 * (off + rounded_root) <= bound * (1 - 0x1p-50);
}

bool IsWithin(double observed, const Rational& square, double bound) {
  const Rational low = Rational(observed) - Rational(bound);
  const Rational high = Rational(observed) + Rational(bound);
  return high.Sign() >= 0 && high * high >= square && (low.Sign() <= 0 || low * low <= square);
}

Checks AskDistances(const PlacedCase& c, const Description& subject, WireframeForm form,
                    WireframeMeaning meaning, std::string property) {
  std::vector<ExpectedDistance> expected;
  Questions questions;
  for (const BarycentricQuery& q : SomeBarycentricQueries(c)) {
    if (!q.inside) continue;
    const std::array<double, 3> barycentric_bounds =
        subject.barycentrics->BarycentricErrorBounds(BarycentricForm::kVertexArea, q.v, q.place.at);
    for (int i = 0; i < 3; ++i) {
      const double barycentric_bound = barycentric_bounds[static_cast<std::size_t>(i)];
      if (form == WireframeForm::kHeight &&
          !HasSquares(EdgeStart(q.v, i), EdgeEnd(q.v, i), subject.info.input)) {
        continue;
      }
      if (!IsStated(barycentric_bound)) continue;
      const auto expect = [&](const auto& scale) {
        const double rounded = RoundedRoot(scale.square);
        const double bound = BoundOf(scale.scale, barycentric_bound, rounded, subject.info.input);
        if (!IsStated(bound)) return false;
        expected.push_back({q, i, questions.distances.size(), meaning, rounded, bound});
        return true;
      };
      if (!expect(meaning.estimated(q, i))) expect(meaning.exact(q, i));
    }
    questions.distances.push_back({form, q.v, q.place.at});
  }
  return OneCheck(std::move(questions), [expected = std::move(expected),
                                         property = std::move(property)](const Answers& answers) {
    return AreAsExpected(expected, answers, property);
  });
}

}  // namespace rasterproof::props
