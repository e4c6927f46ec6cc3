// The kernels that plans choose from: row spans in an arithmetic that is exact for the scene.
#ifndef RASTERPROOF_REFERENCE_PLAN_KERNEL_H_
#define RASTERPROOF_REFERENCE_PLAN_KERNEL_H_

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/scene.h"
#include "reference/bands.h"
#include "reference/box.h"
#include "reference/edge_ownership.h"
#include "reference/homogeneous_edges.h"
#include "reference/machine.h"
#include "reference/plan_scene.h"
#include "reference/sample_grid.h"

namespace rasterproof::reference {

/// Coordinates and edge values in T, integers in units of 2^-lattice.
template <class T>
struct PlanArithmetic {
  double units;  ///< in a pixel

  PlanArithmetic(const Scene& scene, const Profile& profile)
      : units(std::ldexp(1.0, SceneLattice(scene, profile))) {}
  T Convert(double x) const { return static_cast<T>(x * units); }
};

/// Which stages a kernel keeps; the others are compiled out.
struct PlanStages {
  bool snap = true;
  bool clip = true;
};

/// A directed edge whose inside is positive.
template <class T>
struct PlanEdge {
  T x, y, dx, dy;
  T from;  ///< smallest value that is inside

  PlanEdge(Point2 a, Point2 b, const PlanArithmetic<T>& arithmetic, bool owns_ties)
      : x(arithmetic.Convert(a.x)),
        y(arithmetic.Convert(a.y)),
        dx(arithmetic.Convert(b.x) - x),
        dy(arithmetic.Convert(b.y) - y),
        from(owns_ties ? 0 : 1) {}

  T At(T px, T py) const { return (px - x) * dy - (py - y) * dx; }
};

/// An edge over the samples of a box: E = start + column across + row down, every partial sum of it
/// the difference of E at two samples of the box.
template <class T>
class BoxEdge {
 public:
  /// (px, py): the box's first sample.
  BoxEdge(const PlanEdge<T>& edge, T px, T py, const PixelRect& box, T pixel)
      : start_(edge.At(px, py)),
        // With one column or row there is nothing to step to, and the product need not fit.
        across_(box.x1 - box.x0 > 1 ? edge.dy * pixel : T{0}),
        down_(box.y1 - box.y0 > 1 ? -edge.dx * pixel : T{0}),
        from_(edge.from),
        columns_(across_ != 0 ? 1 / static_cast<double>(across_) : 0),
        width_(box.x1 - box.x0),
        inside_first_(across_ < 0) {}

  /// Narrows the columns [first, last) of a row to those inside.
  void Narrow(int row, int& first, int& last) const {
    const int crossing = Crossing(row);
    if (inside_first_) {
      last = std::min(last, crossing);
    } else {
      first = std::max(first, crossing);
    }
  }

 private:
  /// The first column of a row that is on the other side than the columns before it; the box's
  /// width if there is none. Where E does not change along a row, 0 (inside) or the width.
  ///
  /// The crossing is (from - E) / across columns from the first. In double it has a relative error
  /// of 2^-51 and, as far as it matters, at most 2^16 columns: it is off by less than 2^-34,
  /// the bias included (proofs/crossing.g).
  /// With 32 bits E takes fewer than 2^31 steps from column to column. Then the true crossing is a
  /// column or at least 2^-31 away from one, and kBias tells the two apart: no sample is looked at.
  /// With 64 bits the floor of the guess is at most one column beyond the last that has not changed
  /// side; E decides from there, upwards, and is asked for samples of the box only.
  int Crossing(int row) const {
    const T at_row = start_ + static_cast<T>(row) * down_;
    if (across_ == 0) return at_row < from_ ? width_ : 0;
    const double guess = (static_cast<double>(from_) - static_cast<double>(at_row)) * columns_;
    if constexpr (sizeof(T) <= 4) {
      // A column that the crossing falls on is inside: the last one, or the first.
      constexpr double kBias = 0x1p-33;
      const double changed = guess + (inside_first_ ? 1 + kBias : 1 - kBias);
      return static_cast<int>(std::clamp(changed, 0.0, static_cast<double>(width_)));
    } else {
      int i = static_cast<int>(std::clamp(guess, 0.0, width_ - 1.0));
      while (i < width_ && IsInside(at_row, i) == inside_first_) ++i;
      return i;
    }
  }
  bool IsInside(T at_row, int column) const {
    return at_row + static_cast<T>(column) * across_ >= from_;
  }

  T start_, across_, down_;
  T from_;
  double columns_;  ///< columns per unit of E
  int width_;
  bool inside_first_;
};

/// The samples of one offset whose rows and columns meet the closed box.
template <bool kClip>
PixelRect PlannedBox(Point2 least, Point2 most, Point2 offset, const PixelRect& area) {
  if constexpr (kClip) {
    const int x0 = FirstSampleFrom(least.x, offset.x, area.x0, area.x1);
    const int y0 = FirstSampleFrom(least.y, offset.y, area.y0, area.y1);
    return {x0, y0, FirstSampleBeyond(most.x, offset.x, x0, area.x1),
            FirstSampleBeyond(most.y, offset.y, y0, area.y1)};
  } else {
    // On the lattice the differences are exact, and the plan proved the results inside the area.
    return {static_cast<int>(std::ceil(least.x - offset.x)),
            static_cast<int>(std::ceil(least.y - offset.y)),
            static_cast<int>(std::floor(most.x - offset.x)) + 1,
            static_cast<int>(std::floor(most.y - offset.y)) + 1};
  }
}

/// The edges of a triangle, oriented so that the inside is positive, by the rows that they bound.
template <class T>
struct PlanTriangle {
  double middle_y;
  PlanEdge<T> whole;  ///< from the least y to the largest
  PlanEdge<T> upper;  ///< the other two meet in the middle vertex
  PlanEdge<T> lower;
};
template <class T>
PlanTriangle<T> OrientEdges(const std::array<Point2, 3>& v, bool front,
                            const PlanArithmetic<T>& arithmetic, const TieRule& rule) {
  const auto edge = [&](std::size_t from, std::size_t to) {
    // Vertices i and i + 1 are ends in drawing order, which is the order of a front-facing edge.
    const bool in_order = ((from + 1) % 3 == to) == front;
    const Point2 a = v[in_order ? from : to];
    const Point2 b = v[in_order ? to : from];
    // E moves by dY when the sample moves right, by -dX when it moves down.
    return PlanEdge<T>(a, b, arithmetic, OwnsTies(b.y - a.y, a.x - b.x, rule));
  };
  std::array<std::size_t, 3> by_y{0, 1, 2};
  const auto order = [&](std::size_t i, std::size_t j) {
    if (v[by_y[j]].y < v[by_y[i]].y) std::swap(by_y[i], by_y[j]);
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  return {v[by_y[1]].y, edge(by_y[0], by_y[2]), edge(by_y[0], by_y[1]), edge(by_y[1], by_y[2])};
}

/// The counts of one box: rows of samples `stride` words apart.
struct BoxCounts {
  std::uint32_t* first_sample;
  std::ptrdiff_t stride;
  std::ptrdiff_t row_stride;

  void AddToRow(int row, int first, int last) const {
    std::uint32_t* const samples = first_sample + row * row_stride;
    if (stride == 1) {  // neighbours in memory: vectorised
      for (int i = first; i < last; ++i) ++samples[i];
    } else {
      for (int i = first; i < last; ++i) ++samples[i * stride];
    }
  }
};

/// Adds one to the samples of rows [row, end) that every given edge counts as inside.
template <class... Edges>
void FillRows(int row, int end, int width, const BoxCounts& counts, const Edges&... edges) {
  for (; row < end; ++row) {
    int first = 0;
    int last = width;
    (edges.Narrow(row, first, last), ...);
    counts.AddToRow(row, first, last);
  }
}

/// Fills the samples of a box that all edges which bound their row count as inside: rows above the
/// middle vertex cross the upper one of two edges, rows below it the lower one, its own row both.
template <class T>
void FillBox(const PlanTriangle<T>& triangle, const PlanArithmetic<T>& arithmetic,
             const PixelRect& box, Point2 offset, const BoxCounts& counts) {
  const T px = arithmetic.Convert(box.x0 + offset.x);
  const T py = arithmetic.Convert(box.y0 + offset.y);
  const T pixel = arithmetic.Convert(1);
  const BoxEdge<T> whole(triangle.whole, px, py, box, pixel);
  const BoxEdge<T> upper(triangle.upper, px, py, box, pixel);
  const BoxEdge<T> lower(triangle.lower, px, py, box, pixel);
  const int width = box.x1 - box.x0;
  const int above = FirstSampleFrom(triangle.middle_y, offset.y, box.y0, box.y1) - box.y0;
  const int below = FirstSampleBeyond(triangle.middle_y, offset.y, box.y0, box.y1) - box.y0;
  FillRows(0, above, width, counts, whole, upper);
  FillRows(above, below, width, counts, whole, upper, lower);
  FillRows(below, box.y1 - box.y0, width, counts, whole, lower);
}

template <class T, PlanStages kStages>
void DrawPlannedTriangle(const std::array<Point2, 3>& v, const PlanArithmetic<T>& arithmetic,
                         const SampleGrid& grid, const Profile& profile, Cull cull,
                         const PixelRect& area, CoverageCounts& counts) {
  const T twice_area = PlanEdge<T>(v[0], v[1], arithmetic, false)
                           .At(arithmetic.Convert(v[2].x), arithmetic.Convert(v[2].y));
  if (twice_area == 0) return;
  const bool front = twice_area > 0;
  if (cull == (front ? Cull::kFront : Cull::kBack)) return;
  const PlanTriangle<T> triangle = OrientEdges<T>(v, front, arithmetic, profile.tie_rule);
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  const int samples = grid.samples();
  std::uint32_t* const buffer = (front ? counts.front : counts.back).data();
  for (int s = 0; s < samples; ++s) {
    const Point2 offset = grid.offsets[static_cast<std::size_t>(s)];
    const PixelRect box = PlannedBox<kStages.clip>({left, top}, {right, bottom}, offset, area);
    if (IsEmpty(box)) continue;
    const BoxCounts samples_of_box{buffer + counts.Index(box.x0, box.y0, s), samples,
                                   static_cast<std::ptrdiff_t>(samples) * counts.width};
    RunForThisMachine([&] { FillBox(triangle, arithmetic, box, offset, samples_of_box); });
  }
}

/// A plan's draw function.
template <class T, PlanStages kStages>
void DrawPlanned(const Scene& scene, const Profile& profile, const DrawOptions& options,
                 CoverageCounts& counts) {
  const SampleGrid grid(profile, scene.height);
  RequireShape(scene, grid, counts);
  const PlanArithmetic<T> arithmetic(scene, profile);
  const auto draw = [&](const PixelRect& area) {
    for (const Triangle& t : scene.triangles) {
      const auto v = ScreenCorners<kStages.snap>(scene, t, profile.snap, grid);
      if (!v) continue;
      DrawPlannedTriangle<T, kStages>(*v, arithmetic, grid, profile, options.cull, area, counts);
    }
  };
  if constexpr (kStages.clip) {
    ForEachBand(DrawArea(scene, options), options, draw);
  } else {
    draw(DrawArea(scene, options));
  }
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_PLAN_KERNEL_H_
