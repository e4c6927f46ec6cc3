#include "core/drawing.h"

#include <algorithm>

namespace rasterproof {

Scene SceneOf(const DrawJob& job) {
  if (!job.triangles) return *job.scene;
  Scene scene;
  scene.name = job.scene->name;
  scene.width = job.scene->width;
  scene.height = job.scene->height;
  scene.precision = job.scene->precision;
  scene.clip_space = job.scene->clip_space;
  scene.vertices = job.scene->vertices;
  scene.triangles = *job.triangles;
  scene.channels = job.scene->channels;
  return scene;
}

bool AreInTheUsualMode(std::span<const DrawJob> jobs) {
  return std::ranges::all_of(
      jobs, [](const DrawJob& job) { return job.options.float_mode == FloatMode::kUsual; });
}

}  // namespace rasterproof
