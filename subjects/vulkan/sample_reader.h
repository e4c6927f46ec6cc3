// Reads every sample of a multisampled image into a buffer, by a compute shader.
#ifndef RASTERPROOF_SUBJECTS_VULKAN_SAMPLE_READER_H_
#define RASTERPROOF_SUBJECTS_VULKAN_SAMPLE_READER_H_

#include <vulkan/vulkan.h>

namespace rasterproof::subjects {

/// Domain:     a device that outlives it, and a queue that computes.
class SampleReader {
 public:
  explicit SampleReader(VkDevice device);
  ~SampleReader();
  SampleReader(const SampleReader&) = delete;
  SampleReader& operator=(const SampleReader&) = delete;

  /// Records the copy of the image, which is in layout GENERAL, into [height][width][sample] pairs
  /// of floats.
  void Record(VkCommandBuffer commands, VkImageView view, VkBuffer texels, VkExtent2D extent,
              int samples);

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
