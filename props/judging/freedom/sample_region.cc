#include "props/judging/freedom/sample_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "core/clauses/clauses.h"
#include "core/elementary.h"
#include "core/profile.h"
#include "props/judging/freedom/free_choices.h"

namespace rasterproof::props {
namespace {

// With u = 2^-53 and all coordinates below L, a difference is off by u L, and so is the line's
// direction over its length l: at a point at most 2L away that displaces the line by less than
// 8u L (1 + L / l). Products and sums add less than 16u L. 2^-46 is 128u. Intersections within a
// pixel are off by a few u each, at most some thousand of them: less than kLeastError.
constexpr double kErrorPerCoordinate = 0x1p-46;
constexpr double kLeastError = 0x1p-30;
// A triangle that is clipped: each point of what remains of its outline lies within a grid step of
// the outline on each axis, and a step is a pixel at most. Two pixels are more than the diagonal of
// that.
constexpr double kClippedMargin = 2;

double ErrorOf(double largest, double length) {
  return kLeastError + kErrorPerCoordinate * (largest + 1) * (1 + (largest + 1) / length);
}

// The line from a to b, and what lies on the side where E(a, b; p) has the sign of `side`, or on
// the line. Nothing if a and b are one point.
std::optional<HalfPlane> Beside(Point2 a, Point2 b, int side, double largest) {
  const Point2 d{b.x - a.x, b.y - a.y};
  const double length = Hypot(d.x, d.y);
  if (!(length > 0)) return std::nullopt;
  const double sign = side > 0 ? -1 : 1;  // E = (p.x - a.x) d.y - (p.y - a.y) d.x
  return HalfPlane{a, {sign * d.y / length, -sign * d.x / length}, ErrorOf(largest, length)};
}

ConvexSet BoxOf(Point2 low, Point2 high, double largest) {
  const double error = ErrorOf(largest, 1);
  return {
      {{low, {-1, 0}, error}, {low, {0, -1}, error}, {high, {1, 0}, error}, {high, {0, 1}, error}}};
}

double Turn(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// One half of the outline of a convex hull: of points by x, or of the same from right to left.
void AddHalfHull(const std::vector<Point2>& points, std::vector<Point2>& hull) {
  const std::size_t first = hull.size();
  for (const Point2 p : points) {
    while (hull.size() >= first + 2 && Turn(hull[hull.size() - 2], hull.back(), p) >= 0)
      hull.pop_back();
    hull.push_back(p);
  }
  hull.pop_back();  // the first of the other half
}

// A point that rounding leaves out of the hull lies within the error of one of its lines.
ConvexSet HullOf(std::vector<Point2> points, double largest) {
  const auto before = [](Point2 a, Point2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); };
  std::ranges::sort(points, before);
  Point2 low = points.front();
  Point2 high = low;
  for (const Point2 p : points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  std::vector<Point2> hull;
  AddHalfHull(points, hull);
  std::ranges::reverse(points);
  AddHalfHull(points, hull);
  ConvexSet set = BoxOf(low, high, largest);
  for (std::size_t k = 0; k < hull.size(); ++k) {
    // From left to right and back, the rest lies where E < 0.
    if (const auto side = Beside(hull[k], hull[(k + 1) % hull.size()], -1, largest))
      set.sides.push_back(*side);
  }
  return set;
}

using Places = std::array<LegalPlaces, 3>;

// The sign of the area for all places of the corners, for certain.
std::optional<int> FacingOf(const Places& places, double largest) {
  const double error = kErrorPerCoordinate * (largest + 1) * (largest + 1);
  double least = INFINITY;
  double most = -INFINITY;
  for (const Point2 a : CornersOf(places[0])) {
    for (const Point2 b : CornersOf(places[1])) {
      for (const Point2 p : CornersOf(places[2])) {
        least = std::min(least, Turn(a, b, p));
        most = std::max(most, Turn(a, b, p));
      }
    }
  }
  if (least > error) return 1;
  if (most < -error) return -1;
  return std::nullopt;
}

// The points that lie on the triangle's side of each edge wherever its ends are: E is affine in
// each end, and so has its extremes at corners of their places.
ConvexSet CoreOf(const Places& places, int facing, double largest) {
  ConvexSet core;
  for (std::size_t i = 0; i < 3; ++i) {
    for (const Point2 a : CornersOf(places[i])) {
      for (const Point2 b : CornersOf(places[(i + 1) % 3]))
        core.sides.push_back(*Beside(a, b, facing, largest));  // apart: the area is not zero
    }
  }
  return core;
}

HalfPlane Inwards(HalfPlane side, double pixels) {
  side.at = {side.at.x - pixels * side.normal.x, side.at.y - pixels * side.normal.y};
  return side;
}

// What clipping to the box, or to a wider one, leaves of a triangle wherever it puts new vertices.
ConvexSet CoreOfClipped(const std::array<Vertex, 3>& v, const WindowBox& box, int facing,
                        double largest) {
  ConvexSet core = BoxOf({box.x0, box.y0}, {box.x1, box.y1}, largest);
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2 a = WindowPoint(v[i]);
    const Point2 b = WindowPoint(v[(i + 1) % 3]);
    core.sides.push_back(*Beside(a, b, facing, largest));
  }
  for (HalfPlane& side : core.sides) side = Inwards(side, kClippedMargin);
  return core;
}

bool Contains(const WindowBox& box, const LegalPlaces& places, const Vertex& v) {
  return box.Contains(places.low.x, places.low.y) && box.Contains(places.high.x, places.high.y) &&
         box.Contains(v.x, v.y);
}

double LargestOf(const PlacedCase& c, const Places& places) {
  double largest = std::max(c.scene.width, c.scene.height);
  for (const auto& [low, high] : places) {
    for (const double x : {low.x, low.y, high.x, high.y}) largest = std::max(largest, std::fabs(x));
  }
  return largest;
}

std::array<Point2, 4> ExtremesOf(const PixelSquare& square) {
  const auto [x, y] = square.corner;
  return {{{x, y}, {x + 1, y}, {x + 1, y + 1}, {x, y + 1}}};
}

}  // namespace

bool BoundsSamples(const Profile& profile) {
  if (profile.sample_positions == SamplePositions::kStated) return false;
  const Specification* const specification = SpecificationOf(profile);
  return specification == nullptr || specification->api != "gl";
}

PixelSquare SquareOf(const PlacedCase& c, int x, int row) {
  const int above = c.profile.y_axis == YAxis::kUp ? c.scene.height - 1 - row : row;
  return {{static_cast<double>(x), static_cast<double>(above)}};
}

bool AreApart(const PixelSquare& square, const ConvexSet& set) {
  const std::array<Point2, 4> corners = ExtremesOf(square);
  return std::ranges::any_of(set.sides, [&](const HalfPlane& side) {
    return std::ranges::all_of(corners, [&](Point2 p) { return side.Value(p) > side.error; });
  });
}

bool IsInside(const PixelSquare& square, const ConvexSet& set) {
  const std::array<Point2, 4> corners = ExtremesOf(square);
  return std::ranges::all_of(set.sides, [&](const HalfPlane& side) {
    return std::ranges::all_of(corners, [&](Point2 p) { return side.Value(p) < -side.error; });
  });
}

std::optional<TriangleReach> ReachOfTriangle(const PlacedCase& c, const Triangle& t) {
  const std::array<Vertex, 3> v = Corners(c.scene, t);
  if (!std::ranges::all_of(v, IsFinite)) return std::nullopt;
  const std::optional<Places> places = LegalPlacesOf(c, t);
  if (!places) return std::nullopt;
  const double largest = LargestOf(c, *places);
  TriangleReach reach;
  std::vector<Point2> corners;
  const std::optional<WindowBox> box = UnclippedBox(c.profile, c.scene.width, c.scene.height);
  for (std::size_t k = 0; k < 3; ++k) {
    const LegalPlaces& corner = (*places)[k];
    for (const Point2 p : CornersOf(corner)) corners.push_back(p);
    reach.around_corner[k] = BoxOf(corner.low, corner.high, largest);
    reach.is_clipped = reach.is_clipped || (box && !Contains(*box, corner, v[k]));
  }
  reach.most = HullOf(std::move(corners), largest);
  reach.facing = FacingOf(*places, largest);
  if (reach.facing) {
    reach.least = reach.is_clipped ? CoreOfClipped(v, *box, *reach.facing, largest)
                                   : CoreOf(*places, *reach.facing, largest);
  }
  return reach;
}

ConvexSet ReachOfEdge(const PlacedCase& c, const Triangle& t, std::size_t from) {
  const Places places = *LegalPlacesOf(c, t);
  std::vector<Point2> ends = CornersOf(places[from]);
  for (const Point2 p : CornersOf(places[(from + 1) % 3])) ends.push_back(p);
  return HullOf(std::move(ends), LargestOf(c, places));
}

SampleRegion::SampleRegion() {
  constexpr double kLow = -kLeastError;
  constexpr double kHigh = 1 + kLeastError;
  pieces_ = {{{kLow, kLow}, {kHigh, kLow}, {kHigh, kHigh}, {kLow, kHigh}}};
}

// The part with values up to `slack`.
SampleRegion::Polygon SampleRegion::Cut(const Polygon& polygon, const PixelSquare& square,
                                        const HalfPlane& half, double slack) {
  const Point2 at{half.at.x - square.corner.x, half.at.y - square.corner.y};
  const HalfPlane local{at, half.normal, half.error};
  Polygon part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point2 p = polygon[k];
    const Point2 q = polygon[(k + 1) % polygon.size()];
    const double here = local.Value(p) - slack;
    const double there = local.Value(q) - slack;
    if (here <= 0) part.push_back(p);
    if ((here <= 0) == (there <= 0)) continue;
    const double share = here / (here - there);
    part.push_back({p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
  }
  return part;
}

void SampleRegion::Replace(std::vector<Polygon> pieces) {
  if (pieces.size() <= kMostPieces) pieces_ = std::move(pieces);
}

void SampleRegion::KeepWithin(const PixelSquare& square, std::span<const ConvexSet> sets) {
  std::vector<Polygon> kept;
  for (const ConvexSet& set : sets) {
    for (const Polygon& piece : pieces_) {
      Polygon part = piece;
      for (const HalfPlane& side : set.sides) part = Cut(part, square, side, side.error);
      if (!part.empty()) kept.push_back(std::move(part));
    }
  }
  Replace(std::move(kept));
}

void SampleRegion::KeepWithinBox(Point2 low, Point2 high) {
  KeepWithin(PixelSquare{}, std::array{BoxOf(low, high, 1)});
}

void SampleRegion::TakeAway(const PixelSquare& square, const ConvexSet& set) {
  std::vector<Polygon> kept;
  for (const Polygon& piece : pieces_) {
    Polygon rest = piece;  // the part beyond no side yet; overlaps what is kept by half the error
    for (const HalfPlane& side : set.sides) {
      const HalfPlane beyond{side.at, {-side.normal.x, -side.normal.y}, side.error};
      Polygon part = Cut(rest, square, beyond, side.error);
      if (!part.empty()) kept.push_back(std::move(part));
      rest = Cut(rest, square, side, -side.error / 2);
    }
  }
  Replace(std::move(kept));
}

}  // namespace rasterproof::props
