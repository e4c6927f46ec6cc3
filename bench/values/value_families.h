// Triangles of which values are hard, each family in one way.
#ifndef RASTERPROOF_BENCH_VALUES_VALUE_FAMILIES_H_
#define RASTERPROOF_BENCH_VALUES_VALUE_FAMILIES_H_

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "bench/values/value_kernels.h"
#include "library/rasterize.h"

namespace rasterproof::bench {

/// A row of the table of families of values.
struct ValueFamilyKind {
  std::string_view name;
  std::string_view summary;  ///< a sentence
  bool is_clip_space = false;
  int width = 512;
  int height = 512;
  ValueTriangle (*draw)(std::uint64_t seed, int index) = nullptr;
};

/// "screen", "slivers", "cancelling", "far", "tiny", "w-4", "w-20", "w-60", "near-zero-w", "mesh".
std::span<const ValueFamilyKind> ValueFamilyKinds();

/// Triangles until they cover so many pixels, as the library takes them and as kernels do.
struct ValueScene {
  std::vector<ValueTriangle> triangles;
  std::vector<ValueRun> runs;
  std::uint64_t covered = 0;
  std::vector<float> positions;
  std::vector<float> numbers;
  std::vector<std::uint32_t> indices;
  RasterSpace space = RasterSpace::kWindow;

  RasterMesh Mesh() const { return {positions, indices, space}; }
};
ValueScene MakeValueScene(const ValueFamilyKind& kind, std::uint64_t covered, std::uint64_t seed);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_VALUES_VALUE_FAMILIES_H_
