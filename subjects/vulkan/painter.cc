#include "subjects/vulkan/painter.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>

#include "subjects/vulkan/objects.h"

namespace rasterproof::subjects {
namespace {

constexpr VkDynamicState kScissor = VK_DYNAMIC_STATE_SCISSOR;

VkPipelineColorBlendAttachmentState Blending(bool adds) {
  VkPipelineColorBlendAttachmentState state{};
  state.blendEnable = adds ? VK_TRUE : VK_FALSE;
  state.srcColorBlendFactor = state.dstColorBlendFactor = VK_BLEND_FACTOR_ONE;
  state.srcAlphaBlendFactor = state.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
  state.colorWriteMask = VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT |
                         VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
  return state;
}

constexpr VkImageSubresourceRange kWhole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0,
                                         VK_REMAINING_ARRAY_LAYERS};
constexpr VkImageSubresourceRange kAllDepths{VK_IMAGE_ASPECT_DEPTH_BIT, 0, 1, 0, 1};
constexpr VkFormat kDepthFormat = VK_FORMAT_D32_SFLOAT;

void Transition(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to,
                const VkImageSubresourceRange& range = kWhole) {
  VkImageMemoryBarrier barrier{};
  barrier.sType = VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER;
  barrier.srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = range;
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                       VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

VkResult MakeInstance(const VulkanDriver& driver, VkInstance& instance) {
  if (*driver.description != '\0') setenv("VK_DRIVER_FILES", driver.description, 1);
  VkApplicationInfo application{};
  application.sType = VK_STRUCTURE_TYPE_APPLICATION_INFO;
  application.apiVersion = VK_API_VERSION_1_3;
  VkInstanceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_INSTANCE_CREATE_INFO;
  info.pApplicationInfo = &application;
  return vkCreateInstance(&info, nullptr, &instance);
}

// The last device whose name begins so, or any GPU; VK_NULL_HANDLE if there is none.
VkPhysicalDevice FindDevice(VkInstance instance, const char* name) {
  std::uint32_t count = 0;
  vkEnumeratePhysicalDevices(instance, &count, nullptr);
  std::vector<VkPhysicalDevice> devices(count);
  vkEnumeratePhysicalDevices(instance, &count, devices.data());
  VkPhysicalDevice found = VK_NULL_HANDLE;
  for (VkPhysicalDevice device : devices) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    const bool is_gpu = properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU ||
                        properties.deviceType == VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU;
    const bool is_named = std::string_view(properties.deviceName).starts_with(name);
    if (*name == '\0' ? is_gpu : is_named) found = device;
  }
  return found;
}

}  // namespace

std::optional<int> ReportedSubpixelBits(const VulkanDriver& driver) {
  VkInstance instance = VK_NULL_HANDLE;
  if (MakeInstance(driver, instance) != VK_SUCCESS) return std::nullopt;
  std::optional<int> bits;
  if (const VkPhysicalDevice device = FindDevice(instance, driver.device)) {
    VkPhysicalDeviceProperties properties{};
    vkGetPhysicalDeviceProperties(device, &properties);
    bits = static_cast<int>(properties.limits.subPixelPrecisionBits);
  }
  vkDestroyInstance(instance, nullptr);
  return bits;
}

VulkanPainter::VulkanPainter(const VulkanDriver& driver, const VulkanPainting& painting)
    : painting_(painting),
      half_viewport_(driver.half_viewport),
      samples_(driver.samples),
      sample_bit_(static_cast<VkSampleCountFlagBits>(driver.samples)) {
  Require(MakeInstance(driver, instance_), "no Vulkan");
  MakeDevice(driver.device);
  if (samples_ > 1) {
    RequireSamples();
    reader_.emplace(device_);
  }
  MakePipeline();
  MakeCommands();
}

VkFormat VulkanPainter::Format() const {
  return painting_.components == 2 ? VK_FORMAT_R32G32_SFLOAT : VK_FORMAT_R32G32B32A32_SFLOAT;
}

void VulkanPainter::MakeDevice(const char* name) {
  physical_ = FindDevice(instance_, name);
  if (physical_ == VK_NULL_HANDLE) throw std::runtime_error("no such device");
  VkFormatProperties format{};
  vkGetPhysicalDeviceFormatProperties(physical_, Format(), &format);
  const VkFormatFeatureFlags needed = painting_.adds ? VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BLEND_BIT
                                                     : VK_FORMAT_FEATURE_COLOR_ATTACHMENT_BIT;
  if ((format.optimalTilingFeatures & needed) == 0) {
    throw std::runtime_error("the device cannot draw into floats");
  }
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{};
  queue.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;
  VkPhysicalDeviceVulkan13Features features{};
  features.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES;
  features.dynamicRendering = VK_TRUE;
  VkPhysicalDeviceFeatures of_samples{};
  of_samples.sampleRateShading = painting_.shades_samples ? VK_TRUE : VK_FALSE;
  VkDeviceCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO;
  info.pNext = &features;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  info.pEnabledFeatures = &of_samples;
  Require(vkCreateDevice(physical_, &info, nullptr, &device_), "no Vulkan device");
  vkGetDeviceQueue(device_, 0, 0, &queue_);
}

void VulkanPainter::RequireSamples() const {
  VkPhysicalDeviceProperties properties{};
  vkGetPhysicalDeviceProperties(physical_, &properties);
  const VkPhysicalDeviceLimits& limits = properties.limits;
  if (limits.standardSampleLocations != VK_TRUE) {
    throw std::runtime_error("the device does not say where its samples lie");
  }
  VkImageFormatProperties format{};
  Require(vkGetPhysicalDeviceImageFormatProperties(physical_, Format(), VK_IMAGE_TYPE_2D,
                                                   VK_IMAGE_TILING_OPTIMAL, Usage(), 0, &format),
          "no multisampled image of floats");
  if ((format.sampleCounts & sample_bit_) == 0) throw std::runtime_error("not so many samples");
}

VkImageUsageFlags VulkanPainter::Usage() const {
  return VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT |
         (samples_ > 1 ? VK_IMAGE_USAGE_SAMPLED_BIT : VK_IMAGE_USAGE_TRANSFER_SRC_BIT);
}

void VulkanPainter::MakeCommands() {
  VkCommandPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO;
  pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
  Require(vkCreateCommandPool(device_, &pool, nullptr, &pool_), "no command pool");
  VkCommandBufferAllocateInfo buffer{};
  buffer.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO;
  buffer.commandPool = pool_;
  buffer.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
  buffer.commandBufferCount = 1;
  Require(vkAllocateCommandBuffers(device_, &buffer, &commands_), "no command buffer");
  VkFenceCreateInfo fence{};
  fence.sType = VK_STRUCTURE_TYPE_FENCE_CREATE_INFO;
  Require(vkCreateFence(device_, &fence, nullptr, &fence_), "no fence");
}

// NOLINTNEXTLINE(readability-function-size): structures to fill in, one after the other.
void VulkanPainter::MakePipeline() {
  constexpr VkPushConstantRange kConstants{VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(PassKinds)};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &kConstants;
  Require(vkCreatePipelineLayout(device_, &layout, nullptr, &layout_), "no pipeline layout");
  const std::array<VkPipelineShaderStageCreateInfo, 2> stages{
      Stage(VK_SHADER_STAGE_VERTEX_BIT, Module(device_, painting_.vertex_shader)),
      Stage(VK_SHADER_STAGE_FRAGMENT_BIT, Module(device_, painting_.fragment_shader))};
  const std::uint32_t bytes = painting_.components * std::uint32_t{sizeof(float)};
  const VkVertexInputBindingDescription binding{0, painting_.inputs * bytes,
                                                VK_VERTEX_INPUT_RATE_VERTEX};
  std::vector<VkVertexInputAttributeDescription> attributes;
  for (std::uint32_t k = 0; k < painting_.inputs; ++k)
    attributes.push_back({k, 0, Format(), k * bytes});
  VkPipelineVertexInputStateCreateInfo input{};
  input.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO;
  input.vertexBindingDescriptionCount = 1;
  input.pVertexBindingDescriptions = &binding;
  input.vertexAttributeDescriptionCount = painting_.inputs;
  input.pVertexAttributeDescriptions = attributes.data();
  VkPipelineInputAssemblyStateCreateInfo assembly{};
  assembly.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO;
  assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
  VkPipelineViewportStateCreateInfo views{};
  views.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO;
  views.viewportCount = 1;
  const auto half = static_cast<float>(half_viewport_);
  const VkViewport viewport{-half, -half, 2 * half, 2 * half, 0, 1};
  views.pViewports = &viewport;
  views.scissorCount = 1;
  VkPipelineRasterizationStateCreateInfo raster{};
  raster.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO;
  raster.frontFace = VK_FRONT_FACE_COUNTER_CLOCKWISE;
  raster.lineWidth = 1;
  VkPipelineMultisampleStateCreateInfo samples{};
  samples.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO;
  samples.rasterizationSamples = sample_bit_;
  const std::vector blending(painting_.layers, Blending(painting_.adds));
  VkPipelineColorBlendStateCreateInfo blend{};
  blend.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO;
  blend.attachmentCount = painting_.layers;
  blend.pAttachments = blending.data();
  VkPipelineDynamicStateCreateInfo dynamic{};
  dynamic.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO;
  dynamic.dynamicStateCount = 1;
  dynamic.pDynamicStates = &kScissor;
  VkPipelineRenderingCreateInfo rendering{};
  rendering.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO;
  const std::vector formats(painting_.layers, Format());
  rendering.colorAttachmentCount = painting_.layers;
  rendering.pColorAttachmentFormats = formats.data();
  if (KeepsDepths()) rendering.depthAttachmentFormat = kDepthFormat;
  VkPipelineDepthStencilStateCreateInfo depths{};
  depths.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO;
  depths.depthTestEnable = depths.depthWriteEnable = KeepsDepths() ? VK_TRUE : VK_FALSE;
  depths.depthCompareOp = VK_COMPARE_OP_ALWAYS;
  VkGraphicsPipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO;
  info.pNext = &rendering;
  info.stageCount = 2;
  info.pStages = stages.data();
  info.pVertexInputState = &input;
  info.pInputAssemblyState = &assembly;
  info.pViewportState = &views;
  info.pRasterizationState = &raster;
  info.pMultisampleState = &samples;
  info.pDepthStencilState = &depths;
  info.pColorBlendState = &blend;
  info.pDynamicState = &dynamic;
  info.layout = layout_;
  Require(vkCreateGraphicsPipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_),
          "no pipeline");
  for (const VkPipelineShaderStageCreateInfo& stage : stages) {
    vkDestroyShaderModule(device_, stage.module, nullptr);
  }
}

VkDeviceMemory VulkanPainter::Allocate(const VkMemoryRequirements& needs,
                                       VkMemoryPropertyFlags wanted) {
  VkPhysicalDeviceMemoryProperties types{};
  vkGetPhysicalDeviceMemoryProperties(physical_, &types);
  for (std::uint32_t k = 0; k < types.memoryTypeCount; ++k) {
    if ((needs.memoryTypeBits >> k & 1U) == 0) continue;
    if ((types.memoryTypes[k].propertyFlags & wanted) != wanted) continue;
    VkMemoryAllocateInfo info{};
    info.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO;
    info.allocationSize = needs.size;
    info.memoryTypeIndex = k;
    VkDeviceMemory memory = VK_NULL_HANDLE;
    Require(vkAllocateMemory(device_, &info, nullptr, &memory), "no memory");
    return memory;
  }
  throw std::runtime_error("no memory of that type");
}

void VulkanPainter::Release(VulkanBuffer& buffer) {
  vkDestroyBuffer(device_, buffer.buffer, nullptr);
  vkFreeMemory(device_, buffer.memory, nullptr);
  buffer = {};
}

void VulkanPainter::Grow(VulkanBuffer& buffer, VkDeviceSize size, VkBufferUsageFlags usage) {
  if (size <= buffer.size) return;
  Release(buffer);
  VkBufferCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO;
  info.size = size;
  info.usage = usage;
  Require(vkCreateBuffer(device_, &info, nullptr, &buffer.buffer), "no buffer");
  VkMemoryRequirements needs{};
  vkGetBufferMemoryRequirements(device_, buffer.buffer, &needs);
  buffer.memory =
      Allocate(needs, VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT);
  Require(vkBindBufferMemory(device_, buffer.buffer, buffer.memory, 0), "no bound buffer");
  Require(vkMapMemory(device_, buffer.memory, 0, VK_WHOLE_SIZE, 0, &buffer.mapped), "not mapped");
  buffer.size = size;
}

void VulkanPainter::ReleaseImage(VulkanImage& image) {
  vkDestroyImage(device_, image.image, nullptr);
  vkFreeMemory(device_, image.memory, nullptr);
  image = {};
}

void VulkanPainter::ReleaseTarget() {
  for (VkImageView view : views_) vkDestroyImageView(device_, view, nullptr);
  vkDestroyImageView(device_, layers_, nullptr);
  vkDestroyImageView(device_, depth_view_, nullptr);
  ReleaseImage(colors_);
  ReleaseImage(depths_);
}

VulkanImage VulkanPainter::MakeImage(VkFormat format, std::uint32_t layers,
                                     VkImageUsageFlags usage) {
  VulkanImage made;
  VkImageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO;
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = format;
  info.extent = {extent_.width, extent_.height, 1};
  info.mipLevels = 1;
  info.arrayLayers = layers;
  info.samples = sample_bit_;
  info.usage = usage;
  Require(vkCreateImage(device_, &info, nullptr, &made.image), "no image");
  VkMemoryRequirements needs{};
  vkGetImageMemoryRequirements(device_, made.image, &needs);
  made.memory = Allocate(needs, 0);
  Require(vkBindImageMemory(device_, made.image, made.memory, 0), "no bound image");
  return made;
}

VkImageView VulkanPainter::MakeView(VkImage image, VkImageViewType type, VkFormat format,
                                    const VkImageSubresourceRange& range) {
  VkImageViewCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO;
  info.image = image;
  info.viewType = type;
  info.format = format;
  info.subresourceRange = range;
  VkImageView view = VK_NULL_HANDLE;
  Require(vkCreateImageView(device_, &info, nullptr, &view), "no image view");
  return view;
}

void VulkanPainter::Resize(std::uint32_t width, std::uint32_t height) {
  if (width == extent_.width && height == extent_.height) return;
  ReleaseTarget();
  extent_ = {width, height};
  colors_ = MakeImage(Format(), painting_.layers, Usage());
  views_.clear();
  for (std::uint32_t k = 0; k < painting_.layers; ++k) {
    views_.push_back(MakeView(colors_.image, VK_IMAGE_VIEW_TYPE_2D, Format(),
                              {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, k, 1}));
  }
  if (reader_) layers_ = MakeView(colors_.image, VK_IMAGE_VIEW_TYPE_2D_ARRAY, Format(), kWhole);
  if (!KeepsDepths()) return;
  depths_ = MakeImage(kDepthFormat, 1,
                      VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT | VK_IMAGE_USAGE_SAMPLED_BIT);
  depth_view_ = MakeView(depths_.image, VK_IMAGE_VIEW_TYPE_2D, kDepthFormat, kAllDepths);
}

void VulkanPainter::Upload(std::span<const float> vertices, std::span<const std::int32_t> indices) {
  Grow(vertices_, std::max<std::size_t>(vertices.size_bytes(), 64),
       VK_BUFFER_USAGE_VERTEX_BUFFER_BIT);
  Grow(indices_, std::max<std::size_t>(indices.size_bytes(), 64), VK_BUFFER_USAGE_INDEX_BUFFER_BIT);
  if (!vertices.empty()) std::memcpy(vertices_.mapped, vertices.data(), vertices.size_bytes());
  if (!indices.empty()) std::memcpy(indices_.mapped, indices.data(), indices.size_bytes());
}

VkRenderingAttachmentInfo VulkanPainter::Attachment(VkImageView view) const {
  VkRenderingAttachmentInfo info{};
  info.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO;
  info.imageView = view;
  info.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
  info.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  return info;
}

void VulkanPainter::Record(std::uint32_t indices, const PassKinds& constants) {
  VkCommandBufferBeginInfo begin{};
  begin.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO;
  Require(vkBeginCommandBuffer(commands_, &begin), "no commands");
  Transition(commands_, colors_.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL);
  std::vector<VkRenderingAttachmentInfo> colors;
  for (VkImageView view : views_) colors.push_back(Attachment(view));
  VkRenderingInfo rendering{};
  rendering.sType = VK_STRUCTURE_TYPE_RENDERING_INFO;
  rendering.renderArea = {{0, 0}, extent_};
  rendering.layerCount = 1;
  rendering.colorAttachmentCount = painting_.layers;
  rendering.pColorAttachments = colors.data();
  const VkRenderingAttachmentInfo depths = Attachment(depth_view_);
  if (KeepsDepths()) {
    Transition(commands_, depths_.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL,
               kAllDepths);
    rendering.pDepthAttachment = &depths;
  }
  vkCmdBeginRendering(commands_, &rendering);
  vkCmdBindPipeline(commands_, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_);
  vkCmdSetScissor(commands_, 0, 1, &rendering.renderArea);
  vkCmdPushConstants(commands_, layout_, VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(constants),
                     constants.data());
  const VkDeviceSize offset = 0;
  vkCmdBindVertexBuffers(commands_, 0, 1, &vertices_.buffer, &offset);
  vkCmdBindIndexBuffer(commands_, indices_.buffer, 0, VK_INDEX_TYPE_UINT32);
  vkCmdDrawIndexed(commands_, indices, 1, 0, 0, 0);
  vkCmdEndRendering(commands_);
  RecordReading();
  Require(vkEndCommandBuffer(commands_), "no commands");
}

void VulkanPainter::RecordReading() {
  if (reader_) {
    Transition(commands_, colors_.image, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL);
    if (KeepsDepths()) {
      Transition(commands_, depths_.image, VK_IMAGE_LAYOUT_GENERAL, VK_IMAGE_LAYOUT_GENERAL,
                 kAllDepths);
    }
    reader_->Record(commands_, layers_, KeepsDepths() ? depth_view_ : views_[0], texels_.buffer,
                    {.width = static_cast<std::int32_t>(extent_.width),
                     .height = static_cast<std::int32_t>(extent_.height),
                     .samples = samples_,
                     .layers = static_cast<std::int32_t>(painting_.layers),
                     .components = static_cast<std::int32_t>(painting_.components),
                     .depths_in_layer = painting_.depths_in_layer});
    return;
  }
  Transition(commands_, colors_.image, VK_IMAGE_LAYOUT_GENERAL,
             VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  VkBufferImageCopy copy{};
  copy.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, painting_.layers};
  copy.imageExtent = {extent_.width, extent_.height, 1};
  vkCmdCopyImageToBuffer(commands_, colors_.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                         texels_.buffer, 1, &copy);
}

void VulkanPainter::Run() {
  VkSubmitInfo submit{};
  submit.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO;
  submit.commandBufferCount = 1;
  submit.pCommandBuffers = &commands_;
  Require(vkQueueSubmit(queue_, 1, &submit, fence_), "not submitted");
  Require(vkWaitForFences(device_, 1, &fence_, VK_TRUE, UINT64_MAX), "not done");
  Require(vkResetFences(device_, 1, &fence_), "no fence");
}

const float* VulkanPainter::Paint(std::int32_t width, std::int32_t height,
                                  std::span<const float> vertices,
                                  std::span<const std::int32_t> indices,
                                  const PassKinds& constants) {
  Resize(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(height));
  Upload(vertices, indices);
  const std::size_t texels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height) *
                             static_cast<std::size_t>(samples_) * painting_.layers;
  Grow(texels_, texels * painting_.components * sizeof(float),
       VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT);
  Record(static_cast<std::uint32_t>(indices.size()), constants);
  Run();
  return static_cast<const float*>(texels_.mapped);
}

VulkanPainter::~VulkanPainter() {
  vkDeviceWaitIdle(device_);
  reader_.reset();
  for (VulkanBuffer* buffer : {&vertices_, &indices_, &texels_}) Release(*buffer);
  ReleaseTarget();
  vkDestroyFence(device_, fence_, nullptr);
  vkDestroyCommandPool(device_, pool_, nullptr);
  vkDestroyPipeline(device_, pipeline_, nullptr);
  vkDestroyPipelineLayout(device_, layout_, nullptr);
  vkDestroyDevice(device_, nullptr);
  vkDestroyInstance(instance_, nullptr);
}

}  // namespace rasterproof::subjects
