// Where both a walk and direct evaluation are claimed to be exact they give the same number.
#include <cstddef>
#include <iterator>
#include <vector>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/walks.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

// The answers: the walk, and direct values at its steps where both are claimed to be exact.
Verdict Judge(const WalkQuery& walk, const std::vector<int>& exact_steps, const Answers& answers) {
  const EdgeQuery& q = walk.from;
  for (std::size_t k = 0; k < exact_steps.size(); ++k) {
    const int n = exact_steps[k];
    const double walked = answers.steps[0][static_cast<std::size_t>(n)];
    const double direct = answers.edges[k];
    if (walked == direct) continue;
    return EdgeViolation(
        q, k + 1, "walk differs from direct evaluation " + StepsText(walk, n), HexText(walked),
        HexText(direct) + " evaluated afresh; " + ExactEdgeText(q.a, q.b, AfterSteps(walk, n)));
  }
  return Verdict::Held(exact_steps.size());
}

Check CheckOf(const WalkQuery& walk, const EdgeBounds& claimed) {
  const EdgeQuery& q = walk.from;
  const std::vector<double> bounds = BoundsOf(walk, claimed);
  std::vector<int> exact_steps;
  Check check;
  check.questions.steps.push_back(StepsOf(walk));
  for (int n = 0; n <= walk.steps && n < std::ssize(bounds); ++n) {
    const Point2 p = AfterSteps(walk, n);
    if (bounds[static_cast<std::size_t>(n)] != 0 || claimed.ErrorBound(q.a, q.b, p) != 0) continue;
    exact_steps.push_back(n);
    check.questions.edges.push_back({q.a, q.b, p});
  }
  check.judge = [walk, exact_steps, bounds = bounds.size()](const Answers& answers) {
    if (auto wrong = WrongLength(walk, answers.steps[0].size(), bounds)) return *wrong;
    return Judge(walk, exact_steps, answers);
  };
  return check;
}

Asked Ask(const Case& c, const Description& subject) {
  Asked asked;
  for (const WalkQuery& walk : SomeWalks(c)) asked.checks.push_back(CheckOf(walk, *subject.edges));
  return asked;
}

}  // namespace

constinit const Property kWalkEqualsDirectWhereExact{
    .name = "WalkEqualsDirectWhereExact",
    .group = "incremental",
    .clause =
        "Incremental equals direct evaluation wherever the arithmetic is exact (Pineda, "
        "SIGGRAPH 1988, section 3.2).",
    .tolerance = kExact,
    .domains = kOnTheLattice,
    .gate = Where(kAsksSteps, "both stated bounds are 0"),
    .ask = Ask,
};

}  // namespace rasterproof::props
