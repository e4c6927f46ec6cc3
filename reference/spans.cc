#include "reference/spans.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/vertex.h"
#include "library/exact_sign.h"
#include "library/row_crossing.h"
#include "reference/box.h"
#include "reference/machine.h"
#include "reference/method.h"

namespace rasterproof::reference {
namespace {

/// Adds one to the span [x0, x1) of each row in [row0, row1) between two edges.
void FillRows(const library::RowCrossing& one, const library::RowCrossing& other, int row0,
              int row1, FillTarget to) {
  const auto [counts, width] = std::pair{to.counts, to.width};
  for (int j = row0; j < row1; ++j) {
    const int at_one = one.At(j, to.area.x0, to.area.x1);
    const int at_other = other.At(j, to.area.x0, to.area.x1);
    std::uint32_t* const row = counts + static_cast<std::ptrdiff_t>(j) * width;
    const int end = std::max(at_one, at_other);
    for (int i = std::min(at_one, at_other); i < end; ++i) ++row[i];
  }
}

/// Rows whose samples lie in [from, to), inside `clip`; empty if first >= second.
std::pair<int, int> RowsBetween(double from, double to, const PixelRect& clip) {
  return {FirstCentreFrom(from, clip.y0, clip.y1), FirstCentreFrom(to, clip.y0, clip.y1)};
}

}  // namespace

int ExactFacing(const Corners3& v, const RasterOptions& /*options*/) {
  return library::EdgeSign(WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2]));
}

void FillSpans(const Corners3& v, const RasterOptions& /*options*/, const FillTarget& to) {
  std::array<Point2, 3> by_y{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
  std::ranges::sort(by_y, {}, &Point2::y);
  const auto& [top, middle, bottom] = by_y;
  const auto [first, last] = RowsBetween(top.y, bottom.y, to.area);
  if (first >= last) return;
  const library::RowCrossing whole(top, bottom);
  const int bend = FirstCentreFrom(middle.y, first, last);
  RunForThisMachine([&] {
    if (first < bend) FillRows(whole, library::RowCrossing(top, middle), first, bend, to);
    if (bend < last) FillRows(whole, library::RowCrossing(middle, bottom), bend, last, to);
  });
}

}  // namespace rasterproof::reference
