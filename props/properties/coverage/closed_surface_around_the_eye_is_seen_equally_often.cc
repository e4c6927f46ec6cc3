// Front minus back of a closed clip-space surface is the same at every sample.
//
// It is the number of times that the surface winds around the eye.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/mesh/mesh_neighbours.h"
#include "props/judging/mesh/signed_coverage.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace closed_surface_around_the_eye_is_seen_equally_often {

constexpr std::array kRules{
    kCountsTies, kOwnsEdges, kDrawsBothFacings,
    ProfileRule{[](const Profile& p) { return p.snap.IsNone(); }, "no snapping",
                "snapping follows the division: a profile without it is needed"}};

// The eye is the origin. A triangle in a plane through it can hold it only if its vertices are not
// all on one side of w = 0. Of one that is not finite nothing is known.
bool MayHoldTheEye(const std::array<Vertex, 3>& v) {
  if (!std::ranges::all_of(v, IsFinite)) return true;
  const bool in_front = std::ranges::all_of(v, [](const Vertex& p) { return p.w > 0; });
  const bool behind = std::ranges::all_of(v, [](const Vertex& p) { return p.w < 0; });
  return !in_front && !behind && exact::DeterminantSign(v) == 0;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.scene.triangles.empty() || !IsClosed(c.scene)) {
    return NotExercised("the surface is not closed");
  }
  for (const Triangle& t : c.scene.triangles) {
    if (MayHoldTheEye(Corners(c.scene, t))) return NotExercised("the eye may lie on the surface");
  }
  // The surface winds equally often around the eye in every direction: one ray tells it for all.
  const CoverageCounts one = exact::Coverage(c, {.scissor = PixelRect{0, 0, 1, 1}});
  Spared spared;
  if (!HasOneModel(c.profile) && !TellsFacings(subject)) spared.open = OpenTriangles(c);
  return CompareSignedCoverage(c, std::vector<std::int64_t>(one.size(), one.Signed(0)),
                               "the winding number around the eye", std::move(spared));
}

}  // namespace closed_surface_around_the_eye_is_seen_equally_often

extern constinit const Property kClosedSurfaceAroundTheEyeIsSeenEquallyOften{
    .name = "ClosedSurfaceAroundTheEyeIsSeenEquallyOften",
    .group = "coverage",
    .clause = "A closed surface winds equally often around the eye in every direction.",
    .tolerance = kExact,
    .domains = kClosedClip,
    .gate = {.space = Space::kClip,
             .contract = ContractNeeded::kClosed,
             .any_model = true,
             .needs_facings = true,
             .rules = closed_surface_around_the_eye_is_seen_equally_often::kRules,
             .asks_oracle = true,
             .where = "a closed surface that does not pass through the eye"},
    .ask = closed_surface_around_the_eye_is_seen_equally_often::Ask,
};

}  // namespace rasterproof::props
