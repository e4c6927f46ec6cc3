// Which samples of a triangle clipping can decide otherwise.
#ifndef RASTERPROOF_LEGAL_CLIPPED_TRIANGLE_H_
#define RASTERPROOF_LEGAL_CLIPPED_TRIANGLE_H_

#include <array>
#include <cstddef>
#include <optional>

#include "core/profile.h"
#include "core/snap.h"
#include "core/vertex.h"

namespace rasterproof::legal {

/// Where clipping leaves of an edge, whatever it does, one straight line.
struct StraightStretch {
  bool along_y = false;  ///< the axis on which the edge is longer
  bool rises = false;    ///< the edge goes up that axis
  /// Where it begins and ends on that axis: the moved edge passes between the two points.
  std::array<Point2, 2> first;
  std::array<Point2, 2> last;
};

/// A triangle that may be clipped to a rectangle, or to a wider one.
///
/// Where an edge leaves the rectangle, clipping makes a vertex. It lies exactly on the edge as
/// given, which no sentence says, and then goes to a grid point less than a step away on each axis;
/// so does the end inside. The edge thus moves by less than a step on each axis, and stays
/// straight. Neighbours need not take the same point. Edges with both ends inside stay.
class ClippedTriangle {
 public:
  /// `corners`: as given. `is_outside`: whether clipping may look at that one as outside.
  ///
  /// Domain:     finite; the corners and the box in the same axes. Without a grid no sentence says
  ///             how far new vertices may lie from the edge: a pixel, a reading.
  ClippedTriangle(const std::array<Point2, 3>& corners, const std::array<bool, 3>& is_outside,
                  const WindowBox& box, const Snap& grid);

  bool IsClipped() const { return leaves_[0] || leaves_[1] || leaves_[2]; }
  /// How far edges may move, in pixels, on each axis.
  double reach() const { return reach_; }
  /// Whether clipping may decide the sample: it is beside an edge that leaves, or it lies where the
  /// triangle is cut, or beyond.
  bool MayDecide(Point2 p) const;
  /// Whether clipping leaves the sample on its side of edge `e`, from corner e to the next.
  bool Keeps(std::size_t e, Point2 p) const;
  /// The edge that the sample is beside, if it is one edge that leaves, and the line that clipping
  /// puts in its place passes the sample: on which side, the other edges aside, decides it.
  std::optional<std::size_t> OnlyMovedEdge(Point2 p) const;
  /// Of an edge that leaves and has a sample as OnlyMovedEdge says.
  std::optional<StraightStretch> StraightStretchOf(std::size_t e) const;
  /// Whether edge `e` has an end that clipping may look at as outside.
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
