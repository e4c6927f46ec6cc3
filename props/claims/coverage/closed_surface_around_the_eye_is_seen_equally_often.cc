// Front minus back of a closed clip-space surface is the same at every sample: the number of times that it winds around the eye.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/mesh_neighbours.h"
#include "props/judging/signed_coverage.h"

namespace rasterproof::props {
namespace {

Verdict NotExercised(const char* why) { return {Outcome::kNotExercised, 0, 0, why, std::nullopt}; }

// The eye is the origin. A triangle in a plane through it can hold it only if its vertices are not
// all on one side of w = 0.
bool MayHoldTheEye(const std::array<Vertex, 3>& v) {
  const bool in_front = std::ranges::all_of(v, [](const Vertex& p) { return p.w > 0; });
  const bool behind = std::ranges::all_of(v, [](const Vertex& p) { return p.w < 0; });
  return !in_front && !behind && exact::DeterminantSign(v) == 0;
}

Verdict Judge(Subject& subject, const Case& c) {
  const Need need{.space = Space::kClip, .closed_suffices = true, .any_model_suffices = true};
  if (auto refusal = CannotJudgeSignedCoverage(subject, c, need)) return *refusal;
  if (!c.profile.snap.IsNone()) {
    return Verdict::NotApplicable("snapping follows the division: a profile without it is needed");
  }
  if (c.scene.triangles.empty() || !IsClosed(c.scene)) {
    return NotExercised("the surface is not closed");
  }
  for (const Triangle& t : c.scene.triangles) {
    if (MayHoldTheEye(Corners(c.scene, t))) return NotExercised("the eye may lie on the surface");
  }
  // The surface winds equally often around the eye in every direction: one ray tells it for all.
  const CoverageCounts one =
      exact::Coverage(c.scene, c.profile, {.scissor = PixelRect{0, 0, 1, 1}});
  Spared spared;
  if (!HasOneModel(c.profile) && !TellsFacings(subject)) spared.open = OpenTriangles(c);
  return SignedCoverageIs(subject, c, std::vector<std::int64_t>(one.size(), one.Signed(0)),
                          "the winding number around the eye", spared);
}

}  // namespace

constinit const Property kClosedSurfaceAroundTheEyeIsSeenEquallyOften{
    .name = "ClosedSurfaceAroundTheEyeIsSeenEquallyOften",
    .group = "coverage",
    .clause = "A closed surface winds equally often around the eye in every direction.",
    .precondition =
        "contract sample-exact or closed; coordinates within the limit; clip space "
        "without snapping; "
        "a closed surface that does not pass through the eye",
    .tolerance = kExact,
    .domains = kClosedClip,
    .check = Judge,
};

}  // namespace rasterproof::props
