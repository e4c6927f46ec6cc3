#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/vertex.h"
#include "exact/crossing.h"
#include "exact/homogeneous.h"
#include "exact/homogeneous_crossing.h"
#include "exact/sample_frame.h"
#include "exact/signs.h"
#include "exact/spans.h"

namespace rasterproof::exact {
namespace {

// One of the three half planes, as a function of the column in a row.
class ClipHalfPlane {
 public:
  ClipHalfPlane(const Vertex& vi, const Vertex& vj, int facing)
      : vi_(&vi), vj_(&vj), crossing_(vi, vj), facing_(facing) {
    x_sign_ = facing * ProductDifferenceSign(vj.y, vi.w, vj.w, vi.y);
  }

  // Narrows [first, last) to the columns of the row that lie inside.
  void Narrow(const SampleFrame& frame, int row, std::size_t s, int& first, int& last,
              std::uint64_t& certain) const {
    const auto inside = [&](int column) {
      const int sign =
          facing_ * ShiftedHomogeneousEdgeSign(*vi_, *vj_, frame.At(column, row, s), frame.rule);
      return sign > 0 || (sign == 0 && frame.rule.inclusive);
    };
    if (x_sign_ == 0) {  // the same all along the row
      if (!inside(first)) last = first;
      return;
    }
    const Guess guess = crossing_.At(row + frame.offsets[s].y, frame.offsets[s].x);
    if (x_sign_ > 0) {
      first = FirstColumn(guess, first, last, certain, inside);
    } else {
      last = FirstColumn(guess, first, last, certain, [&](int column) { return !inside(column); });
    }
  }

 private:
  const Vertex* vi_;
  const Vertex* vj_;
  HomogeneousCrossing crossing_;
  int facing_;
  int x_sign_ = 0;
};

struct RowRange {
  int begin;
  int end;
};

// Rows that can hold a sample. With every w > 0 the triangle lies between the least and the largest
// y / w, known to half an ulp: far less than the row added on either side. Otherwise all rows.
RowRange RowsOf(const std::array<Vertex, 3>& v, const PixelRect& clip, double offset) {
  RowRange rows{clip.y0, clip.y1};
  if (std::ranges::any_of(v, [](const Vertex& c) { return c.w <= 0; })) return rows;
  const auto [low, high] = std::minmax({v[0].y / v[0].w, v[1].y / v[1].w, v[2].y / v[2].w});
  const double first = std::floor(low - offset) - 1;
  const double last = std::ceil(high - offset) + 1;
  if (first >= rows.end || last < rows.begin) return {rows.begin, rows.begin};
  if (first > rows.begin) rows.begin = static_cast<int>(first);
  if (last < rows.end - 1) rows.end = static_cast<int>(last) + 1;
  return rows;
}

}  // namespace

void AddHomogeneousSpans(const std::array<Vertex, 3>& v, int facing, const SampleFrame& frame,
                         SpanTarget& target) {
  // A positive combination of vertices with w <= 0 never reaches w = t > 0.
  if (std::ranges::all_of(v, [](const Vertex& c) { return c.w <= 0; })) return;
  const std::array<ClipHalfPlane, 3> sides{ClipHalfPlane(v[0], v[1], facing),
                                           ClipHalfPlane(v[1], v[2], facing),
                                           ClipHalfPlane(v[2], v[0], facing)};
  std::uint64_t certain = 0;
  for (std::size_t s = 0; s < frame.offsets.size(); ++s) {
    const RowRange rows = RowsOf(v, frame.clip, frame.offsets[s].y);
    for (int row = rows.begin; row < rows.end; ++row) {
      int first = frame.clip.x0;
      int last = frame.clip.x1;
      for (const ClipHalfPlane& side : sides) {
        if (first < last) side.Narrow(frame, row, s, first, last, certain);
      }
      target.Row(row, static_cast<int>(s), facing).Add(first, last);
    }
  }
  ThreadTiers().filter += certain;
}

}  // namespace rasterproof::exact
