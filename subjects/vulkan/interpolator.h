// Shows what Vulkan's fragments hold: into floats, four channels in a pass.
#ifndef RASTERPROOF_SUBJECTS_VULKAN_INTERPOLATOR_H_
#define RASTERPROOF_SUBJECTS_VULKAN_INTERPOLATOR_H_

#include <cstdint>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "subjects/shaded/shaded.h"
#include "subjects/vulkan/painter.h"

namespace rasterproof::subjects {

/// As GlInterpolator of subjects/gl/, but z outside [0, w] is clipped.
class VulkanInterpolator {
 public:
  /// Error:      throws as VulkanPainter.
  explicit VulkanInterpolator(const VulkanDriver& driver);

  /// Returns 0, or 1 if the scene is out of range.
  std::int32_t Draw(const rasterproof_scene& scene, const rasterproof_target& target);

 private:
  VulkanPainter painter_;
  std::vector<float> corners_;
  std::vector<std::int32_t> indices_;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_VULKAN_INTERPOLATOR_H_
