// Traversal::kSpans in integers: vertices snapped to 1/256 px, crossings in 64 bits with 32 after
// the point.
//
// As spans.h, stepped: of an edge from its upper end (xa, ya), the slope is dx / dy, one division
// in double, cut off to 2^-32; the crossing of its first row is rounded to 2^-32, and each row adds
// the slope. No sum leaves 64 bits: what is asked for lies between the edge's ends, |x| <= 2^14 px.
#ifndef RASTERPROOF_LIBRARY_RIVALS_FIXED_SPANS_H_
#define RASTERPROOF_LIBRARY_RIVALS_FIXED_SPANS_H_

#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/exact_rows.h"
#include "library/kernels/exact_small.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"
#include "library/rivals/fixed_tiles.h"
#include "library/rivals/reals.h"
#include "library/rivals/spans.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

struct alignas(64) FixedSpanBlock : Block {
  /// Crossings of the edges' first rows plus 1/2 less a bit, so that the whole part is the column.
  std::int64_t from[3][kBlock];
  std::int64_t slope[3][kBlock];
  std::int32_t middle_row[kBlock];  ///< the first row at or below the middle corner
  std::uint64_t masks[kBlock];
};

/// The columns of kLanes crossings.
HWY_INLINE VI WholeParts(const VI64 (&v)[kLanes / kDoubles]) {
#if HWY_TARGET == HWY_SCALAR
  return hn::Set(DI(), static_cast<std::int32_t>(v[0].raw >> 32));
#else
  return hn::ConcatOdd(DI(), hn::BitCast(DI(), v[1]), hn::BitCast(DI(), v[0]));
#endif
}

template <bool kWithZ>
HWY_NOINLINE void SetUpFixedSpans(const KernelView& view, const std::uint32_t* indices,
                                  FixedSpanBlock& block) {
  const DDF d;
  const DDI di;
  const DD dd;
  const DI64 wide;
  for (int at = 0; at < kBlock; at += kDoubles) {
    const auto c = LoadCorners<kWithZ>(d, view.vertices, indices + 3 * at);
    if constexpr (kWithZ) StorePlanes(d, c, at, block);
    SnappedCorners s(c);
    std::uint64_t odd = 0;
    for (const int k : {0, 1, 0}) {
      odd ^= MaskBits(di, SortPair(s.y[k], s.y[k + 1], s.x[k], s.x[k + 1]));
    }
    const auto first_row = FirstCentreFromFixed(di, s.y[0], view.height);
    const auto middle_row = FirstCentreFromFixed(di, s.y[1], view.height);
    const std::uint32_t boxed = StoreBox(di, FirstCentreFromFixed(di, Min3(s.x), view.width),
                                         FirstCentreFromFixed(di, Max3(s.x), view.width), first_row,
                                         FirstCentreFromFixed(di, s.y[2], view.height), at, block);
    hn::Store(middle_row, di, block.middle_row + at);
    VD x[3], y[3];
    for (int k = 0; k < 3; ++k) {
      x[k] = hn::PromoteTo(dd, s.x[k]);
      y[k] = hn::PromoteTo(dd, s.y[k]);
    }
    const VD area = TwiceArea(x, y);
    constexpr int kEnds[3][2] = {{0, 1}, {1, 2}, {0, 2}};
    for (int k = 0; k < 3; ++k) {
      const int a = kEnds[k][0];
      const int b = kEnds[k][1];
      // 0 of an edge along the rows, which crosses none.
      const VD down = hn::Sub(y[b], y[a]);
      const VD slope =
          hn::IfThenZeroElse(hn::Eq(down, hn::Zero(dd)), hn::Div(hn::Sub(x[b], x[a]), down));
      const auto row = a == 0 ? first_row : middle_row;
      const auto centre = hn::Add(hn::ShiftLeft<8>(row), hn::Set(di, 128));
      const VD below = hn::PromoteTo(dd, hn::Sub(centre, s.y[a]));
      const VI64 start = hn::ShiftLeft<24>(hn::PromoteTo(wide, s.x[a]));
      const VI64 beyond = ToInt64(hn::Mul(hn::Mul(below, slope), hn::Set(dd, 0x1p24)));
      const VI64 up = hn::Set(wide, (std::int64_t{1} << 31) - 1);
      hn::Store(hn::Add(hn::Add(start, beyond), up), wide, block.from[k] + at);
      hn::Store(hn::ConvertTo(wide, hn::Mul(slope, hn::Set(dd, 0x1p32))), wide,
                block.slope[k] + at);
    }
    block.front |= static_cast<std::uint32_t>(MaskBits(dd, hn::Gt(area, hn::Zero(dd))) ^ odd) << at;
    block.drawn |= (boxed & static_cast<std::uint32_t>(HasArea(dd, area))) << at;
  }
  FindSmall(block);
}

/// The span of kLanes rows, or of a row of kLanes triangles.
struct FixedRows {
  VI first, last;

  HWY_INLINE FixedRows(VI x0, VI x1, VI by_long, VI by_short) {
    const VI a = hn::Max(by_long, x0);
    const VI b = hn::Max(by_short, x0);
    first = hn::Min(hn::Min(a, b), x1);
    last = hn::Min(hn::Max(a, b), x1);
  }
};

/// Fills in the masks of the small triangles, kLanes of them a row at a time.
inline HWY_NOINLINE void FindSmallFixedSpans(FixedSpanBlock& block) {
  const DI di;
  const DI64 wide;
  constexpr int kParts = kLanes / kDoubles;
  for (int at = 0; at < kBlock; at += kLanes) {
    if (((block.small >> at) & ((std::uint64_t{1} << kLanes) - 1)) == 0) continue;
    const VI x0 = hn::Load(di, block.x0 + at);
    const VI x1 = hn::Min(hn::Load(di, block.x1 + at), hn::Add(x0, hn::Set(di, 8)));
    const VI y0 = hn::Load(di, block.y0 + at);
    const VI rows = hn::Sub(hn::Load(di, block.y1 + at), y0);
    const VI middle = hn::Sub(hn::Load(di, block.middle_row + at), y0);
    VI64 edges[3][kParts], slopes[3][kParts], middles[kParts];
    for (int part = 0; part < kParts; ++part) {
      const int i = at + part * kDoubles;
      for (int k = 0; k < 3; ++k) {
        edges[k][part] = hn::Load(wide, block.from[k] + i);
        slopes[k][part] = hn::Load(wide, block.slope[k] + i);
      }
      const auto row =
          hn::Sub(hn::Load(DDI(), block.middle_row + i), hn::Load(DDI(), block.y0 + i));
      middles[part] = hn::PromoteTo(wide, row);
    }
    VI halves[2] = {hn::Zero(di), hn::Zero(di)};
    for (int row = 0; row < block.height; ++row) {
      const auto is_upper = hn::Gt(middle, hn::Set(di, row));
      const VI by_short =
          hn::IfThenElse(is_upper, WholeParts(edges[kUpper]), WholeParts(edges[kLower]));
      const FixedRows crossed(x0, x1, WholeParts(edges[kLong]), by_short);
      for (int part = 0; part < kParts; ++part) {
        edges[kLong][part] = hn::Add(edges[kLong][part], slopes[kLong][part]);
        edges[kUpper][part] = hn::Add(edges[kUpper][part], slopes[kUpper][part]);
        // The lower edge begins at the middle row.
        const auto above = hn::Gt(middles[part], hn::Set(wide, row));
        edges[kLower][part] =
            hn::Add(edges[kLower][part], hn::IfThenZeroElse(above, slopes[kLower][part]));
      }
      const VI one = hn::Set(di, 1);
      const VI bits = hn::Sub(hn::Shl(one, hn::Sub(crossed.last, x0)),
                              hn::Shl(one, hn::Sub(crossed.first, x0)));
      const auto covered = hn::Gt(rows, hn::Set(di, row));
      VI& half = halves[row >> 2];
      half = hn::Or(half, hn::ShiftLeftSame(hn::IfThenElseZero(covered, bits), 8 * (row & 3)));
    }
    StoreMasks(halves, block.masks + at);
  }
}

/// The crossings of one edge with the rows from the first on, kLanes at a time; modulo 2^64, right
/// in its own rows.
class FixedSteps {
 public:
  /// The edge's first row is `skipped` rows beyond the first.
  HWY_INLINE FixedSteps(const FixedSpanBlock& block, int edge, int i, int skipped) {
    const auto slope = static_cast<std::uint64_t>(block.slope[edge][i]);
    std::uint64_t at = static_cast<std::uint64_t>(block.from[edge][i]) -
                       static_cast<std::uint64_t>(skipped) * slope;
    alignas(64) std::uint64_t lanes[kLanes];
    for (std::uint64_t& lane : lanes) {
      lane = at;
      at += slope;
    }
    for (int part = 0; part < kLanes / kDoubles; ++part) {
      const auto* const p = reinterpret_cast<const std::int64_t*>(lanes + part * kDoubles);
      at_[part] = hn::Load(DI64(), p);
    }
    step_ = hn::Set(DI64(), static_cast<std::int64_t>(kLanes * slope));
  }

  HWY_INLINE VI Next() {
    const VI columns = WholeParts(at_);
    for (VI64& at : at_) at = hn::Add(at, step_);
    return columns;
  }

 private:
  VI64 at_[kLanes / kDoubles], step_;
};

/// Draws the rows of a triangle, kLanes at a time.
template <class Sink>
HWY_NOINLINE void DrawFixedRows(const FixedSpanBlock& block, int i, Sink sink) {
  const DI di;
  const Box box = block.BoxOf(i);
  const VI x0 = hn::Set(di, box.x0);
  const VI x1 = hn::Set(di, box.x1);
  FixedSteps whole(block, kLong, i, 0);
  FixedSteps upper(block, kUpper, i, 0);
  FixedSteps lower(block, kLower, i, block.middle_row[i] - box.y0);
  const VI lane = hn::ConvertTo(di, FloatsFrom(DF(), 0));
  for (int row = box.y0; row < box.y1; row += kLanes) {
    const auto is_upper = hn::Lt(lane, hn::Set(di, block.middle_row[i] - row));
    const VI by_upper = upper.Next();
    const FixedRows crossed(x0, x1, whole.Next(), hn::IfThenElse(is_upper, by_upper, lower.Next()));
    EmitRows(sink, box.x1 - box.x0, row, Least(kLanes, box.y1 - row), crossed.first, crossed.last);
  }
}

template <class Sink>
void DrawFixedSpans(const KernelView& view) {
  Sink sink(view);
  FixedSpanBlock block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpFixedSpans<Sink::kNeedsPlane>(view, indices, block);
        if (block.small != 0) FindSmallFixedSpans(block);
      },
      [&](int i, std::uint32_t triangle) {
        sink.Begin(triangle, block.IsFront(i), block.PlaneOf(i));
        if (block.IsSmall(i)) {
          if (block.masks[i] != 0) sink.Mask8x8(block.x0[i], block.y0[i], block.masks[i]);
        } else {
          DrawFixedRows(block, i, sink);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_FIXED_SPANS_H_
