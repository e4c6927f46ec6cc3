#include "props/catalog/degenerate.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "model/snap_scene.h"
#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {
namespace {

bool HasNoArea(const Scene& scene, const std::array<Vertex, 3>& v) {
  if (scene.clip_space) return exact::HomogeneousFacing(v) == 0;
  return exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])}) == 0;
}

}  // namespace

std::vector<std::size_t> FlatTriangles(const Case& c) {
  // What the profile drops for its extent has an area all the same.
  Profile all_sizes = c.profile;
  all_sizes.max_extent.reset();
  const Scene snapped = c.scene.clip_space ? c.scene : SnapScene(c.scene, all_sizes);
  std::vector<std::size_t> flat;
  for (std::size_t t = 0; t < snapped.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = Corners(snapped, snapped.triangles[t]);
    if (std::ranges::all_of(v, IsFinite) && HasNoArea(snapped, v)) flat.push_back(t);
  }
  return flat;
}

Verdict DegenerateTrianglesCoverNothing(Subject& subject, const Case& c) {
  if (c.profile.zero_area == ZeroArea::kUnspecified) {
    return Verdict::NotApplicable("the profile leaves triangles of zero area unspecified");
  }
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  if (c.scene.clip_space && !c.profile.snap.IsNone()) {
    return {Outcome::kNotExercised, 0, 0, "the area after the division and snapping is not decided",
            std::nullopt};
  }
  const std::vector<std::size_t> flat = FlatTriangles(c);
  if (flat.empty()) return {Outcome::kNotExercised, 0, 0, "every triangle has area", std::nullopt};
  const Case alone = OnlyTriangles(c, flat);
  const CoverageCounts observed = Drawn(subject, alone.scene, c.profile, WholeTarget(c));
  const CoverageCounts nothing(c.scene.width, c.scene.height, c.profile.lattice.samples());
  Verdict verdict = SameCounts(observed, nothing, flat.size(), "none, the area is zero,");
  if (verdict.witness) BlameTriangle(subject, c, WholeTarget(c), *verdict.witness);
  return verdict;
}

}  // namespace rasterproof::props
