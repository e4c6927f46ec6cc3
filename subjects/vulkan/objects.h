// What the parts of the Vulkan subject make alike.
#ifndef RASTERPROOF_SUBJECTS_VULKAN_OBJECTS_H_
#define RASTERPROOF_SUBJECTS_VULKAN_OBJECTS_H_

#include <vulkan/vulkan.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>

namespace rasterproof::subjects {

inline void Require(VkResult result, const char* what) {
  if (result != VK_SUCCESS) throw std::runtime_error(what);
}

template <std::size_t n>
VkShaderModule Module(VkDevice device, const std::uint32_t (&words)[n]) {
  VkShaderModuleCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO;
  info.codeSize = sizeof(words);
  info.pCode = words;
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
