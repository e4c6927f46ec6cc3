#include "props/judging/mesh_model.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/snap_clip.h"
#include "exact/winding.h"
#include "model/target_model.h"

namespace rasterproof::props {
namespace {

bool Snaps(const Case& c) {
  return !ForTarget(c.profile, c.scene.width, c.scene.height).snap.IsNone();
}

// The window-space scene that a clip-space one becomes on the grid, under a profile that leaves it
// where it is.
Case OnTheGrid(const Case& c) {
  Case window = c;
  window.scene = exact::SnapClipScene(c.scene, c.profile);
  window.profile = ForTarget(c.profile, c.scene.width, c.scene.height);
  window.profile.by_target_size.clear();
  window.profile.snap = {};
  return window;
}

MeshFacings WindowFacings(const Case& c) {
  const exact::MeshShape shape = exact::ShapeOf(c.scene, c.profile);
  return {shape.folded, shape.degenerate};
}

MeshFacings FacingsFromTheEye(const Scene& scene) {
  MeshFacings facings;
  bool front = false;
  bool back = false;
  for (const Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = Corners(scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    const int facing = exact::HomogeneousFacing(v);
    front = front || facing > 0;
    back = back || facing < 0;
    if (facing == 0) ++facings.degenerate;
  }
  facings.folded = front && back;
  return facings;
}

// Signed coverage *is* the winding number (docs/mathematics.md, sections 4 and 6).
std::vector<std::int64_t> WindingAroundTheEye(const Case& c) {
  Profile profile = ForTarget(c.profile, c.scene.width, c.scene.height);
  profile.by_target_size.clear();
  if (!profile.tie_rule.IsConsistent()) profile.tie_rule = kTopLeft;
  const CoverageCounts counts = exact::Coverage(c.scene, profile);
  std::vector<std::int64_t> winding(counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) winding[k] = counts.Signed(k);
  return winding;
}

}  // namespace

MeshFacings FacingsOf(const Case& c) {
  if (!c.scene.clip_space) return WindowFacings(c);
  return Snaps(c) ? WindowFacings(OnTheGrid(c)) : FacingsFromTheEye(c.scene);
}

std::vector<std::int64_t> WindingOf(const Case& c) {
  if (!c.scene.clip_space) return exact::BoundaryWinding(c.scene, c.profile);
  if (!Snaps(c)) return WindingAroundTheEye(c);
  const Case window = OnTheGrid(c);
  return exact::BoundaryWinding(window.scene, window.profile);
}

}  // namespace rasterproof::props
