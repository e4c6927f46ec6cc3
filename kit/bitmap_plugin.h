// A plugin from a class that fills one triangle at a time into its own bitmap.
#ifndef RASTERPROOF_KIT_BITMAP_PLUGIN_H_
#define RASTERPROOF_KIT_BITMAP_PLUGIN_H_

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <memory>

#include "kit/rasterproof_plugin.h"

namespace rasterproof::kit {

/// Units:      pixels, x right, y down.
struct Corner {
  double x = 0;
  double y = 0;
};
using Corners = std::array<Corner, 3>;

/// The operations that a rasterizer must have.
///
/// Resize:     makes the bitmap that size; false: too large, the scene is refused.
/// Clear:      nothing is covered any more.
/// Fill:       draws a triangle; false: out of the rasterizer's range, the scene is refused.
/// Covered:    whether the pixel of column x and row y is set.
template <class T>
concept TriangleBitmap = requires(T bitmap, const Corners& corners, int n) {
  requires std::default_initializable<T>;
  { bitmap.Resize(n, n) } -> std::same_as<bool>;
  bitmap.Clear();
  { bitmap.Fill(corners) } -> std::same_as<bool>;
  { bitmap.Covered(n, n) } -> std::same_as<bool>;
};

/// Pixels [x0, x1) x [y0, y1).
struct PixelBox {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;
  int y1 = 0;
};

/// A bitmap that knows where it may be set: no pixel outside Touched() is, since Clear. A draw then
/// costs what its triangles cover, and not the target once for each triangle.
template <class T>
concept TouchedBitmap = TriangleBitmap<T> && requires(const T bitmap) {
  { bitmap.Touched() } -> std::same_as<PixelBox>;
};

/// Returns whether all coordinates are in [least, greatest]; false if any is a NaN.
inline bool AllWithin(const Corners& corners, double least, double greatest) {
  for (const Corner& c : corners) {
    if (!(c.x >= least && c.x <= greatest && c.y >= least && c.y <= greatest)) return false;
  }
  return true;
}

inline Corners CornersOf(const rasterproof_scene& scene, std::size_t triangle) {
  Corners corners;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto vertex = static_cast<std::size_t>(scene.triangles[3 * triangle + k]);
    corners[k] = {scene.vertices[4 * vertex], scene.vertices[4 * vertex + 1]};
  }
  return corners;
}

/// Draws every triangle of the scene into a clear bitmap and counts the pixels it covers.
///
/// Returns:    0, or 1 if the bitmap refused the scene.
template <TriangleBitmap Bitmap>
std::int32_t CountOneByOne(Bitmap& bitmap, const rasterproof_scene& scene,
                           const rasterproof_target& target) {
  if (!bitmap.Resize(scene.width, scene.height)) return 1;
  for (std::size_t t = 0; t < scene.triangle_count; ++t) {
    bitmap.Clear();
    if (!bitmap.Fill(CornersOf(scene, t))) return 1;
    PixelBox box{0, 0, scene.width, scene.height};
    if constexpr (TouchedBitmap<Bitmap>) {
      const PixelBox touched = bitmap.Touched();
      box = {std::max(0, touched.x0), std::max(0, touched.y0), std::min(box.x1, touched.x1),
             std::min(box.y1, touched.y1)};
    }
    for (int y = box.y0; y < box.y1; ++y) {
      std::uint32_t* const row = target.front + static_cast<std::size_t>(y) * target.stride;
      for (int x = box.x0; x < box.x1; ++x) row[x] += bitmap.Covered(x, y) ? 1U : 0U;
    }
  }
  return 0;
}

/// The description of a plugin whose state is a Bitmap and whose coverage is counts.
///
/// Domain:     the texts outlive the plugin. A constructor that throws makes every draw a refusal.
template <TriangleBitmap Bitmap>
rasterproof_plugin DescribeBitmap(const char* name, const char* summary, const char* profile,
                                  rasterproof_input input) {
  rasterproof_plugin plugin{};
  plugin.version = RASTERPROOF_PLUGIN_VERSION;
  plugin.size = sizeof(rasterproof_plugin);
  plugin.name = name;
  plugin.summary = summary;
  plugin.profile = profile;
  plugin.input = static_cast<std::uint32_t>(input);
  plugin.coverage = RASTERPROOF_COUNTS;
  plugin.open = []() -> void* {
    try {
      return std::make_unique<Bitmap>().release();
    } catch (const std::exception&) {
      return nullptr;
    }
  };
  plugin.draw = [](void* state, const rasterproof_scene* scene, const rasterproof_target* target) {
    return state == nullptr ? 1 : CountOneByOne(*static_cast<Bitmap*>(state), *scene, *target);
  };
  plugin.close = [](void* state) { delete static_cast<Bitmap*>(state); };
  return plugin;
}

}  // namespace rasterproof::kit

#endif  // RASTERPROOF_KIT_BITMAP_PLUGIN_H_
