// What the kernel of clip space decides exactly, compiled for any machine.
#include <cmath>

#include "library/exact_sum.h"
#include "library/kernels/clip_errors.h"
#include "library/kernels/kernel_table.h"

namespace rasterproof::library::kernels {
namespace {

/// An edge's N = V_j x V_i, each component a difference of two products that are exact, for the
/// coordinates are float32: sums of two factors do, where reference/homogeneous_exact.cc has three.
struct ClipNormal {
  double plus[3], minus[3];

  ClipNormal(const ClipTriangle& t, int i, int j)
      : plus{t.y[j] * t.w[i], t.w[j] * t.x[i], t.x[j] * t.y[i]},
        minus{t.w[j] * t.y[i], t.x[j] * t.w[i], t.y[j] * t.x[i]} {}

  /// Rounded once, so its sign is exact.
  double At(int k) const { return plus[k] - minus[k]; }
};

int SignOf(double v) { return v > 0 ? 1 : v < 0 ? -1 : 0; }

/// Adds factor N . (x, y, w).
///
/// Domain:     factor x and factor y are exact, or factor is 1.
void AddDot(ExactSum& sum, const ClipNormal& n, double factor, double x, double y, double w) {
  const double p[3] = {factor * x, factor * y, factor * w};
  for (int k = 0; k < 3; ++k) {
    sum.Add(p[k], n.plus[k]);
    sum.Subtract(p[k], n.minus[k]);
  }
}

/// The sign of N . (x, y, 1).
int EdgeDotSign(const ClipNormal& n, double x, double y) {
  const double products[3] = {n.At(0) * x, n.At(1) * y, n.At(2)};
  const double value = (products[0] + products[1]) + products[2];
  const double bound =
      kClipDotError * (std::fabs(products[0]) + std::fabs(products[1]) + std::fabs(products[2]));
  if (std::fabs(value) > bound) return SignOf(value);
  ExactSum sum;
  AddDot(sum, n, 1, x, y, 1);
  return sum.Sign();
}

/// The sign of the sum over corners of z_k, or z_k + w_k, times the opposite edge at (x, y).
int NearDotSign(const ClipTriangle& t, double x, double y) {
  const bool has_w = t.near_plane == NearPlane::kMinusW;
  double value = 0;
  double sizes = 0;
  for (int k = 0; k < 3; ++k) {
    const ClipNormal opposite(t, (k + 1) % 3, (k + 2) % 3);
    const double products[3] = {opposite.At(0) * x, opposite.At(1) * y, opposite.At(2)};
    const double factor = has_w ? t.z[k] + t.w[k] : t.z[k];
    value += factor * ((products[0] + products[1]) + products[2]);
    sizes += std::fabs(factor) *
             (std::fabs(products[0]) + std::fabs(products[1]) + std::fabs(products[2]));
  }
  if (std::fabs(value) > kClipNearError * sizes) return SignOf(value);
  ExactSum sum;
  for (int k = 0; k < 3; ++k) {
    const ClipNormal opposite(t, (k + 1) % 3, (k + 2) % 3);
    AddDot(sum, opposite, t.z[k], x, y, 1);
    if (has_w) AddDot(sum, opposite, t.w[k], x, y, 1);
  }
  return sum.Sign();
}

/// The first number from `first` to `last` at which `is_inside` is what it is at the end, of a
/// predicate that changes once.
template <class Predicate>
int ChangeOf(int first, int last, bool at_end, const Predicate& is_inside) {
  while (first < last) {
    const int middle = first + (last - first) / 2;
    if (is_inside(middle) == at_end) {
      last = middle;
    } else {
      first = middle + 1;
    }
  }
  return first;
}

/// Leaves of [first, last) the numbers inside, of a half-line.
template <class Predicate>
void Narrow(int& first, int& last, const Predicate& is_inside) {
  if (first >= last) return;
  const bool begins = is_inside(first);
  const bool ends = is_inside(last - 1);
  if (begins && ends) return;
  if (!begins && !ends) {
    last = first;
    return;
  }
  (begins ? last : first) = ChangeOf(first, last - 1, ends, is_inside);
}

}  // namespace

double ClipDeterminant(const ClipTriangle& t) {
  ExactSum sum;
  AddDot(sum, ClipNormal(t, 1, 2), 1, t.x[0], t.y[0], t.w[0]);
  return sum.ToDouble();
}

bool IsInsideClipEdge(const ClipTriangle& t, int edge, int facing, double x, double y) {
  if (edge == kNearEdge) return facing * NearDotSign(t, x, y) >= 0;
  const ClipNormal n(t, edge, (edge + 1) % 3);
  const int sign = facing * EdgeDotSign(n, x, y);
  if (sign != 0) return sign > 0;
  // The top-left rule moves the sample right, then down.
  const int by_x = facing * SignOf(n.At(0));
  return by_x > 0 || (by_x == 0 && facing * SignOf(n.At(1)) > 0);
}

void ClipColumns(const ClipTriangle& t, int edge, int facing, int row, int& first, int& last) {
  Narrow(first, last, [&](int i) { return IsInsideClipEdge(t, edge, facing, i + 0.5, row + 0.5); });
}

void ClipRows(const ClipTriangle& t, int edge, int facing, int& first, int& last) {
  Narrow(first, last, [&](int j) { return IsInsideClipEdge(t, edge, facing, 0.5, j + 0.5); });
}

}  // namespace rasterproof::library::kernels
