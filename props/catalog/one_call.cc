#include "props/catalog/one_call.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"
#include "props/catalog/winners.h"

namespace rasterproof::props {
namespace {

// A mesh of more triangles is judged by its first ones: what a rasterizer does with neighbours in
// the list shows among them.
constexpr std::size_t kMostTriangles = 32;

// The mesh in one call, so many times over, and then each of its triangles.
std::vector<DrawJob> WholeAndSingles(const Case& c, std::size_t times) {
  const int samples = c.profile.lattice.samples();
  std::vector<DrawJob> jobs{{c.scene, c.options, samples}};
  const auto count = std::min(c.scene.triangles.size(), kMostTriangles);
  jobs.front().scene.triangles.clear();
  for (std::size_t n = 0; n < times * count; ++n) {
    jobs.front().scene.triangles.push_back(c.scene.triangles[n % count]);
  }
  for (std::size_t t = 0; t < count; ++t) {
    jobs.push_back({c.scene, c.options, samples});
    jobs.back().scene.triangles = {c.scene.triangles[t]};
  }
  return jobs;
}

void AddAlone(const CoverageCounts& alone, bool is_mask, CoverageCounts& sum) {
  sum += alone;
  if (!is_mask) return;
  for (std::uint32_t& count : sum.front) count = std::min(count, 1U);
}

}  // namespace

Verdict OneCallDrawsLikeItsTriangles(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .any_model_suffices = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (c.scene.triangles.size() < 2) {
    return {Outcome::kNotExercised, 0, 0, "a mesh of one triangle", std::nullopt};
  }
  Subject& whole = subject.Whole();
  const SubjectInfo& info = whole.Info();
  // Winners: twice, so that something always lies on top.
  const std::size_t times = ShowsWinners(info) ? 2 : 1;
  const std::vector<DrawJob> jobs = WholeAndSingles(c, times);
  const std::vector<DrawOutcome> outcomes = whole.DrawMany(jobs);
  const Drawing& mesh = outcomes.front().Get();
  CoverageCounts sum(mesh.counts.width, mesh.counts.height, mesh.counts.samples);
  std::vector<std::vector<bool>> covered;
  const std::size_t count = jobs.size() - 1;
  for (std::size_t n = 0; n < times * count; ++n) {
    const Drawing& alone = outcomes[std::min(1 + n % count, outcomes.size() - 1)].Get();
    AddAlone(alone.counts, info.coverage == CoverageKind::kMask, sum);
    if (ShowsWinners(info)) covered.push_back(CoveredSamples(alone.counts));
  }
  const std::uint64_t decisions = DecisionsOf(c);
  if (ShowsWinners(info)) {
    return SameWinners(mesh, WinnersOf(covered, info.fragments.order), count, decisions,
                       "drawn alone");
  }
  return SameCounts(mesh.counts, sum, decisions, "that of its triangles drawn alone");
}

}  // namespace rasterproof::props
