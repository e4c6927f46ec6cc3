// Exact square coverage: which pixels' squares a triangle meets, or holds.
#ifndef RASTERPROOF_EXACT_SQUARE_H_
#define RASTERPROOF_EXACT_SQUARE_H_

#include <array>
#include <functional>

#include "core/draw_options.h"
#include "core/square_rule.h"
#include "core/vertex.h"

namespace rasterproof::exact {

/// The squares of a target in screen axes (x right, y down).
///
/// The square of column i and row r is [i, i + 1] x [r - lift, r - lift + 1]: with y up a vertex is
/// turned over (y -> -y), so lift is the target's height, and floor sides lie below.
struct SquareFrame {
  PixelRect clip;
  bool y_up = false;
  double lift = 0;

  Point2 ToScreen(Point2 p) const { return y_up ? Point2{p.x, -p.y} : p; }
};

/// The columns [first, last) of a row.
struct Columns {
  int first = 0;
  int last = 0;
};

/// Receives the columns of one row.
using SquareRow = std::function<void(int row, Columns columns)>;

/// Calls `row` for every row of the clip that has squares of the region, from the top.
///
/// A flat triangle counts as its closed segment or point, whichever closure the region states for
/// the shape, and is grown by sweeping.
/// Domain:     v finite, in screen axes; IsDecidable(region).
/// Error:      none.
/// Cost:       per row one guessed crossing for each edge that passes it, two as a rule, and exact
///             signs where the guess cannot tell; no work per pixel. Growth by edges: three
///             crossings in every row of the clip.
/// Source:     separating axes of convex polygons: docs/decisions/oracle.md.
void ForEachSquareSpan(const std::array<Point2, 3>& v, const SquareRegion& region,
                       const SquareFrame& frame, const SquareRow& row);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_SQUARE_H_
