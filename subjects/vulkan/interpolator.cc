#include "subjects/vulkan/interpolator.h"

#include <numeric>

#include "values.frag.h"
#include "values.vert.h"

namespace rasterproof::subjects {

VulkanInterpolator::VulkanInterpolator(const VulkanDriver& driver)
    : painter_(driver, {.vertex_shader = kVertexShader,
                        .fragment_shader = kFragmentShader,
                        .inputs = kCornerFloats / 4,
                        .components = 4,
                        .layers = kShaderOutputs,
                        .adds = false}) {}

std::int32_t VulkanInterpolator::Draw(const rasterproof_scene& scene,
                                      const rasterproof_target& target) {
  indices_.resize(3 * scene.triangle_count);
  std::iota(indices_.begin(), indices_.end(), 0);
  return DrawInPasses(scene, target, painter_.half_viewport(), corners_,
                      [&](const PassKinds& kinds) {
                        return painter_.Paint(scene.width, scene.height, corners_, indices_, kinds);
                      });
}

}  // namespace rasterproof::subjects
