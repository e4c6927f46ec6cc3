// The pixels whose open squares an edge meets, row by row: exact decisions.
#ifndef RASTERPROOF_LIBRARY_EDGE_SQUARES_H_
#define RASTERPROOF_LIBRARY_EDGE_SQUARES_H_

#include "core/vertex.h"

namespace rasterproof::library {

/// Columns [first, last) of a row; none if first >= last.
struct ColumnRange {
  int first = 0;
  int last = 0;
};

/// The closed segment from a to b beside the open squares (i, i + 1) x (j, j + 1) of a target.
///
/// In the open strip of row j the segment is an interval of x, from its end there or from where it
/// crosses the strip's side. It meets the square of column i if and only if that interval reaches
/// below i + 1 and above i: floors and ceilings of its two ends say which columns those are.
class EdgeSquares {
 public:
  /// Domain:     a and b finite; 1 <= width, height <= kMaxTargetSide.
  EdgeSquares(Point2 a, Point2 b, int width, int height);

  /// The target's rows [first_row, end_row) that the segment meets.
  int first_row() const { return first_row_; }
  int end_row() const { return end_row_; }

  /// The columns whose squares in row j it meets, within the target.
  ///
  /// Domain:     first_row() <= j < end_row().
  /// Error:      none.
  /// Cost:       a product, a sum and a rounding for each side of the strip that it crosses, one
  ///             less in the row after the last one asked for; an exact sign where that is within
  ///             twice RowCrossing::kCrossingError of a whole number, or 18 of them beyond
  ///             RowCrossing::kGuessDomain.
  ColumnRange At(int j);

 private:
  // Whole numbers at or beside an x: equal if it is one. Clamped to [-1, width + 1].
  struct Neighbours {
    int floor;
    int ceiling;
  };
  Neighbours OfX(double x) const;
  Neighbours OfCrossing(int y) const;
  Neighbours SearchCrossing(int y) const;
  // The sign of E(upper, lower; (i, y)), which grows to the right.
  int SignAt(int i, int y) const;

  Point2 upper_;
  Point2 lower_;
  int width_;
  int first_row_;
  int end_row_;
  double slope_;
  bool guess_is_proved_;
  int last_y_ = -1;  // the last side of a strip that was asked for, and what was found
  Neighbours last_{};
};

}  // namespace rasterproof::library

#endif  // RASTERPROOF_LIBRARY_EDGE_SQUARES_H_
