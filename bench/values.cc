#include "bench/values.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "bench/exact_triangles.h"
#include "core/clock.h"
#include "core/evaluators.h"
#include "core/vertex.h"
#include "exact/attributes.h"
#include "exact/edge.h"

namespace rasterproof::bench {
namespace {

constexpr std::size_t kTriangles = 64;
// Of a contender that is slow alone.
constexpr double kMostSecondsOfValues = 1;

using Corners3 = std::array<Point2, 3>;

// The pixel whose centre is nearest to a point, within the target.
Pixel NearestPixel(double x, double y, const Scene& scene) {
  return {static_cast<int>(std::clamp(std::floor(x), 0.0, scene.width - 1.0)),
          static_cast<int>(std::clamp(std::floor(y), 0.0, scene.height - 1.0))};
}

// NaN is the least.
void Raise(double& largest, double value) {
  if (!(value <= largest)) largest = value;
}

double Distance(double shown, const exact::Rational& exact) {
  return (exact::Rational(shown) - exact).Abs().ToDouble();
}

// Pixels beside the middles of the edges and the centroid.
std::array<Pixel, 4> PixelsOf(const Corners3& v, const Scene& scene) {
  std::array<Pixel, 4> pixels;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 a = v[k];
    const Point2 b = v[(k + 1) % 3];
    pixels[k] = NearestPixel((a.x + b.x) / 2, (a.y + b.y) / 2, scene);
  }
  pixels[3] = NearestPixel((v[0].x + v[1].x + v[2].x) / 3, (v[0].y + v[1].y + v[2].y) / 3, scene);
  return pixels;
}

void AddEdges(const EdgeEvaluator& edges, const Corners3& v, const std::array<Pixel, 4>& pixels,
              BenchValues& values) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 a = v[k];
    const Point2 b = v[(k + 1) % 3];
    const Point2 p = CentreOf(pixels[k].x, pixels[k].y);
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double value = edges.Value(a, b, p);
    if (!std::isfinite(value) || length == 0) continue;
    const double error = Distance(value, exact::EdgeValue(a, b, p));
    Raise(values.edge, error / length);
    const double bound = edges.ErrorBound(a, b, p);
    if (bound > 0) Raise(values.edge_share_of_bound, error / bound);
  }
}

// At the pixels that exact geometry covers.
void AddInside(Contender& contender, std::size_t triangle, const std::array<double, 3>& z,
               const Corners3& v, const std::array<Pixel, 4>& pixels, BenchValues& values) {
  std::vector<Pixel> inside;
  std::vector<std::array<exact::Rational, 3>> exact;
  for (const Pixel& pixel : pixels) {
    const auto lambda = exact::Barycentrics(v, CentreOf(pixel.x, pixel.y));
    if (!lambda || std::ranges::any_of(*lambda, [](const auto& l) { return l < 0; })) continue;
    inside.push_back(pixel);
    exact.push_back(*lambda);
  }
  const std::vector<PixelValues> shown = contender.ValuesAlone(triangle, inside);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    exact::Rational depth = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      depth += exact[i][k] * exact::Rational(z[k]);
      const double barycentric = shown[i].barycentrics[k];
      if (std::isfinite(barycentric)) Raise(values.barycentric, Distance(barycentric, exact[i][k]));
    }
    if (std::isfinite(shown[i].depth)) Raise(values.depth, Distance(shown[i].depth, depth));
  }
}

}  // namespace

BenchValues ValuesOf(Contender& contender, const FamilyInput& family) {
  BenchValues values;
  const Scene& scene = family.scene;
  if (scene.clip_space) return values;
  const double begun = WallSeconds();
  const std::size_t step = std::max<std::size_t>(1, scene.triangles.size() / kTriangles);
  for (std::size_t t = 0; t < scene.triangles.size(); t += step) {
    if (contender.IsSlowAlone() && WallSeconds() - begun > kMostSecondsOfValues) break;
    const auto corners = Corners(scene, scene.triangles[t]);
    if (!std::ranges::all_of(corners, [](const Vertex& c) { return IsFinite(c); })) continue;
    const Corners3 v{WindowPoint(corners[0]), WindowPoint(corners[1]), WindowPoint(corners[2])};
    const std::array<Pixel, 4> pixels = PixelsOf(v, scene);
    if (contender.edges() != nullptr) AddEdges(*contender.edges(), v, pixels, values);
    AddInside(contender, t, {corners[0].z, corners[1].z, corners[2].z}, v, pixels, values);
  }
  return values;
}

}  // namespace rasterproof::bench
