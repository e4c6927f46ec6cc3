// The fill stage: edge values along the rows of a box, the tie rule, the count.
#ifndef RASTERPROOF_REFERENCE_FILL_H_
#define RASTERPROOF_REFERENCE_FILL_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vertex.h"
#include "reference/bands.h"
#include "reference/edge_forms.h"
#include "reference/edge_ownership.h"
#include "reference/edge_walks.h"
#include "reference/machine.h"
#include "reference/method.h"

namespace rasterproof::reference {

/// The directed edge a -> b in a form, seen from its lexicographically smaller end if canonical.
template <EdgeForm Form>
Form MakeForm(typename Form::Point a, typename Form::Point b, bool canonical) {
  const bool reversed = canonical && RunsBackwards(a, b);
  return reversed ? Form(b, a, true) : Form(a, b, false);
}

/// Three edges of a triangle of positive area, walking together.
template <RowWalking Walk>
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
template <RowWalking Walk>
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

/// A triangle's corners in the number format of a form.
template <EdgeForm Form>
std::array<typename Form::Point, 3> Converted(const Corners3& v) {
  return {Form::Convert(WindowPoint(v[0])), Form::Convert(WindowPoint(v[1])),
          Form::Convert(WindowPoint(v[2]))};
}

/// A method's facing stage: the sign of E(v0, v1; v2) as the form rounds it.
template <EdgeForm Form>
int FacingBy(const Corners3& corners, const RasterOptions& options) {
  const auto v = Converted<Form>(corners);
  const auto area = MakeForm<Form>(v[0], v[1], options.canonical_edges).At(v[2].x, v[2].y);
  return area > 0 ? 1 : (area < 0 ? -1 : 0);
}

/// A method's fill stage: tests every sample of the area.
template <RowWalking Walk, EdgeOwnership kTies = EdgeOwnership::kTopLeft>
void FillByWalk(const Corners3& corners, const RasterOptions& options, const FillTarget& to) {
  using Form = typename Walk::Form;
  using T = typename Walk::T;
  const auto v = Converted<Form>(corners);
  const auto walk = [&](std::size_t a, std::size_t b) {
    return Walk(MakeForm<Form>(v[a], v[b], options.canonical_edges), to.box.x0, to.box.y0);
  };
  const auto inside_from = [&](std::size_t a, std::size_t b) {
    return InsideFrom<T>(kTies == EdgeOwnership::kInclusive || IsTopLeft(v[a], v[b]));
  };
  WalkingEdges<Walk> edges{{walk(0, 1), walk(1, 2), walk(2, 0)},
                           {inside_from(0, 1), inside_from(1, 2), inside_from(2, 0)}};
  RunForThisMachine(
      [&] { ScanBox(edges, to.box, to.area, TileSide(options), to.counts, to.width); });
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_FILL_H_
