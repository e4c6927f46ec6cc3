// Vulkan as a plugin. The build makes one of each driver: see subjects/real.cmake.
#include <exception>
#include <memory>
#include <string>

#include "kit/rasterproof_plugin.h"
#include "subjects/vulkan/counter.h"

namespace {

using rasterproof::subjects::VulkanCounter;

constexpr rasterproof::subjects::VulkanDriver kDriver{
    RASTERPROOF_VULKAN_ICD, RASTERPROOF_VULKAN_DEVICE, RASTERPROOF_VULKAN_HALF_VIEWPORT,
    RASTERPROOF_VULKAN_SAMPLES};

// All that Vulkan allows, with the subpixel bits that the device reports; the fewest where there is
// no device. Where several samples lie it reports too: one without standardSampleLocations is not
// opened.
constexpr const char* kSet = kDriver.samples == 1   ? "vulkan"
                             : kDriver.samples == 2 ? "vulkan-standard-2x"
                             : kDriver.samples == 4 ? "vulkan-standard-4x"
                                                    : "vulkan-standard-8x";
const std::string& Profile() {
  static const std::string profile =
      R"({"name": ")" RASTERPROOF_VULKAN_NAME R"(", "specification": ")" + std::string(kSet) +
      R"(", "subpixel_bits": )" +
      std::to_string(rasterproof::subjects::ReportedSubpixelBits(kDriver).value_or(4)) +
      R"(, "coordinate_limit": )" + std::to_string(kDriver.half_viewport) + "}";
  return profile;
}

void* Open() {
  try {
    return std::make_unique<VulkanCounter>(kDriver).release();
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::int32_t Draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  if (state == nullptr) return 1;
  try {
    return static_cast<VulkanCounter*>(state)->Draw(*scene, *target);
  } catch (const std::exception&) {
    return 1;
  }
}

void Close(void* state) { delete static_cast<VulkanCounter*>(state); }

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = [] {
    rasterproof_plugin described{};
    described.version = RASTERPROOF_PLUGIN_VERSION;
    described.size = sizeof(rasterproof_plugin);
    described.name = RASTERPROOF_VULKAN_NAME;
    described.summary = "Vulkan, additive blending, " RASTERPROOF_VULKAN_NAME;
    described.profile = Profile().c_str();
    described.input = RASTERPROOF_FLOAT32;
    described.coverage = RASTERPROOF_FACING_COUNTS;
    described.draw = Draw;
    described.open = Open;
    described.close = Close;
    return described;
  }();
  return &plugin;
}
