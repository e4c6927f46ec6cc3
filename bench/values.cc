#include "bench/values.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "bench/exact_triangles.h"
#include "core/evaluators.h"
#include "core/vertex.h"
#include "exact/edge.h"

namespace rasterproof::bench {
namespace {

constexpr std::size_t kTriangles = 256;

// The pixel's centre nearest to a point, within the target.
Point2 NearestCentre(double x, double y, const Scene& scene) {
  return {std::clamp(std::floor(x), 0.0, scene.width - 1.0) + 0.5,
          std::clamp(std::floor(y), 0.0, scene.height - 1.0) + 0.5};
}

// NaN is the least.
void Raise(double& largest, double value) {
  if (!(value <= largest)) largest = value;
}

}  // namespace

BenchValues ValuesOf(const Contender& contender, const FamilyInput& family) {
  BenchValues values;
  const EdgeEvaluator* edges = contender.edges();
  const Scene& scene = family.scene;
  if (edges == nullptr || scene.clip_space) return values;
  const std::size_t step = std::max<std::size_t>(1, scene.triangles.size() / kTriangles);
  for (std::size_t t = 0; t < scene.triangles.size(); t += step) {
    const auto v = Corners(scene, scene.triangles[t]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 a = WindowPoint(v[k]);
      const Point2 b = WindowPoint(v[(k + 1) % 3]);
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const Point2 p = NearestCentre((a.x + b.x) / 2, (a.y + b.y) / 2, scene);
      const double value = edges->Value(a, b, p);
      if (!std::isfinite(value) || length == 0) continue;
      const double error = (exact::Rational(value) - exact::EdgeValue(a, b, p)).Abs().ToDouble();
      Raise(values.edge, error / length);
      const double bound = edges->ErrorBound(a, b, p);
      if (bound > 0) Raise(values.edge_share_of_bound, error / bound);
    }
  }
  return values;
}

}  // namespace rasterproof::bench
