// What the exact kernel draws, pixel for pixel, and what a sink keeps of it, for tests.
#ifndef RASTERPROOF_TESTS_LIBRARY_KERNEL_DEFINITIONS_H_
#define RASTERPROOF_TESTS_LIBRARY_KERNEL_DEFINITIONS_H_

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "library/kernels/kernel.h"
#include "tests/library/drawn_scenes.h"

namespace rasterproof::library::kernels {

/// What one triangle covers of a target.
struct Covered {
  bool is_front = false;
  std::vector<std::pair<int, int>> pixels;  ///< x, y
};

namespace definitions {

inline float Centre(int pixel) { return static_cast<float>(pixel) + 0.5F; }

/// Coverage of the exact triangle, by the oracle.
inline Covered Exact(const KernelTriangle& t, int width, int height) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  for (const KernelVertex& v : t) scene.vertices.push_back({v.x, v.y, 0, 1});
  scene.triangles = {{0, 1, 2}};
  Covered covered;
  const CoverageCounts counts = exact::Coverage(scene, Profile{});
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::size_t k = counts.Index(x, y, 0);
      if (counts.front[k] + counts.back[k] == 0) continue;
      covered.is_front = counts.front[k] != 0;
      covered.pixels.emplace_back(x, y);
    }
  }
  return covered;
}

}  // namespace definitions

/// z at a pixel centre: see Sink::kDepth.
inline float DefineDepth(const KernelTriangle& t, int x, int y) {
  const float ux = t[1].x - t[0].x, uy = t[1].y - t[0].y, uz = t[1].z - t[0].z;
  const float vx = t[2].x - t[0].x, vy = t[2].y - t[0].y, vz = t[2].z - t[0].z;
  const float det = ux * vy - vx * uy;
  const float zx = (uz * vy - vz * uy) / det;
  const float zy = (vz * ux - uz * vx) / det;
  const float zc = (t[0].z - zx * t[0].x) - zy * t[0].y;
  const float least = std::min({t[0].z, t[1].z, t[2].z});
  const float most = std::max({t[0].z, t[1].z, t[2].z});
  for (const KernelVertex& vertex : t) {
    if (!std::isfinite(vertex.z)) return std::numeric_limits<float>::infinity();
  }
  for (const float coefficient : {zc, zx, zy}) {
    if (!(std::fabs(coefficient) < 0x1p100F)) return least + 0.0F;  // of -0, too, 0
  }
  const float z = (zc + zy * definitions::Centre(y)) + zx * definitions::Centre(x);
  return std::clamp(z, least, most) + 0.0F;
}

/// What Surface::At returns of every pixel, row by row. define(triangle) is its Covered.
template <class DefineTriangle>
std::vector<std::uint64_t> DefineSurface(Sink sink, const KernelScene& scene,
                                         const DefineTriangle& define) {
  const std::uint32_t far = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
  const std::uint64_t clear = sink == Sink::kId      ? Surface::kNoTriangle
                              : sink == Sink::kDepth ? far
                                                     : 0;
  std::vector<std::uint64_t> pixels(
      static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height), clear);
  for (std::size_t i = 0; i + 2 < scene.indices.size(); i += 3) {
    const KernelTriangle t{scene.vertices[scene.indices[i]], scene.vertices[scene.indices[i + 1]],
                           scene.vertices[scene.indices[i + 2]]};
    const Covered covered = define(t);
    for (const auto& [x, y] : covered.pixels) {
      std::uint64_t& pixel = pixels[static_cast<std::size_t>(y * scene.width + x)];
      switch (sink) {
        case Sink::kCount8:
          pixel = std::min<std::uint64_t>(pixel + 1, 255);
          break;
        case Sink::kFacing:
          pixel += covered.is_front ? 1 : std::uint64_t{1} << 32;
          break;
        case Sink::kMask:
          pixel = 1;
          break;
        case Sink::kId:
          pixel = i / 3;
          break;
        case Sink::kDepth: {
          const float z = DefineDepth(t, x, y);
          if (z < std::bit_cast<float>(static_cast<std::uint32_t>(pixel))) {
            pixel = std::bit_cast<std::uint32_t>(z);
          }
          break;
        }
      }
    }
  }
  return pixels;
}

/// The first pixel that differs, in words; empty if none does.
inline std::string FirstDifference(const Surface& surface,
                                   const std::vector<std::uint64_t>& expected) {
  for (int y = 0; y < surface.height(); ++y) {
    for (int x = 0; x < surface.width(); ++x) {
      const std::uint64_t wanted = expected[static_cast<std::size_t>(y * surface.width() + x)];
      if (surface.At(x, y) == wanted) continue;
      return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " is " +
             std::to_string(surface.At(x, y)) + ", not " + std::to_string(wanted);
    }
  }
  return "";
}

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_TESTS_LIBRARY_KERNEL_DEFINITIONS_H_
