// The nearest triangle at each pixel centre, with what was asked to be known of it.
#include "core/fragments.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "reference/bands.h"
#include "reference/box.h"
#include "reference/rasterize.h"

namespace rasterproof::reference {
namespace {

constexpr float kNothing = std::numeric_limits<float>::infinity();

/// The three linear functions of a triangle that every interpolated value is made of.
///
/// With rows V_i = (x_i, y_i, w_i), the point (p.x, p.y, 1) is sum beta_i V_i, and beta_i is
/// proportional to (V_j x V_k) . (p.x, p.y, 1), edge jk opposite vertex i. Then beta_i / sum beta
/// are the (perspective-correct) barycentrics and sum beta_i z_i / sum beta_i w_i is z / w there.
/// In window space w = 1: the beta_i are the edge values, anchored at a vertex to lose nothing to
/// cancellation far from the origin.
class Interpolant {
 public:
  explicit Interpolant(const std::array<Vertex, 3>& v, bool clip_space) : v_(v) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vertex& j = v[(i + 1) % 3];
      const Vertex& k = v[(i + 2) % 3];
      lines_[i] = clip_space ? Line{k.y * j.w - k.w * j.y, k.w * j.x - k.x * j.w, 0, 0,
                                    k.x * j.y - k.y * j.x}
                             : Line{k.y - j.y, j.x - k.x, j.x, j.y, 0};
    }
  }

  void MoveTo(double x, double y) {
    for (std::size_t i = 0; i < 3; ++i) beta_[i] = lines_[i].At(x, y);
  }
  std::array<float, 3> Barycentrics() const {
    const double sum = beta_[0] + beta_[1] + beta_[2];
    return {static_cast<float>(beta_[0] / sum), static_cast<float>(beta_[1] / sum),
            static_cast<float>(beta_[2] / sum)};
  }
  /// Infinity where z is not a number there.
  float Depth() const {
    double z = 0;
    double w = 0;
    for (std::size_t i = 0; i < 3; ++i) {
      z += beta_[i] * v_[i].z;
      w += beta_[i] * v_[i].w;
    }
    const double depth = z / w;
    return std::isnan(depth) ? kNothing : static_cast<float>(depth);
  }
  float EdgeDistance() const {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
      nearest = std::fmin(nearest, std::fabs(beta_[i]) / std::hypot(lines_[i].a, lines_[i].b));
    }
    return static_cast<float>(nearest);
  }

 private:
  struct Line {
    double a, b, x0, y0, c;
    double At(double x, double y) const { return a * (x - x0) + b * (y - y0) + c; }
  };
  const std::array<Vertex, 3>& v_;
  std::array<Line, 3> lines_{};
  std::array<double, 3> beta_{};
};

/// Pixels that a triangle may touch under any method: its box, one pixel wider for what a snap or
/// the division may move, or everything if its edges don't stay within the projected vertices.
PixelRect FragmentBox(const std::array<Vertex, 3>& v, bool clip_space, const PixelRect& area) {
  std::array<Point2, 3> window;
  for (std::size_t i = 0; i < 3; ++i) {
    if (clip_space && !(v[i].w > 0)) return area;
    window[i] = clip_space ? Point2{v[i].x / v[i].w, v[i].y / v[i].w} : WindowPoint(v[i]);
    if (!std::isfinite(window[i].x) || !std::isfinite(window[i].y)) return area;
  }
  const PixelRect box = SampleBox(window, {0, 0, kMaxTargetSide, kMaxTargetSide});
  return Intersection({box.x0 - 1, box.y0 - 1, box.x1 + 1, box.y1 + 1}, area);
}

/// Shades the samples of one triangle that `counts` says are covered, and clears them there.
template <bool kBarycentrics, bool kDistance>
void ShadeTriangle(Interpolant& interpolant, std::int32_t triangle, const PixelRect& box,
                   CoverageCounts& counts, FragmentBuffers& out) {
  for (int j = box.y0; j < box.y1; ++j) {
    for (int i = box.x0; i < box.x1; ++i) {
      const std::size_t n = counts.Index(i, j);
      if (counts.Count(n) == 0) continue;
      counts.front[n] = counts.back[n] = 0;
      interpolant.MoveTo(i + 0.5, j + 0.5);
      const float depth = interpolant.Depth();
      if (out.triangle[n] >= 0 && !(depth < out.depth[n])) continue;
      out.triangle[n] = triangle;
      out.depth[n] = depth;
      if constexpr (kBarycentrics) out.barycentrics[n] = interpolant.Barycentrics();
      if constexpr (kDistance) out.edge_distance[n] = interpolant.EdgeDistance();
    }
  }
}

using Shade = decltype(&ShadeTriangle<false, false>);

Shade ShaderFor(const Needs& needs) {
  if (needs.barycentrics) {
    return needs.edge_distance ? &ShadeTriangle<true, true> : &ShadeTriangle<true, false>;
  }
  return needs.edge_distance ? &ShadeTriangle<false, true> : &ShadeTriangle<false, false>;
}

FragmentBuffers EmptyBuffers(const Scene& scene, const Needs& needs) {
  const std::size_t size = CoverageCounts::Size(scene.width, scene.height, 1);
  FragmentBuffers out;
  out.width = scene.width;
  out.height = scene.height;
  out.triangle.assign(size, -1);
  out.depth.assign(size, kNothing);  // the nearest triangle is found by it, asked for or not
  if (needs.barycentrics) out.barycentrics.assign(size, {0, 0, 0});
  if (needs.edge_distance) out.edge_distance.assign(size, kNothing);
  return out;
}

}  // namespace

FragmentBuffers RasterizeFragments(const Scene& scene, const Method& method,
                                   const RasterOptions& options, const Needs& needs) {
  RequireTakes(scene, method);
  FragmentBuffers out = EmptyBuffers(scene, needs);
  const Shade shade = ShaderFor(needs);
  // One triangle at a time by the method's own kernel, so that every method is served by one
  // shader. Bands share no row, so they can share the buffers.
  CoverageCounts counts(scene.width, scene.height);
  ForEachBand(DrawArea(scene, options), options, [&](const PixelRect& band) {
    Scene single = scene;
    single.triangles = {{0, 1, 2}};
    RasterOptions within = options;
    within.threads = 1;
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      const std::array<Vertex, 3> v = Corners(scene, scene.triangles[t]);
      const PixelRect box = FragmentBox(v, scene.clip_space, band);
      if (IsEmpty(box) || !std::ranges::all_of(v, IsFinite)) continue;
      single.vertices.assign(v.begin(), v.end());
      within.scissor = box;
      Rasterize(single, method, within, counts);
      Interpolant interpolant(v, scene.clip_space);
      shade(interpolant, static_cast<std::int32_t>(t), box, counts, out);
    }
  });
  if (!needs.depth) out.depth.clear();
  return out;
}

}  // namespace rasterproof::reference
