// A closed surface shows as much front as back at every sample.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "model/snap_scene.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/mesh/mesh_neighbours.h"
#include "props/judging/mesh/signed_coverage.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace closed_mesh_cancels {

constexpr std::array kRules{kCountsTies, kOwnsEdges, kDrawsBothFacings};

// What is closed before it is snapped stays closed, whatever grid points are chosen.
bool IsClosedInEveryModel(const PlacedCase& c) {
  if (c.scene.clip_space) return IsClosed(c.scene);
  const bool one_model = HasOneModel(c.profile) && IsUnclipped(c.scene, c.profile);
  if (one_model) return IsClosed(c.placed);
  return IsClosed(UnsnappedScene(c));
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (std::ranges::any_of(c.scene.vertices, [](const Vertex& v) { return !(v.w > 0); })) {
    return NotExercised("the surface may wind around the eye");
  }
  if (!c.scene.clip_space) {  // elsewhere the scene tells, whatever it becomes on a grid
    if (const auto why = exact::WhyNotDecided(c)) return NotDecided(why->what());
  }
  const bool one_model = HasOneModel(c.profile) && IsUnclipped(c.scene, c.profile);
  if (!IsClosedInEveryModel(c)) return NotExercised("the mesh has a boundary");
  Spared spared;
  if (!one_model) {
    spared.open = OpenTriangles(c);
    spared.clipped = ClippedEdges(c);
    spared.outline = Outline::OfMoved(c, spared.open.MostMoved());  // of owners left open
    // A surface that is turned in part still cancels, by the facings that the subject itself gives
    // its triangles; what covers something without area need not.
    const bool turns_cancel =
        TellsFacings(subject) && c.profile.degenerate_triangles == DegenerateTriangles::kNothing;
    if (turns_cancel) spared.open.ForgetTurned();
  }
  const std::size_t size =
      CoverageCounts::Size(c.scene.width, c.scene.height, c.profile.pattern.samples());
  return CompareSignedCoverage(c, std::vector<std::int64_t>(size), "zero, the mesh is closed",
                               std::move(spared));
}

}  // namespace closed_mesh_cancels

extern constinit const Property kClosedMeshCancels{
    .name = "ClosedMeshCancels",
    .group = "coverage",
    .clause = "A closed surface has no boundary: what it shows of its front it shows of its back.",
    .required_by = kEveryEdgeClauses,
    .tolerance = kExact,
    .domains = kClosed,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kClosed,
             .any_model = true,
             .judges_clipped = true,
             .needs_facings = true,
             .rules = closed_mesh_cancels::kRules,
             .where = "every edge is walked as often each way; in clip space in front of the eye; "
                      "facings told, or no legal choice turns a triangle there"},
    .ask = closed_mesh_cancels::Ask,
};

}  // namespace rasterproof::props
