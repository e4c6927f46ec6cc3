#include "core/drawing.h"

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
  return scene;
}

}  // namespace rasterproof
