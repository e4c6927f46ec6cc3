#include "props/judging/places.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <utility>

#include "core/profile.h"
#include "core/scene.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// The index range of `count` places spread evenly over [0, size).
int Spread(int k, int count, int size) {
  return static_cast<int>((static_cast<std::int64_t>(k) * size) / count);
}

// Clamps before the conversion: a crossing can lie anywhere, NaN included.
int ClampedFloor(double x, int size) {
  if (!(x > 0)) return 0;
  return x >= size ? size - 1 : static_cast<int>(x);
}

// Window coordinate of the edge line at `across` along the other axis, in double: only a hint.
double Crossing(double a_along, double a_across, double b_along, double b_across, double across) {
  const double part = (across - a_across) / (b_across - a_across);
  return a_along + part * (b_along - a_along);
}

class PlaceCollector {
 public:
  explicit PlaceCollector(const PlacedCase& c) : case_(c) {}

  void Add(int x, int row, int sample) {
    if (x < 0 || row < 0 || x >= case_.scene.width || row >= case_.scene.height) return;
    places_.push_back(PlaceOf(case_, x, row, sample));
  }

  // Walks the axis along which the edge is longer and takes the pixels on both sides of the line.
  void AddNear(Point2 a, Point2 b, int per_edge) {
    const bool steep = std::fabs(b.y - a.y) >= std::fabs(b.x - a.x);
    const int length = steep ? case_.scene.height : case_.scene.width;
    const double low = steep ? std::min(a.y, b.y) : std::min(a.x, b.x);
    const double high = steep ? std::max(a.y, b.y) : std::max(a.x, b.x);
    const int first = ClampedFloor(low - 1, length);
    const int last = ClampedFloor(high + 1, length);
    const int count = std::min(per_edge, last - first + 1);
    for (int k = 0; k < count; ++k) {
      const int across = first + Spread(k, count, last - first + 1);
      for (int sample = 0; sample < std::min(2, case_.profile.pattern.samples()); ++sample) {
        AddAcross(a, b, steep, across, sample);
      }
    }
  }

  void AddCorners() {
    const int right = case_.scene.width - 1;
    const int bottom = case_.scene.height - 1;
    for (const auto& [x, row] : {std::pair{0, 0}, {right, 0}, {0, bottom}, {right, bottom}}) {
      Add(x, row, 0);
    }
  }

  std::vector<SamplePlace> Take() {
    const auto key = [](const SamplePlace& p) { return std::tuple(p.row, p.x, p.sample); };
    std::ranges::sort(places_, {}, key);
    const auto repeated = std::ranges::unique(places_, {}, key);
    places_.erase(repeated.begin(), repeated.end());
    return std::move(places_);
  }

 private:
  // `across` counts window units of the axis that is walked; rows count from the top.
  void AddAcross(Point2 a, Point2 b, bool steep, int across, int sample) {
    const Point2& location = case_.profile.pattern.locations[static_cast<std::size_t>(sample)];
    if (steep) {
      const double x = Crossing(a.x, a.y, b.x, b.y, across + location.y);
      const int column = ClampedFloor(x - location.x, case_.scene.width);
      const int row = RowOf(across);
      Add(column, row, sample);
      Add(column + 1, row, sample);
      return;
    }
    const double y = Crossing(a.y, a.x, b.y, b.x, across + location.x);
    const int line = ClampedFloor(y - location.y, case_.scene.height);
    Add(across, RowOf(line), sample);
    Add(across, RowOf(line + 1), sample);
  }

  int RowOf(int line) const {
    return case_.profile.y_axis == YAxis::kDown ? line : case_.scene.height - 1 - line;
  }

  const PlacedCase& case_;
  std::vector<SamplePlace> places_;
};

}  // namespace

SamplePlace PlaceOf(const PlacedCase& c, int x, int row, int sample) {
  const int line = c.profile.y_axis == YAxis::kDown ? row : c.scene.height - 1 - row;
  return {x, row, sample, c.profile.pattern.At(x, line, sample)};
}

std::vector<CornersPlace> SomeTriangles(const PlacedCase& c, int limit) {
  const int size = static_cast<int>(c.placed.triangles.size());
  const int count = std::min(limit, size);
  std::vector<CornersPlace> chosen;
  for (int k = 0; k < count; ++k) {
    const int triangle = Spread(k, count, size);
    const std::array<Vertex, 3> v =
        Corners(c.placed, c.placed.triangles[static_cast<std::size_t>(triangle)]);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    chosen.push_back({triangle, {WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])}});
  }
  return chosen;
}

std::vector<SamplePlace> SamplesNearEdges(const PlacedCase& c, const std::array<Point2, 3>& v,
                                          int per_edge) {
  PlaceCollector collector(c);
  for (int i = 0; i < 3; ++i) collector.AddNear(EdgeStart(v, i), EdgeEnd(v, i), per_edge);
  collector.AddCorners();
  return collector.Take();
}

}  // namespace rasterproof::props
