#include "library/row_crossing.h"

#include <cmath>

#include "core/own_precision.h"
#include "core/vertex.h"

namespace rasterproof::library {

RowCrossing::RowCrossing(Point2 upper, Point2 lower) : upper_(upper), lower_(lower) {
  const double dy = lower.y - upper.y;
  slope_ = (lower.x - upper.x) / dy;
  guess_is_proved_ = std::fabs(upper.x) <= kGuessDomain && std::fabs(lower.x) <= kGuessDomain &&
                     std::isfinite(dy) && std::isfinite(slope_);
}

int RowCrossing::SearchCrossing(int j, int low, int high) const {
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (IsAtOrRightOf(middle, j)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

int RowCrossing::ResolveAt(int j, int column) const {
  return IsAtOrRightOf(column, j) ? column : column + 1;
}

}  // namespace rasterproof::library
