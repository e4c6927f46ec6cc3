// Each scene of a batch is drawn as it is drawn alone.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/scene.h"
#include "core/subject_info.h"
#include "core/target_size.h"
#include "props/judging/primitive_ids.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace batch_draws_like_single_calls {

constexpr std::size_t kSingles = 5;

// Draws the case with the other options that the subject takes.
std::vector<DrawQuestion> WithOtherOptions(const PlacedCase& c, const SubjectInfo& info) {
  std::vector<DrawQuestion> draws;
  if (info.takes_culling) {
    DrawOptions culls = c.options;
    culls.cull = c.options.cull == Cull::kNone ? Cull::kBack : Cull::kNone;
    draws.push_back(WholeCallOf(c.scene, c.profile, culls));
  }
  if (info.takes_scissor) {
    DrawOptions cuts = c.options;
    cuts.scissor = PixelRect{0, 0, (c.scene.width + 1) / 2, (c.scene.height + 1) / 2};
    draws.push_back(WholeCallOf(c.scene, c.profile, cuts));
  }
  return draws;
}

// The case, the same indices into other vertices, the same vertices with other indices, some of its
// triangles alone, the case with other options and on a larger target, and the case again: scenes
// that give away what is left of one in the next.
std::vector<DrawQuestion> DrawsOf(const PlacedCase& c, const SubjectInfo& info) {
  const DrawQuestion draw = WholeCallOf(c.scene, c.profile, c.options);
  std::vector<DrawQuestion> draws{draw, draw, draw};
  Scene reversed = c.scene;
  std::ranges::reverse(reversed.vertices);
  draws[1].job.scene = std::make_shared<const Scene>(std::move(reversed));
  const auto last = static_cast<std::int32_t>(c.scene.vertices.size()) - 1;
  std::vector<Triangle>& mirrored = draws[2].job.triangles.emplace(c.scene.triangles);
  for (Triangle& t : mirrored) t = {last - t[0], last - t[1], last - t[2]};
  for (std::size_t t = 0; t < std::min(c.scene.triangles.size(), kSingles); ++t) {
    draws.push_back(draw);
    draws.back().job.triangles = {c.scene.triangles[t]};
  }
  for (DrawQuestion& other : WithOtherOptions(c, info)) draws.push_back(std::move(other));
  if (IsTargetSize(c.scene.width + 1, c.scene.height + 1, c.profile.pattern.samples())) {
    Scene larger = c.scene;
    ++larger.width;
    ++larger.height;
    draws.push_back(draw);
    draws.back().job.scene = std::make_shared<const Scene>(std::move(larger));
  }
  draws.push_back(draw);
  return draws;
}

// Judges whether a scene of the batch shows what it shows in a separate call.
Verdict LikeAlone(const Drawing& drawn, const Drawing& alone, std::size_t triangles) {
  Verdict same = SameCounts(drawn.counts, alone.counts, 0, "that in a call of its own");
  if (same.outcome == Outcome::kViolated || alone.primitive_ids.empty()) return same;
  return SamePrimitiveIds(drawn, alone.primitive_ids, triangles, 0, "in a call of its own");
}

// The batch. What is compared with it puts the case to the test once.
Check InOneCall(const PlacedCase& c, std::vector<DrawQuestion> draws) {
  Check check;
  check.questions.company = Company::kOneCallAlone;
  check.questions.draws = std::move(draws);
  check.judge = [&c](const Answers&) { return Verdict::Held(DecisionsOf(c)); };
  return check;
}

// Compares scene k of a batch of `count` with the same scene in a call that is no batch.
Check InItsOwnCall(const PlacedCase& c, DrawQuestion draw, std::size_t k, std::size_t count) {
  Check check;
  check.questions.company = Company::kInOrderAlone;
  check.questions.draws.push_back(std::move(draw));
  check.bases = {k};
  check.judge = [&c, k, count](const Answers& answers) {
    Verdict same = LikeAlone(*answers.draws[0], *answers.draws[1], c.scene.triangles.size());
    if (same.outcome == Outcome::kViolated) {
      same.message = "scene " + std::to_string(k + 1) + " of a batch of " + std::to_string(count) +
                     ": " + same.message;
    }
    return OfDraw(1, std::move(same));
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  const std::vector<DrawQuestion> draws = DrawsOf(c, subject.info);
  Checks asked;
  asked.checks.push_back(InOneCall(c, draws));
  for (std::size_t k = 0; k < draws.size(); ++k) {
    asked.checks.push_back(InItsOwnCall(c, draws[k], k, draws.size()));
  }
  return asked;
}

}  // namespace batch_draws_like_single_calls

extern constinit const Property kBatchDrawsLikeSingleCalls{
    .name = "BatchDrawsLikeSingleCalls",
    .group = "extremes",
    .clause = "Scenes that share a call have nothing to do with each other.",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .is_about_sequence = true,
    .gate = {.space = Space::kEither,
             .shows = Shows::kBatches,
             .contract = ContractNeeded::kAny,
             .judges_degenerates = true},
    .ask = batch_draws_like_single_calls::Ask,
};

}  // namespace rasterproof::props
