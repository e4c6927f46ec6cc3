// Exact coverage as a library: meshes drawn into memory of your own.
//
//     #include "library/rasterize.h"
//     rasterproof::Rasterize({.positions = xyz, .indices = triangles},
//                            {.output = rasterproof::RasterOutput::kMask, .width = 1920,
//                             .height = 1080, .pitch = 240, .memory = mask});
//
// A pixel is covered if its centre lies inside the triangle of the given float32 vertices: any
// finite values, nothing snapped or clipped, no sample decided by a rounded number. Ties follow the
// top-left rule, so triangles that share an edge leave no gap along it and overlap nowhere. Both
// windings are drawn; a triangle with a NaN or an infinity in x or y covers nothing. Every
// instruction set gives the same bits.
//
// This holds in any floating-point environment: while a call draws, callbacks included, the thread
// rounds to nearest, keeps subnormal numbers (no FTZ, no DAZ) and traps nothing; afterwards the
// environment is restored, flags included.
//
// Link rasterproof::rasterize; docs/library.md has the rest. The same in C:
// library/rasterproof_rasterize.h.
#ifndef RASTERPROOF_LIBRARY_RASTERIZE_H_
#define RASTERPROOF_LIBRARY_RASTERIZE_H_

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>

#include "core/error.h"

namespace rasterproof {

/// What the positions of a mesh are. Window space: x, y, z of each vertex, in pixels, x right, y
/// down; pixel (i, j) has its centre at (i + 1/2, j + 1/2). Clip space: x, y, z, w of each, already
/// scaled to the viewport, so that (x / w, y / w) is its place in the window and z / w its depth;
/// any sign of w. Of clip coordinates (X, Y, z, w), Y up, that is x = (w + X) width / 2 and
/// y = (w - Y) height / 2: computed once for each vertex, for what it rounds moves the vertex.
///
/// In clip space a pixel is covered if the ray through its centre meets the triangle before the
/// eye, exactly, vertices at or behind the eye or not: nothing is divided by w, and nothing is
/// clipped. With a near plane only points that satisfy its condition are kept, those exactly on it
/// included. There is no far plane. A triangle with a NaN or an infinity in x, y or w, or in z
/// where there is a near plane, covers nothing.
enum class RasterSpace : std::uint8_t {
  kWindow,
  kClip,           ///< without a near plane
  kClipNearZero,   ///< 0 <= z: Vulkan, Direct3D
  kClipNearMinusW  ///< -w <= z: OpenGL
};

/// Triangles as indices of vertices.
///
/// Domain:     any float32; at most 2^29 vertices, fewer than 2^32 - 1 triangles. Both aligned to 4
///             bytes, and apart from the target's memory, first row to last one's last pixel.
struct RasterMesh {
  std::span<const float> positions = {};        ///< see RasterSpace; z for depths and near planes
  std::span<const std::uint32_t> indices = {};  ///< three of each triangle
  RasterSpace space = RasterSpace::kWindow;
};

/// The data kept of covered pixels. Little-endian; pixels of 4 bytes are aligned.
///
/// The z of a triangle at a pixel is that of the plane through its vertices at the pixel's centre,
/// in float32, never less than their least z nor more than their greatest; their least throughout
/// where float32 finds no plane, because the area rounds to zero or a coefficient is 2^100 or more.
/// A triangle with a z that is a NaN or an infinity leaves depths as they are. In clip space the z
/// of a pixel is z / w of the triangle there, computed in double and rounded, at most float32's
/// largest number in size, and not cut to the vertices' range.
///
/// The last three are of window space, of pixels' squares in place of their centres, and of the
/// mesh as a whole. A triangle without area meets no square.
/// - kInnerMask never covers too much, and common edges take nothing from it: set are pixels whose
///   centre is covered and whose square no edge of the outline meets. The outline is what is left
///   of all triangles' edges, each triangle counter-clockwise on screen, after pairs of opposite
///   edges are taken away; vertices are one where x and y are equal. A back face counts as a front
///   face does.
/// - kInnerDepths keeps the lesser of what is there and the greatest z, over the square, of the
///   planes of all triangles that meet it (each at most its vertices'), rounded up: no point of the
///   square lies farther. A z that is a NaN or an infinity leaves its squares as they are.
enum class RasterOutput : std::uint8_t {
  kCounts,        ///< a byte: how many triangles cover the pixel, 255 at most
  kFacingCounts,  ///< uint32, twice: front facing ones in `memory`, others in `back`
  kMask,          ///< a bit, pixel x at bit x & 7 of byte x >> 3: whether any does
  kIds,           ///< uint32: the last triangle that does; kNoTriangle
  kDepths,        ///< float32: the least z
  kInnerMask,     ///< a bit, only if the mesh covers all of the pixel's open square
  kOuterMask,     ///< a bit: whether any triangle meets the pixel's open square
  kInnerDepths    ///< float32, of kInnerMask's pixels: the greatest z that the square may show
};
inline constexpr std::uint32_t kNoTriangle = 0xffffffff;

/// Memory of the caller's, rows from the top.
///
/// Domain:     1 <= width, height <= 65536; a pitch of at least a row, of whole pixels; memory (and
///             back, where there is one) from the first row to the last one's last pixel.
struct RasterTarget {
  RasterOutput output = RasterOutput::kCounts;
  int width = 0;
  int height = 0;
  std::size_t pitch = 0;  ///< bytes from one row to the next
  std::span<std::byte> memory = {};
  std::span<std::byte> back = {};  ///< kFacingCounts alone
};

/// A run of pixels that a triangle covers: columns [x0, x1) of row y.
struct RasterSpan {
  std::uint32_t triangle = 0;
  bool is_front = false;  ///< counter-clockwise, as seen on the screen
  int y = 0;
  int x0 = 0;
  int x1 = 0;
};

/// Instruction sets. kBest: the last one in the list that this machine runs.
enum class InstructionSet : std::uint8_t { kBest, kScalar, kSse4, kAvx2, kAvx512, kNeon };

/// Whether this machine, and this build of the library, runs it.
bool IsSupported(InstructionSet set);

/// Draws the triangles in order onto the contents of memory: counts are added to, depths are tested
/// against those there. To empty the pixels first, call Clear.
///
/// Vectors read and rewrite, unchanged, the bytes of memory between and after rows: no other thread
/// may write there meanwhile. Allocates nothing if memory has RoomFor(target) bytes; otherwise the
/// last rows are drawn elsewhere and copied, and the mesh is traversed twice. kInnerMask and
/// kInnerDepths allocate a mask, the outline's edges and, for depths, 4 bytes a pixel.
///
/// Error:      InputError, which names the argument and the remedy; nothing is drawn then.
void Rasterize(const RasterMesh& mesh, const RasterTarget& target,
               InstructionSet set = InstructionSet::kBest);

/// Calls on_span for every row of every triangle that is covered: triangles in order, each from its
/// top row down. It may throw, and that ends the drawing.
///
/// Error:      as above; also if on_span is empty.
void Rasterize(const RasterMesh& mesh, int width, int height,
               const std::function<void(const RasterSpan&)>& on_span,
               InstructionSet set = InstructionSet::kBest);

/// How numbers at the vertices become those of pixels. In window space both are the same.
enum class RasterInterpolation : std::uint8_t {
  kPerspective,  ///< of the triangle before the division by w
  kLinear        ///< of its picture on the screen: noperspective
};

enum class RasterRounding : std::uint8_t {
  kFast,    ///< in float32, within kValueConditions; the same bits by every instruction set
  kNearest  ///< the nearest float32, ties to even, always; within 1/2 ulp
};

inline constexpr int kMostRasterChannels = 64;

/// Numbers of the vertices, and memory for those of the pixels: a plane of rows for each channel,
/// one after the other, row y of channel c at (c height + y) pitch.
///
/// Domain:     1 <= channels <= kMostRasterChannels; pitch >= width; memory apart from the mesh's.
///             kFast: numbers of at most 2^100, and at least 2^-100 or 0. kNearest: any finite
///             numbers, and no derivatives. A channel with a NaN or an infinity at a triangle's
///             vertex is a NaN all over the triangle.
struct RasterValues {
  std::span<const float> numbers = {};  ///< `channels` of each vertex
  int channels = 1;
  RasterInterpolation interpolation = RasterInterpolation::kPerspective;
  RasterRounding rounding = RasterRounding::kFast;
  int width = 0;
  int height = 0;
  std::size_t pitch = 0;  ///< numbers from one row to the next
  std::span<float> values = {};
  std::span<float> dx = {};  ///< d/dx and d/dy, a pixel; both or neither
  std::span<float> dy = {};
};

/// The largest error of a value by kFast, in units of 2^-24 of the condition C of exact/values.h:
/// of k conditions k / (1 - e), where the denominator may be off by a share e = k 2^-24 sum M_i /
/// |d| below 1/2; beyond that nothing is stated. And 2^-149, as values may be subnormal.
///
/// Planes are found in double, off by 2^-50 of their terms, and rounded to float32: 1. The product
/// with the coordinate and two sums: 4 in n and in d. The quotient: 5. Where nothing divides: 4,
/// and d's 2^-50.
/// Proof:      reference/proofs/library_values.g.
inline constexpr double kValueConditions = 5 + 0x1p-16;

/// The same of derivatives, in units of their conditions C_x and C_y: over (1 - e)^2. And 2^-126: a
/// subnormal value's 2^-150 is multiplied by |d.a / d|, which e keeps below 2^23.
///
/// (n.a - value d.a) / d: n.a has 1 rounding, the difference 1, the quotient 1, value d.a two more
/// and the value's own error, kValueConditions of C |d.a|; d has 4: no part has more than 5.
inline constexpr double kDerivativeConditions = 5 + 0x1p-10;

/// Writes the numbers of each covered pixel, of the last triangle that covers it; others stay as
/// they are. Coverage as Rasterize has it.
///
/// Error:      as Rasterize, and for numbers and memory that are not what RasterValues says.
void RasterizeValues(const RasterMesh& mesh, const RasterValues& values,
                     InstructionSet set = InstructionSet::kBest);

/// Threads that draw a mesh together: each a part of its triangles, into memory of its own that is
/// merged in the end. Bit for bit what Rasterize() draws, for every number of them.
///
/// They keep their memory, a target's for each but one, for the next call. Waking them takes about
/// a tenth of a millisecond, and merging time in proportion to the target: less work than that is
/// done sooner by one thread.
/// Outputs of squares are drawn by the calling thread alone.
class RasterWorkers {
 public:
  /// Calls act(k) once for each k in [0, count), at once as far as it can, and returns after the
  /// last one; the next call sees what they wrote. A program's own threads.
  using ForEach = std::function<void(int count, const std::function<void(int)>& act)>;

  /// Starts count - 1 threads; the calling one of Rasterize draws, too.
  ///
  /// Domain:     1 <= count <= 256.
  /// Error:      InputError beyond that; std::system_error where threads can't be started.
  explicit RasterWorkers(int count);
  /// Starts none: for_each is called instead, up to three times a drawing.
  RasterWorkers(int count, ForEach for_each);
  RasterWorkers(const RasterWorkers&) = delete;
  RasterWorkers& operator=(const RasterWorkers&) = delete;
  ~RasterWorkers();

  /// As the function of this name, but that it allocates. One call at a time.
  ///
  /// Domain:     the mesh apart from all of the target's memory, room included.
  void Rasterize(const RasterMesh& mesh, const RasterTarget& target,
                 InstructionSet set = InstructionSet::kBest);

 private:
  class Crew;
  std::unique_ptr<Crew> crew_;
};

/// Writes 1 for each triangle that covers no pixel centre of the target, 0 for each that does: what
/// culling of small triangles may drop, but for outputs of squares.
///
/// Domain:     a byte a triangle, apart from the mesh.
/// Error:      as Rasterize.
void MarkEmptyTriangles(const RasterMesh& mesh, int width, int height,
                        std::span<std::uint8_t> is_empty,
                        InstructionSet set = InstructionSet::kBest);

/// Bytes of memory (and of back) with which nothing is copied: the rows and some 7 more.
///
/// Domain:     a target whose width, height and pitch are in their domain; memory is not looked at.
std::size_t RoomFor(const RasterTarget& target);

/// Empties every pixel: no count, no bit, kNoTriangle, a depth of infinity. Bits after the last
/// pixel of a mask's row are emptied too.
///
/// Error:      as Rasterize.
void Clear(const RasterTarget& target);

}  // namespace rasterproof

#endif  // RASTERPROOF_LIBRARY_RASTERIZE_H_
