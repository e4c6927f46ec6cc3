#include "props/judging/values/value_estimates.h"

#include <cmath>
#include <cstddef>

namespace rasterproof::props {
namespace {

// beta_i = x p.x + y p.y + c, and the magnitudes of the products in it.
struct Line {
  double x = 0;
  double y = 0;
  double c = 0;
  double size_x = 0;
  double size_y = 0;
  double size_c = 0;

  double At(Point2 p) const { return x * p.x + y * p.y + c; }
  double SizeAt(Point2 p) const {
    return size_x * std::fabs(p.x) + size_y * std::fabs(p.y) + size_c;
  }
};

Line LineThrough(const RayCorner& a, const RayCorner& b) {
  const auto size = [](double s, double t) { return std::fabs(s) + std::fabs(t); };
  return {a.y * b.w - a.w * b.y,      a.w * b.x - a.x * b.w,      a.x * b.y - a.y * b.x,
          size(a.y * b.w, a.w * b.y), size(a.w * b.x, a.x * b.w), size(a.x * b.y, a.y * b.x)};
}

std::array<Line, 3> LinesOf(const RayCorners& v) {
  return {LineThrough(v[1], v[2]), LineThrough(v[2], v[0]), LineThrough(v[0], v[1])};
}

}  // namespace

// A value is sum beta_i c_i / sum beta_i e_i.
ValueEstimate EstimateValue(const RayCorners& v, Interpolation interpolation,
                            const std::array<double, 3>& a, Point2 p) {
  const std::array<Line, 3> lines = LinesOf(v);
  std::array<double, 3> c = a;
  std::array<double, 3> e{1, 1, 1};
  if (interpolation != Interpolation::kPerspective) {
    for (std::size_t i = 0; i < 3; ++i) {
      e[i] = v[i].w;
      if (interpolation == Interpolation::kLinear) c[i] *= v[i].w;
    }
  }
  double n = 0;
  double d = 0;
  std::array<double, 2> dn{};
  std::array<double, 2> dd{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double beta = lines[i].At(p);
    n += beta * c[i];
    d += beta * e[i];
    dn[0] += lines[i].x * c[i];
    dn[1] += lines[i].y * c[i];
    dd[0] += lines[i].x * e[i];
    dd[1] += lines[i].y * e[i];
  }
  ValueEstimate estimate;
  estimate.value = n / d;
  estimate.denominator = d;
  double size = 0;
  double denominator_size = 0;
  std::array<double, 2> slope_sizes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double factor = std::fabs(c[i]) + std::fabs(estimate.value * e[i]);
    size += lines[i].SizeAt(p) * factor;
    denominator_size += lines[i].SizeAt(p) * std::fabs(e[i]);
    slope_sizes[0] += lines[i].size_x * factor;
    slope_sizes[1] += lines[i].size_y * factor;
  }
  const double magnitude = std::fabs(d);
  estimate.condition = size / magnitude;
  estimate.denominator_condition = denominator_size / magnitude;
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const double slope = (dn[axis] - estimate.value * dd[axis]) / d;
    estimate.derivatives[axis] = slope;
    estimate.derivative_conditions[axis] =
        (slope_sizes[axis] + estimate.condition * std::fabs(dd[axis]) +
         std::fabs(slope) * denominator_size) /
        magnitude;
  }
  return estimate;
}

std::array<double, 3> WeightsOfPower(const RayCorners& v, int power, Point2 p) {
  const std::array<Line, 3> lines = LinesOf(v);
  std::array<double, 3> weights{};
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = lines[i].At(p);
    for (int k = 0; k < power; ++k) weights[i] *= v[i].w;
    for (int k = 0; k > power; --k) weights[i] /= v[i].w;
  }
  return weights;
}

}  // namespace rasterproof::props
