#include "core/target_size.h"

#include <cstdint>

#include "core/sample_pattern.h"
#include "core/scene.h"

namespace rasterproof {

bool IsTargetSize(int width, int height, int samples) {
  return width >= 1 && height >= 1 && width <= kMaxTargetSide && height <= kMaxTargetSide &&
         samples >= 1 && samples <= kMaxSamplesPerPixel &&
         std::int64_t{width} * height * samples <= kMaxTargetSamples;
}

std::optional<InputError> TargetSizeError(const std::string& place, int width, int height,
                                          int samples) {
  if (IsTargetSize(width, height, samples)) return std::nullopt;
  return InputError(place,
                    "a target of " + std::to_string(width) + " x " + std::to_string(height) +
                        " pixels of " + std::to_string(samples) + " samples is out of range",
                    "give sides of 1 to " + std::to_string(kMaxTargetSide) + ", 1 to " +
                        std::to_string(kMaxSamplesPerPixel) + " samples a pixel and at most " +
                        std::to_string(kMaxTargetSamples) + " samples in all");
}

void RequireTargetSize(const std::string& place, int width, int height, int samples) {
  if (const auto error = TargetSizeError(place, width, height, samples)) throw InputError(*error);
}

}  // namespace rasterproof
