// What passes between the dispatcher and the code of one SIMD target.
//
// Plain data and no functions: an inline function compiled with AVX-512 here could be the one that
// the linker keeps for every target.
#ifndef RASTERPROOF_LIBRARY_KERNELS_KERNEL_TABLE_H_
#define RASTERPROOF_LIBRARY_KERNELS_KERNEL_TABLE_H_

#include <cstddef>
#include <cstdint>

namespace rasterproof::library::kernels {

/// A run of covered pixels: columns [x0, x1) of a row.
struct KernelSpan {
  std::uint32_t triangle;
  bool is_front;
  int row, x0, x1;
};

/// Columns [first, last) of consecutive rows; empty where first >= last.
constexpr int kKnownRows = 16;
struct alignas(64) KnownRows {
  std::int32_t first[kKnownRows], last[kKnownRows];
};

/// What was found of a triangle before.
struct KnownTriangle {
  std::uint64_t bits;  ///< with rows 0: of a box of 8x8, bit 8 r + c is pixel (x + c, y + r)
  std::uint32_t triangle;
  int x, y;   ///< of the box; else y is the first row
  int rows;   ///< as many, in the next groups of KnownRows
  int width;  ///< of the box around them
  bool is_front;
};
struct KnownSpans {
  const KnownTriangle* triangles;  ///< in the order of their numbers
  std::size_t count;
  const KnownRows* rows;
};

/// Which points of a triangle in clip space are kept by their z: 0 <= z as in Vulkan and Direct3D,
/// -w <= z as in OpenGL, the plane itself included.
enum class NearPlane : std::uint8_t { kNone, kZero, kMinusW };

/// A scene and a surface as a kernel sees them.
struct KernelView {
  const float* vertices;         ///< x, y, z of each; of clip kernels x, y, z, w
  const std::uint32_t* indices;  ///< three of each triangle
  std::size_t triangles;
  int width;
  int height;
  void* planes[2];       ///< see Surface::plane
  std::ptrdiff_t pitch;  ///< see Surface::pitch

  // Traversal::kMaskTiles of library/rivals alone: strips of 32 pixels, a word for each of their
  // strip_height rows, and a bit for each 32x8 tile of them that is full, full_pitch words a row of
  // tiles. Cleared.
  std::uint32_t* strips;
  std::ptrdiff_t strip_height;
  std::uint64_t* full_tiles;
  std::ptrdiff_t full_pitch;

  std::uint64_t* tiers;  ///< Draw() counts here: rows decided exactly, by expansions, edges of
                         ///< triangles beyond its guesses

  // Exact and clip kernels alone: rows above this one are not drawn.
  int first_row;
  NearPlane near_plane;  ///< clip kernels alone
  // exact_spans and clip_spans alone, which have no planes: what is called with every span, in
  // order.
  void (*on_span)(const void* state, const KernelSpan& span);
  const void* state;
  const KnownSpans* known;  ///< what `known` writes; vertices and indices for planes alone
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

/// A triangle in clip space, of float32 coordinates: no product of two of them is rounded, and
/// nothing that is computed of them in double over- or underflows.
struct ClipTriangle {
  double x[3], y[3], z[3], w[3];
  NearPlane near_plane;
};

/// "Edge" number 3 is the near plane, where it cuts the triangle; edge e goes from corner e to the
/// next one.
constexpr int kNearEdge = 3;

/// D = V0 . (V2 x V1) over (x, y, w): its sign is the facing, +1 front. The nearest double.
double ClipDeterminant(const ClipTriangle& t);

/// Whether (x, y), a multiple of 1/2 below 2^17, is on the triangle's side of one edge; exactly on
/// an edge if the top-left rule gives it to the triangle, exactly on the near plane always.
bool IsInsideClipEdge(const ClipTriangle& t, int edge, int facing, double x, double y);

/// Leaves of columns [first, last) those whose centres in the row are inside one edge.
void ClipColumns(const ClipTriangle& t, int edge, int facing, int row, int& first, int& last);

/// Leaves of rows [first, last) those that lie inside an edge parallel to them.
void ClipRows(const ClipTriangle& t, int edge, int facing, int& first, int& last);

using KernelFunction = void (*)(const KernelView&);

/// Of one target.
struct KernelTable {
  KernelFunction exact[5];  ///< by Sink
  KernelFunction fill[5];   ///< by Sink: see Fill()
  KernelFunction exact_spans;
  KernelFunction clip[5];  ///< by Sink
  KernelFunction clip_spans;
  KernelFunction known[5];  ///< by Sink
};

extern const KernelTable kScalarKernels;
extern const KernelTable kSse4Kernels;
extern const KernelTable kAvx2Kernels;
extern const KernelTable kAvx512Kernels;
extern const KernelTable kNeonKernels;

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_LIBRARY_KERNELS_KERNEL_TABLE_H_
