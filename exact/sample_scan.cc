#include "exact/sample_scan.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include "core/coverage.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/sample_frame.h"

namespace rasterproof::exact {
namespace {

// [begin, end) shrunk to the pixels that can have a sample in [low, high]. Every sample of a pixel
// lies within (-1 - H, 1) of its index: the caller gives the least and largest offset.
struct Range {
  int begin;
  int end;
};

Range Shrink(Range range, double low, double high, double least_offset, double largest_offset) {
  const double first = std::floor(low - largest_offset) - 1;
  const double last = std::ceil(high - least_offset) + 1;
  if (first >= range.end || last < range.begin) return {range.begin, range.begin};
  return {first > range.begin ? static_cast<int>(first) : range.begin,
          last < range.end - 1 ? static_cast<int>(last) + 1 : range.end};
}

PixelRect BoxOf(const std::array<Vertex, 3>& v, const SampleFrame& frame) {
  const auto [x_low, x_high] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [y_low, y_high] = std::minmax({v[0].y, v[1].y, v[2].y});
  const auto [x_least, x_largest] = std::ranges::minmax(frame.offsets, {}, &Point2::x);
  const auto [y_least, y_largest] = std::ranges::minmax(frame.offsets, {}, &Point2::y);
  const Range x = Shrink({frame.clip.x0, frame.clip.x1}, x_low, x_high, x_least.x, x_largest.x);
  const Range y = Shrink({frame.clip.y0, frame.clip.y1}, y_low, y_high, y_least.y, y_largest.y);
  return {x.begin, y.begin, x.end, y.end};
}

}  // namespace

void ScanSamples(const std::array<Vertex, 3>& v, bool clip_space, int facing,
                 const SampleFrame& frame, Decider decider, CoverageCounts& counts) {
  const PixelRect box = clip_space ? frame.clip : BoxOf(v, frame);
  const std::array<Point2, 3> window{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])};
  std::vector<std::uint32_t>& plane = facing > 0 ? counts.front : counts.back;
  for (int row = box.y0; row < box.y1; ++row) {
    for (int i = box.x0; i < box.x1; ++i) {
      for (std::size_t s = 0; s < frame.offsets.size(); ++s) {
        const Point2 p = frame.At(i, row, s);
        const bool covers = clip_space ? HomogeneousCovers(v, p, frame.rule, decider)
                                       : Covers(window, p, frame.rule, decider);
        if (covers) ++plane[counts.Index(i, row, static_cast<int>(s))];
      }
    }
  }
}

}  // namespace rasterproof::exact
