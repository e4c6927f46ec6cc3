#include "subjects/mutants/real_geometry.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/scene.h"
#include "library/exact_sign.h"

namespace rasterproof::subjects::mutants {
namespace {

// Top-left: a left edge runs down on screen, a top edge runs left.
bool IsTopLeft(Point2 a, Point2 b) { return b.y > a.y || (b.y == a.y && b.x < a.x); }

// The first pixel of [0, size) whose centre is not before x.
int FirstPixel(double x, int size) {
  const double pixel = std::ceil(x - 0.5);
  return pixel > 0 ? static_cast<int>(std::min<double>(pixel, size)) : 0;
}

class RealGeometry final : public Subject {
 public:
  RealGeometry(const std::string& name, const std::string& summary, RealStages stages)
      : stages_(std::move(stages)) {
    info_.name = name;
    info_.summary = summary;
    info_.profile = stages_.profile;
  }

  const SubjectInfo& OwnInfo() const override { return info_; }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    for (const Triangle& t : scene.triangles) {
      const std::array<Vertex, 3> corners = Corners(scene, t);
      if (!std::ranges::all_of(corners, IsFinite)) continue;
      Points v{WindowPoint(corners[0]), WindowPoint(corners[1]), WindowPoint(corners[2])};
      if (stages_.drops && stages_.drops(v)) continue;
      if (stages_.vertices) stages_.vertices(v);
      DrawTriangle(v, options, counts);
    }
  }

 private:
  int Sign(Point2 a, Point2 b, Point2 p) const {
    return stages_.sign ? stages_.sign(a, b, p) : library::EdgeSign(a, b, p);
  }

  bool Covers(const Points& v, Point2 p) const {
    for (std::size_t i = 0; i < 3; ++i) {
      const Point2& a = v[i];
      const Point2& b = v[(i + 1) % 3];
      const int sign = Sign(a, b, p);
      if (sign < 0) return false;
      if (sign == 0 && !(stages_.owns ? stages_.owns(a, b) : IsTopLeft(a, b))) return false;
    }
    return true;
  }

  void DrawTriangle(Points v, const DrawOptions& options, CoverageCounts& counts) const {
    const int facing = stages_.facing ? stages_.facing(v) : Sign(v[0], v[1], v[2]);
    if (facing == 0 || options.cull == (facing > 0 ? Cull::kFront : Cull::kBack)) return;
    if (facing < 0) std::swap(v[1], v[2]);
    std::vector<std::uint32_t>& side = facing > 0 ? counts.front : counts.back;
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    const PixelRect clip = options.scissor.value_or(PixelRect{0, 0, counts.width, counts.height});
    for (int row = std::max(clip.y0, FirstPixel(top, counts.height));
         row < clip.y1 && row + 0.5 <= bottom; ++row) {
      for (int x = std::max(clip.x0, FirstPixel(left, counts.width));
           x < clip.x1 && x + 0.5 <= right; ++x) {
        if (Covers(v, {x + 0.5, row + 0.5})) ++side[counts.Index(x, row)];
      }
    }
  }

  RealStages stages_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> MakeRealGeometry(const std::string& name, const std::string& summary,
                                          RealStages stages) {
  return std::make_unique<RealGeometry>(name, summary, std::move(stages));
}

}  // namespace rasterproof::subjects::mutants
