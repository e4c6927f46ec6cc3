// The nearest triangle at each pixel, with its barycentrics and depth, for pictures.
#ifndef RASTERPROOF_CORE_FRAGMENTS_H_
#define RASTERPROOF_CORE_FRAGMENTS_H_

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace rasterproof {

/// Per-pixel results; a buffer that was not asked for is empty.
///
/// Shape:      row-major [height][width], top row first; sample 0 of each pixel.
struct FragmentBuffers {
  int width = 0;
  int height = 0;
  std::vector<std::int32_t> triangle;  ///< nearest (smallest z, first drawn wins ties); -1: none
  std::vector<std::array<float, 3>> barycentrics;  ///< barycentrics, entry i for vertex i
  std::vector<float> depth;          ///< interpolated z; +infinity where nothing was drawn
  std::vector<float> edge_distance;  ///< pixels to the nearest edge line of that triangle
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_FRAGMENTS_H_
