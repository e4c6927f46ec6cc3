// Counts triangles in Vulkan: additive blending into floats, one channel for each facing.
#ifndef RASTERPROOF_SUBJECTS_VULKAN_COUNTER_H_
#define RASTERPROOF_SUBJECTS_VULKAN_COUNTER_H_

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "kit/rasterproof_plugin.h"
#include "subjects/vulkan/sample_reader.h"

namespace rasterproof::subjects {

/// Memory that both sides see.
struct VulkanBuffer {
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  void* mapped = nullptr;
  VkDeviceSize size = 0;
};

/// A driver without a display, and how large a viewport it takes.
struct VulkanDriver {
  /// File that the loader reads in place of those that are installed; empty: it reads those.
  const char* description;
  const char* device;  ///< how the device's name begins; empty: any GPU
  int half_viewport;   ///< a power of two; nothing within is clipped
  int samples;         ///< a pixel
};

/// The subpixel bits that the driver's device reports; nothing if there is no such device.
std::optional<int> ReportedSubpixelBits(const VulkanDriver& driver);

/// Draws a scene in one draw.
///
/// Window coordinates arrive exactly, as in subjects/gl/counter.h: the viewport is centred on the
/// origin, a power of two to either side.
class VulkanCounter {
 public:
  /// Error:      throws std::runtime_error if there is no such device, or if it does not have the
  ///             driver's number of samples at the standard locations.
  explicit VulkanCounter(const VulkanDriver& driver);
  ~VulkanCounter();
  VulkanCounter(const VulkanCounter&) = delete;
  VulkanCounter& operator=(const VulkanCounter&) = delete;

  /// Returns 0, or 1 if the scene is out of range.
  std::int32_t Draw(const rasterproof_scene& scene, const rasterproof_target& target);

 private:
  void MakeDevice(const char* name);
  void RequireSamples() const;
  VkImageUsageFlags Usage() const;
  void MakePipeline();
  void MakeCommands();
  VkDeviceMemory Allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted);
  void Grow(VulkanBuffer& buffer, VkDeviceSize size, VkBufferUsageFlags usage);
  void Release(VulkanBuffer& buffer);
  void Resize(std::uint32_t width, std::uint32_t height);
  void ReleaseImage();
  bool Upload(const rasterproof_scene& scene);
  void Record(std::uint32_t indices);
  void RecordReading();
  void Run();

  int half_viewport_;
  int samples_;
  VkSampleCountFlagBits sample_bit_;
  VkInstance instance_ = VK_NULL_HANDLE;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  VkExtent2D extent_{};
  VkImage image_ = VK_NULL_HANDLE;
  VkDeviceMemory image_memory_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
  VulkanBuffer vertices_;
  VulkanBuffer indices_;
  VulkanBuffer texels_;
  std::optional<SampleReader> reader_;  ///< of more samples than one
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_VULKAN_COUNTER_H_
