// Vulkan as a plugin. The build makes one of each driver: see subjects/real.cmake.
#include <exception>
#include <memory>
#include <string>
#include <string_view>

#include "kit/rasterproof_plugin.h"
#include "subjects/vulkan/counter.h"
#include "subjects/vulkan/interpolator.h"

namespace {

using rasterproof::subjects::VulkanCounter;
using rasterproof::subjects::VulkanInterpolator;

constexpr rasterproof::subjects::VulkanDriver kDriver{
    RASTERPROOF_VULKAN_ICD, RASTERPROOF_VULKAN_DEVICE, RASTERPROOF_VULKAN_HALF_VIEWPORT,
    RASTERPROOF_VULKAN_SAMPLES};

int SubpixelBits() { return rasterproof::subjects::ReportedSubpixelBits(kDriver).value_or(4); }

#if defined(RASTERPROOF_VULKAN_SHOWS_VALUES)
// As in subjects/gl/gl.cc: Vulkan states no error either. lavapipe is llvmpipe.
using Drawer = VulkanInterpolator;
constexpr std::uint32_t kTakes = RASTERPROOF_TAKES_CLIP_SPACE | RASTERPROOF_TAKES_WANTS |
                                 RASTERPROOF_SHOWS_VALUES | RASTERPROOF_SHOWS_DERIVATIVES;
std::string States() {
  const bool is_llvmpipe = std::string_view(kDriver.device) == "llvmpipe";
  return (is_llvmpipe ? "" : R"("subpixel_bits": )" + std::to_string(SubpixelBits()) + ", ") +
         R"("sample_locations": "standard-)" + std::to_string(kDriver.samples) +
         R"(", "centroid": "inside", "contract": "none", "coordinate_limit": 1024,
            "values": {"weights": "perspective", "provoking": "first", "derivatives": "fine",
                       "flat": true, "linear": true, "inverse_w": true, "centres": true,
                       "centroids": true, "flushes": true})";
}
#else
using Drawer = VulkanCounter;
constexpr std::uint32_t kTakes = 0;
// All that Vulkan allows, with the subpixel bits that the device reports; the fewest where there is
// no device. Where several samples lie it reports too: one without standardSampleLocations is not
// opened.
constexpr const char* kSet = kDriver.samples == 1   ? "vulkan"
                             : kDriver.samples == 2 ? "vulkan-standard-2x"
                             : kDriver.samples == 4 ? "vulkan-standard-4x"
                                                    : "vulkan-standard-8x";
std::string States() {
  return R"("specification": ")" + std::string(kSet) + R"(", "subpixel_bits": )" +
         std::to_string(SubpixelBits()) + R"(, "coordinate_limit": )" +
         std::to_string(kDriver.half_viewport);
}
#endif

const std::string& Profile() {
  static const std::string profile =
      R"({"name": ")" RASTERPROOF_VULKAN_NAME R"(", )" + States() + "}";
  return profile;
}

void* Open() {
  try {
    return std::make_unique<Drawer>(kDriver).release();
  } catch (const std::exception&) {
    return nullptr;
  }
}

std::int32_t Draw(void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
  if (state == nullptr) return 1;
  try {
    return static_cast<Drawer*>(state)->Draw(*scene, *target);
  } catch (const std::exception&) {
    return 1;
  }
}

void Close(void* state) { delete static_cast<Drawer*>(state); }

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = [] {
    rasterproof_plugin described{};
    described.version = RASTERPROOF_PLUGIN_VERSION;
    described.size = sizeof(rasterproof_plugin);
    described.name = RASTERPROOF_VULKAN_NAME;
    described.summary = "Vulkan, " RASTERPROOF_VULKAN_NAME;
    described.profile = Profile().c_str();
    described.input = RASTERPROOF_FLOAT32;
    const bool shows_values = (kTakes & RASTERPROOF_SHOWS_VALUES) != 0;
    described.coverage = shows_values ? RASTERPROOF_FRAGMENTS : RASTERPROOF_FACING_COUNTS;
    described.takes = kTakes;
    described.draw = Draw;
    described.open = Open;
    described.close = Close;
    return described;
  }();
  return &plugin;
}
