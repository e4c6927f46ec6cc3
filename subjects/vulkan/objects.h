// What the parts of the Vulkan subject make alike.
#ifndef RASTERPROOF_SUBJECTS_VULKAN_OBJECTS_H_
#define RASTERPROOF_SUBJECTS_VULKAN_OBJECTS_H_

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <stdexcept>

namespace rasterproof::subjects {

inline void Require(VkResult result, const char* what) {
  if (result != VK_SUCCESS) throw std::runtime_error(what);
}

inline VkShaderModule Module(VkDevice device, std::span<const std::uint32_t> words) {
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = words.size_bytes();
  info.pCode = words.data();
  VkShaderModule module = VK_NULL_HANDLE;
  Require(vkCreateShaderModule(device, &info, nullptr, &module), "no shader module");
  return module;
}

inline VkPipelineShaderStageCreateInfo Stage(VkShaderStageFlagBits stage, VkShaderModule module) {
  VkPipelineShaderStageCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
  info.stage = stage;
  info.module = module;
  info.pName = "main";
  return info;
}

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_VULKAN_OBJECTS_H_
