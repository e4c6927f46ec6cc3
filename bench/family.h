// The families of triangles that methods are timed and put to the test on.
#ifndef RASTERPROOF_BENCH_FAMILY_H_
#define RASTERPROOF_BENCH_FAMILY_H_

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene.h"
#include "library/kernels/kernel.h"

namespace rasterproof::bench {

/// How much of a family is drawn: an eighth, enough to see which method leads; half, which a run of
/// all families and contenders has time for; all of it.
enum class FamilySize : std::uint8_t { kQuick, kHalf, kFull };

/// A family, or a scene of the user's, in the two formats that methods read, both made before
/// anything is timed.
struct FamilyInput {
  std::string name;
  std::string summary;
  Scene scene;
  /// The same for kernels, of window space or of clip space; empty of the other one, and where
  /// float32 does not hold them.
  std::vector<library::kernels::KernelVertex> vertices;
  std::vector<library::kernels::ClipVertex> clip_vertices;
  std::vector<std::uint32_t> indices;
  bool is_constructed = false;
  bool is_random = false;

  bool KernelsDrawIt() const { return !vertices.empty(); }
  bool ClipKernelsDrawIt() const { return !clip_vertices.empty(); }
  library::kernels::KernelScene KernelScene() const {
    return {vertices, indices, scene.width, scene.height};
  }
};

/// A row of the table of families.
struct FamilyKind {
  std::string_view name;
  std::string_view summary;  ///< a sentence
  bool is_random = false;    ///< independent triangles of one distribution
  /// Draws about 1 / `part` of the full number of triangles.
  Scene (*make)(int part, std::uint64_t seed) = nullptr;
  /// Its vertices are placed to be hard: what fails is counted, and is no rate of anything.
  bool is_constructed = false;
};

/// "px5", "px100", "px1m", "walks", "needles", "fan", "mesh", "ties", "snapped-4", "snapped-8",
/// "far", "torus", "perspective", "four-samples", "grazing".
std::span<const FamilyKind> FamilyKinds();

/// Makes the family.
FamilyInput MakeFamily(const FamilyKind& kind, FamilySize size, std::uint64_t seed);

/// A user's scene as a family.
FamilyInput FamilyOf(Scene scene, std::string summary);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_FAMILY_H_
