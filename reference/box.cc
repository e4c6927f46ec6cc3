#include "reference/box.h"

#include <algorithm>
#include <array>

namespace rasterproof::reference {

int FirstCentreFrom(double x, int low, int high) {
  if (!(x > low)) return low;
  if (x >= high) return high;
  const int n = static_cast<int>(x);  // low < x < high: truncation is the floor
  return n + 0.5 >= x ? n : n + 1;
}

int FirstCentreBeyond(double x, int low, int high) {
  if (!(x >= low)) return low;
  if (x >= high) return high;
  const int n = static_cast<int>(x);
  return n + 0.5 > x ? n : n + 1;
}

PixelRect TargetOf(const Scene& scene) { return {0, 0, scene.width, scene.height}; }

PixelRect DrawArea(const Scene& scene, const DrawOptions& options) {
  const PixelRect target = TargetOf(scene);
  return options.scissor ? Intersection(target, *options.scissor) : target;
}

PixelRect Intersection(const PixelRect& a, const PixelRect& b) {
  return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

PixelRect SampleBox(const std::array<Point2, 3>& v, const PixelRect& area) {
  if (IsEmpty(area)) return {};
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  return {FirstCentreFrom(left, area.x0, area.x1), FirstCentreFrom(top, area.y0, area.y1),
          FirstCentreBeyond(right, area.x0, area.x1), FirstCentreBeyond(bottom, area.y0, area.y1)};
}

std::optional<Corners3> PlaceAsGiven(const Corners3& given) {
  if (!std::ranges::all_of(given, IsFinite)) return std::nullopt;
  return given;
}

PixelRect BoxOfCorners(const Corners3& v, const PixelRect& target) {
  return SampleBox({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])}, target);
}

}  // namespace rasterproof::reference
