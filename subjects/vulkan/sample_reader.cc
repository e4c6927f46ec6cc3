#include "subjects/vulkan/sample_reader.h"

#include <array>
#include <cstdint>

#include "read_samples.comp.h"
#include "subjects/vulkan/objects.h"

namespace rasterproof::subjects {
namespace {

constexpr std::array kKinds{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER,
                            VK_DESCRIPTOR_TYPE_STORAGE_BUFFER,
                            VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER};
constexpr std::uint32_t kGroupSide = 8;  // as in the shader

}  // namespace

SampleReader::SampleReader(VkDevice device) : device_(device) {
  MakeLayouts();
  MakePipeline();
  MakeSet();
}

void SampleReader::MakeLayouts() {
  VkSamplerCreateInfo sampler{};
  sampler.sType = VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO;
  Require(vkCreateSampler(device_, &sampler, nullptr, &sampler_), "no sampler");
  std::array<VkDescriptorSetLayoutBinding, kKinds.size()> bindings{};
  for (std::uint32_t k = 0; k < bindings.size(); ++k) {
    bindings[k] = {k, kKinds[k], 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr};
  }
  VkDescriptorSetLayoutCreateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO;
  set.bindingCount = static_cast<std::uint32_t>(bindings.size());
  set.pBindings = bindings.data();
  Require(vkCreateDescriptorSetLayout(device_, &set, nullptr, &set_layout_), "no set layout");
  constexpr VkPushConstantRange kShape{VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(SampleShape)};
  VkPipelineLayoutCreateInfo layout{};
  layout.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO;
  layout.setLayoutCount = 1;
  layout.pSetLayouts = &set_layout_;
  layout.pushConstantRangeCount = 1;
  layout.pPushConstantRanges = &kShape;
  Require(vkCreatePipelineLayout(device_, &layout, nullptr, &layout_), "no pipeline layout");
}

void SampleReader::MakePipeline() {
  VkComputePipelineCreateInfo info{};
  info.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO;
  info.stage = Stage(VK_SHADER_STAGE_COMPUTE_BIT, Module(device_, kComputeShader));
  info.layout = layout_;
  Require(vkCreateComputePipelines(device_, VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_),
          "no compute pipeline");
  vkDestroyShaderModule(device_, info.stage.module, nullptr);
}

void SampleReader::MakeSet() {
  std::array<VkDescriptorPoolSize, kKinds.size()> sizes{};
  for (std::size_t k = 0; k < sizes.size(); ++k) sizes[k] = {kKinds[k], 1};
  VkDescriptorPoolCreateInfo pool{};
  pool.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO;
  pool.maxSets = 1;
  pool.poolSizeCount = static_cast<std::uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  Require(vkCreateDescriptorPool(device_, &pool, nullptr, &pool_), "no descriptor pool");
  VkDescriptorSetAllocateInfo set{};
  set.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO;
  set.descriptorPool = pool_;
  set.descriptorSetCount = 1;
  set.pSetLayouts = &set_layout_;
  Require(vkAllocateDescriptorSets(device_, &set, &set_), "no descriptor set");
}

void SampleReader::Record(VkCommandBuffer commands, VkImageView layers, VkImageView depths,
                          VkBuffer texels, const SampleShape& shape) {
  const VkDescriptorImageInfo image{sampler_, layers, VK_IMAGE_LAYOUT_GENERAL};
  const VkDescriptorImageInfo depth{sampler_, depths, VK_IMAGE_LAYOUT_GENERAL};
  const VkDescriptorBufferInfo buffer{texels, 0, VK_WHOLE_SIZE};
  std::array<VkWriteDescriptorSet, kKinds.size()> writes{};
  for (std::uint32_t k = 0; k < writes.size(); ++k) {
    writes[k].sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET;
    writes[k].dstSet = set_;
    writes[k].dstBinding = k;
    writes[k].descriptorCount = 1;
    writes[k].descriptorType = kKinds[k];
  }
  writes[0].pImageInfo = &image;
  writes[1].pBufferInfo = &buffer;
  writes[2].pImageInfo = &depth;
  vkUpdateDescriptorSets(device_, static_cast<std::uint32_t>(writes.size()), writes.data(), 0,
                         nullptr);
  vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_COMPUTE, pipeline_);
  vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_COMPUTE, layout_, 0, 1, &set_, 0,
                          nullptr);
  vkCmdPushConstants(commands, layout_, VK_SHADER_STAGE_COMPUTE_BIT, 0, sizeof(shape), &shape);
  const auto groups = [](std::int32_t side) {
    return (static_cast<std::uint32_t>(side) + kGroupSide - 1) / kGroupSide;
  };
  vkCmdDispatch(commands, groups(shape.width), groups(shape.height), 1);
}

SampleReader::~SampleReader() {
  vkDestroyDescriptorPool(device_, pool_, nullptr);
  vkDestroyPipeline(device_, pipeline_, nullptr);
  vkDestroyPipelineLayout(device_, layout_, nullptr);
  vkDestroyDescriptorSetLayout(device_, set_layout_, nullptr);
  vkDestroySampler(device_, sampler_, nullptr);
}

}  // namespace rasterproof::subjects
