// What the exact kernel seldom needs, compiled for any machine.
#include "core/vertex.h"
#include "library/exact_sign.h"
#include "library/kernels/kernel_table.h"
#include "library/row_crossing.h"

namespace rasterproof::library::kernels {

bool IsCentreAtOrRight(const ExactEdge& edge, double x, double y) {
  return EdgeSign({edge.ax, edge.ay}, {edge.cx, edge.cy}, {x, y}) >= 0;
}

int ExactCrossing(const ExactEdge& edge, int row, int width) {
  return RowCrossing({edge.ax, edge.ay}, {edge.cx, edge.cy}).At(row, 0, width);
}

}  // namespace rasterproof::library::kernels
