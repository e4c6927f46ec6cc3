#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/vertex.h"
#include "exact/row_edge.h"
#include "exact/sample_frame.h"
#include "exact/signs.h"
#include "exact/spans.h"

namespace rasterproof::exact {
namespace {

// Two edges that bound the rows [begin, end).
class Band {
 public:
  Band(const RowEdge& a, const RowEdge& b, int begin, int end)
      : a_(&a), b_(&b), begin_(begin), end_(end) {}

  void AddSpans(const SampleFrame& frame, std::size_t s, int facing, SpanTarget& target,
                std::uint64_t& certain) const {
    // The first column whose shifted sample lies right of the edge. Under the inclusive rule the
    // samples on an edge belong to the span at either end of it, under the exclusive rule at
    // neither.
    for (int row = begin_; row < end_; ++row) {
      const int a = a_->FirstColumnAtSide(frame, row, s, +1, certain);
      const int b = b_->FirstColumnAtSide(frame, row, s, +1, certain);
      int first = std::min(a, b);
      int last = std::max(a, b);
      if (!frame.rule.IsConsistent()) {
        const int on_a = a_->FirstColumnAtSide(frame, row, s, 0, certain);
        const int on_b = b_->FirstColumnAtSide(frame, row, s, 0, certain);
        if (frame.rule.inclusive) {
          first = std::min(on_a, on_b);
        } else {
          last = std::max(on_a, on_b);
        }
      }
      target.Row(row, static_cast<int>(s), facing).Add(first, last);
    }
  }

 private:
  const RowEdge* a_;
  const RowEdge* b_;
  int begin_;
  int end_;
};

}  // namespace

void AddWindowSpans(const std::array<Point2, 3>& v, int facing, const SampleFrame& frame,
                    SpanTarget& target) {
  std::array<Point2, 3> by_y = v;
  if (by_y[1].y < by_y[0].y) std::swap(by_y[0], by_y[1]);
  if (by_y[2].y < by_y[1].y) std::swap(by_y[1], by_y[2]);
  if (by_y[1].y < by_y[0].y) std::swap(by_y[0], by_y[1]);
  const auto& [top, middle, bottom] = by_y;

  // A row exactly at a vertex belongs to the band below it if the samples shift down, else to the
  // one above. Under the inclusive rule the bands are closed, save that the lower one leaves the
  // middle row to the upper one if that is there. Under the exclusive rule they are open, save that
  // the upper one takes the middle row if the lower one is there to go on from it.
  const TieRule& rule = frame.rule;
  const bool upper_band = top.y < middle.y;
  const bool lower_band = middle.y < bottom.y;
  const bool shifts_up = rule.IsConsistent() && rule.sign_y < 0;
  const bool skips_top = shifts_up || rule.exclusive;
  const bool through_end = shifts_up || rule.inclusive;
  const bool upper_takes_middle = rule.exclusive ? lower_band : through_end;
  const bool lower_skips_middle = rule.inclusive ? upper_band : skips_top;

  const RowEdge longest(top, bottom);
  const RowEdge upper(top, middle);
  const RowEdge lower(middle, bottom);
  std::uint64_t certain = 0;
  for (std::size_t s = 0; s < frame.offsets.size(); ++s) {
    const auto row_of = [&](double y, bool strict) {
      return FirstRowAtOrBelow(y, strict, frame.offsets[s].y, frame.clip.y0, frame.clip.y1);
    };
    const int end = row_of(bottom.y, through_end);
    if (upper_band) {
      Band(longest, upper, row_of(top.y, skips_top), row_of(middle.y, upper_takes_middle))
          .AddSpans(frame, s, facing, target, certain);
    }
    Band(longest, lower, row_of(middle.y, lower_skips_middle), end)
        .AddSpans(frame, s, facing, target, certain);
  }
  ThreadTiers().filter += certain;
}

}  // namespace rasterproof::exact
