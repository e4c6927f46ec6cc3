#include "library/exact_sign.h"

#include <cmath>

#include "core/own_precision.h"

namespace rasterproof::library {
namespace {

/// x - y, and whether that is the exact difference.
struct Difference {
  double value;
  bool exact;
  Difference(double x, double y) : value(x - y) {
    // TwoDiff's tail; where the difference overflows it is NaN and compares unequal to zero.
    const double from_x = x - value;
    exact = (x - (value + from_x)) + (from_x - y) == 0;
  }
};

/// Whether the product and its rounding error are both far from the ends of the exponent range: an
/// error is a multiple of 2^-106 times the product's power of two.
bool InStableRange(double product) {
  const double size = std::fabs(product);
  return size >= 0x1p-900 && size <= 0x1p1000;
}

/// The sign of ab - cd. Rounding is monotone: unequal rounded products already decide; equal ones
/// leave the comparison to their rounding errors, which fma gives exactly.
int CompareProducts(double a, double b, double c, double d) {
  const double left = a * b;
  const double right = c * d;
  if (left != right) return left > right ? 1 : -1;
  const double left_error = std::fma(a, b, -left);
  const double right_error = std::fma(c, d, -right);
  return (left_error > right_error ? 1 : 0) - (left_error < right_error ? 1 : 0);
}

}  // namespace

ExactSum ExactEdge(Point2 a, Point2 b, Point2 p) {
  // (p.x - a.x)(b.y - a.y) - (p.y - a.y)(b.x - a.x) multiplied out; a.x a.y cancels. The
  // differences themselves would need up to 2100 bits each, the six products never more than 106.
  ExactSum sum;
  sum.Add(p.x, b.y);
  sum.Subtract(p.x, a.y);
  sum.Subtract(a.x, b.y);
  sum.Subtract(p.y, b.x);
  sum.Add(p.y, a.x);
  sum.Add(a.y, b.x);
  return sum;
}

int UnfilteredEdgeSign(Point2 a, Point2 b, Point2 p) {
  const Difference px(p.x, a.x);
  const Difference by(b.y, a.y);
  const Difference py(p.y, a.y);
  const Difference bx(b.x, a.x);
  if (px.exact && by.exact && py.exact && bx.exact) {
    const double left = px.value * by.value;
    const double right = py.value * bx.value;
    const bool left_ok = px.value == 0 || by.value == 0 || InStableRange(left);
    const bool right_ok = py.value == 0 || bx.value == 0 || InStableRange(right);
    if (left_ok && right_ok) return CompareProducts(px.value, by.value, py.value, bx.value);
  }
  return ExactEdge(a, b, p).Sign();
}

}  // namespace rasterproof::library
