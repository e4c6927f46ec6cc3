// The decider by CGAL's filtered kernel: interval arithmetic, then exact numbers. Only LGPL parts:
// Kernel_23, Filtered_kernel, Number_types.
//
// CGAL checks with assertions that the processor obeys the rounding mode it needs; without them it
// answers wrongly where the processor does not.
#undef NDEBUG
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "core/vertex.h"
#include "exact/deciders.h"

#ifndef CGAL_DO_NOT_USE_BOOST_MP
#error "CGAL's exact numbers must not be Boost's: the two backends would be one"
#endif

namespace rasterproof::exact {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

Kernel::Point_2 ToKernel(Point2 p) { return {p.x, p.y}; }
Kernel::Point_3 ToKernel(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

}  // namespace

// orient2d is det[b - a, p - a]; E is det[p - a, b - a].
int CgalEdgeSign(Point2 a, Point2 b, Point2 p) {
  return -static_cast<int>(CGAL::orientation(ToKernel(a), ToKernel(b), ToKernel(p)));
}

// Seen from the origin, the orientation of three points is the sign of their determinant.
int CgalDeterminantSign(const Rows3& rows) {
  return static_cast<int>(CGAL::orientation(Kernel::Point_3(0, 0, 0), ToKernel(rows[0]),
                                            ToKernel(rows[1]), ToKernel(rows[2])));
}

}  // namespace rasterproof::exact
