// Where in its pixel a sample may lie, inferred from drawings.
//
// Every set here is a little larger than what it stands for, never smaller: each line is moved
// outwards by more than doubles can be off. A region that is empty is empty, too, in exact numbers.
#ifndef RASTERPROOF_PROPS_JUDGING_FREEDOM_SAMPLE_REGION_H_
#define RASTERPROOF_PROPS_JUDGING_FREEDOM_SAMPLE_REGION_H_

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// Returns whether the profile leaves open where samples lie, but within their closed pixel. OpenGL
/// says that sample points may lie outside.
bool BoundsSamples(const Profile& profile);

/// The points with normal . (p - at) <= 0.
///
/// Domain:     a unit normal.
struct HalfPlane {
  Point2 at;
  Point2 normal;
  double error = 0;  ///< in pixels: how far doubles may have moved the line, on the target

  /// The signed distance of the line from p, in pixels.
  double Value(Point2 p) const { return normal.x * (p.x - at.x) + normal.y * (p.y - at.y); }
};

/// The points of all its half planes. None: the whole plane.
struct ConvexSet {
  std::vector<HalfPlane> sides;
};

/// The closed unit square of a pixel, by its corner of least window coordinates.
struct PixelSquare {
  Point2 corner;

  Point2 Centre() const { return {corner.x + 0.5, corner.y + 0.5}; }
};
/// Returns the square of pixel column x and row `row` from the top, under the profile's y axis.
PixelSquare SquareOf(const PlacedCase& c, int x, int row);

/// Returns whether the square and the set have no point in common, for certain.
bool AreApart(const PixelSquare& square, const ConvexSet& set);
/// Returns whether the square lies in the set's interior, for certain.
bool IsInside(const PixelSquare& square, const ConvexSet& set);

/// What every legal placing of a triangle has in common.
struct TriangleReach {
  ConvexSet most;                          ///< what is covered lies here
  std::optional<ConvexSet> least;          ///< whose interior is covered. Nothing: no point need be
  std::optional<int> facing;               ///< the sign of its area; nothing: it may turn
  std::array<ConvexSet, 3> around_corner;  ///< where each corner may lie
  bool is_clipped = false;                 ///< clipping may make vertices of it
};

/// Nothing if nothing is known of it: a corner is not finite, or clipping may move it anywhere.
///
/// Domain:     a window-space case whose profile states no extents and no side that is culled.
std::optional<TriangleReach> ReachOfTriangle(const PlacedCase& c, const Triangle& t);

/// Returns where the edge from corner `from` to the next may lie.
///
/// Domain:     a triangle of which something is known: see ReachOfTriangle().
ConvexSet ReachOfEdge(const PlacedCase& c, const Triangle& t, std::size_t from);

/// The places of one sample, in coordinates of its pixel: at first the whole closed square.
class SampleRegion {
 public:
  SampleRegion();

  /// Keeps what lies in one of the sets.
  void KeepWithin(const PixelSquare& square, std::span<const ConvexSet> sets);
  /// Keeps what lies in a box of the pixel's own coordinates.
  void KeepWithinBox(Point2 low, Point2 high);
  /// Takes the interior of the set away.
  void TakeAway(const PixelSquare& square, const ConvexSet& set);
  /// No point of the pixel will do.
  bool IsEmpty() const { return pieces_.empty(); }

 private:
  using Polygon = std::vector<Point2>;

  // More than this are not kept apart: what would make more is not taken into account.
  static constexpr std::size_t kMostPieces = 256;

  static Polygon Cut(const Polygon& polygon, const PixelSquare& square, const HalfPlane& half,
                     double slack);
  void Replace(std::vector<Polygon> pieces);

  std::vector<Polygon> pieces_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_FREEDOM_SAMPLE_REGION_H_
