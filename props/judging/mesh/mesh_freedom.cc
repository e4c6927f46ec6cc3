#include "props/judging/mesh/mesh_freedom.h"

#include <algorithm>

#include "core/profile.h"
#include "core/scene.h"
#include "legal/owners.h"
#include "model/snap_scene.h"
#include "props/judging/mesh/mesh_model.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

bool LiesAroundTheEye(const Scene& scene) {
  return scene.clip_space &&
         std::ranges::any_of(scene.vertices, [](const Vertex& v) { return !(v.w > 0); });
}

}  // namespace

SharedTies::SharedTies(const PlacedCase& c) {
  if (!legal::SharesTies(c.profile)) return;
  if (LegalReach(c) != 0) {
    edges_ = Outline::OfAllEdges(c, LegalReach(c));
    return;
  }
  allowed_.emplace(c, legal::Sight{.coverage = CoverageKind::kCounts}, WholeTarget(c));
}

OpenParts::OpenParts(const PlacedCase& c, bool spares_outline) {
  const bool one_model = HasOneModel(c.profile) && IsUnclipped(c.scene, c.profile);
  if (one_model || LiesAroundTheEye(c.scene)) {
    const MeshFacings facings = FacingsOf(c);
    is_folded_ = facings.folded;
    is_flat_ = !one_model && facings.degenerate != 0;
  }
  if (one_model) {
    if (spares_outline) outline_ = Outline(c);
    return;
  }
  double most_moved = LegalReach(c);
  if (LiesAroundTheEye(c.scene)) {
    thin_ = ThinTriangles(c, most_moved);
  } else {
    open_ = OpenTriangles(c);
    clipped_ = ClippedEdges(c);
    is_folded_ = open_.RestIsFolded();
    most_moved = open_.MostMoved();
  }
  outline_ = Outline::OfMoved(c, most_moved);
}

}  // namespace rasterproof::props
