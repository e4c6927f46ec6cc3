// Draws triangles in Vulkan into layers of floats, and reads them back.
#ifndef RASTERPROOF_SUBJECTS_VULKAN_PAINTER_H_
#define RASTERPROOF_SUBJECTS_VULKAN_PAINTER_H_

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "subjects/shaded/shaded.h"
#include "subjects/vulkan/sample_reader.h"

namespace rasterproof::subjects {

/// What is drawn into.
struct VulkanImage {
  VkImage image = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
};

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

/// What is drawn, and how.
struct VulkanPainting {
  std::span<const std::uint32_t> vertex_shader;
  std::span<const std::uint32_t> fragment_shader;
  std::uint32_t inputs;      ///< of the vertex shader, the same floats each
  std::uint32_t components;  ///< floats of an input and of a texel: 2 or 4
  std::uint32_t layers;      ///< outputs of the fragment shader
  bool adds;                 ///< instead of replacing what is there
  bool shades_samples;       ///< the fragment shader is run for each sample
  /// The layer whose fourth float is the depth that was written; -1: there are no depths.
  std::int32_t depths_in_layer;
};

/// Draws a mesh in one draw.
///
/// The viewport is that of AddClipPlace().
class VulkanPainter {
 public:
  /// Error:      throws std::runtime_error if there is no such device, or if it does not have the
  ///             driver's number of samples at the standard locations.
  VulkanPainter(const VulkanDriver& driver, const VulkanPainting& painting);
  ~VulkanPainter();
  VulkanPainter(const VulkanPainter&) = delete;
  VulkanPainter& operator=(const VulkanPainter&) = delete;

  int half_viewport() const { return half_viewport_; }
  int samples() const { return samples_; }

  /// Draws on an empty target. Returns its texels: [layer][height][width * samples][components].
  const float* Paint(std::int32_t width, std::int32_t height, std::span<const float> vertices,
                     std::span<const std::int32_t> indices, const PassKinds& constants = {});

 private:
  void MakeDevice(const char* name);
  void RequireSamples() const;
  VkImageUsageFlags Usage() const;
  VkFormat Format() const;
  void MakePipeline();
  void MakeCommands();
  VkDeviceMemory Allocate(const VkMemoryRequirements& needs, VkMemoryPropertyFlags wanted);
  void Grow(VulkanBuffer& buffer, VkDeviceSize size, VkBufferUsageFlags usage);
  void Release(VulkanBuffer& buffer);
  void Resize(std::uint32_t width, std::uint32_t height);
  bool KeepsDepths() const { return painting_.depths_in_layer >= 0; }
  VulkanImage MakeImage(VkFormat format, std::uint32_t layers, VkImageUsageFlags usage);
  VkImageView MakeView(VkImage image, VkImageViewType type, VkFormat format,
                       const VkImageSubresourceRange& range);
  void ReleaseImage(VulkanImage& image);
  void ReleaseTarget();
  VkRenderingAttachmentInfo Attachment(VkImageView view) const;
  void Upload(std::span<const float> vertices, std::span<const std::int32_t> indices);
  void Record(std::uint32_t indices, const PassKinds& constants);
  void RecordReading();
  void Run();

  VulkanPainting painting_;
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
  VulkanImage colors_;
  VulkanImage depths_;
  std::vector<VkImageView> views_;           ///< one a layer
  VkImageView layers_ = VK_NULL_HANDLE;      ///< of all, for the reader
  VkImageView depth_view_ = VK_NULL_HANDLE;  ///< if depths are kept
  VulkanBuffer vertices_;
  VulkanBuffer indices_;
  VulkanBuffer texels_;
  std::optional<SampleReader> reader_;  ///< of more samples than one
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_VULKAN_PAINTER_H_
