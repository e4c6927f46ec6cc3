// The column at which a row crosses an edge: guessed in double, corrected by exact signs.
#ifndef RASTERPROOF_EXACT_CROSSING_H_
#define RASTERPROOF_EXACT_CROSSING_H_

#include <algorithm>
#include <cstdint>

namespace rasterproof::exact {

/// A place on a row, in columns, known up to an error: it lies strictly between at - error and
/// at + error. If nothing is known, the error is infinite and `at` is finite.
struct Guess {
  double at = 0;
  double error = 0;
};

/// min(max(ceil(v), begin), end) for 0 <= begin <= end; v may be infinite.
inline int ClampedCeiling(double v, int begin, int end) {
  if (!(v > begin)) return begin;
  if (v > end - 1) return end;
  const int whole = static_cast<int>(v);  // v > 0: truncation is the floor
  return whole + (whole < v ? 1 : 0);
}

/// The first column in [begin, end) that `beyond` holds for, or `end`.
///
/// Domain:     beyond is monotone (false, then true) and turns true at the first column at or right
///             of the crossing, or at the next column if the crossing is exactly at a column.
/// Properties: asks `beyond` only for columns that the guess can't decide: none, usually.
template <class Beyond>
int FirstColumn(Guess guess, int begin, int end, std::uint64_t& certain, Beyond&& beyond) {
  // If both ends round up to the same column then no column's place lies in between, ties included.
  int low = ClampedCeiling(guess.at - guess.error, begin, end);
  int high = ClampedCeiling(guess.at + guess.error, begin, end);
  if (low == high) [[likely]] {
    ++certain;
    return low;
  }
  // Columns before `low` lie left of the crossing. Those from `high` on lie right of it.
  while (low < high) {
    const int middle = low + (high - low) / 2;
    if (beyond(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return low;
}

/// Adds `+1` to the samples [first, last) of a row of differences (prefix-summed at the end).
struct SpanSink {
  std::uint32_t* row = nullptr;  ///< the row's sample 0 of column 0, plus s
  int stride = 1;                ///< samples per pixel
  int width = 0;

  void Add(int first, int last) const {
    if (first >= last) return;
    ++row[first * stride];
    if (last < width) --row[last * stride];
  }
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_CROSSING_H_
