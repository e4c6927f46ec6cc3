// Exact spans of one triangle: the daily work behind Coverage.
#ifndef RASTERPROOF_EXACT_SPANS_H_
#define RASTERPROOF_EXACT_SPANS_H_

#include <array>

#include "core/coverage.h"
#include "core/vertex.h"
#include "exact/crossing.h"
#include "exact/sample_frame.h"

namespace rasterproof::exact {

/// Counts being written as differences along each row: a span costs two additions, whatever its
/// length. Sum() turns them into counts.
class SpanTarget {
 public:
  explicit SpanTarget(CoverageCounts& counts) : counts_(&counts) {}

  SpanSink Row(int row, int s, int facing) {
    std::vector<std::uint32_t>& plane = facing > 0 ? counts_->front : counts_->back;
    return {plane.data() + counts_->Index(0, row, s), counts_->samples, counts_->width};
  }
  void Sum();

 private:
  CoverageCounts* counts_;
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
