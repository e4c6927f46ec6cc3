// A second implementation of interpolated values, from their definition: planes over the window
// through the numbers at the corners, by Gaussian elimination in GMP's rationals. It shares no
// code, no number type and no formula with what it checks: no edge function and no determinant.
#ifndef RASTERPROOF_TESTS_EXACT_NAIVE_VALUES_H_
#define RASTERPROOF_TESTS_EXACT_NAIVE_VALUES_H_

#include <gmpxx.h>

#include <array>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/channel.h"
#include "core/vertex.h"
#include "exact/values.h"

namespace rasterproof::exact {

/// Rows (x, y, w) of three corners.
using NaiveRows = std::array<std::array<mpq_class, 3>, 3>;

inline NaiveRows NaiveRowsOf(const std::array<Vertex, 3>& v) {
  NaiveRows rows;
  for (std::size_t i = 0; i < 3; ++i) {
    rows[i] = {mpq_class(v[i].x), mpq_class(v[i].y), mpq_class(v[i].w)};
  }
  return rows;
}

struct NaiveValue {
  mpq_class value;
  mpq_class dx;
  mpq_class dy;
};

/// The plane (A, B, C) with A x_i + B y_i + C w_i = right_i; nothing if it is not unique.
inline std::optional<std::array<mpq_class, 3>> NaivePlane(NaiveRows rows,
                                                          std::array<mpq_class, 3> right) {
  for (std::size_t k = 0; k < 3; ++k) {
    std::size_t pivot = k;
    while (pivot < 3 && rows[pivot][k] == 0) ++pivot;
    if (pivot == 3) return std::nullopt;
    std::swap(rows[k], rows[pivot]);
    std::swap(right[k], right[pivot]);
    for (std::size_t i = 0; i < 3; ++i) {
      if (i == k || rows[i][k] == 0) continue;
      const mpq_class factor = rows[i][k] / rows[k][k];
      for (std::size_t j = k; j < 3; ++j) rows[i][j] -= factor * rows[k][j];
      right[i] -= factor * right[k];
    }
  }
  return std::array<mpq_class, 3>{right[0] / rows[0][0], right[1] / rows[1][1],
                                  right[2] / rows[2][2]};
}

/// Value and derivatives at p. On the window a/w, 1/w and what is linear on the screen are planes;
/// a value in perspective is the quotient of the first two.
inline std::optional<NaiveValue> NaiveValueAt(const NaiveRows& rows, Interpolation interpolation,
                                              const std::array<mpq_class, 3>& a, Point2 p) {
  const mpq_class x(p.x);
  const mpq_class y(p.y);
  const auto on_plane = [&](const std::array<mpq_class, 3>& right) -> std::optional<NaiveValue> {
    const auto plane = NaivePlane(rows, right);
    if (!plane) return std::nullopt;
    const auto& [slope_x, slope_y, at_origin] = *plane;
    return NaiveValue{slope_x * x + slope_y * y + at_origin, slope_x, slope_y};
  };
  if (interpolation == Interpolation::kLinear) {
    return on_plane({a[0] * rows[0][2], a[1] * rows[1][2], a[2] * rows[2][2]});
  }
  const auto over_w = on_plane(a);
  if (interpolation == Interpolation::kInverseW) return over_w;
  const auto inverse_w = on_plane({1, 1, 1});
  if (!over_w || !inverse_w || inverse_w->value == 0) return std::nullopt;
  const mpq_class square = inverse_w->value * inverse_w->value;
  return NaiveValue{over_w->value / inverse_w->value,
                    (over_w->dx * inverse_w->value - over_w->value * inverse_w->dx) / square,
                    (over_w->dy * inverse_w->value - over_w->value * inverse_w->dy) / square};
}

/// Whether the two deciders' numbers are the same rationals.
inline bool Equal(const ValueAndDerivatives& a, const NaiveValue& b) {
  return a.value.ToString() == b.value.get_str() && a.dx.ToString() == b.dx.get_str() &&
         a.dy.ToString() == b.dy.get_str();
}

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_TESTS_EXACT_NAIVE_VALUES_H_
