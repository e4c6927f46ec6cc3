// Walking the 8x8 tiles of a triangle's box: rejected, accepted, or tested by pixel.
#ifndef RASTERPROOF_LIBRARY_RIVALS_TILE_WALK_H_
#define RASTERPROOF_LIBRARY_RIVALS_TILE_WALK_H_

#include <cstdint>

#include "library/kernels/blocks.h"
#include "library/kernels/vectors.h"

namespace rasterproof::library::kernels::HWY_NAMESPACE {

constexpr std::uint64_t kAllPixels = ~std::uint64_t{0};

/// Column and row of each pixel of a tile.
alignas(64) constexpr float kColumns[64] = {
    0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7,
    0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
alignas(64) constexpr float kRows[64] = {
    0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3,
    4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7};
alignas(64) constexpr std::int32_t kIntColumns[64] = {
    0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7,
    0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7, 0, 1, 2, 3, 4, 5, 6, 7};
alignas(64) constexpr std::int32_t kIntRows[64] = {
    0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3,
    4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7};

/// The pixels of a tile that lie in the box.
HWY_INLINE std::uint64_t ClipTile(const Box& box, int x, int y) {
  std::uint64_t columns = 0xff;
  std::uint64_t rows = kAllPixels;
  if (x < box.x0) columns &= 0xffU << (box.x0 - x);
  if (x + 8 > box.x1) columns &= 0xffU >> (x + 8 - box.x1);
  if (y < box.y0) rows &= kAllPixels << (8 * (box.y0 - y));
  if (y + 8 > box.y1) rows &= kAllPixels >> (8 * (y + 8 - box.y1));
  return columns * 0x0101010101010101U & rows;
}

/// Draws the tiles [first, end) of the row of tiles at y, whose pixels in the box are all inside.
template <class Sink>
HWY_INLINE void DrawFullTiles(const Box& box, int first, int end, int y, Sink& sink) {
  if (end - first == 1) {
    sink.Mask8x8(8 * first, y, ClipTile(box, 8 * first, y));
    return;
  }
  const int x0 = Greatest(8 * first, box.x0);
  const int x1 = Least(8 * end, box.x1);
  const int last = Least(y + 8, box.y1);
  for (int row = Greatest(y, box.y0); row < last; ++row) sink.Span(row, x0, x1);
}

/// Walks the tiles that meet the box, kTiles at a time along each row of tiles.
///
/// Edges has: kTiles; BeginRow(y); Classify(i, any, full): of the tiles from the i-th of the row,
/// as bits, which may have a pixel inside and which have all; Pixels(i): the mask of one tile.
template <class Edges, class Sink>
HWY_INLINE void WalkTiles(Edges& edges, const Box& box, Sink& sink) {
  const int first = box.x0 >> 3;
  const int tiles = ((box.x1 + 7) >> 3) - first;
  for (int y = box.y0 & ~7; y < box.y1; y += 8) {
    edges.BeginRow(y);
    int run = 0;  // full tiles put off, in front of `run_end`
    int run_end = 0;
    bool was_inside = false;
    for (int i = 0; i < tiles; i += Edges::kTiles) {
      std::uint32_t any;
      std::uint32_t full;
      edges.Classify(i, any, full);
      if (tiles - i < Edges::kTiles) any &= (1U << (tiles - i)) - 1;
      if (any == 0) {
        if (was_inside) break;
        continue;
      }
      was_inside = true;
      full &= any;
      for (std::uint32_t partial = any & ~full; partial != 0; partial &= partial - 1) {
        const int tile = i + CountTrailingZeros(partial);
        const int x = 8 * (first + tile);
        const std::uint64_t bits = edges.Pixels(tile) & ClipTile(box, x, y);
        if (bits != 0) sink.Mask8x8(x, y, bits);
      }
      while (full != 0) {
        const int begin = CountTrailingZeros(full);
        const int length = CountTrailingZeros(~(std::uint64_t{full} >> begin));
        full &= ~static_cast<std::uint32_t>(((std::uint64_t{1} << length) - 1) << begin);
        if (run > 0 && run_end != first + i + begin) {
          DrawFullTiles(box, run_end - run, run_end, y, sink);
          run = 0;
        }
        run += length;
        run_end = first + i + begin + length;
      }
    }
    if (run > 0) DrawFullTiles(box, run_end - run, run_end, y, sink);
  }
}

}  // namespace rasterproof::library::kernels::HWY_NAMESPACE

#endif  // RASTERPROOF_LIBRARY_RIVALS_TILE_WALK_H_
