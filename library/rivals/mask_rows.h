// Traversal::kMaskTiles: the crossings of spans.h as shifted masks of 8 rows by 32 pixels, in the
// manner of masked occlusion culling, into strips of 32 pixels that are turned into rows at the
// end.
//
// A tile of 32x8 that is full is skipped by a bit in its row of tiles.
#ifndef RASTERPROOF_LIBRARY_RIVALS_MASK_ROWS_H_
#define RASTERPROOF_LIBRARY_RIVALS_MASK_ROWS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"
#include "library/rivals/reals.h"
#include "library/rivals/spans.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Eight rows of a strip.
using D8 = hn::CappedTag<float, 8>;
using DI8 = hn::Rebind<std::int32_t, D8>;
using DU8 = hn::Rebind<std::uint32_t, D8>;
constexpr int kEight = kLanesOf<D8>;

/// All bits from the n-th on; none if n >= 32.
HWY_INLINE hn::Vec<DU8> BitsFrom(hn::Vec<DU8> n) {
  const DU8 du;
  const auto all = hn::Set(du, 0xffffffffU);
#if HWY_TARGET <= HWY_AVX2
  return hn::Shl(all, n);  // vpsllvd shifts everything out
#else
  // A shift by 32 is undefined: by half and the rest.
  const auto shift = hn::Min(n, hn::Set(du, 32U));
  const auto half = hn::ShiftRight<1>(shift);
  return hn::Shl(hn::Shl(all, half), hn::Sub(shift, half));
#endif
}

class MaskStrips {
 public:
  HWY_INLINE explicit MaskStrips(const KernelView& view)
      : view_(view), words_(view.strips), full_(view.full_tiles) {}

  /// The 8x8 pixels from (x, y), in one strip or two.
  HWY_INLINE void Or8x8(int x, int y, std::uint64_t bits) {
    std::uint32_t* p = words_ + (x >> 5) * view_.strip_height + y;
    const int shift = x & 31;
    alignas(8) std::uint8_t bytes[8];
    __builtin_memcpy(bytes, &bits, 8);
    const DU8 du;
    for (int r = 0; r < 8; r += kEight) {
      const auto rows = hn::PromoteTo(du, hn::LoadU(hn::Rebind<std::uint8_t, DU8>(), bytes + r));
      hn::StoreU(hn::Or(hn::LoadU(du, p + r), hn::ShiftLeftSame(rows, shift)), du, p + r);
      if (shift > 24) {
        std::uint32_t* next = p + view_.strip_height + r;
        hn::StoreU(hn::Or(hn::LoadU(du, next), hn::ShiftRightSame(rows, 32 - shift)), du, next);
      }
    }
  }

  HWY_INLINE void OrTriangle(const SpanBlock<float>& block, int i) {
    const D8 d;
    const DI8 di;
    const Box box = block.BoxOf(i);
    const SpanEdges<D8, false> edges(block, [&](const float* p) { return hn::Set(d, p[i]); });
    const auto column = [&](hn::Vec<D8> crossing) {
      const auto from = hn::Max(hn::Ceil(crossing), hn::Set(d, static_cast<float>(box.x0)));
      return hn::ConvertTo(di, hn::Min(from, hn::Set(d, static_cast<float>(box.x1))));
    };
    const int first = box.x0 >> 5;
    const int end = (box.x1 + 31) >> 5;
    for (int y = box.y0 & ~7; y < box.y1; y += 8) {
      hn::Vec<DI8> left[8 / kEight], right[8 / kEight];
      auto least = hn::Set(di, box.x1);
      auto most = hn::Zero(di);
      for (int v = 0; v < 8 / kEight; ++v) {
        const auto row = FloatsFrom(d, static_cast<float>(y + v * kEight));
        hn::Vec<D8> by_long, by_short;
        edges.At(hn::Add(row, hn::Set(d, 0.5F)), by_long, by_short);
        const auto a = column(by_long);
        const auto b = column(by_short);
        const auto inside =
            hn::RebindMask(di, hn::And(hn::Ge(row, hn::Set(d, static_cast<float>(box.y0))),
                                       hn::Lt(row, hn::Set(d, static_cast<float>(box.y1)))));
        // Rows outside the box begin where the target ends.
        left[v] = hn::IfThenElse(inside, hn::Min(a, b), hn::Set(di, 1 << 20));
        right[v] = hn::IfThenElseZero(inside, hn::Max(a, b));
        least = hn::Min(least, left[v]);
        most = hn::Max(most, right[v]);
      }
      OrTiles(y, Greatest(first, hn::GetLane(hn::MinOfLanes(di, least)) >> 5),
              Least(end, (hn::GetLane(hn::MaxOfLanes(di, most)) + 31) >> 5), left, right);
    }
  }

  /// Adds the strips to the view's mask.
  HWY_INLINE void Resolve() const {
    auto* line = static_cast<std::uint8_t*>(view_.planes[0]);
    for (int y = 0; y < view_.height; ++y, line += view_.pitch) {
      const std::uint32_t* word = words_ + y;
      for (int x = 0; x < view_.width; x += 32, word += view_.strip_height) {
        std::uint32_t old;
        __builtin_memcpy(&old, line + (x >> 3), 4);
        old |= *word;
        __builtin_memcpy(line + (x >> 3), &old, 4);
      }
    }
  }

 private:
  /// The tiles [first, end) of the row of tiles at y, but those that are full.
  HWY_INLINE void OrTiles(int y, int first, int end, const hn::Vec<DI8> (&left)[8 / kEight],
                          const hn::Vec<DI8> (&right)[8 / kEight]) {
    for (int group = first >> 6; 64 * group < end; ++group) {
      std::uint64_t& full = full_[(y >> 3) * view_.full_pitch + group];
      std::uint64_t open = ~full;
      if (64 * group < first) open &= ~std::uint64_t{0} << (first & 63);
      if (end - 64 * group < 64) open &= (std::uint64_t{1} << (end & 63)) - 1;
      for (; open != 0; open &= open - 1) {
        const int bit = CountTrailingZeros(open);
        if (OrTile(y, 64 * group + bit, left, right)) full |= std::uint64_t{1} << bit;
      }
    }
  }

  /// Returns whether the tile is full now.
  HWY_INLINE bool OrTile(int y, int tile, const hn::Vec<DI8> (&left)[8 / kEight],
                         const hn::Vec<DI8> (&right)[8 / kEight]) {
    const DI8 di;
    const DU8 du;
    const auto from = hn::Set(di, 32 * tile);
    std::uint32_t* p = words_ + tile * view_.strip_height + y;
    bool is_full = true;
    for (int v = 0; v < 8 / kEight; ++v) {
      const auto begin = hn::BitCast(du, hn::Max(hn::Sub(left[v], from), hn::Zero(di)));
      const auto end = hn::BitCast(du, hn::Max(hn::Sub(right[v], from), hn::Zero(di)));
      const auto rows =
          hn::Or(hn::LoadU(du, p + v * kEight), hn::AndNot(BitsFrom(end), BitsFrom(begin)));
      hn::StoreU(rows, du, p + v * kEight);
      is_full &= hn::AllTrue(du, hn::Eq(rows, hn::Set(du, 0xffffffffU)));
    }
    return is_full;
  }

  const KernelView& view_;
  std::uint32_t* words_;
  std::uint64_t* full_;
};

inline void DrawMaskRows(const KernelView& view) {
  MaskStrips strips(view);
  SpanBlock<float> block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpSpans<float, Form::kDirect, false>(view, indices, block);
        if (block.small != 0) FindSmallSpans<float, false>(block);
      },
      [&](int i, std::uint32_t /*triangle*/) {
        if (block.IsSmall(i)) {
          strips.Or8x8(block.x0[i], block.y0[i], block.masks[i]);
        } else {
          strips.OrTriangle(block, i);
        }
      });
  strips.Resolve();
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_MASK_ROWS_H_
