// Counts triangles in Vulkan: additive blending into floats, one channel for each facing.
#ifndef RASTERPROOF_SUBJECTS_VULKAN_COUNTER_H_
#define RASTERPROOF_SUBJECTS_VULKAN_COUNTER_H_

#include <cstdint>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "subjects/vulkan/painter.h"

namespace rasterproof::subjects {

/// Draws a scene of window space in one draw.
class VulkanCounter {
 public:
  /// Error:      throws as VulkanPainter.
  explicit VulkanCounter(const VulkanDriver& driver);

  /// Returns 0, or 1 if the scene is out of range.
  std::int32_t Draw(const rasterproof_scene& scene, const rasterproof_target& target);

 private:
  VulkanPainter painter_;
  std::vector<float> clip_;  ///< x and y of each vertex
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_VULKAN_COUNTER_H_
