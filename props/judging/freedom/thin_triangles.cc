#include "props/judging/freedom/thin_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <optional>

#include "core/elementary.h"
#include "core/profile.h"
#include "core/scene.h"
#include "model/snap.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "props/judging/freedom/outline.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// Geometry farther from the target than this can't come near a sample of it.
constexpr double kAround = 64;  // pixels
// How far a clipped vertex lies beside its edge, as a part of the largest coordinate that it was
// made of. A cut mixes from + part (to - from): the difference rounds by 2u of that coordinate, the
// product by as much, the sum by u; four cuts, 20u, are less than 32u. An error of `part` moves the
// vertex along its edge, kAround away from the target.
constexpr double kClipError = 0x1p-48;

// A vertex of the visible part, and the size of what it was computed from.
struct ClipCorner {
  double x = 0;
  double y = 0;
  double w = 0;
  double size = 0;
};

using Plane = std::function<double(const ClipCorner&)>;

ClipCorner Between(const ClipCorner& a, const ClipCorner& b, double at_a, double at_b) {
  const double part = at_a / (at_a - at_b);
  const auto mix = [part](double from, double to) { return from + part * (to - from); };
  return {mix(a.x, b.x), mix(a.y, b.y), mix(a.w, b.w), std::max(a.size, b.size)};
}

std::vector<ClipCorner> CutBy(const std::vector<ClipCorner>& polygon, const Plane& inside) {
  std::vector<ClipCorner> cut;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const ClipCorner& a = polygon[i];
    const ClipCorner& b = polygon[(i + 1) % polygon.size()];
    const double at_a = inside(a);
    const double at_b = inside(b);
    if (at_a >= 0) cut.push_back(a);
    if ((at_a >= 0) != (at_b >= 0)) cut.push_back(Between(a, b, at_a, at_b));
  }
  return cut;
}

// The part of the triangle that is seen on the target and kAround beside it. The four planes meet
// in the eye, so nothing behind it is left.
std::vector<ClipCorner> SeenPart(const std::array<Vertex, 3>& v, const Scene& scene) {
  std::vector<ClipCorner> part;
  for (const Vertex& p : v) {
    part.push_back({p.x, p.y, p.w, std::max({std::fabs(p.x), std::fabs(p.y), std::fabs(p.w)})});
  }
  const std::array<Plane, 4> planes{
      [](const ClipCorner& p) { return p.x + kAround * p.w; },
      [](const ClipCorner& p) { return p.y + kAround * p.w; },
      [&](const ClipCorner& p) { return (scene.width + kAround) * p.w - p.x; },
      [&](const ClipCorner& p) { return (scene.height + kAround) * p.w - p.y; }};
  for (const Plane& plane : planes) part = CutBy(part, plane);
  return part;
}

// Nothing if a corner's place is not known to a small part of the reach.
std::optional<std::vector<Point2>> Projected(const std::vector<ClipCorner>& part, double reach) {
  std::vector<Point2> places;
  for (const ClipCorner& p : part) {
    const double error =
        kClipError * p.size / p.w * (1 + std::fabs(p.x / p.w) + std::fabs(p.y / p.w));
    if (!(p.w > 0) || !(error <= reach / 8)) return std::nullopt;
    places.push_back({p.x / p.w, p.y / p.w});
  }
  return places;
}

double Across(Point2 a, Point2 b, Point2 p) {
  const double length = Hypot(b.x - a.x, b.y - a.y);
  return length == 0 ? 0 : ((p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x)) / length;
}

// Convex, either way round. Points within `reach` of it count.
bool LiesWithin(const std::vector<Point2>& polygon, Point2 p, double reach) {
  bool left = true;
  bool right = true;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i];
    const Point2 b = polygon[(i + 1) % polygon.size()];
    const double across = Across(a, b, p);
    left = left && across >= 0;
    right = right && across <= 0;
    if (VisibleEdge({a.x, a.y}, {b.x, b.y}).Distance(p) <= reach) return true;
  }
  return left || right;
}

// The reach that the freedom of places allows.
double ReachOfVertices(const PlacedCase& c) {
  const TargetProfile& profile = c.profile;
  const bool moves_pixels = !MovesClippedEdges(profile) && !IsUnclipped(c.scene, profile);
  if (profile.contract != Contract::kSampleExact || moves_pixels) {
    return std::sqrt(2.0) * kMovedOutlineMargin;
  }
  if (!profile.freedom.MovesVertices() || profile.snap.IsNone()) return 0;
  // A legal grid point lies within a step of the vertex, and so does the canonical one; and on each
  // axis.
  return std::sqrt(2.0) * 2 *
         std::ldexp(1.0, -LegalGrids(profile.snap, profile.freedom).front().bits);
}

}  // namespace

double WidthOf(std::span<const Point2> polygon) {
  double width = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point2 a = polygon[i];
    const Point2 b = polygon[(i + 1) % polygon.size()];
    double reaches = 0;
    for (const Point2 p : polygon) reaches = std::max(reaches, std::fabs(Across(a, b, p)));
    if (a != b) width = std::min(width, reaches);
  }
  return std::isinf(width) ? 0 : width;
}

double LegalReach(const PlacedCase& c) { return ReachOfVertices(c) + SampleReach(c.profile); }

ThinTriangles::ThinTriangles(const PlacedCase& c, double reach) : reach_(reach) {
  if (reach == 0) return;
  for (const Triangle& t : c.scene.triangles) {
    const std::array<Vertex, 3> v = Corners(c.scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    const std::vector<ClipCorner> seen = SeenPart(v, c.scene);
    if (seen.empty()) continue;
    std::optional<std::vector<Point2>> places = Projected(seen, reach);
    everywhere_ = everywhere_ || !places;
    if (!places) continue;
    // What passes behind the eye is drawn as the pieces that clipping leaves of it, each with
    // separate corners: a sliver among them may turn, however broad the whole is.
    const bool is_cut = std::ranges::any_of(v, [](const Vertex& p) { return !(p.w > 0); });
    // An eighth for the corners, on both sides.
    if (is_cut || WidthOf(*places) < 2.25 * reach) outlines_.push_back(std::move(*places));
  }
}

bool ThinTriangles::AreNear(Point2 p) const {
  if (everywhere_) return true;
  return std::ranges::any_of(outlines_, [&](const std::vector<Point2>& outline) {
    return LiesWithin(outline, p, 1.25 * reach_);
  });
}

}  // namespace rasterproof::props
