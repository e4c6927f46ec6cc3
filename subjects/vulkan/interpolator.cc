#include "subjects/vulkan/interpolator.h"

#include <cstdint>
#include <numeric>
#include <span>

#include "sample_values.frag.h"
#include "values.frag.h"
#include "values.vert.h"

namespace rasterproof::subjects {

namespace {

std::span<const std::uint32_t> ShaderOf(int samples) {
  if (samples > 1) return kSampleFragmentShader;
  return kFragmentShader;
}

}  // namespace

VulkanInterpolator::VulkanInterpolator(const VulkanDriver& driver)
    : painter_(driver, {.vertex_shader = kVertexShader,
                        .fragment_shader = ShaderOf(driver.samples),
                        .inputs = kCornerFloats / 4,
                        .components = 4,
                        .layers = kShaderOutputs,
                        .adds = false,
                        .shades_samples = driver.samples > 1,
                        // Of which sample gl_FragCoord has the depth, Vulkan does not say.
                        .depths_in_layer = driver.samples > 1 ? std::int32_t{kPlace} : -1}) {}

std::int32_t VulkanInterpolator::Draw(const rasterproof_scene& scene,
                                      const rasterproof_target& target) {
  indices_.resize(3 * scene.triangle_count);
  std::iota(indices_.begin(), indices_.end(), 0);
  return DrawInPasses(scene, target, painter_.half_viewport(), painter_.samples(), corners_,
                      [&](const PassKinds& kinds) {
                        return painter_.Paint(scene.width, scene.height, corners_, indices_, kinds);
                      });
}

}  // namespace rasterproof::subjects
