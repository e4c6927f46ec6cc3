// The part of an edge that is seen: in front of the eye, as the window shows it.
#ifndef RASTERPROOF_PROPS_JUDGING_FREEDOM_VISIBLE_EDGE_H_
#define RASTERPROOF_PROPS_JUDGING_FREEDOM_VISIBLE_EDGE_H_

#include <array>
#include <optional>

#include "core/vertex.h"
#include "exact/rational.h"

namespace rasterproof::props {

/// The segment between two vertices (x / w, y / w) with w > 0; a ray if the edge passes behind the
/// eye; nothing if both ends have w <= 0. In window space w is 1.
class VisibleEdge {
 public:
  /// Domain:     finite vertices.
  VisibleEdge(const Vertex& a, const Vertex& b);

  bool IsEmpty() const { return !seen_; }
  /// From p to the nearest point of it, in pixels.
  ///
  /// Returns:    infinity if it is empty; 0 if doubles can't decide.
  /// Error:      a few ulps of the largest coordinate: for choices, not for verdicts.
  double Distance(Point2 p) const;
  /// The square of that distance, exactly; nothing if it is empty.
  std::optional<exact::Rational> SquaredDistance(Point2 p) const;

 private:
  Vertex a_;
  Vertex b_;
  bool seen_ = false;
  bool is_ray_ = false;
  Point2 start_;
  Point2 along_;  ///< to the other end; of a ray: its direction
};

/// The edge of a triangle that is nearest to a sample: the one opposite vertex `edge`.
///
/// Returns:    -1 if none of them is seen.
/// Error:      none. Of equally near ones the first.
int NearestEdge(const std::array<Vertex, 3>& v, Point2 p);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FREEDOM_VISIBLE_EDGE_H_
