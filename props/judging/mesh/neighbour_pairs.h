// Two neighbouring triangles, and the samples beside the edge that they share.
#ifndef RASTERPROOF_PROPS_JUDGING_MESH_NEIGHBOUR_PAIRS_H_
#define RASTERPROOF_PROPS_JUDGING_MESH_NEIGHBOUR_PAIRS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "props/judging/freedom/visible_edge.h"
#include "props/judging/mesh/mesh_freedom.h"
#include "props/judging/mesh/mesh_neighbours.h"
#include "props/judging/places.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// A few pairs of the case's neighbours that fold in no legal model, spread evenly.
class NeighbourPair {
 public:
  static std::vector<Neighbours> Some(const PlacedCase& c);

  /// The pair alone. Either space.
  NeighbourPair(const PlacedCase& c, const Neighbours& pair);

  /// The case with no other triangle.
  const PlacedCase& Alone() const { return alone_; }
  /// Whether the pair is not judged: a legal model folds or flattens it.
  bool IsOpen() const { return open_.IsFolded() || open_.IsFlat(); }

  /// The samples within a pixel of the shared edge that are nearer to it than to any other edge of
  /// the two: a disc around such a sample reaches the shared edge and no other, so that it lies
  /// inside the two triangles together. Away from their outline, where that may move: by the step
  /// to which a scanline's crossings are rounded, or by what a legal choice leaves open.
  std::vector<SamplePlace> SamplesBesideTheEdge() const;
  /// Whether a legal choice could turn a triangle that covers the sample: it is not judged.
  bool CanTurnAt(const SamplePlace& sample) const { return open_.CanTurnAt(sample.at); }
  /// Whether the two may have the sample as each clips the edge: neither clause nor model says that
  /// they do so alike.
  bool ClippingMayDecide(const SamplePlace& sample) const {
    return open_.ClippingMayDecide(sample.at);
  }
  /// Whether both triangles may have the sample, which lies on the edge.
  bool MayShare(const SamplePlace& sample, std::size_t index, std::uint32_t count) const;

  /// `so_far` violated by a sample that is covered so often; on the case that the pair is of.
  Verdict CoveredTimes(std::uint32_t count, const SamplePlace& sample, Verdict so_far) const;

 private:
  bool SharedEdgeIsNearest(Point2 p) const;

  Neighbours pair_;
  PlacedCase alone_;
  OpenParts open_;
  SharedTies ties_;
  std::optional<VisibleEdge> shared_;
  Point2 low_, high_;  ///< of the shared edge, a pixel further; all there is in clip space
  std::vector<VisibleEdge> outer_;
  double outer_moves_ = 0;  ///< in pixels, at most
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_MESH_NEIGHBOUR_PAIRS_H_
