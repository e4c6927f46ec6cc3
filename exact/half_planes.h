// Whether closed half planes and a rectangle have a point in common, decided exactly.
#ifndef RASTERPROOF_EXACT_HALF_PLANES_H_
#define RASTERPROOF_EXACT_HALF_PLANES_H_

#include <array>
#include <vector>

#include "core/vertex.h"
#include "exact/rational.h"

namespace rasterproof::exact {

/// The points with a x + b y + c >= 0: its line is part of it.
struct HalfPlane {
  Rational a;
  Rational b;
  Rational c;
};

/// The half planes whose intersection is the convex hull of the points.
///
/// Domain:     finite points, not all of them on one line.
std::vector<HalfPlane> HullOf(const std::vector<Point2>& points);

/// The half planes of the points where low[i] <= lambda_i <= high[i] of the triangle, for each i.
///
/// Domain:     finite; an area that is not zero.
std::vector<HalfPlane> WhereBarycentricsAre(const std::array<Point2, 3>& v,
                                            const std::array<Rational, 3>& low,
                                            const std::array<Rational, 3>& high);

/// Whether the closed rectangle from `low` to `high` has a point of all of the half planes.
///
/// Cost:       rationals: some ten microseconds for each half plane.
bool RectangleMeets(Point2 low, Point2 high, const std::vector<HalfPlane>& planes);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_HALF_PLANES_H_
