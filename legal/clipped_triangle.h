// Which samples of a triangle clipping can decide otherwise.
#ifndef RASTERPROOF_LEGAL_CLIPPED_TRIANGLE_H_
#define RASTERPROOF_LEGAL_CLIPPED_TRIANGLE_H_

#include <array>
#include <cstddef>

#include "core/profile.h"
#include "core/snap.h"
#include "core/vertex.h"

namespace rasterproof::legal {

/// A triangle that may be clipped to a rectangle, or to a wider one.
///
/// Where an edge leaves the rectangle, clipping makes a vertex. It lies exactly on the edge as
/// given, which no sentence says, and then goes to a grid point less than a step away on each axis;
/// so does the end inside. The edge thus moves by less than a step on each axis. Neighbours need
/// not take the same point. Edges with both ends inside stay.
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

 private:
  bool IsBeside(std::size_t e, Point2 p) const;

  std::array<Point2, 3> corners_;
  std::array<bool, 3> is_outside_;
  std::array<bool, 3> leaves_;  ///< by edge
  double reach_;
  WindowBox inner_;  ///< new vertices do not lie inside
};

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_CLIPPED_TRIANGLE_H_
