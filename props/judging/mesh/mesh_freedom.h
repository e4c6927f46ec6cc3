// What a profile leaves open about the samples of a mesh.
//
// Properties of meshes want each inner sample covered exactly once. OpenParts names the samples
// where that is not stated, so that they are not judged; SharedTies those that may be covered more
// than once. For single triangles, see facing_freedom.h.
#ifndef RASTERPROOF_PROPS_JUDGING_MESH_MESH_FREEDOM_H_
#define RASTERPROOF_PROPS_JUDGING_MESH_MESH_FREEDOM_H_

#include <cstddef>
#include <cstdint>
#include <optional>

#include "legal/allowed.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/freedom/outline.h"
#include "props/judging/freedom/thin_triangles.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// The samples that more than one triangle of a mesh may cover. There are none unless
/// legal::SharesTies(). Otherwise they are the samples on the mesh's edges; if the profile leaves
/// the places of vertices free, all samples near its edges.
class SharedTies {
 public:
  explicit SharedTies(const PlacedCase& c);

  /// Returns whether the sample at `at` may be covered `count` times, where `count` is more than a
  /// mesh without shared samples would have. A count that is not more needs no permission.
  ///
  /// Shape:      `index` is that of the sample in counts of the case's target.
  bool Allow(std::uint32_t count, std::size_t index, Point2 at) const {
    return allowed_ ? count <= allowed_->Most(index) : edges_.IsNear(at);
  }

 private:
  std::optional<legal::Allowed> allowed_;
  Outline edges_;
};

/// The parts of a mesh where a legal choice may decide what is covered: its outline, triangles that
/// can turn over, and edges that clipping can move.
class OpenParts {
 public:
  /// `spares_outline`: the samples next to the outline count as open even if the profile has one
  /// model. Use it where another property judges these samples.
  OpenParts(const PlacedCase& c, bool spares_outline);

  /// Returns whether two triangles face opposite ways. Triangles that can turn over do not count:
  /// see CanTurnAt().
  bool IsFolded() const { return is_folded_; }
  /// Returns whether a mesh around the eye has a triangle whose plane holds the eye. Such a mesh is
  /// not judged unless the profile has one model. Always false of other meshes.
  bool IsFlat() const { return is_flat_; }
  bool IsBesideTheOutline(Point2 p) const { return outline_.IsNear(p); }
  bool CanTurnAt(Point2 p) const { return open_.CanCover(p) || thin_.AreNear(p); }
  bool ClippingMayDecide(Point2 p) const { return clipped_.MayDecide(p); }

 private:
  bool is_folded_ = false;
  bool is_flat_ = false;
  Outline outline_;
  OpenTriangles open_;
  ClippedEdges clipped_;
  ThinTriangles thin_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_MESH_MESH_FREEDOM_H_
