#include "subjects/mutants/clipping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "subjects/mutants/placing.h"

namespace rasterproof::subjects::mutants {
namespace {

using Polygon = std::vector<Point2>;

// A side of the rectangle: x or y at most, or at least, so much.
struct Side {
  bool is_x = false;
  double at = 0;
  double sign = 1;  ///< +1: at most

  double Of(Point2 p) const { return is_x ? p.x : p.y; }
  bool Holds(Point2 p) const { return sign * Of(p) <= sign * at; }
};

// One for both directions of the edge.
Point2 Crossing(Point2 a, Point2 b, const Side& side) {
  if (std::pair(b.x, b.y) < std::pair(a.x, a.y)) std::swap(a, b);
  const double part = (side.at - side.Of(a)) / (side.Of(b) - side.Of(a));
  if (side.is_x) return {side.at, a.y + part * (b.y - a.y)};
  return {a.x + part * (b.x - a.x), side.at};
}

// Sutherland and Hodgman's, of one side.
Polygon Clipped(const Polygon& polygon, const Side& side) {
  Polygon clipped;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point2 a = polygon[k];
    const Point2 b = polygon[(k + 1) % polygon.size()];
    if (side.Holds(a)) clipped.push_back(a);
    if (side.Holds(a) != side.Holds(b)) clipped.push_back(Crossing(a, b, side));
  }
  return clipped;
}

// The vertices on the side move along it, away from their middle.
void Widen(Polygon& polygon, const Side& side, double by) {
  double least = HUGE_VAL;
  double most = -HUGE_VAL;
  const auto along = [&](Point2& p) -> double& { return side.is_x ? p.y : p.x; };
  for (Point2& p : polygon) {
    if (side.Of(p) != side.at) continue;
    least = std::min(least, along(p));
    most = std::max(most, along(p));
  }
  for (Point2& p : polygon) {
    if (side.Of(p) == side.at) along(p) += 2 * along(p) < least + most ? -by : by;
  }
}

class ClippingSubject final : public Subject {
 public:
  ClippingSubject(const std::string& name, const std::string& summary, ClippingStages stages)
      : stages_(std::move(stages)), base_(Make(name, summary, stages_.base)) {
    info_ = base_->Info();
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    const double far = stages_.beyond;
    const WindowBox box{-far, -far, scene.width + far, scene.height + far};
    Scene one = scene;
    for (const Triangle& t : scene.triangles) {
      const std::array<Vertex, 3> v = Corners(scene, t);
      const bool is_inside =
          std::ranges::all_of(v, [&](const Vertex& p) { return box.Contains(p.x, p.y); });
      const bool has_nan = std::ranges::any_of(v, [](const Vertex& p) { return std::isnan(p.z); });
      if (is_inside || has_nan || !std::ranges::all_of(v, IsFinite)) {
        one.triangles = {t};
        DrawOnto(*base_, one, options, counts);
      } else {
        DrawClipped(scene, PolygonOf(v, box), options, counts);
      }
    }
  }

 private:
  Polygon PolygonOf(const std::array<Vertex, 3>& v, const WindowBox& box) const {
    Polygon polygon{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
    const std::array<Side, 4> sides{Side{true, box.x0, -1}, Side{true, box.x1, 1},
                                    Side{false, box.y0, -1}, Side{false, box.y1, 1}};
    for (const Side& side : sides) polygon = Clipped(polygon, side);
    for (const Side& side : sides) {
      if (stages_.wider != 0) Widen(polygon, side, stages_.wider);
    }
    return polygon;
  }

  // As a fan. The facing is that of what is left: with y down a front has a negative area.
  void DrawClipped(const Scene& scene, const Polygon& polygon, const DrawOptions& options,
                   CoverageCounts& counts) {
    if (polygon.size() < 3) return;
    Scene fan;
    fan.width = scene.width;
    fan.height = scene.height;
    fan.precision = Precision::kFloat64;
    double area = 0;
    for (const Point2 p : polygon) fan.vertices.push_back({p.x, p.y, 0, 1});
    const auto placed = [&](std::size_t k) {
      const Point2 p = polygon[k % polygon.size()];
      return Point2{SnapToGrid(p.x, info_.profile.snap), SnapToGrid(p.y, info_.profile.snap)};
    };
    for (std::size_t k = 0; k < polygon.size(); ++k) {
      area += placed(k).x * placed(k + 1).y - placed(k + 1).x * placed(k).y;
      const auto n = static_cast<std::int32_t>(k);
      if (k > 0 && k + 1 < polygon.size()) fan.triangles.push_back({0, n, n + 1});
    }
    AddWinding(fan, area < 0, options, counts);
  }

  void AddWinding(const Scene& fan, bool is_front, const DrawOptions& options,
                  CoverageCounts& counts) {
    if (options.cull == (is_front ? Cull::kFront : Cull::kBack)) return;
    DrawOptions both = options;
    both.cull = Cull::kNone;
    CoverageCounts drawn(counts.width, counts.height, counts.samples);
    DrawOnto(*base_, fan, both, drawn);
    std::vector<std::uint32_t>& side = is_front ? counts.front : counts.back;
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      const std::int64_t winding = is_front ? drawn.Signed(k) : -drawn.Signed(k);
      if (winding > 0) side[k] += static_cast<std::uint32_t>(winding);
    }
  }

  ClippingStages stages_;
  std::unique_ptr<Subject> base_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> Make(const std::string& name, const std::string& summary,
                              ClippingStages stages) {
  return std::make_unique<ClippingSubject>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
