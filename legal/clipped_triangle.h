// The samples of a triangle whose coverage clipping can change.
#ifndef RASTERPROOF_LEGAL_CLIPPED_TRIANGLE_H_
#define RASTERPROOF_LEGAL_CLIPPED_TRIANGLE_H_

#include <array>
#include <cstddef>
#include <optional>

#include "core/profile.h"
#include "core/snap.h"
#include "core/vertex.h"

namespace rasterproof::legal {

/// A stretch of an edge in which every legal clipping leaves one straight line.
struct StraightStretch {
  bool along_y = false;  ///< the axis on which the edge is longer
  bool rises = false;    ///< the edge goes up that axis
  /// Where it begins and ends on that axis: the moved edge passes between the two points.
  std::array<Point2, 2> first;
  std::array<Point2, 2> last;
};

/// A triangle that may be clipped to a rectangle, or to a wider one.
///
/// Where an edge leaves the rectangle, clipping makes a vertex. We take it to lie exactly on the
/// given edge, though no specification says so, and then to go to a grid point less than a step
/// away on each axis, as does the end inside. The edge thus moves by less than a step on each axis
/// and stays straight. Neighbours may choose different points. Edges with both ends inside stay.
class ClippedTriangle {
 public:
  /// `corners`: as given. `is_outside`: whether clipping may treat the corner as outside.
  ///
  /// Domain:     finite; the corners and the box in the same axes. Without a grid no specification
  ///             says how far new vertices may lie from the edge: we take one pixel.
  ClippedTriangle(const std::array<Point2, 3>& corners, const std::array<bool, 3>& is_outside,
                  const WindowBox& box, const Snap& grid);

  bool IsClipped() const { return leaves_[0] || leaves_[1] || leaves_[2]; }
  /// How far edges may move, in pixels, on each axis.
  double reach() const { return reach_; }
  /// Whether clipping may decide the sample: it is next to an edge that leaves, or it lies at or
  /// beyond a cut through the triangle.
  bool MayDecide(Point2 p) const;
  /// Whether clipping leaves the sample on its side of edge `e`, from corner e to the next.
  bool Keeps(std::size_t e, Point2 p) const;
  /// Whether the sample is out of reach of the triangle and of every piece that clipping makes of
  /// it: their corners lie less than the reach, and what places of corners differ by, `moved`, from
  /// the given triangle on each axis. Holds for triangles without area too.
  bool IsFarFrom(Point2 p, double moved) const;
  /// The edge next to the sample, if exactly one edge that leaves is, and its moved line passes the
  /// sample: the line's side of it, apart from the other edges, then decides.
  std::optional<std::size_t> OnlyMovedEdge(Point2 p) const;
  /// Domain:     an edge that OnlyMovedEdge() returned for some sample.
  std::optional<StraightStretch> StraightStretchOf(std::size_t e) const;
  /// Whether edge `e` has an end that clipping may treat as outside.
  bool Leaves(std::size_t e) const { return leaves_[e]; }

 private:
  bool IsBeside(std::size_t e, Point2 p) const;
  bool IsInner(Point2 p) const {
    return p.x > inner_.x0 && p.x < inner_.x1 && p.y > inner_.y0 && p.y < inner_.y1;
  }

  std::array<Point2, 3> corners_;
  std::array<bool, 3> is_outside_;
  std::array<bool, 3> leaves_;  ///< by edge
  double reach_;
  WindowBox box_;
  WindowBox inner_;  ///< new vertices do not lie inside
};

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_CLIPPED_TRIANGLE_H_
