#include "props/judging/mesh/mesh_model.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/winding.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// Signed coverage *is* the winding number (docs/mathematics.md, sections 4 and 6).
std::vector<std::int64_t> WindingAroundTheEye(const PlacedCase& c) {
  exact::PlacedScene scene = c;
  if (!scene.profile.tie_rule.IsConsistent()) scene.profile.tie_rule = kTopLeft;
  const CoverageCounts counts = exact::Coverage(scene);
  std::vector<std::int64_t> winding(counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) winding[k] = counts.Signed(k);
  return winding;
}

}  // namespace

MeshFacings FacingsOf(const PlacedCase& c) {
  const auto fronts = static_cast<std::size_t>(std::ranges::count(c.facings, 1));
  const auto backs = static_cast<std::size_t>(std::ranges::count(c.facings, -1));
  std::size_t finite = 0;
  for (const Triangle& t : c.placed.triangles) {
    if (std::ranges::all_of(Corners(c.placed, t), IsFinite)) ++finite;
  }
  return {fronts != 0 && backs != 0, finite - fronts - backs};
}

std::vector<std::int64_t> WindingOf(const PlacedCase& c) {
  return c.placed.clip_space ? WindingAroundTheEye(c) : exact::BoundaryWinding(c);
}

}  // namespace rasterproof::props
