#include "props/judging/grid_ruler.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/vertex.h"

namespace rasterproof::props {
namespace {

constexpr int kColumnsOfASeam = 4;
constexpr int kLeastHeight = 4;
// The finest seam: float32 holds its ends on targets of up to 2^10 pixels.
constexpr int kFinestSeam = 12;
// Seams of which a triangle is drawn alone.
constexpr std::size_t kMostAlone = 3;

// In the order of their use.
std::vector<int> BitsOfSeams(const TargetProfile& profile) {
  const int own = profile.snap.bits;
  const int least = std::max(1, *profile.freedom.least_bits);
  std::vector<int> bits{own, own + 1, least + 1};
  for (int k = least + 2; k <= kFinestSeam; ++k) bits.push_back(k);
  std::vector<int> once;
  for (const int k : bits) {
    if (k >= 1 && k <= kFinestSeam && std::ranges::find(once, k) == once.end()) once.push_back(k);
  }
  return once;
}

void AddTriangle(const Point2& a, const Point2& b, const Point2& c, Scene& scene) {
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  for (const Point2& p : {a, b, c}) scene.vertices.push_back({p.x, p.y, 0, 1});
  scene.triangles.push_back({first, first + 1, first + 2});
}

}  // namespace

GridRuler GridRulerOn(const TargetProfile& profile, int width, int height, Precision precision) {
  Scene empty;
  empty.width = width;
  empty.height = height;
  empty.precision = precision;
  GridRuler ruler{empty, {}};
  const bool fits = height >= kLeastHeight && width <= 1 << 10 && height <= 1 << 10;
  if (profile.fixed || profile.snap.IsNone() || !fits) return ruler;
  const std::vector<int> bits = BitsOfSeams(profile);
  const int most = std::min(static_cast<int>(bits.size()), width / kColumnsOfASeam);
  for (int k = 0; k < most; ++k) {
    const int column = k * kColumnsOfASeam + 1;
    const double step = std::ldexp(1.0, -bits[static_cast<std::size_t>(k)]);
    const double samples = profile.pattern.At(column, 0).x;
    const Point2 top{samples - step, 0};
    const Point2 bottom{samples + 2 * step, static_cast<double>(height)};
    const Point2 left{column - 1.0, bottom.y};
    const Point2 right{column + 2.0, 0};
    const auto first = static_cast<std::int32_t>(ruler.seams.vertices.size());
    for (const Point2& p : {top, bottom, left, right})
      ruler.seams.vertices.push_back({p.x, p.y, 0, 1});
    ruler.seams.triangles.push_back({first, first + 1, first + 2});
    ruler.seams.triangles.push_back({first, first + 3, first + 1});
    if (ruler.alone.size() == kMostAlone) continue;
    AddTriangle(top, right, bottom, ruler.alone.emplace_back(empty));
  }
  return ruler;
}

}  // namespace rasterproof::props
