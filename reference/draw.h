// The stages in order: triangles, set-up, box, rows of tiles, edge values, tie rule, count.
#ifndef RASTERPROOF_REFERENCE_DRAW_H_
#define RASTERPROOF_REFERENCE_DRAW_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "reference/bands.h"
#include "reference/box.h"
#include "reference/machine.h"
#include "reference/method.h"
#include "reference/tie_rule.h"

namespace rasterproof::reference {

/// Throws InputError unless the scene is in window space and the counts have its size.
void RequireWindowScene(const Scene& scene, const CoverageCounts& counts);

/// One triangle's way to the counts: everything that does not depend on the method's arithmetic.
struct TriangleTask {
  std::array<Point2, 3> v;
  PixelRect target;  ///< where walks may start
  PixelRect clip;    ///< what may be written
};

/// Calls paint(task) for every triangle with finite vertices, in each band of the draw area.
template <class Paint>
void ForEachTriangle(const Scene& scene, const RasterOptions& options, CoverageCounts& counts,
                     const Paint& paint) {
  RequireWindowScene(scene, counts);
  const PixelRect target = TargetOf(scene);
  ForEachBand(DrawArea(scene, options), options, [&](const PixelRect& band) {
    for (const Triangle& t : scene.triangles) {
      const std::array<Vertex, 3> corners = Corners(scene, t);
      if (!std::ranges::all_of(corners, IsFinite)) continue;
      paint(
          TriangleTask{{WindowPoint(corners[0]), WindowPoint(corners[1]), WindowPoint(corners[2])},
                       target,
                       band});
    }
  });
}

/// The directed edge a -> b in a form, seen from its lexicographically smaller end if canonical.
template <class Form>
Form MakeForm(typename Form::Point a, typename Form::Point b, bool canonical) {
  const bool reversed = canonical && RunsBackwards(a, b);
  return reversed ? Form(b, a, true) : Form(a, b, false);
}

/// Three edges of a triangle of positive area, walking together.
template <class Walk>
struct WalkingEdges {
  using T = typename Walk::T;
  using Cursors = std::array<typename Walk::Cursor, 3>;
  std::array<Walk, 3> walks;
  std::array<T, 3> inside_from;

  Cursors RowStart(int j) {
    return {walks[0].RowStart(j), walks[1].RowStart(j), walks[2].RowStart(j)};
  }
};

/// Adds one to every sample of columns [x0, x1) that all three edges count as inside.
template <class Cursors, class T>
void ScanRow(Cursors& cursors, const std::array<T, 3>& inside_from, int x0, int x1,
             std::uint32_t* row) {
  auto [e0, e1, e2] = cursors;
  const auto [from0, from1, from2] = inside_from;
  for (int i = x0; i < x1; ++i) {
    row[i] +=
        IsInside(e0.Value(i), from0) & IsInside(e1.Value(i), from1) & IsInside(e2.Value(i), from2);
    e0.Next();
    e1.Next();
    e2.Next();
  }
  cursors = {e0, e1, e2};
}

/// Walks the clipped box tile by tile; every row's cursors go on from one tile to the next.
template <class Walk>
void ScanBox(WalkingEdges<Walk>& edges, const PixelRect& box, const PixelRect& clipped, int tile,
             std::uint32_t* counts, int width) {
  const auto start = [&](int j) {
    auto cursors = edges.RowStart(j);
    for (auto& cursor : cursors) cursor.Skip(clipped.x0 - box.x0);
    return cursors;
  };
  const auto row = [&](int j) { return counts + static_cast<std::ptrdiff_t>(j) * width; };
  if (tile <= 0) {
    for (int j = clipped.y0; j < clipped.y1; ++j) {
      auto cursors = start(j);
      ScanRow(cursors, edges.inside_from, clipped.x0, clipped.x1, row(j));
    }
    return;
  }
  std::vector<typename WalkingEdges<Walk>::Cursors> cursors;
  for (int y = clipped.y0; y < clipped.y1;) {
    const int end_y = std::min(clipped.y1, (y / tile + 1) * tile);
    cursors.clear();
    for (int j = y; j < end_y; ++j) cursors.push_back(start(j));
    for (int x = clipped.x0; x < clipped.x1;) {
      const int end_x = std::min(clipped.x1, (x / tile + 1) * tile);
      for (int j = y; j < end_y; ++j) {
        ScanRow(cursors[static_cast<std::size_t>(j - y)], edges.inside_from, x, end_x, row(j));
      }
      x = end_x;
    }
    y = end_y;
  }
}

/// Draws one triangle by testing every sample of its box.
template <class Walk, TieRule kTies>
void DrawBox(const TriangleTask& task, const RasterOptions& options, CoverageCounts& counts) {
  using Form = typename Walk::Form;
  using T = typename Walk::T;
  const PixelRect box = SampleBox(task.v, task.target);
  const PixelRect clipped = Intersection(box, task.clip);
  if (IsEmpty(clipped)) return;

  std::array<typename Form::Point, 3> v{Form::Convert(task.v[0]), Form::Convert(task.v[1]),
                                        Form::Convert(task.v[2])};
  const T area = MakeForm<Form>(v[0], v[1], options.canonical_edges).At(v[2].x, v[2].y);
  if (!(area > 0 || area < 0)) return;
  const bool front = area > 0;
  if (options.cull == (front ? Cull::kFront : Cull::kBack)) return;
  if (!front) std::swap(v[1], v[2]);

  const auto walk = [&](int a, int b) {
    const auto& from = v[static_cast<std::size_t>(a)];
    const auto& to = v[static_cast<std::size_t>(b)];
    return Walk(MakeForm<Form>(from, to, options.canonical_edges), box.x0, box.y0);
  };
  const auto inside_from = [&](int a, int b) {
    return InsideFrom<T>(kTies == TieRule::kInclusive ||
                         IsTopLeft(v[static_cast<std::size_t>(a)], v[static_cast<std::size_t>(b)]));
  };
  WalkingEdges<Walk> edges{{walk(0, 1), walk(1, 2), walk(2, 0)},
                           {inside_from(0, 1), inside_from(1, 2), inside_from(2, 0)}};
  std::uint32_t* const buffer = (front ? counts.front : counts.back).data();
  RunForThisMachine([&] { ScanBox(edges, box, clipped, TileSide(options), buffer, counts.width); });
}

/// Draws a scene by one walk: the `draw` of a row of the table.
template <class Walk, TieRule kTies = TieRule::kTopLeft>
void DrawScene(const Scene& scene, const RasterOptions& options, CoverageCounts& counts) {
  ForEachTriangle(scene, options, counts,
                  [&](const TriangleTask& task) { DrawBox<Walk, kTies>(task, options, counts); });
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_DRAW_H_
