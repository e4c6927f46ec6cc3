#include "subjects/shaded/shaded.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kChannels = std::tuple_size_v<PassKinds>;

// A pass's texels, and where they belong.
struct Drawn {
  const rasterproof_scene& scene;
  const rasterproof_target& target;
  const float* texels;

  std::size_t Columns() const {
    return static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(target.samples);
  }
  std::size_t Pixels() const { return Columns() * static_cast<std::size_t>(scene.height); }
  std::size_t At(std::size_t n) const { return n / Columns() * target.stride + n % Columns(); }
  const float* Of(ShaderOutput output, std::size_t n) const {
    return texels + 4 * (output * Pixels() + n);
  }
};

void ReadPlaces(const Drawn& drawn) {
  const rasterproof_target& target = drawn.target;
  for (std::size_t n = 0; n < drawn.Pixels(); ++n) {
    const std::size_t at = drawn.At(n);
    const float* const place = drawn.Of(kPlace, n);
    target.primitive_ids[at] = static_cast<std::int32_t>(*drawn.Of(kTriangle, n)) - 1;
    if (target.barycentrics != nullptr) std::copy_n(place, 3, target.barycentrics + 3 * at);
    if (target.depths != nullptr) target.depths[at] = double{place[3]};
  }
}

void ReadValues(const Drawn& drawn, std::size_t first) {
  const rasterproof_target& target = drawn.target;
  const std::size_t channels = drawn.scene.channel_count;
  const std::size_t count = std::min(kChannels, channels - first);
  const auto read = [&](ShaderOutput output, double* into, std::size_t entries) {
    for (std::size_t n = 0; n < drawn.Pixels(); ++n) {
      for (std::size_t c = 0; c < count; ++c)
        into[entries * (channels * drawn.At(n) + first + c)] = double{drawn.Of(output, n)[c]};
    }
  };
  if (target.values != nullptr) read(kValue, target.values, 1);
  if (target.derivatives == nullptr) return;
  read(kByX, target.derivatives, 2);
  read(kByY, target.derivatives + 1, 2);
}

PassKinds AddChannels(const rasterproof_scene& scene, std::size_t first,
                      std::vector<float>& corners) {
  const std::size_t count = std::min(kChannels, scene.channel_count - first);
  PassKinds kinds{};
  for (std::size_t c = 0; c < count; ++c) {
    const rasterproof_channel& channel = scene.channels[first + c];
    kinds[c] = channel.interpolation + 4 * channel.at;
    if (channel.values == nullptr) continue;
    for (std::size_t k = 0; k < 3 * scene.triangle_count; ++k)
      corners[kCornerFloats * k + 4 + c] = static_cast<float>(channel.values[scene.triangles[k]]);
  }
  return kinds;
}

}  // namespace

bool AddClipPlace(const double* vertex, double half_viewport, std::vector<float>& clip) {
  for (std::size_t k = 0; k < 2; ++k) {
    const double scaled = vertex[k];
    // A NaN passes: what becomes of it is the driver's to say. What would be clipped does not.
    if (std::fabs(scaled) > half_viewport * vertex[3]) return false;
    clip.push_back(static_cast<float>(scaled / half_viewport));
    if (!std::isnan(scaled) && double{clip.back()} * half_viewport != scaled) return false;
  }
  return true;
}

std::int32_t DrawInPasses(const rasterproof_scene& scene, const rasterproof_target& target,
                          double half_viewport, int samples, std::vector<float>& corners,
                          const std::function<const float*(const PassKinds&)>& paint) {
  if (target.samples != samples) return 1;
  // The samples of a row may be read side by side, in a texture as wide as the viewport.
  if (scene.width > half_viewport || scene.height > half_viewport ||
      scene.width * samples > 2 * half_viewport) {
    return 1;
  }
  corners.clear();
  for (std::size_t k = 0; k < 3 * scene.triangle_count; ++k) {
    const double* const vertex = scene.vertices + 4 * scene.triangles[k];
    if (!AddClipPlace(vertex, half_viewport, corners)) return 1;
    corners.insert(corners.end(), {static_cast<float>(vertex[2]), static_cast<float>(vertex[3])});
    corners.resize(kCornerFloats * (k + 1));
  }
  const bool wants = target.values != nullptr || target.derivatives != nullptr;
  for (std::size_t first = 0; first == 0 || (wants && first < scene.channel_count);
       first += kChannels) {
    const PassKinds kinds = AddChannels(scene, first, corners);
    const Drawn drawn{scene, target, paint(kinds)};
    if (first == 0) ReadPlaces(drawn);
    ReadValues(drawn, first);
  }
  return 0;
}

}  // namespace rasterproof::subjects
