#include "library/edge_squares.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/own_precision.h"
#include "core/vertex.h"
#include "library/exact_sign.h"
#include "library/row_crossing.h"

namespace rasterproof::library {

EdgeSquares::EdgeSquares(Point2 a, Point2 b, int width, int height)
    : upper_(a), lower_(b), width_(width) {
  if (upper_.y > lower_.y) std::swap(upper_, lower_);
  const double most = height;
  first_row_ = static_cast<int>(std::clamp(std::floor(upper_.y), 0.0, most));
  end_row_ = static_cast<int>(std::clamp(std::ceil(lower_.y), 0.0, most));
  const double dy = lower_.y - upper_.y;
  slope_ = (lower_.x - upper_.x) / dy;
  guess_is_proved_ = std::fabs(upper_.x) <= RowCrossing::kGuessDomain &&
                     std::fabs(lower_.x) <= RowCrossing::kGuessDomain && std::isfinite(dy) &&
                     std::isfinite(slope_);
}

ColumnRange EdgeSquares::At(int j) {
  const Neighbours above = j == last_y_ ? last_ : (upper_.y >= j ? OfX(upper_.x) : OfCrossing(j));
  const Neighbours below = lower_.y <= j + 1 ? OfX(lower_.x) : OfCrossing(j + 1);
  last_y_ = j + 1;
  last_ = below;
  return {std::max(0, std::min(above.floor, below.floor)),
          std::min(width_, std::max(above.ceiling, below.ceiling))};
}

EdgeSquares::Neighbours EdgeSquares::OfX(double x) const {
  const double clamped = std::clamp(x, -0.5, width_ + 0.5);
  return {static_cast<int>(std::floor(clamped)), static_cast<int>(std::ceil(clamped))};
}

// RowCrossing's guess and its error, at a side of the strip in place of the centres' line.
EdgeSquares::Neighbours EdgeSquares::OfCrossing(int y) const {
  if (!guess_is_proved_) return SearchCrossing(y);
  constexpr double kReach = 2 * RowCrossing::kCrossingError;
  const double guess = upper_.x + (y - upper_.y) * slope_;
  if (guess <= -0.5 || guess >= width_ + 0.5) return OfX(guess);
  const int i = static_cast<int>(std::floor(guess + kReach));
  if (guess - i > kReach) return {i, i + 1};
  const int sign = SignAt(i, y);
  return {sign > 0 ? i - 1 : i, sign < 0 ? i + 1 : i};
}

EdgeSquares::Neighbours EdgeSquares::SearchCrossing(int y) const {
  int low = 0;
  int high = width_ + 1;
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (SignAt(middle, y) >= 0) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  const bool is_on_it = low <= width_ && SignAt(low, y) == 0;
  return {is_on_it ? low : low - 1, low};
}

int EdgeSquares::SignAt(int i, int y) const {
  return EdgeSign(upper_, lower_, {static_cast<double>(i), static_cast<double>(y)});
}

}  // namespace rasterproof::library
