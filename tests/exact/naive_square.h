// A third implementation of square coverage, schoolbook and slow: the triangle is grown as a hull
// and clipped by the pixel's square, in GMP's rationals. No separating axis, no sign of an edge's
// farthest corner.
#ifndef RASTERPROOF_TESTS_EXACT_NAIVE_SQUARE_H_
#define RASTERPROOF_TESTS_EXACT_NAIVE_SQUARE_H_

#include <gmpxx.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "core/square_rule.h"
#include "core/tie_rule.h"
#include "core/vertex.h"
#include "tests/exact/naive.h"

namespace rasterproof::exact {

using NaivePolygon = std::vector<NaivePoint>;

struct NaiveSquare {
  mpq_class x0;
  mpq_class y0;
  mpq_class x1;
  mpq_class y1;
};

inline bool NaiveLess(const NaivePoint& a, const NaivePoint& b) {
  return a.x != b.x ? a.x < b.x : a.y < b.y;
}

// The convex hull, by two chains. Points and segments are hulls too.
inline NaivePolygon NaiveHull(NaivePolygon points) {
  std::sort(points.begin(), points.end(), NaiveLess);
  NaivePolygon hull;
  for (int chain = 0; chain < 2; ++chain) {
    const std::size_t begin = hull.size();
    for (const NaivePoint& p : points) {
      while (hull.size() >= begin + 2 && NaiveEdge(hull[hull.size() - 2], hull.back(), p) >= 0) {
        hull.pop_back();
      }
      hull.push_back(p);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull.empty() ? NaivePolygon{points.front()} : hull;
}

// What of the polygon has side(p) >= 0, for an affine side.
template <class Side>
NaivePolygon NaiveClip(const NaivePolygon& polygon, const Side& side) {
  NaivePolygon kept;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const NaivePoint& p = polygon[k];
    const NaivePoint& q = polygon[(k + 1) % polygon.size()];
    const mpq_class at_p = side(p);
    const mpq_class at_q = side(q);
    if (at_p >= 0) kept.push_back(p);
    if (at_p * at_q >= 0) continue;
    const mpq_class t = at_p / (at_p - at_q);
    kept.push_back({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)});
  }
  return kept;
}

inline NaivePolygon NaiveClip(NaivePolygon polygon, const NaiveSquare& q) {
  using Value = mpq_class;
  polygon = NaiveClip(polygon, [&](const NaivePoint& p) -> Value { return p.x - q.x0; });
  polygon = NaiveClip(polygon, [&](const NaivePoint& p) -> Value { return q.x1 - p.x; });
  polygon = NaiveClip(polygon, [&](const NaivePoint& p) -> Value { return p.y - q.y0; });
  return NaiveClip(polygon, [&](const NaivePoint& p) -> Value { return q.y1 - p.y; });
}

inline bool NaiveHasArea(const NaivePolygon& polygon) {
  for (std::size_t k = 2; k < polygon.size(); ++k) {
    if (NaiveEdge(polygon[0], polygon[1], polygon[k]) != 0) return true;
    if (k >= 3 && NaiveEdge(polygon[0], polygon[k - 1], polygon[k]) != 0) return true;
  }
  return false;
}

// Whether the closed hull and the square have a point in common that both sets have.
inline bool NaiveMeets(const NaivePolygon& hull, bool flat, const NaiveSquare& q,
                       const SquareRegion& region) {
  const NaivePolygon common = NaiveClip(hull, q);
  if (common.empty()) return false;
  if (!flat && (region.square == Closure::kOpen || region.shape != Closure::kClosed)) {
    return NaiveHasArea(common);
  }
  // A convex set within the square's boundary lies on one side of it.
  const auto all = [&](const auto& on) { return std::all_of(common.begin(), common.end(), on); };
  const bool on_ceiling = all([&](const NaivePoint& p) { return p.x == q.x1; }) ||
                          all([&](const NaivePoint& p) { return p.y == q.y1; });
  const bool on_floor = all([&](const NaivePoint& p) { return p.x == q.x0; }) ||
                        all([&](const NaivePoint& p) { return p.y == q.y0; });
  if (region.square == Closure::kClosed) return true;
  return !on_ceiling && (region.square == Closure::kHalfOpen || !on_floor);
}

inline std::array<NaivePoint, 4> NaiveCorners(const NaiveSquare& q) {
  return {NaivePoint{q.x0, q.y0}, NaivePoint{q.x1, q.y0}, NaivePoint{q.x0, q.y1},
          NaivePoint{q.x1, q.y1}};
}

// Whether every point of the square is one of the triangle, which is not flat.
inline bool NaiveHolds(const std::array<NaiveRow, 3>& v, const NaiveSquare& q,
                       const SquareRegion& region) {
  TieRule floor_in;  // the half-open shape, in axes whose y grows towards ceilings
  const bool closed = region.shape == Closure::kClosed || region.square == Closure::kOpen ||
                      (region.square == Closure::kHalfOpen && region.shape == Closure::kHalfOpen);
  const auto corners = NaiveCorners(q);
  for (std::size_t k = 0; k < 4; ++k) {
    // Of a half-open square in an open triangle: sides without their ends belong to it.
    const bool has_corner = region.square == Closure::kClosed || k == 0;
    if (closed || !has_corner) {
      if (!NaiveCovers(v, corners[k], true)) return false;
    } else if (region.shape == Closure::kHalfOpen) {
      if (!NaiveCovers(v, NaiveShifted(corners[k], floor_in), false)) return false;
    } else if (!NaiveCovers(v, corners[k], false)) {
      return false;
    }
  }
  if (region.square != Closure::kHalfOpen || region.shape != Closure::kOpen) return true;
  // Its floor sides, but for their far ends, must be inside: so must be their middles.
  const NaivePoint below{(q.x0 + q.x1) / 2, q.y0};
  const NaivePoint left{q.x0, (q.y0 + q.y1) / 2};
  return NaiveCovers(v, below, false) && NaiveCovers(v, left, false);
}

// The square of pixel (i, j), in the profile's own axes, j counted along them.
inline bool NaiveSquareCovers(const std::array<Point2, 3>& v, const SquareRegion& region, int i,
                              int j) {
  const mpq_class u(region.half_width);
  NaivePolygon points;
  for (const Point2& p : v) points.push_back(NaiveAt(p));
  const mpq_class area = NaiveEdge(points[0], points[1], points[2]);
  const bool flat = area == 0;
  const NaiveSquare grown{i - u, j - u, i + 1 + u, j + 1 + u};
  if (region.relation == SquareRelation::kContains) {
    std::array<NaiveRow, 3> rows;
    for (std::size_t k = 0; k < 3; ++k) rows[k] = {points[k].x, points[k].y, 1};
    return !flat && NaiveHolds(rows, grown, region);
  }
  if (!flat && region.growth == SquareGrowth::kEdges) {
    for (std::size_t k = 0; k < 3; ++k) {
      bool reaches = false;
      for (const NaivePoint& corner : NaiveCorners(grown)) {
        const mpq_class e = NaiveEdge(points[k], points[(k + 1) % 3], corner) * area;
        const bool floor_corner = corner.x == grown.x0 && corner.y == grown.y0;
        const bool touches = region.shape == Closure::kClosed &&
                             (region.square == Closure::kClosed ||
                              (region.square == Closure::kHalfOpen && floor_corner));
        reaches = reaches || e > 0 || (e == 0 && touches);
      }
      if (!reaches) return false;
    }
    return true;
  }
  if (u < 0) return NaiveMeets(NaiveHull(points), flat, grown, region);
  NaivePolygon swept;
  for (const NaivePoint& p : points) {
    for (const int x : {-1, 1}) {
      for (const int y : {-1, 1}) swept.push_back({p.x + x * u, p.y + y * u});
    }
  }
  const NaiveSquare square{i, j, i + 1, j + 1};
  return NaiveMeets(NaiveHull(swept), flat, square, region);
}

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_TESTS_EXACT_NAIVE_SQUARE_H_
