#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/ulp.h"
#include "core/vertex.h"
#include "exact/crossing.h"
#include "exact/homogeneous.h"
#include "exact/sample_frame.h"
#include "exact/signs.h"
#include "exact/spans.h"

namespace rasterproof::exact {
namespace {

// Coordinates in which no product, normal or quotient below over- or underflows: products of two in
// [2^-400, 2^400], their residuals multiples of 2^-506, so normals 0 or in [2^-506, 2^401], and the
// quotient below 2^(401 + 18 + 506).
constexpr double kLeastTame = 0x1p-200;
constexpr double kLargestTame = 0x1p200;

bool IsTame(double c) {
  const double magnitude = std::fabs(c);
  return magnitude == 0 || (magnitude >= kLeastTame && magnitude <= kLargestTame);
}

// Error of the column -(ny y + nw) / nx - offset at which a row crosses, in units of T / |nx| + 1.
//
// With T = |ny y| + |nw|: the normals are off by 2 u each, the product and the sum round once more,
// so the numerator is off by at most 4.01 u T; nx by 2 u and the quotient by u, of at most T / |nx|
// each; less the offset: one more of T / |nx| + 1, and the caller's at +- error as much again.
// Together below 9.1 u T / |nx| + 2.1 u; 16 leaves room for the five roundings of the bound.
constexpr double kHomogeneousCrossingErrorMultiplier = 16 * rounding_epsilon<double>();

// a b - c d within 2 u of itself (Kahan's algorithm; Jeannerod, Louvet, Muller 2013), without over-
// or underflow. So it is 0 only if exactly so.
double ProductDifference(double a, double b, double c, double d) {
  const double q = c * d;
  const double q_residual = std::fma(-c, d, q);
  return std::fma(a, b, -q) + q_residual;
}

// One of the three half planes, as a function of the column in a row.
class HalfPlane {
 public:
  HalfPlane(const Vertex& vi, const Vertex& vj, int facing) : vi_(&vi), vj_(&vj), facing_(facing) {
    tame_ = true;
    for (const double c : {vi.x, vi.y, vi.w, vj.x, vj.y, vj.w}) tame_ = tame_ && IsTame(c);
    x_sign_ = facing * ProductDifferenceSign(vj.y, vi.w, vj.w, vi.y);
    if (!tame_) return;
    nx_ = ProductDifference(vj.y, vi.w, vj.w, vi.y);
    ny_ = ProductDifference(vj.w, vi.x, vj.x, vi.w);
    nw_ = ProductDifference(vj.x, vi.y, vj.y, vi.x);
  }

  // Narrows [first, last) to the columns of the row that lie inside.
  void Narrow(const SampleFrame& frame, int row, std::size_t s, int& first, int& last,
              std::uint64_t& certain) const {
    const auto inside = [&](int column) {
      const int sign =
          facing_ * ShiftedHomogeneousEdgeSign(*vi_, *vj_, frame.At(column, row, s), frame.rule);
      return sign > 0 || (sign == 0 && frame.rule.inclusive);
    };
    if (x_sign_ == 0) {  // the same all along the row
      if (!inside(first)) last = first;
      return;
    }
    const Guess guess = Crossing(row + frame.offsets[s].y, frame.offsets[s].x);
    if (x_sign_ > 0) {
      first = FirstColumn(guess, first, last, certain, inside);
    } else {
      last = FirstColumn(guess, first, last, certain, [&](int column) { return !inside(column); });
    }
  }

 private:
  // The zero of nx x + ny y + nw, less the offset.
  Guess Crossing(double y, double offset) const {
    if (!tame_) return {0, std::numeric_limits<double>::infinity()};
    const double reach = (std::fabs(ny_ * y) + std::fabs(nw_)) / std::fabs(nx_);
    return {-(ny_ * y + nw_) / nx_ - offset, kHomogeneousCrossingErrorMultiplier * (reach + 1)};
  }

  const Vertex* vi_;
  const Vertex* vj_;
  int facing_;
  bool tame_ = false;
  int x_sign_ = 0;
  double nx_ = 0;
  double ny_ = 0;
  double nw_ = 0;
};

struct RowRange {
  int begin;
  int end;
};

// Rows that can hold a sample. With every w > 0 the triangle lies between the least and the largest
// y / w, known to half an ulp: far less than the row added on either side. Otherwise: all.
RowRange RowsOf(const std::array<Vertex, 3>& v, const PixelRect& clip, double offset) {
  RowRange rows{clip.y0, clip.y1};
  if (std::ranges::any_of(v, [](const Vertex& c) { return c.w <= 0; })) return rows;
  const auto [low, high] = std::minmax({v[0].y / v[0].w, v[1].y / v[1].w, v[2].y / v[2].w});
  const double first = std::floor(low - offset) - 1;
  const double last = std::ceil(high - offset) + 1;
  if (first >= rows.end || last < rows.begin) return {rows.begin, rows.begin};
  if (first > rows.begin) rows.begin = static_cast<int>(first);
  if (last < rows.end - 1) rows.end = static_cast<int>(last) + 1;
  return rows;
}

}  // namespace

void AddHomogeneousSpans(const std::array<Vertex, 3>& v, int facing, const SampleFrame& frame,
                         SpanTarget& target) {
  // A positive combination of vertices with w <= 0 never reaches w = t > 0.
  if (std::ranges::all_of(v, [](const Vertex& c) { return c.w <= 0; })) return;
  const std::array<HalfPlane, 3> sides{HalfPlane(v[0], v[1], facing), HalfPlane(v[1], v[2], facing),
                                       HalfPlane(v[2], v[0], facing)};
  std::uint64_t certain = 0;
  for (std::size_t s = 0; s < frame.offsets.size(); ++s) {
    const RowRange rows = RowsOf(v, frame.clip, frame.offsets[s].y);
    for (int row = rows.begin; row < rows.end; ++row) {
      int first = frame.clip.x0;
      int last = frame.clip.x1;
      for (const HalfPlane& side : sides) {
        if (first < last) side.Narrow(frame, row, s, first, last, certain);
      }
      target.Row(row, static_cast<int>(s), facing).Add(first, last);
    }
  }
  ThreadTiers().filter += certain;
}

}  // namespace rasterproof::exact
