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
  double value = 0;  ///< of the parameter, where there is one
  ValueTriangle (*draw)(std::uint64_t seed, int index, double value) = nullptr;
};

/// "screen", "slivers", "cancelling", "far", "tiny", "w-4", "w-20", "w-60", "near-zero-w", "mesh".
std::span<const ValueFamilyKind> ValueFamilyKinds();

/// A power of two that makes values harder as its exponent grows from `first` to `last`.
struct ValueParameter {
  ValueFamilyKind kind;  ///< of any value
  int first = 0;
  int last = 0;
};

/// "w-ratio", "distance", "aspect".
std::span<const ValueParameter> ValueParameters();

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
