#include "bench/exact_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/coverage.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/sample_frame.h"
#include "exact/spans.h"
#include "model/snap_scene.h"

namespace rasterproof::bench {
namespace {

std::array<Point2, 3> DividedCorners(const Scene& scene, std::size_t triangle) {
  std::array<Point2, 3> points;
  const auto v = Corners(scene, scene.triangles[triangle]);
  for (std::size_t k = 0; k < 3; ++k) {
    points[k] = scene.clip_space ? Point2{v[k].x / v[k].w, v[k].y / v[k].w} : WindowPoint(v[k]);
  }
  return points;
}

}  // namespace

PixelRect JudgedArea(const Scene& scene, std::size_t triangle) {
  constexpr double kMargin = 2;
  const std::array<Point2, 3> v = DividedCorners(scene, triangle);
  const auto within = [](double x, int size) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(size)));
  };
  const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
  return {
      within(std::floor(x0) - kMargin, scene.width), within(std::floor(y0) - kMargin, scene.height),
      within(std::ceil(x1) + kMargin, scene.width), within(std::ceil(y1) + kMargin, scene.height)};
}

struct ExactTriangles::State {
  Scene placed;
  exact::SampleFrame frame;
  CoverageCounts counts;
  exact::SpanTarget target;

  State(const Scene& scene, const Profile& model)
      : placed(scene.clip_space ? scene : SnapScene(scene, {model, scene})),
        frame(scene, {model, scene}, {}),
        counts(scene.width, scene.height),
        target(counts) {}
};

ExactTriangles::ExactTriangles(const Scene& scene, const Profile& model)
    : state_(std::make_unique<State>(scene, model)) {}
ExactTriangles::~ExactTriangles() = default;

void ExactTriangles::Cover(std::size_t triangle, const PixelRect& area,
                           std::vector<std::uint8_t>& covered) {
  State& s = *state_;
  const auto columns = static_cast<std::size_t>(std::max(0, area.x1 - area.x0));
  covered.assign(columns * static_cast<std::size_t>(std::max(0, area.y1 - area.y0)), 0);
  const auto v = exact::ScreenTriangle(s.placed, s.placed.triangles[triangle], s.frame);
  if (!v) return;
  const std::array<Point2, 3> points{WindowPoint((*v)[0]), WindowPoint((*v)[1]),
                                     WindowPoint((*v)[2])};
  const int facing = s.placed.clip_space ? exact::HomogeneousFacing(*v) : exact::Facing(points);
  if (facing == 0) return;
  if (s.placed.clip_space) {
    exact::AddHomogeneousSpans(*v, facing, s.frame, s.target);
  } else {
    exact::AddWindowSpans(points, facing, s.frame, s.target);
  }
  const auto width = static_cast<std::size_t>(s.counts.width);
  s.target.Take([&](std::size_t at) {
    const std::size_t x = at % width - static_cast<std::size_t>(area.x0);
    const std::size_t y = at / width - static_cast<std::size_t>(area.y0);
    covered[y * columns + x] = 1;
  });
}

bool ExactTriangles::Covers(std::size_t triangle, int x, int y) const {
  const State& s = *state_;
  const auto v = exact::ScreenTriangle(s.placed, s.placed.triangles[triangle], s.frame);
  if (!v) return false;
  const Point2 at = s.frame.At(x, y, 0);
  if (s.placed.clip_space) return exact::HomogeneousCovers(*v, at, s.frame.rule);
  return exact::Covers({WindowPoint((*v)[0]), WindowPoint((*v)[1]), WindowPoint((*v)[2])}, at,
                       s.frame.rule);
}

std::array<Point2, 3> ExactTriangles::CornersOf(std::size_t triangle) const {
  return DividedCorners(state_->placed, triangle);
}

}  // namespace rasterproof::bench
