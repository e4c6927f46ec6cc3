// The samples of a mesh that legal choices leave open: those that are not judged, and those that
// may be covered more than once.
#ifndef RASTERPROOF_PROPS_JUDGING_MESH_FREEDOM_H_
#define RASTERPROOF_PROPS_JUDGING_MESH_FREEDOM_H_

#include <cstddef>
#include <cstdint>

#include "core/coverage.h"
#include "props/judging/free_choices.h"
#include "props/judging/outline.h"
#include "props/judging/thin_triangles.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// Whether every triangle may have the samples on its edges: edge_samples may be shared, or the tie
/// rule is inclusive.
bool SharesTies(const Profile& profile);

/// The samples that more than one triangle of a mesh may cover: those on its edges, where the
/// profile lets every triangle have them; near its edges, where those may lie elsewhere.
class SharedTies {
 public:
  explicit SharedTies(const PlacedCase& c);

  /// Whether the sample may be covered this often. `index`: in counts of the case's target.
  bool Allow(std::uint32_t count, std::size_t index, Point2 at) const {
    return most_.size() != 0 ? count <= most_.Count(index) : edges_.IsNear(at);
  }

 private:
  CoverageCounts most_;
  Outline edges_;
};

/// A mesh's outline, and its triangles that a legal choice can turn.
class OpenParts {
 public:
  /// `spares_outline`: another property judges the samples next to the outline.
  OpenParts(const PlacedCase& c, bool spares_outline);

  /// Whether triangles face opposite ways, in some legal model.
  bool IsFolded() const { return is_folded_; }
  /// Around the eye: triangles in a plane with it are not judged.
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

#endif  // RASTERPROOF_PROPS_JUDGING_MESH_FREEDOM_H_
