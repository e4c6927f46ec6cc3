// Fast exact rasterizers of indexed float32 triangles: one sink and SIMD target at a time.
//
// Crossings of edges with rows decide: top-left, watertight, every finite float32. Both windings
// are drawn, triangles without area are not. What they are measured against is in library/rivals.
// What they draw, pixel for pixel and by every target, tests/library/kernel_definitions.h defines
// in plain loops.
#ifndef RASTERPROOF_LIBRARY_KERNELS_KERNEL_H_
#define RASTERPROOF_LIBRARY_KERNELS_KERNEL_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "library/kernels/kernel_table.h"

namespace rasterproof::library::kernels {

/// Window space, y down; z is read by the depth sink alone.
struct KernelVertex {
  float x = 0;
  float y = 0;
  float z = 0;

  friend bool operator==(const KernelVertex&, const KernelVertex&) = default;
};

/// Clip space, already scaled to the viewport: (x / w, y / w) is the place on the target, y down.
struct ClipVertex {
  float x = 0;
  float y = 0;
  float z = 0;
  float w = 1;
};

/// Triangles in clip space. Does not own what it sees.
///
/// Domain:     as KernelScene's.
struct ClipScene {
  std::span<const ClipVertex> vertices;
  std::span<const std::uint32_t> indices;
  int width = 1;
  int height = 1;
  NearPlane near_plane = NearPlane::kNone;
};

/// Triangles as three indices each, drawn in order. Does not own what it sees.
///
/// Domain:     any float32, NaN and infinity included; every index within `vertices`, of which
///             there are at most 2^29; 1 <= width, height <= 65536.
struct KernelScene {
  std::span<const KernelVertex> vertices;
  std::span<const std::uint32_t> indices;
  int width = 1;
  int height = 1;
};

/// Instruction sets that the kernels are compiled for, least first. kScalar is the compiler's
/// default for the machine, with no vectors of our own; kNeon is that of 64-bit Arm.
enum class Target : std::uint8_t { kScalar, kSse4, kAvx2, kAvx512, kNeon };
inline constexpr std::array kTargets{Target::kScalar, Target::kSse4, Target::kAvx2, Target::kAvx512,
                                     Target::kNeon};

/// What is kept of the covered pixels.
enum class Sink : std::uint8_t {
  kCount8,  ///< 8 bits a pixel: how many triangles cover it, 255 at most
  kFacing,  ///< 2 x 32 bits: front (counter-clockwise on screen) and back facing ones apart
  kMask,    ///< 1 bit: whether any does
  kId,      ///< 32 bits: index of the last one that does
  kDepth  ///< float32: the least z, of the plane through the vertices at the pixel's centre, within
          ///< theirs; see Plane in blocks.h
};
inline constexpr std::array kSinks{Sink::kCount8, Sink::kFacing, Sink::kMask, Sink::kId,
                                   Sink::kDepth};

/// "avx512", "facing".
std::string_view NameOf(Target target);
std::string_view NameOf(Sink sink);

/// The targets that this machine runs, least first. Never empty.
std::span<const Target> SupportedTargets();

/// The pixels that a sink keeps, with room to write a whole vector or tile at the edges.
class Surface {
 public:
  /// Cleared.
  Surface(Sink sink, int width, int height);

  Sink sink() const { return sink_; }
  int width() const { return width_; }
  int height() const { return height_; }

  /// No coverage; kId: kNoTriangle; kDepth: +infinity.
  void Clear();

  static constexpr std::uint32_t kNoTriangle = 0xffffffff;

  /// One pixel's value: a count; kFacing: front | back << 32; kMask: 0 or 1; kId; kDepth: its bits.
  ///
  /// Domain:     0 <= x < width, 0 <= y < height.
  std::uint64_t At(int x, int y) const;

  /// Rows are pitch() pixels apart (kMask: bytes). Plane 1 is kFacing's back, nullptr otherwise.
  std::ptrdiff_t pitch() const { return pitch_; }
  std::byte* plane(int index);

 private:
  Sink sink_;
  int width_;
  int height_;
  std::ptrdiff_t pitch_;
  std::size_t plane_bytes_;
  std::size_t start_;  // of the first aligned byte
  std::vector<std::byte> bytes_;
};

/// What a kernel sees of a scene, and of a surface. Owns nothing.
KernelView ViewOf(const KernelScene& scene);
KernelView ViewOf(const ClipScene& scene);
void Attach(Surface& surface, KernelView& view);

/// Draws the scene onto what the surface holds already. Allocates nothing.
/// Draws the same in whatever floating-point mode its caller left.
///
/// Domain:     a target of SupportedTargets(); a surface of the scene's size. InputError otherwise.
void Draw(Target target, const KernelScene& scene, Surface& surface);

/// Draws the scene onto what the surface holds already: covered is a pixel whose centre the
/// triangle covers as the eye sees it, vertices at or behind the eye or not, if its z is not before
/// the near plane. Exact, by the top-left rule; nothing is divided by w or clipped. Triangles with
/// a NaN or an infinity in x, y or w, or in z where there is a near plane, cover nothing. Allocates
/// nothing, and draws the same in whatever floating-point mode its caller left.
///
/// kDepth keeps the least z / w, which is affine on the screen: see kClipDepthError. Beyond
/// float32's range it is float32's largest number. A vertex's z that is not finite leaves depths as
/// they are.
///
/// Domain:     a target of SupportedTargets(); a surface of the scene's size. InputError otherwise.
void DrawClip(Target target, const ClipScene& scene, Surface& surface);

/// Draws rows first_row to height - 1 into memory of the caller's. Allocates nothing.
///
/// Domain:     a target of SupportedTargets(); what the view names; room as sinks.h wants it: 7
///             rows below the last one drawn, and 64 pixels behind.
void DrawExact(Target target, Sink sink, KernelView view);

/// The same by the kernel of clip space: view.near_plane, and vertices of four coordinates.
void DrawClip(Target target, Sink sink, KernelView view);

/// Calls view.on_span with what Draw() covers, triangle by triangle, each from its top row down. It
/// may throw.
void DrawExactSpans(Target target, KernelView view);
void DrawClipSpans(Target target, KernelView view);

/// Writes spans that were found before: what the surface's sink costs. kDepth takes its planes from
/// the scene's triangles.
///
/// Domain:     a target of SupportedTargets(); spans within the surface, of the scene's size.
void DrawKnown(Target target, const KnownSpans& spans, const KernelScene& scene, Surface& surface);

/// Writes every pixel of the surface once, row by row, as one triangle over all of it would: adds 1
/// (kFacing: to the front), stores a bit or an id, or takes the lesser depth: the store limit.
///
/// Domain:     a target of SupportedTargets().
void Fill(Target target, Surface& surface);

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_LIBRARY_KERNELS_KERNEL_H_
