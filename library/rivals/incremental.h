// Traversal::kRows: float32 edge functions stepped over the box by sums, 32 pixels of a row at a
// time. No tile can compute the same: what a sum is depends on the pixels before it.
#ifndef RASTERPROOF_LIBRARY_RIVALS_INCREMENTAL_H_
#define RASTERPROOF_LIBRARY_RIVALS_INCREMENTAL_H_

#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/kernel_table.h"
#include "library/kernels/vectors.h"
#include "library/rivals/edges.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

/// Pixels of a step along a row: several vectors, so that none waits for its own last sum.
constexpr int kStep = 32;

/// Column c of a row has E = (row + (c mod 32) a) + 32 a + ... + 32 a; each row begins b after the
/// last.
template <class Sink>
HWY_INLINE void StepOverBox(const EdgeBlock<float>& block, int i, Sink& sink) {
  const DF d;
  constexpr int kVectors = kStep / kLanes;
  const Box box = block.BoxOf(i);
  float row[3];
  VF lanes[3][kVectors], step[3], least[3];
  for (int k = 0; k < 3; ++k) {
    row[k] = block.e[k][i];
    const VF a = hn::Set(d, block.a[k][i]);
    step[k] = hn::Mul(a, hn::Set(d, static_cast<float>(kStep)));
    least[k] = hn::Set(d, block.least[k][i]);
    for (int v = 0; v < kVectors; ++v) {
      lanes[k][v] = hn::Mul(a, FloatsFrom(d, static_cast<float>(v * kLanes)));
    }
  }
  for (int y = box.y0; y < box.y1; ++y) {
    VF e[3][kVectors];
    for (int k = 0; k < 3; ++k) {
      const VF from = hn::Set(d, row[k]);
      for (int v = 0; v < kVectors; ++v) e[k][v] = hn::Add(from, lanes[k][v]);
      row[k] += block.b[k][i];
    }
    bool was_inside = false;
    for (int x = box.x0; x < box.x1; x += kStep) {
      std::uint64_t bits = 0;
      for (int v = 0; v < kVectors; ++v) {
        const auto inside = hn::And(hn::And(hn::Ge(e[0][v], least[0]), hn::Ge(e[1][v], least[1])),
                                    hn::Ge(e[2][v], least[2]));
        bits |= MaskBits(d, inside) << (v * kLanes);
        for (int k = 0; k < 3; ++k) e[k][v] = hn::Add(e[k][v], step[k]);
      }
      if (box.x1 - x < kStep) bits &= (std::uint64_t{1} << (box.x1 - x)) - 1;
      if (bits == 0) {
        if (was_inside) break;  // the triangle is convex: the rest of the row is outside
        continue;
      }
      was_inside = true;
      sink.Row32(y, x, static_cast<std::uint32_t>(bits));
    }
  }
}

template <class Sink>
void DrawIncremental(const KernelView& view) {
  Sink sink(view);
  EdgeBlock<float> block;
  ForEachTriangle(
      view, block,
      [&](const std::uint32_t* indices) {
        SetUpEdges<float, Form::kStepped, Sink::kNeedsPlane>(view, indices, block);
        if (block.small != 0) FindSmallMasks<float, Form::kStepped, true>(block);
      },
      [&](int i, std::uint32_t triangle) {
        sink.Begin(triangle, block.IsFront(i), block.PlaneOf(i));
        if (block.IsSmall(i)) {
          const std::uint64_t bits = block.masks[i] & SmallBoxMask(block, i);
          if (bits != 0) sink.Mask8x8(block.x0[i], block.y0[i], bits);
        } else {
          StepOverBox(block, i, sink);
        }
      });
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_INCREMENTAL_H_
