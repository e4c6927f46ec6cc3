// Each scene of a batch is drawn as it is drawn alone.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"
#include "props/judging/winners.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kSingles = 5;

// The case, the same indices into other vertices, the same vertices with other indices, some of its
// triangles alone, the case on a larger target, and the case again: scenes that give away what is
// left of one in the next.
std::vector<DrawJob> JobsOf(const Case& c) {
  const int samples = c.profile.lattice.samples();
  DrawJob job{c.scene, c.options, samples};
  job.wants = kCoverageAndIds;
  std::vector<DrawJob> jobs{job, job, job};
  Scene reversed = c.scene;
  std::ranges::reverse(reversed.vertices);
  jobs[1].scene = std::make_shared<const Scene>(std::move(reversed));
  const auto last = static_cast<std::int32_t>(c.scene.vertices.size()) - 1;
  jobs[2].triangles = c.scene.triangles;
  for (Triangle& t : *jobs[2].triangles) t = {last - t[0], last - t[1], last - t[2]};
  for (std::size_t t = 0; t < std::min(c.scene.triangles.size(), kSingles); ++t) {
    jobs.push_back(job);
    jobs.back().triangles = {c.scene.triangles[t]};
  }
  if (c.scene.width < kMaxTargetSide && c.scene.height < kMaxTargetSide) {
    Scene larger = c.scene;
    ++larger.width;
    ++larger.height;
    jobs.push_back(job);
    jobs.back().scene = std::make_shared<const Scene>(std::move(larger));
  }
  jobs.push_back(job);
  return jobs;
}

Verdict Judge(Subject& subject, const Case& c) {
  Subject& whole = subject.Whole();
  if (!whole.Info().takes_batches) {
    return Verdict::NotApplicable("the subject takes no batches");
  }
  const Need need{.space = Space::kEither, .any_contract_suffices = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  const std::vector<DrawJob> jobs = JobsOf(c);
  const std::vector<DrawOutcome> batch = whole.DrawMany(jobs);
  const std::uint64_t decisions = DecisionsOf(c);
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    const Drawing& drawn = batch[std::min(k, batch.size() - 1)].Get();
    const Drawing alone = whole.Show(jobs[k]);
    const std::string scene =
        "scene " + std::to_string(k + 1) + " of a batch of " + std::to_string(jobs.size());
    Verdict same = SameCounts(drawn.counts, alone.counts, decisions, "that in a call of its own");
    if (same.outcome != Outcome::kViolated && !alone.winners.empty()) {
      same = SameWinners(drawn, alone.winners, c.scene.triangles.size(), decisions,
                         "in a call of its own");
    }
    if (same.outcome != Outcome::kViolated) continue;
    same.message = scene + ": " + same.message;
    return same;
  }
  return Verdict::Held(decisions);
}

}  // namespace

constinit const Property kBatchDrawsLikeSingleCalls{
    .name = "BatchDrawsLikeSingleCalls",
    .group = "extremes",
    .clause = "Scenes that share a call have nothing to do with each other.",
    .precondition =
        "the subject takes batches; any contract but none; coordinates within the "
        "limit",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .check = Judge,
    .is_about_sequence = true,
};

}  // namespace rasterproof::props
