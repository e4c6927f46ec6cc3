#include "tests/exact/square_shapes.h"

#include <cmath>
#include <limits>
#include <utility>

namespace rasterproof::exact {
namespace {

constexpr std::array<double, 7> kHalfWidths{0, 0x1p-9, 0x1p-8, 0.5, -0x1p-10, -0x1p-20, -0.0625};

double UlpsBeside(double x, int ulps) {
  auto f = static_cast<float>(x);
  for (; ulps > 0; --ulps) f = std::nextafter(f, std::numeric_limits<float>::max());
  for (; ulps < 0; ++ulps) f = std::nextafter(f, std::numeric_limits<float>::lowest());
  return double{f};
}

}  // namespace

double SquareDraw::NearLine() {
  const double line = Below(kSquareTargetSide + 3) - 1;
  switch (Below(6)) {
    case 0:
      return UlpsBeside(line, Below(3) - 1);
    case 1:
      return line + (Below(3) - 1) * 0x1p-8;
    case 2:
      return line + (Below(2) == 0 ? 1 : -1) * kHalfWidths[static_cast<std::size_t>(Below(7))];
    case 3:
      return std::nextafter(line, Below(2) == 0 ? -9.0 : 9.0);
    default:
      return line;
  }
}

Point2 SquareDraw::Crossing() {
  return {static_cast<double>(Below(kSquareTargetSide + 1)),
          static_cast<double>(Below(kSquareTargetSide + 1))};
}

Point2 SquareDraw::Anywhere() {
  const double range = kSquareTargetSide + 3;
  if (Below(3) == 0) return {std::floor(Unit() * range * 4) / 4 - 1, Below(28) / 4.0 - 1};
  return {double{static_cast<float>(Unit() * range - 1)},
          double{static_cast<float>(Unit() * range - 1)}};
}

// An edge whose line passes through two crossings of grid lines, or misses them by little.
std::array<Point2, 3> SquareDraw::ThroughCrossings() {
  const Point2 p = Crossing();
  const Point2 q = Crossing();
  const auto at = [&](double t) { return Point2{p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}; };
  Point2 a = at(-(Below(9) / 4.0));
  const Point2 b = at(1 + Below(9) / 4.0);
  if (Below(3) == 0) a.x = UlpsBeside(a.x, Below(3) - 1);
  if (Below(6) == 0) a.y += (Below(3) - 1) * 0x1p-8;
  return {a, b, Anywhere()};
}

std::array<Point2, 3> SquareDraw::InOnePixel() {
  const Point2 corner = Crossing();
  const double size = std::ldexp(1.0, -Below(24));
  const auto near = [&] {
    return Point2{corner.x + Below(5) * 0.25 * size, corner.y + Unit() * size};
  };
  return {near(), near(), near()};
}

std::array<Point2, 3> SquareDraw::Thin() {
  const Point2 a = Anywhere();
  const Point2 b = Below(2) == 0 ? Anywhere() : Crossing();
  Point2 c{(a.x + b.x) / 2, (a.y + b.y) / 2};
  if (Below(3) != 0) c.x = UlpsBeside(c.x, Below(5) - 2);
  return {a, b, c};
}

std::array<Point2, 3> SquareDraw::Triangle() {
  const auto near_lines = [&] { return Point2{NearLine(), NearLine()}; };
  std::array<Point2, 3> v;
  switch (Below(8)) {
    case 0:
      v = {Anywhere(), Anywhere(), Anywhere()};
      break;
    case 1:
      v = InOnePixel();
      break;
    case 2:
      v = Thin();
      break;
    case 3:
    case 4:
      v = ThroughCrossings();
      break;
    case 5:  // flat: a segment, a point
      v = {near_lines(), near_lines(), near_lines()};
      v[2] = v[static_cast<std::size_t>(Below(2))];
      if (Below(3) == 0) v[1] = v[0];
      break;
    default:
      v = {near_lines(), near_lines(), Below(2) == 0 ? near_lines() : Anywhere()};
  }
  if (Below(2) == 0) std::swap(v[0], v[static_cast<std::size_t>(1 + Below(2))]);
  if (Below(16) == 0) {
    for (Point2& p : v) p = {std::ldexp(p.x - 2, 40), std::ldexp(p.y - 2, 40)};
  }
  return v;
}

SquareFrame SquareDraw::Frame() {
  SquareFrame frame;
  frame.clip = {0, 0, kSquareTargetSide, kSquareTargetSide};
  frame.y_up = Below(4) == 0;
  frame.lift = frame.y_up ? kSquareTargetSide : 0;
  return frame;
}

SquareRegion SquareDraw::Region() {
  for (;;) {
    SquareRegion region;
    region.relation = static_cast<SquareRelation>(Below(2));
    region.square = static_cast<Closure>(Below(3));
    region.shape = static_cast<Closure>(Below(3));
    region.growth = Below(5) == 0 ? SquareGrowth::kEdges : SquareGrowth::kSwept;
    if (Below(2) == 0) region.half_width = kHalfWidths[static_cast<std::size_t>(Below(7))];
    if (IsDecidable(region)) return region;
  }
}

}  // namespace rasterproof::exact
