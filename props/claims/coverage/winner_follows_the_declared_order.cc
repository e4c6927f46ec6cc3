// The winner of every sample is the last triangle that covers it by the model, or the first one, as the subject declares.
#include <cstddef>
#include <string>
#include <vector>

#include "exact/coverage.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"
#include "props/judging/winners.h"

namespace rasterproof::props {
namespace {

// The mesh is drawn over itself until so many triangles are: more than a byte can number.
constexpr std::size_t kFewestDrawn = 300;

Verdict Judge(Subject& subject, const Case& c) {
  Subject& whole = subject.Whole();
  if (!ShowsWinners(whole.Info())) {
    return Verdict::NotApplicable("the subject does not show which triangle wins");
  }
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  if (c.scene.triangles.empty()) return Verdict::Held(0);
  DrawJob job{c.scene, c.options, c.profile.lattice.samples()};
  job.wants = kCoverageAndIds;
  std::vector<Triangle>& drawn = job.triangles.emplace(c.scene.triangles);
  while (drawn.size() < kFewestDrawn) {
    drawn.insert(drawn.end(), c.scene.triangles.begin(), c.scene.triangles.end());
  }
  const Drawing drawing = whole.Show(job);
  std::vector<std::vector<bool>> covered;
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    covered.push_back(
        CoveredSamples(exact::Coverage(OnlyTriangles(c, {t}).scene, c.profile, c.options)));
  }
  for (std::size_t t = 0; covered.size() < drawn.size(); ++t) {
    covered.push_back(covered[t]);
  }
  Verdict verdict =
      SameWinners(drawing, WinnersOf(covered, whole.Info().fragments.order),
                  c.scene.triangles.size(), DecisionsOf(c), "that cover it by the model");
  if (verdict.outcome == Outcome::kViolated) {
    verdict.message +=
        " (the scene drawn over itself, " + std::to_string(drawn.size()) + " triangles)";
  }
  return verdict;
}

}  // namespace

constinit const Property kWinnerFollowsTheDeclaredOrder{
    .name = "WinnerFollowsTheDeclaredOrder",
    .group = "coverage",
    .clause =
        "Primitives are drawn in order (OpenGL 4.6 section 2.1; Vulkan 1.3, Rasterization "
        "Order): without a depth test the last one on a sample stays.",
    .precondition =
        "the subject shows winners; contract sample-exact; coordinates within the "
        "limit",
    .tolerance = kExact,
    .domains = kAnyMesh,
    .check = Judge,
};

}  // namespace rasterproof::props
