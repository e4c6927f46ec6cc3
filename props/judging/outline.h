// The neighbourhood of a mesh's outline, where what it covers is not always stated.
#ifndef RASTERPROOF_PROPS_JUDGING_OUTLINE_H_
#define RASTERPROOF_PROPS_JUDGING_OUTLINE_H_

#include <vector>

#include "core/vertex.h"
#include "props/judging/mesh_neighbours.h"
#include "props/judging/visible_edge.h"
#include "props/placed_case.h"

namespace rasterproof::props {

// How far from the outline a sample must be where the outline is not judged. Edge values of float32
// displace an edge by at most a few 2^-24 of the largest coordinate (docs/mathematics.md, forward
// bounds): 2^-18 of it is generous. A watertight subject may also have moved its vertices by
// snapping them to its own grid: a pixel on each axis is generous for that.
inline constexpr double kOutlineMarginPerCoordinate = 0x1p-18;
inline constexpr double kOutlineMargin = 0x1p-10;
inline constexpr double kMovedOutlineMargin = 1;
// A sample whose place in its pixel is not stated lies at most a diagonal from any other place.
inline constexpr double kSampleMargin = 1.4142135623730952;

/// How far a sample may lie from where the profile's pattern has it.
inline double SampleReach(const Profile& profile) {
  return profile.sample_positions == SamplePositions::kStated ? 0 : kSampleMargin;
}

/// The samples beside some edges of a mesh: those of its boundary, or all.
class Outline {
 public:
  /// No outline: nothing is near.
  Outline() = default;
  /// The boundary of what the canonical model draws; in clip space as given.
  explicit Outline(const PlacedCase& c);
  /// The subject may have moved the boundary, by choosing other grid points than the canonical
  /// ones, by snapping its vertices to its own grid or by clipping it: by this many pixels, or by
  /// one if that is more. Edges cancel only if they are one in every legal model.
  /// Where the profile's tie_ownership states an owner on shared edges alone, vertices count as
  /// well; where it states none, all edges do.
  static Outline OfMoved(const PlacedCase& c, double most_moved);
  /// The same of every edge of every triangle.
  static Outline OfAllEdges(const PlacedCase& c, double most_moved);

  bool IsNear(Point2 p) const;
  bool IsEmpty() const { return edges_.empty() && vertices_.empty(); }

 private:
  struct SeenEdge {
    VisibleEdge seen;
    double margin = 0;
  };

  struct SeenVertex {
    Point2 at;
    double margin = 0;
  };

  void Add(const Scene& scene, const BoundaryEdge& edge, double moved);
  void AddVertices(const Scene& scene, double moved);

  std::vector<SeenEdge> edges_;
  std::vector<SeenVertex> vertices_;
  double largest_ = 0;  ///< window coordinate
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_OUTLINE_H_
