// What the exact kernel is measured against: the arithmetic of textbooks in one frame, each at the
// best speed it can have.
//
// A rival is a traversal, an arithmetic and a sink. Its traversals share their source, so that two
// rivals can differ in one thing alone. What each one but kTwin draws, pixel for pixel and by every
// target, tests/library/rival_definitions.h defines in plain loops. Users' programs link none.
#ifndef RASTERPROOF_LIBRARY_RIVALS_RIVAL_H_
#define RASTERPROOF_LIBRARY_RIVALS_RIVAL_H_

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "library/kernels/kernel.h"

namespace rasterproof::library::rivals {

/// How the pixels of a triangle are visited. Both windings are drawn, triangles without area are
/// not. Small ones, of at most 8x8 pixels, are found a triangle a lane.
enum class Traversal : std::uint8_t {
  kTiles,     ///< the box by tiles of 8x8, accepted, rejected or tested by pixel
  kSpans,     ///< spans between the crossings of the edges with the rows of pixel centres
  kRows,      ///< the box row by row, 32 pixels at a time
  kMaskTiles  ///< spans into tiles of 32x8 bits that know when they are full; kMask alone
};

/// What decides. Of tiles and rows: edge functions; of spans: an edge's crossing, less 1/2, from
/// its end of lesser y, with one division an edge.
enum class Arithmetic : std::uint8_t {
  kFloat32Direct,   ///< (x - vx) a + (y - vy) b; (vx - 1/2) + (y - vy) s
  kFloat32Affine,   ///< A x + (B y + C); C + y s
  kFloat32Stepped,  ///< the value at the first place, and a multiple of the step
  kFloat64Direct,
  kFloat64Affine,
  kFloat64Stepped,
  kInt32,     ///< vertices snapped to 1/256 px, within kFixedRange; 32 bits within a tile
  kInt64,     ///< snapped likewise, 64 bits; spans: slopes and crossings of 32 bits after the point
  kUnchecked  ///< spans: the exact kernel's own code with what makes it exact left out
};

/// Rivals that snap skip triangles with a coordinate beyond this, in pixels.
inline constexpr float kFixedRange = 16384;

struct Rival {
  Traversal traversal = Traversal::kSpans;
  Arithmetic arithmetic = Arithmetic::kFloat64Direct;

  friend bool operator==(const Rival&, const Rival&) = default;
};

inline constexpr std::array<Rival, 18> kRivals{{
    {Traversal::kSpans, Arithmetic::kUnchecked},
    {Traversal::kRows, Arithmetic::kFloat32Stepped},
    {Traversal::kTiles, Arithmetic::kFloat32Direct},
    {Traversal::kTiles, Arithmetic::kFloat32Affine},
    {Traversal::kTiles, Arithmetic::kFloat32Stepped},
    {Traversal::kTiles, Arithmetic::kFloat64Direct},
    {Traversal::kTiles, Arithmetic::kFloat64Affine},
    {Traversal::kTiles, Arithmetic::kFloat64Stepped},
    {Traversal::kTiles, Arithmetic::kInt32},
    {Traversal::kTiles, Arithmetic::kInt64},
    {Traversal::kSpans, Arithmetic::kFloat32Direct},
    {Traversal::kSpans, Arithmetic::kFloat32Affine},
    {Traversal::kSpans, Arithmetic::kFloat32Stepped},
    {Traversal::kSpans, Arithmetic::kFloat64Direct},
    {Traversal::kSpans, Arithmetic::kFloat64Affine},
    {Traversal::kSpans, Arithmetic::kFloat64Stepped},
    {Traversal::kSpans, Arithmetic::kInt64},
    {Traversal::kMaskTiles, Arithmetic::kFloat32Direct},
}};

/// Whose vertices are snapped to 1/256 px; beyond kFixedRange it skips triangles.
constexpr bool Snaps(Arithmetic arithmetic) {
  return arithmetic == Arithmetic::kInt32 || arithmetic == Arithmetic::kInt64;
}

/// The exact kernel's twin, which shows what exactness costs. It states nothing: what it draws at
/// edges may depend on the target.
inline constexpr Rival kTwin = kRivals.front();

/// "tiles"; "f64-affine".
std::string_view NameOf(Traversal traversal);
std::string_view NameOf(Arithmetic arithmetic);
/// "spans-f64-affine"; of direct forms "spans-f64"; of those that were kernels before,
/// "kernel-tiles".
std::string NameOf(const Rival& rival);

/// What it computes, in words.
std::string SummaryOf(const Rival& rival);

/// Of that name.
std::optional<Rival> FindRival(std::string_view name);

/// Whether there is such a kernel: kMask and kFacing of all rivals, the other sinks of kTwin and of
/// spans in float32 and float64, direct; of kMaskTiles kMask alone. Of instruction sets kScalar,
/// kAvx2 and kAvx512.
bool Draws(const Rival& rival, kernels::Target target, kernels::Sink sink);

/// The widest of this machine's that rivals are compiled for.
kernels::Target WidestTarget();

/// Draws the scene onto what the surface holds already. Allocates nothing but kMaskTiles' tiles.
///
/// Domain:     a target of kernels::SupportedTargets(); Draws(rival, target, surface.sink()); a
///             surface of the scene's size. InputError otherwise. Rounding to nearest.
void Draw(const Rival& rival, kernels::Target target, const kernels::KernelScene& scene,
          kernels::Surface& surface);

/// The rival of clip space: homogeneous edges in float32, spans between their crossings with the
/// rows; nothing divided by w. It skips triangles whose determinant is 0 or overflows.
inline constexpr std::string_view kHomogeneous = "spans-hom-f32";
/// kMask and kFacing, by the instruction sets of the others.
bool DrawsHomogeneous(kernels::Target target, kernels::Sink sink);

/// As Draw().
///
/// Domain:     DrawsHomogeneous(target, surface.sink()); a scene without a near plane. InputError
///             otherwise.
void DrawHomogeneous(kernels::Target target, const kernels::ClipScene& scene,
                     kernels::Surface& surface);

}  // namespace rasterproof::library::rivals

#endif  // RASTERPROOF_LIBRARY_RIVALS_RIVAL_H_
