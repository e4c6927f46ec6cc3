#include "props/judging/values/value_estimates.h"

#include <algorithm>
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

// The numbers that a value is sum beta_i c_i / sum beta_i e_i of.
struct Factors {
  std::array<double, 3> c{};
  std::array<double, 3> e{};
};

Factors FactorsOf(const RayCorners& v, Interpolation interpolation,
                  const std::array<double, 3>& a) {
  Factors factors{a, {1, 1, 1}};
  if (interpolation == Interpolation::kPerspective) return factors;
  for (std::size_t i = 0; i < 3; ++i) {
    factors.e[i] = v[i].w;
    if (interpolation == Interpolation::kLinear) factors.c[i] *= v[i].w;
  }
  return factors;
}

double SizeOfProducts(Point2 s, Point2 t) { return std::fabs(s.x * t.y) + std::fabs(s.y * t.x); }

Point2 Between(Point2 a, Point2 b) { return {b.x - a.x, b.y - a.y}; }

// Of the products of an edge function, from whichever of its ends has the larger ones.
double SizeOfEdge(Point2 a, Point2 b, Point2 p) {
  return std::max(SizeOfProducts(Between(a, p), Between(a, b)),
                  SizeOfProducts(Between(b, p), Between(a, b)));
}

}  // namespace

// A value is sum beta_i c_i / sum beta_i e_i.
ValueEstimate EstimateValue(const RayCorners& v, Interpolation interpolation,
                            const std::array<double, 3>& a, Point2 p) {
  const std::array<Line, 3> lines = LinesOf(v);
  const auto [c, e] = FactorsOf(v, interpolation, a);
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
    estimate.denominator_slopes[axis] = dd[axis];
    estimate.derivative_conditions[axis] =
        (slope_sizes[axis] + estimate.condition * std::fabs(dd[axis]) +
         std::fabs(slope) * denominator_size) /
        magnitude;
  }
  return estimate;
}

UsualConditions UsualConditionsOf(const RayCorners& v, Interpolation interpolation,
                                  const std::array<double, 3>& a, Point2 p) {
  std::array<Point2, 3> at{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(v[i].w > 0)) return {};
    at[i] = {v[i].x / v[i].w, v[i].y / v[i].w};
  }
  const ValueEstimate e = EstimateValue(v, interpolation, a, p);
  const double largest = std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
  const Factors factors = FactorsOf(v, interpolation, {largest, largest, largest});
  const std::array<Line, 3> lines = LinesOf(v);
  const double area =
      at[0].x * (at[1].y - at[2].y) + at[1].x * (at[2].y - at[0].y) + at[2].x * (at[0].y - at[1].y);
  const double size_of_area =
      std::max({SizeOfEdge(at[0], at[1], at[2]), SizeOfEdge(at[1], at[2], at[0]),
                SizeOfEdge(at[2], at[0], at[1])});
  const double of_area = size_of_area / std::fabs(area);
  const double d = std::fabs(e.denominator);
  UsualConditions usual{0, {}, of_area};
  std::array<double, 2> slopes{};
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const double size = (lines[i].SizeAt(p) + v[j].w * v[k].w * SizeOfEdge(at[j], at[k], p)) / d;
    const double factor = factors.c[i] + std::fabs(e.value * factors.e[i]);
    usual.value += size * factor;
    usual.denominator += size * factors.e[i];
    slopes[0] += lines[i].size_x / d * factor;
    slopes[1] += lines[i].size_y / d * factor;
  }
  usual.value += of_area * std::max(std::fabs(e.value), largest);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    usual.derivatives[axis] = e.derivative_conditions[axis] +
                              slopes[axis] * (1 + usual.denominator) +
                              std::fabs(e.derivatives[axis]) * usual.denominator +
                              usual.value * std::fabs(e.denominator_slopes[axis]) / d;
  }
  return usual;
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
