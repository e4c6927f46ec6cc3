// Reads every sample of a multisampled image into a buffer, by a compute shader.
#ifndef RASTERPROOF_SUBJECTS_VULKAN_SAMPLE_READER_H_
#define RASTERPROOF_SUBJECTS_VULKAN_SAMPLE_READER_H_

#include <vulkan/vulkan.h>

#include <cstdint>

namespace rasterproof::subjects {

/// What is read: every layer, every sample, so many floats of each; in one layer, if any, the depth
/// in place of the fourth.
struct SampleShape {
  std::int32_t width;
  std::int32_t height;
  std::int32_t samples;
  std::int32_t layers;
  std::int32_t components;
  std::int32_t depths_in_layer;  ///< -1: in none
};

/// Domain:     a device that outlives it, and a queue that computes.
class SampleReader {
 public:
  explicit SampleReader(VkDevice device);
  ~SampleReader();
  SampleReader(const SampleReader&) = delete;
  SampleReader& operator=(const SampleReader&) = delete;

  /// Records the copy of the layers and depths, which are in layout GENERAL, into
  /// [layer][height][width][sample][component] floats. `depths`: any view of one layer, if unread.
  void Record(VkCommandBuffer commands, VkImageView layers, VkImageView depths, VkBuffer texels,
              const SampleShape& shape);

 private:
  void MakeLayouts();
  void MakePipeline();
  void MakeSet();

  VkDevice device_;
  VkSampler sampler_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout set_layout_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_VULKAN_SAMPLE_READER_H_
