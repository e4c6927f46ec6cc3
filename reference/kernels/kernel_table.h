// What passes between the dispatcher and the code of one SIMD target.
//
// Plain data and no functions: an inline function compiled with AVX-512 here could be the one that
// the linker keeps for every target.
#ifndef RASTERPROOF_REFERENCE_KERNELS_KERNEL_TABLE_H_
#define RASTERPROOF_REFERENCE_KERNELS_KERNEL_TABLE_H_

#include <cstddef>
#include <cstdint>

namespace rasterproof::reference::kernels {

/// A run of covered pixels: columns [x0, x1) of a row.
struct KernelSpan {
  std::uint32_t triangle;
  bool is_front;
  int row, x0, x1;
};

/// A scene and a surface as a kernel sees them.
struct KernelView {
  const float* vertices;         ///< x, y, z of each
  const std::uint32_t* indices;  ///< three of each triangle
  std::size_t triangles;
  int width;
  int height;
  void* planes[2];       ///< see Surface::plane
  std::ptrdiff_t pitch;  ///< see Surface::pitch

  // kMaskRows alone: strips of 32 pixels, a word for each of their strip_height rows, and a bit for
  // each 32x8 tile of them that is full, full_pitch words a row of tiles. Cleared.
  std::uint32_t* strips;
  std::ptrdiff_t strip_height;
  std::uint64_t* full_tiles;
  std::ptrdiff_t full_pitch;

  std::uint64_t* tiers;  ///< kExact counts here: rows decided exactly, by expansions, edges of
                         ///< triangles beyond its guesses

  // kExact alone: rows above this one are not drawn.
  int first_row;
  // KernelTable::exact_spans alone, which has no planes: what is called with every span, in order.
  void (*on_span)(const void* state, const KernelSpan& span);
  const void* state;
};

/// An edge from its upper end to its lower one, as it was given; a kernel's own coordinates are
/// relative to (left, top).
struct ExactEdge {
  double ax, ay, cx, cy;
  double left, top;
};

/// Whether (x, y) is at or right of the edge. Exact for all finite float32 ends and pixel centres.
bool IsCentreAtOrRight(const ExactEdge& edge, double x, double y);

/// The first of columns 0 to width whose centre in the row is at or right of the edge; width if
/// none is. Exact, as above.
int ExactCrossing(const ExactEdge& edge, int row, int width);

using KernelFunction = void (*)(const KernelView&);

/// Of one target.
struct KernelTable {
  KernelFunction draw[7][5];  ///< by KernelMethod and Sink; nullptr where there is no such kernel
  KernelFunction fill[5];     ///< by Sink: see Fill()
  KernelFunction exact_spans;
};

extern const KernelTable kScalarKernels;
extern const KernelTable kSse4Kernels;
extern const KernelTable kAvx2Kernels;
extern const KernelTable kAvx512Kernels;
extern const KernelTable kNeonKernels;

}  // namespace rasterproof::reference::kernels

#endif  // RASTERPROOF_REFERENCE_KERNELS_KERNEL_TABLE_H_
