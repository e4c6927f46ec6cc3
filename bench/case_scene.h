// Scenes of one triangle.
#ifndef RASTERPROOF_BENCH_CASE_SCENE_H_
#define RASTERPROOF_BENCH_CASE_SCENE_H_

#include <algorithm>
#include <array>

#include "core/scene.h"
#include "core/ulp.h"
#include "core/vertex.h"

namespace rasterproof::bench {

/// The triangle alone on a target: of float32 if float32 holds every coordinate.
inline Scene SceneOfTriangle(const std::array<Vertex, 3>& v, int width, int height,
                             bool is_clip_space) {
  Scene scene;
  scene.name = "hard";
  scene.width = width;
  scene.height = height;
  scene.clip_space = is_clip_space;
  const bool is_float32 = std::ranges::all_of(
      v, [](const Vertex& p) { return IsFloat32(p.x) && IsFloat32(p.y) && IsFloat32(p.w); });
  scene.precision = is_float32 ? Precision::kFloat32 : Precision::kFloat64;
  scene.vertices.assign(v.begin(), v.end());
  scene.triangles = {{0, 1, 2}};
  return scene;
}

inline Scene SceneOfTriangle(const std::array<Point2, 3>& v, int width, int height) {
  std::array<Vertex, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) corners[k] = {v[k].x, v[k].y};
  return SceneOfTriangle(corners, width, height, false);
}

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_CASE_SCENE_H_
