// Vulkan as a plugin.
#include <exception>
#include <memory>

#include "kit/rasterproof_plugin.h"
#include "subjects/vulkan/counter.h"

namespace {

using rasterproof::subjects::VulkanCounter;

// Vulkan leaves the rounding to subpixels and ties free; of two polygons on either side of a common
// edge with identical endpoints exactly one covers a sample on it (Vulkan 1.3,
// Basic Polygon Rasterization).
constexpr const char* kProfile = R"({"name": "vulkan", "subpixel_bits": 8,
  "snap_rule": "nearest-even", "contract": "watertight", "coordinate_limit": 8192})";

void* Open() {
  try {
    return std::make_unique<VulkanCounter>().release();
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
  static const rasterproof_plugin plugin{.version = RASTERPROOF_PLUGIN_VERSION,
                                         .size = sizeof(rasterproof_plugin),
                                         .name = "vulkan-lavapipe",
                                         .summary = "Vulkan on the processor, additive blending",
                                         .profile = kProfile,
                                         .input = RASTERPROOF_FLOAT32,
                                         .coverage = RASTERPROOF_FACING_COUNTS,
                                         .takes = 0,
                                         .draw = Draw,
                                         .open = Open,
                                         .reset = nullptr,
                                         .close = Close};
  return &plugin;
}
