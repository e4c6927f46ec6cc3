// The exact kernel behind the C interface: what bench tells of a plugin against what it tells of the
// kernel that draws into the same sink.
//
//     cmake --build build --target kernel_plugin
//     build/rasterproof bench --plugin build/test_plugins/kernel.so --subject kernel-exact
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "kit/rasterproof_rasterize.h"

namespace {

std::int32_t Draw(void* /*state*/, const rasterproof_scene* scene,
                  const rasterproof_target* target) {
  static std::vector<float> positions;
  static std::vector<std::uint32_t> indices;
  positions.clear();
  for (std::size_t i = 0; i < scene->vertex_count; ++i) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      positions.push_back(static_cast<float>(scene->vertices[4 * i + axis]));
    }
  }
  indices.assign(scene->triangles, scene->triangles + 3 * scene->triangle_count);
  const rasterproof_raster_mesh mesh{positions.data(), scene->vertex_count, indices.data(),
                                     scene->triangle_count};
  const std::size_t rows = static_cast<std::size_t>(scene->height) - 1;
  const std::size_t bytes = 4 * (rows * target->stride + static_cast<std::size_t>(scene->width));
  const rasterproof_raster_target counts{.output = RASTERPROOF_RASTER_FACING_COUNTS,
                                         .width = scene->width,
                                         .height = scene->height,
                                         .pitch = 4 * target->stride,
                                         .memory = target->front,
                                         .memory_size = bytes,
                                         .back = target->back,
                                         .back_size = bytes};
  return rasterproof_rasterize(&mesh, &counts, RASTERPROOF_RASTER_BEST) == RASTERPROOF_RASTER_OK
             ? 0
             : 1;
}

rasterproof_plugin Describe() {
  rasterproof_plugin plugin{};
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof(rasterproof_plugin);
  plugin.name = "kernel";
  plugin.summary = "the exact kernel behind the C interface";
  plugin.profile = "real";
  plugin.input = RASTERPROOF_FLOAT32;
  plugin.coverage = RASTERPROOF_FACING_COUNTS;
  plugin.draw = &Draw;
  plugin.edge_error = -1;
  plugin.stepping_error = -1;
  return plugin;
}

}  // namespace

extern "C" const rasterproof_plugin* rasterproof_plugin_describe() {
  static const rasterproof_plugin plugin = Describe();
  return &plugin;
}
