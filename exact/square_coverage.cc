#include "exact/square_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "core/square_rule.h"
#include "core/vertex.h"
#include "exact/coverage.h"
#include "exact/spans.h"
#include "exact/square.h"

namespace rasterproof::exact {
namespace {

enum class Bound : std::uint8_t { kMust, kMay };

// A region within the one of every choice of places (kMust), or that contains all of them (kMay).
//
// A placed triangle T' lies in T + [-t, t]^2 and T in T' + [-t, t]^2, as their corners do. So T
// meets a square shrunk by t only if T' meets the square, and T' meets it only if T meets the one
// grown by t. T' holds what T holds grown by t, and T holds shrunk by t what T' holds.
SquareRegion WhateverIsChosen(SquareRegion region, double t, Bound bound) {
  if (region.geometry == SquareGeometry::kGiven || t == 0) return region;
  region.geometry = SquareGeometry::kGiven;
  const bool grows = (bound == Bound::kMay) == (region.relation == SquareRelation::kIntersects);
  region.half_width += grows ? t : -t;
  return region;
}

std::array<Point2, 3> PointsOf(const Scene& scene, const Triangle& t, const SquareFrame& frame) {
  const std::array<Vertex, 3> v = Corners(scene, t);
  std::array<Point2, 3> points;
  for (std::size_t k = 0; k < 3; ++k) points[k] = frame.ToScreen({v[k].x, v[k].y});
  return points;
}

bool IsFiniteTriangle(const Scene& scene, const Triangle& t) {
  return std::ranges::all_of(Corners(scene, t), [](const Vertex& v) { return IsFinite(v); });
}

// Moved by up to t on each axis, corners change twice the area by at most t times the sum of all
// |dx| + |dy|, and 6 t^2. The test leaves a margin for rounding.
bool MoveCanFlatten(const std::array<Point2, 3>& v, double t) {
  double sides = 0;
  double products = 0;
  for (unsigned k = 0; k < 3; ++k) {
    const Point2 a = v[k];
    const Point2 b = v[(k + 1) % 3];
    sides += std::fabs(b.x - a.x) + std::fabs(b.y - a.y);
    products += (std::fabs(a.x) + std::fabs(b.x)) * (std::fabs(a.y) + std::fabs(b.y));
  }
  const double area = (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);
  return !(std::fabs(area) > 1.0001 * (t * sides + 6 * t * t) + 0x1p-48 * products);
}

class Painter {
 public:
  Painter(const PlacedScene& scene, const DrawOptions& options)
      : given_(scene.scene),
        placed_(scene.placed),
        frame_{{0, 0, given_.width, given_.height}, scene.profile.y_axis == YAxis::kUp, 0},
        rule_(*scene.profile.squares),
        reach_(PlacingReach(scene.profile.snap, scene.profile.freedom)),
        profile_(scene.profile),
        cull_(options.cull) {
    if (frame_.y_up) frame_.lift = given_.height;
    if (const auto& s = options.scissor) {
      frame_.clip = {std::max(0, s->x0), std::max(0, s->y0), std::min(given_.width, s->x1),
                     std::min(given_.height, s->y1)};
    }
  }

  bool MayBeFlat(std::size_t t) const { return MayBeFlat(given_.triangles[t]); }
  bool MayBeFlat(const Triangle& t) const {
    if (reach_ != 0) return MoveCanFlatten(PointsOf(given_, t, frame_), reach_);
    return Facing(PointsOf(placed_, t, frame_)) == 0;
  }

  void Paint(Bound bound, CoverageCounts& counts) const {
    const auto& stated = bound == Bound::kMust ? rule_.must : rule_.may;
    if (!stated || frame_.clip.x0 >= frame_.clip.x1) return;
    const SquareRegion region = WhateverIsChosen(*stated, reach_, bound);
    if (region.half_width < kLeastHalfWidth) return;  // no pixel
    SpanTarget target(counts);
    for (std::size_t k = 0; k < given_.triangles.size(); ++k) {
      const Triangle& t = given_.triangles[k];
      if (IsDrawn(t) && Paints(t, bound) && !IsCulled(t, bound))
        PaintOne(t, region, target, counts);
    }
    target.Sum();
  }

 private:
  // A z that is no number may discard a triangle, which placing tells.
  bool IsDrawn(const Triangle& t) const {
    return IsFiniteTriangle(given_, t) && IsFiniteTriangle(placed_, t);
  }

  bool Paints(const Triangle& t, Bound bound) const {
    if (rule_.flat == FlatSquares::kDrawn) {
      // A vertex that is named twice: such triangles may be dropped before they are drawn.
      const bool repeats = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
      return bound == Bound::kMay || !repeats;
    }
    if (bound == Bound::kMay && (reach_ != 0 || rule_.flat == FlatSquares::kFree)) return true;
    return !MayBeFlat(t);
  }

  // One that may be flat has no facing that is sure.
  bool IsCulled(const Triangle& t, Bound bound) const {
    if (profile_.culls == Cull::kNone) return false;
    if (MayBeFlat(t)) return bound == Bound::kMust;
    return AlwaysCulls(profile_, Facing(PointsOf(placed_, t, frame_)));
  }

  void PaintOne(const Triangle& t, const SquareRegion& region, SpanTarget& target,
                CoverageCounts& counts) const {
    const int facing = Facing(PointsOf(placed_, t, frame_)) > 0 ? +1 : -1;
    if (cull_ == (facing > 0 ? Cull::kFront : Cull::kBack)) return;
    const bool given = region.geometry == SquareGeometry::kGiven;
    const std::array<Point2, 3> v = PointsOf(given ? given_ : placed_, t, frame_);
    ForEachSquareSpan(v, region, frame_, [&](int row, Columns columns) {
      for (int s = 0; s < counts.samples; ++s) {
        target.Row(row, s, facing).Add(columns.first, columns.last);
      }
    });
  }

  const Scene& given_;
  const Scene& placed_;
  SquareFrame frame_;
  SquareRule rule_;
  double reach_;
  const Profile& profile_;
  Cull cull_;
};

CoverageCounts Painted(const PlacedScene& scene, const DrawOptions& options, Bound bound) {
  CoverageCounts counts(scene.scene.width, scene.scene.height, scene.profile.pattern.samples());
  Painter(scene, options).Paint(bound, counts);
  return counts;
}

}  // namespace

double PlacingReach(const Snap& snap, const Freedom& freedom) {
  if (snap.IsNone() || !freedom.MovesVertices()) return 0;
  const bool by_rule = !freedom.any_rounding && !freedom.least_bits;
  const double steps = by_rule ? freedom.snap_tolerance : 1;
  const double reach =
      std::ldexp(steps, -std::min(snap.bits, freedom.least_bits.value_or(snap.bits)));
  return std::ceil(reach / kSquareStep) * kSquareStep;
}

CoverageCounts MustCover(const PlacedScene& scene, const DrawOptions& options) {
  return Painted(scene, options, Bound::kMust);
}

CoverageCounts MayCover(const PlacedScene& scene, const DrawOptions& options) {
  return Painted(scene, options, Bound::kMay);
}

bool MayBeFlat(const PlacedScene& scene, std::size_t t) { return Painter(scene, {}).MayBeFlat(t); }

CoverageCounts SquareCoverage(const PlacedScene& scene, const DrawOptions& options) {
  return scene.profile.squares->must ? MustCover(scene, options) : MayCover(scene, options);
}

}  // namespace rasterproof::exact
