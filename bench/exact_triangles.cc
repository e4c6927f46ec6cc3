#include "bench/exact_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "core/coverage.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/sample_frame.h"
#include "exact/spans.h"
#include "model/segment_distance.h"
#include "model/snap_scene.h"

namespace rasterproof::bench {
namespace {

Point2 Divided(const Vertex& v) { return {v.x / v.w, v.y / v.w}; }

bool IsBeforeTheEye(const Scene& scene, const Vertex& v) { return !scene.clip_space || v.w > 0; }

// Of an edge from a, before the eye, to b, behind it: where it has left every target. It goes to
// infinity in the direction of what lies on it at w = 0.
Point2 FarOff(const Vertex& a, const Vertex& b) {
  constexpr double kFar = 0x1p24;
  const double t = a.w / (a.w - b.w);
  const double x = a.x + t * (b.x - a.x);
  const double y = a.y + t * (b.y - a.y);
  const double length = std::max(std::hypot(x, y), std::numeric_limits<double>::min());
  const Point2 from = Divided(a);
  return {from.x + x / length * kFar, from.y + y / length * kFar};
}

}  // namespace

PixelRect JudgedArea(const Scene& scene, std::size_t triangle) {
  constexpr double kMargin = 2;
  const std::array<Vertex, 3> corners = Corners(scene, scene.triangles[triangle]);
  if (!std::ranges::all_of(corners, [&](const Vertex& v) { return IsBeforeTheEye(scene, v); })) {
    return {0, 0, scene.width, scene.height};
  }
  std::array<Point2, 3> v;
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = scene.clip_space ? Divided(corners[k]) : WindowPoint(corners[k]);
  }
  const auto within = [](double x, int size) {
    return static_cast<int>(std::clamp(x, 0.0, static_cast<double>(size)));
  };
  const auto [x0, x1] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y0, y1] = std::minmax({v[0].y, v[1].y, v[2].y});
  return {
      within(std::floor(x0) - kMargin, scene.width), within(std::floor(y0) - kMargin, scene.height),
      within(std::ceil(x1) + kMargin, scene.width), within(std::ceil(y1) + kMargin, scene.height)};
}

double DistanceFrom(const SeenEdges& edges, Point2 p) {
  double distance = std::numeric_limits<double>::infinity();
  for (const auto& edge : edges) {
    if (edge) distance = std::min(distance, SegmentDistance((*edge)[0], (*edge)[1], p));
  }
  return distance;
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

SeenEdges ExactTriangles::EdgesOf(std::size_t triangle) const {
  const Scene& scene = state_->placed;
  const std::array<Vertex, 3> v = Corners(scene, scene.triangles[triangle]);
  SeenEdges edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& a = v[k];
    const Vertex& b = v[(k + 1) % 3];
    if (!scene.clip_space) {
      edges[k] = {WindowPoint(a), WindowPoint(b)};
    } else if (a.w > 0) {
      edges[k] = {Divided(a), b.w > 0 ? Divided(b) : FarOff(a, b)};
    } else if (b.w > 0) {
      edges[k] = {FarOff(b, a), Divided(b)};
    }
  }
  return edges;
}

}  // namespace rasterproof::bench
