#include "props/compare/can_touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rasterproof::props {
namespace {

// Of the number's size; 0 has none.
struct Exponents {
  int least;
  int greatest;
};

Exponents ExponentsOf(const Scene& scene) {
  Exponents range{-8, std::ilogb(std::max({1, scene.width, scene.height}))};
  for (const Vertex& v : scene.vertices) {
    for (const double x : {v.x, v.y}) {
      if (x == 0) continue;
      range.least = std::min(range.least, std::ilogb(x));
      range.greatest = std::max(range.greatest, std::ilogb(x));
    }
  }
  return range;
}

template <class Float>
bool FlushingCanTouch(const Exponents& range) {
  constexpr int kDigits = std::numeric_limits<Float>::digits;
  constexpr int kLeastNormal = std::numeric_limits<Float>::min_exponent - 1;
  const int least_edge_value = 2 * range.least - 3 * (kDigits - 1);
  const int most_area = 2 * (range.greatest + 1) + 3;
  return least_edge_value < kLeastNormal || -most_area < kLeastNormal ||
         least_edge_value - most_area < kLeastNormal;
}

}  // namespace

bool CanTouch(FloatMode mode, const Scene& scene, Precision input) {
  if (!HasFloatMode(mode)) return false;
  if (mode != FloatMode::kFlushToZero && mode != FloatMode::kDenormalsAreZero) return true;
  const auto is_finite = [](const Vertex& v) { return std::isfinite(v.x) && std::isfinite(v.y); };
  if (scene.clip_space || !std::ranges::all_of(scene.vertices, is_finite)) return true;
  const Exponents range = ExponentsOf(scene);
  return input == Precision::kFloat32 ? FlushingCanTouch<float>(range)
                                      : FlushingCanTouch<double>(range);
}

}  // namespace rasterproof::props
