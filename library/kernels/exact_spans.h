// The exact kernel: one decision per edge and row, none per pixel; exact for every finite float32.
#ifndef RASTERPROOF_LIBRARY_KERNELS_EXACT_SPANS_H_
#define RASTERPROOF_LIBRARY_KERNELS_EXACT_SPANS_H_

#include <cstddef>
#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/exact_block.h"
#include "library/kernels/exact_crossings.h"
#include "library/kernels/exact_rows.h"
#include "library/kernels/exact_small.h"
#include "library/kernels/exact_steps.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// A triangle beyond kGuessDomain, row by row.
template <class Sink>
HWY_NOINLINE void DrawFar(const KernelView& view, const ExactBlock& block, int i,
                          std::uint32_t triangle, Sink& sink) {
  bool has_begun = false;
  for (int row = block.y0[i]; row < block.y1[i]; ++row) {
    const bool is_upper = row + 0.5 < double{block.y[1][i]};
    const int by_long = ExactCrossing(block.EdgeOf(kLongEdge, i), row, view.width);
    const int by_short =
        ExactCrossing(block.EdgeOf(is_upper ? kUpperEdge : kLowerEdge, i), row, view.width);
    view.tiers[2] += 2;
    if (by_long == by_short) continue;
    if (!has_begun) {
      const bool odd = ((block.odd >> i) & 1) != 0;
      sink.Begin(triangle, IsFrontBy(by_long < by_short, odd), block.PlaneOf(i));
      has_begun = true;
    }
    sink.Span(row, Least(by_long, by_short), Greatest(by_long, by_short));
  }
}

/// Finds the masks of the small triangles of a group. has_ties: whether the last group had rows
/// that their guesses did not tell; returns whether this one has.
template <bool kExact, bool kFacing>
HWY_INLINE bool SetUpSmall(const KernelView& view, const ExactGroup& g, bool has_ties, int at,
                           ExactBlock& block) {
  const DI di;
  if (g.others == 0) {
    hn::Store(Truncated(g.x0), di, block.x0 + at);
    hn::Store(Truncated(g.y0), di, block.y0 + at);
  }
  const SmallEdges edges(g);
  // Where there was a tie, there will be one: then rows are decided at once.
  if (!has_ties) {
    const std::uint32_t left = block.long_is_left;
    const std::uint32_t drawn = block.drawn;
    const bool is_open = FindExactMasks<kExact, false, kFacing>(view, edges, block, at);
    if (!is_open) return false;
    block.long_is_left = left;
    block.drawn = drawn;
  }
  return ResolveMasks<kFacing>(view, g, edges, block, at);
}

/// Sets up a block and finds the masks of its small triangles. has_ties: whether the last group had
/// rows that their guesses did not tell.
template <bool kExact, class Sink>
HWY_INLINE void SetUpExact(const KernelView& view, const std::uint32_t* indices, bool& has_ties,
                           ExactBlock& block) {
  constexpr bool kFacing = Sink::kNeedsFacing;
  const DF d;
  block.small = 0;
  block.near = 0;
  block.inside = 0;
  block.odd = 0;
  block.far = 0;
  block.stepped = 0;
  block.long_is_left = 0;
  for (int at = 0; at < kBlock; at += kLanes) {
    const auto corners = LoadCorners<Sink::kNeedsPlane>(d, view.vertices, indices + 3 * at);
    std::uint32_t odd;
    const ExactGroup g(view, corners, odd);
    block.odd |= odd << at;
    block.small |= g.small << at;
    block.drawn |= g.small << at;
    if (g.others != 0) SetUpOthers(view, corners, g, at, block);
    if (g.small != 0) has_ties = SetUpSmall<kExact, kFacing>(view, g, has_ties, at, block);
    if constexpr (Sink::kNeedsPlane) {
      if (((block.drawn >> at) & ((std::uint64_t{1} << kLanes) - 1)) != 0) {
        StorePlanes(d, corners, at, block);
      }
    }
  }
}

template <bool kExact, class Sink>
HWY_INLINE void DrawSpans(const KernelView& view) {
  Sink sink(view);
  ExactBlock block;
  bool has_ties = false;
  const bool can_step = Greatest(view.width, view.height) <= static_cast<int>(kSteppedSide);
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpExact<kExact, Sink>(view, indices, has_ties, block);
      },
      [&](int i, std::uint32_t triangle) {
        if (block.IsSmall(i)) {
          const std::uint64_t bits = block.masks[i];
          if (bits == 0) return;
          const bool is_left = ((block.long_is_left >> i) & 1) != 0;
          sink.Begin(triangle, IsFrontBy(is_left, ((block.odd >> i) & 1) != 0), block.PlaneOf(i));
          sink.Mask8x8(block.x0[i], block.y0[i], bits);
        } else if (((block.near >> i) & 1) != 0) {
          DrawNear<kExact>(view, block, i, triangle, sink);
        } else if (HWY_UNLIKELY(((block.far >> i) & 1) != 0)) {
          DrawFar(view, block, i, triangle, sink);
        } else if (!(can_step && ((block.stepped >> i) & 1) != 0 &&
                     DrawSteps<kExact>(view, block, i, triangle, sink))) {
          if (((block.inside >> i) & 1) != 0) {
            DrawExactRows<kExact, true>(view, block, i, triangle, sink);
          } else {
            DrawExactRows<kExact, false>(view, block, i, triangle, sink);
          }
        }
      });
}

template <class Sink>
void DrawExact(const KernelView& view) {
  DrawSpans<true, Sink>(view);
}
template <class Sink>
void DrawExactUnsafe(const KernelView& view) {
  DrawSpans<false, Sink>(view);
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_KERNELS_EXACT_SPANS_H_
