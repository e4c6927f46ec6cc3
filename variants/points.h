// The two kinds of points that a staged rasterizer computes with.
#ifndef RASTERPROOF_VARIANTS_POINTS_H_
#define RASTERPROOF_VARIANTS_POINTS_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/vertex.h"

namespace rasterproof::variants {

/// A place in steps of the grid that holds the vertices and the samples. Screen axes: x right, y
/// down, whatever the profile's y axis.
struct GridPoint {
  std::int64_t x = 0;
  std::int64_t y = 0;

  friend bool operator==(const GridPoint&, const GridPoint&) = default;
};

/// The value of the edge a -> b at p, or what 64 bits hold that is nearest to it.
///
/// Domain:     coordinates below 2^61.
inline std::int64_t EdgeValue(GridPoint a, GridPoint b, GridPoint p) {
  __extension__ using Wide = __int128;
  const Wide value = Wide{p.x - a.x} * (b.y - a.y) - Wide{p.y - a.y} * (b.x - a.x);
  constexpr Wide kLeast = std::numeric_limits<std::int64_t>::min();
  constexpr Wide kMost = std::numeric_limits<std::int64_t>::max();
  return static_cast<std::int64_t>(std::clamp(value, kLeast, kMost));
}

/// The value of the edge a -> b at p in double, each operation rounded.
inline double RoundedEdgeValue(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

/// The barycentrics of p in double.
///
/// Domain:     a triangle whose area is not zero in double.
inline std::array<double, 3> BarycentricsAt(const std::array<Point2, 3>& v, Point2 p) {
  const double area = RoundedEdgeValue(v[0], v[1], v[2]);
  std::array<double, 3> of_p{};
  for (std::size_t i = 0; i < 3; ++i)
    of_p[i] = RoundedEdgeValue(v[(i + 1) % 3], v[(i + 2) % 3], p) / area;
  return of_p;
}

/// The pixel that a coordinate lies in, rounded toward zero; far outside one at 2^28 pixels.
///
/// Domain:     not NaN.
inline int ToPixel(double x) {
  constexpr double kFarthest = 0x1p28;  // of a box's end: targets are smaller
  return static_cast<int>(std::clamp(x, -kFarthest, kFarthest));
}

/// Where pixels and their samples lie among the points of a kind.
template <class Point>
struct Lattice;

/// Points in pixels, as the profile places them.
template <>
struct Lattice<Point2> {
  using Value = int;  ///< of an edge at a point: its sign

  /// Whether it draws a triangle with a vertex there, in pixels.
  static bool Reaches(double x, double /*limit*/) { return std::isfinite(x); }
  static Point2 At(double x, double y) { return {x, y}; }
  static Point2 InPixels(Point2 p) { return p; }
  static Point2 SampleOf(int x, int row, Point2 offset) { return {offset.x + x, offset.y + row}; }
  /// The first pixel whose sample at `offset` lies at or beyond the coordinate.
  static int FirstPixel(double at, double offset) { return ToPixel(std::ceil(at - offset)); }
  /// The first pixel whose sample lies beyond it.
  static int EndPixel(double at, double offset) { return ToPixel(std::floor(at - offset) + 1); }
};

/// Points on a grid. Vertices farther out than twice the profile's limit are not drawn.
template <>
struct Lattice<GridPoint> {
  using Value = std::int64_t;  ///< in steps: EdgeValue

  int bits = 8;  ///< a step is 2^-bits pixel

  static bool Reaches(double x, double limit) { return std::fabs(x) <= 2 * limit; }
  std::int64_t Steps(double pixels) const {
    return static_cast<std::int64_t>(std::ldexp(pixels, bits));
  }
  GridPoint At(double x, double y) const { return {Steps(x), Steps(y)}; }
  Point2 InPixels(GridPoint p) const {
    return {std::ldexp(static_cast<double>(p.x), -bits),
            std::ldexp(static_cast<double>(p.y), -bits)};
  }
  GridPoint SampleOf(int x, int row, const GridPoint& offset) const {
    return {(std::int64_t{x} << bits) + offset.x, (std::int64_t{row} << bits) + offset.y};
  }
  int FirstPixel(std::int64_t at, std::int64_t offset) const {
    return static_cast<int>((at - offset + (std::int64_t{1} << bits) - 1) >> bits);
  }
  int EndPixel(std::int64_t at, std::int64_t offset) const { return FirstPixel(at + 1, offset); }
};

}  // namespace rasterproof::variants

#endif  // RASTERPROOF_VARIANTS_POINTS_H_
