// Exact row spans of one triangle: the fast path of Coverage.
#ifndef RASTERPROOF_EXACT_SPANS_H_
#define RASTERPROOF_EXACT_SPANS_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/vertex.h"
#include "exact/crossing.h"
#include "exact/sample_frame.h"

namespace rasterproof::exact {

/// Counts, kept as differences along each row while they are written: a span of any length costs
/// two additions. Sum() turns them into counts.
class SpanTarget {
 public:
  explicit SpanTarget(CoverageCounts& counts) : counts_(&counts), begin_(counts.height) {}

  SpanSink Row(int row, int s, int facing) {
    begin_ = std::min(begin_, row);
    end_ = std::max(end_, row + 1);
    std::vector<std::uint32_t>& plane = facing > 0 ? counts_->front : counts_->back;
    return {plane.data() + counts_->Index(0, row, s), counts_->samples, counts_->width};
  }
  void Sum();
  /// Calls `covered` with the index of every covered sample and resets the counts to zero. Use
  /// either this or Sum().
  ///
  /// Cost:       the rows that hold spans.
  template <class Covered>
  void Take(const Covered& covered) {
    const auto samples = static_cast<std::size_t>(counts_->samples);
    for (; begin_ < end_; ++begin_) {
      const std::size_t first = counts_->Index(0, begin_);
      const std::size_t last = first + static_cast<std::size_t>(counts_->width) * samples;
      for (std::size_t s = 0; s < samples; ++s) {
        std::uint32_t count = 0;
        for (std::size_t k = first + s; k < last; k += samples) {
          count += std::exchange(counts_->front[k], 0) + std::exchange(counts_->back[k], 0);
          if (count != 0) covered(k);
        }
      }
    }
    begin_ = counts_->height;
    end_ = 0;
  }

 private:
  CoverageCounts* counts_;
  int begin_;  ///< the rows that hold spans
  int end_ = 0;
};

/// Adds the spans of a window-space triangle in screen axes.
///
/// Domain:     finite, of the given facing (not 0).
void AddWindowSpans(const std::array<Point2, 3>& v, int facing, const SampleFrame& frame,
                    SpanTarget& target);

/// Adds the spans of a clip-space triangle in screen axes: every w, the eye's plane included.
///
/// Domain:     finite, of the given facing (not 0).
void AddHomogeneousSpans(const std::array<Vertex, 3>& v, int facing, const SampleFrame& frame,
                         SpanTarget& target);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_SPANS_H_
