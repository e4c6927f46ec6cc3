#include "props/judging/subnormals.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace rasterproof::props {

bool CanTouch(FloatMode mode, const Scene& scene, Precision input) {
  if (!HasFloatMode(mode)) return false;
  if (mode != FloatMode::kFlushToZero && mode != FloatMode::kDenormalsAreZero) return true;
  const double small = input == Precision::kFloat32 ? 0x1p-40 : 0x1p-459;
  return std::ranges::any_of(scene.vertices, [&](const Vertex& v) {
    return std::ranges::any_of(std::array{v.x, v.y, v.w},
                               [&](double x) { return x != 0 && std::fabs(x) < small; });
  });
}

}  // namespace rasterproof::props
