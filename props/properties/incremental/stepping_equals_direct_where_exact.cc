// Where the subject claims that stepping and direct evaluation are both exact, they give the same
// number.
#include <cstddef>
#include <iterator>
#include <vector>

#include "props/judging/values/stepping.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace stepping_equals_direct_where_exact {

// The answers: the stepping, and direct values at its steps where both claim to be exact.
Verdict Judge(const SteppingQuery& stepping, const std::vector<int>& exact_steps,
              const Answers& answers) {
  const EdgeQuery& q = stepping.from;
  for (std::size_t k = 0; k < exact_steps.size(); ++k) {
    const int n = exact_steps[k];
    const double walked = answers.steps[0][static_cast<std::size_t>(n)];
    const double direct = answers.edges[k];
    if (walked == direct) continue;
    return EdgeViolation(
        q, k + 1, "stepping differs from direct evaluation " + StepsText(stepping, n), {walked},
        {direct, " evaluated afresh; E = ", ExactEdge(q.a, q.b, AfterSteps(stepping, n))});
  }
  return Verdict::Held(exact_steps.size());
}

Check CheckOf(const SteppingQuery& stepping, const EdgeBounds& stated) {
  const EdgeQuery& q = stepping.from;
  const std::vector<double> bounds = BoundsOf(stepping, stated);
  std::vector<int> exact_steps;
  Check check;
  check.questions.steps.push_back(StepsOf(stepping));
  for (int n = 0; n <= stepping.steps && n < std::ssize(bounds); ++n) {
    const Point2 p = AfterSteps(stepping, n);
    if (bounds[static_cast<std::size_t>(n)] != 0 || stated.ErrorBound(q.a, q.b, p) != 0) continue;
    exact_steps.push_back(n);
    check.questions.edges.push_back({q.a, q.b, p});
  }
  check.judge = [stepping, exact_steps, bounds = bounds.size()](const Answers& answers) {
    if (auto wrong = WrongLength(stepping, answers.steps[0].size(), bounds)) return *wrong;
    return Judge(stepping, exact_steps, answers);
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  Checks asked;
  for (const SteppingQuery& stepping : SomeSteppingQueries(c))
    asked.checks.push_back(CheckOf(stepping, *subject.edges));
  return asked;
}

}  // namespace stepping_equals_direct_where_exact

extern constinit const Property kSteppingEqualsDirectWhereExact{
    .name = "SteppingEqualsDirectWhereExact",
    .group = "incremental",
    .clause =
        "Incremental equals direct evaluation wherever the arithmetic is exact (Pineda, "
        "SIGGRAPH 1988, section 3.2).",
    .tolerance = kExact,
    .domains = kOnTheLattice,
    .gate = Where(kAsksSteps, "both stated bounds are 0"),
    .ask = stepping_equals_direct_where_exact::Ask,
};

}  // namespace rasterproof::props
