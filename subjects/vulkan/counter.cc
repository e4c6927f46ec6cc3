#include "subjects/vulkan/counter.h"

#include <cstddef>

#include "subjects/shaded/shaded.h"
#include "triangle.frag.h"
#include "triangle.vert.h"

namespace rasterproof::subjects {

VulkanCounter::VulkanCounter(const VulkanDriver& driver)
    : painter_(driver, {.vertex_shader = kVertexShader,
                        .fragment_shader = kFragmentShader,
                        .inputs = 1,
                        .components = 2,
                        .layers = 1,
                        .adds = true,
                        .shades_samples = false,
                        .depths_in_layer = -1}) {}

std::int32_t VulkanCounter::Draw(const rasterproof_scene& scene, const rasterproof_target& target) {
  const int most = painter_.half_viewport();
  if (scene.width > most || scene.height > most || target.samples != painter_.samples()) return 1;
  clip_.clear();
  for (std::size_t v = 0; v < scene.vertex_count; ++v)
    if (!AddClipPlace(scene.vertices + 4 * v, most, clip_)) return 1;
  const float* texel =
      painter_.Paint(scene.width, scene.height, clip_, {scene.triangles, 3 * scene.triangle_count});
  const auto height = static_cast<std::size_t>(scene.height);
  const std::size_t row =
      static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(target.samples);
  for (std::size_t y = 0; y < height; ++y) {
    for (std::size_t x = 0; x < row; ++x, texel += 2) {
      target.front[y * target.stride + x] += static_cast<std::uint32_t>(texel[0]);
      target.back[y * target.stride + x] += static_cast<std::uint32_t>(texel[1]);
    }
  }
  return 0;
}

}  // namespace rasterproof::subjects
