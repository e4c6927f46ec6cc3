// A second decider of squares, slow: it asks each square alone, by the signs of every edge at its
// four corners.
#ifndef RASTERPROOF_TESTS_EXACT_ONE_SQUARE_H_
#define RASTERPROOF_TESTS_EXACT_ONE_SQUARE_H_

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/square_rule.h"
#include "core/tie_rule.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/square.h"

namespace rasterproof::exact {

// The corners of the square, grown: the floor corner, which a half-open square has, first.
inline std::array<Point2, 4> CornersOfSquare(const SquareRegion& region, const SquareFrame& frame,
                                             int i, int r) {
  const double low = i - region.half_width;
  const double high = i + (1 + region.half_width);
  double floor = r + (-region.half_width - frame.lift);
  double ceiling = r + (1 + region.half_width - frame.lift);
  if (frame.y_up) std::swap(floor, ceiling);
  return {Point2{low, floor}, Point2{high, floor}, Point2{low, ceiling}, Point2{high, ceiling}};
}

// Whether [a, b] meets the square's [floor, ceiling] along one axis.
inline bool MeetsAlong(double a, double b, double floor, double ceiling, const SquareRegion& region,
                       Closure shape) {
  if (floor > ceiling) return MeetsAlong(-b, -a, -floor, -ceiling, region, shape);
  const bool closed = shape == Closure::kClosed;
  const bool floor_in = closed && region.square != Closure::kOpen;
  const bool ceiling_in = closed && region.square == Closure::kClosed;
  return (b > floor || (b == floor && floor_in)) && (a < ceiling || (a == ceiling && ceiling_in));
}

// The largest or least of the signs at the corners, and the meaning of a zero among them.
inline bool PassesEdge(const std::array<int, 4>& signs, const SquareRegion& region, Closure shape) {
  const auto [least, largest] = std::ranges::minmax(signs);
  const bool on_floor_corner = signs[0] == 0;
  const Closure square = region.square;
  if (region.relation == SquareRelation::kIntersects) {
    if (largest != 0) return largest > 0;
    if (shape != Closure::kClosed || square == Closure::kOpen) return false;
    return square == Closure::kClosed || on_floor_corner;
  }
  if (least != 0) return least > 0;
  if (shape == Closure::kClosed || square == Closure::kOpen) return true;
  return square == Closure::kHalfOpen && (shape == Closure::kHalfOpen || !on_floor_corner);
}

/// Returns whether the square of column i and row r is in the region.
///
/// Domain:     as ForEachSquareSpan.
inline bool IsSquareCovered(const std::array<Point2, 3>& v, const SquareRegion& region,
                            const SquareFrame& frame, int i, int r, Decider decider) {
  const std::array<Point2, 4> q = CornersOfSquare(region, frame, i, r);
  const int facing = EdgeSign(v[0], v[1], v[2], decider);
  const bool meets = region.relation == SquareRelation::kIntersects;
  const Closure shape = facing == 0 ? Closure::kClosed : region.shape;
  if (facing == 0 && !meets) return false;
  if (meets && (facing == 0 || region.growth == SquareGrowth::kSwept)) {
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    if (!MeetsAlong(left, right, q[0].x, q[3].x, region, shape)) return false;
    if (!MeetsAlong(top, bottom, q[0].y, q[3].y, region, shape)) return false;
  }
  // A closed square lies in a half-open set if its corners do.
  const bool shifted = !meets && region.square == Closure::kClosed && shape == Closure::kHalfOpen;
  const TieRule floor_in{+1, static_cast<std::int8_t>(frame.y_up ? -1 : +1), false, false, false};
  for (unsigned k = 0; k < 3; ++k) {
    const Point2 a = v[k];
    const Point2 b = v[(k + 1) % 3];
    if (a == b) continue;
    for (const int inner : {+1, -1}) {
      if (facing != 0 && inner != facing) continue;
      std::array<int, 4> signs{};
      for (unsigned c = 0; c < 4; ++c) {
        signs[c] = inner * (shifted ? ShiftedEdgeSign(a, b, q[c], floor_in, decider)
                                    : EdgeSign(a, b, q[c], decider));
      }
      if (!PassesEdge(signs, region, shape)) return false;
    }
  }
  return true;
}

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_TESTS_EXACT_ONE_SQUARE_H_
