// What each kernel draws, pixel for pixel: plain loops over float32 and integers, for tests.
#ifndef RASTERPROOF_TESTS_LIBRARY_KERNEL_DEFINITIONS_H_
#define RASTERPROOF_TESTS_LIBRARY_KERNEL_DEFINITIONS_H_

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
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

struct Box {
  int x0 = 0, x1 = 0, y0 = 0, y1 = 0;
  bool IsEmpty() const { return x0 >= x1 || y0 >= y1; }
  bool IsSmall() const { return x1 - x0 <= 8 && y1 - y0 <= 8; }
};

inline int FirstCentreFrom(float v, int size) {
  return static_cast<int>(std::clamp(std::ceil(v - 0.5F), 0.0F, static_cast<float>(size)));
}
inline int FirstCentreBeyond(float v, int size) {
  return static_cast<int>(std::clamp(std::floor(v - 0.5F) + 1.0F, 0.0F, static_cast<float>(size)));
}
inline float Centre(int pixel) { return static_cast<float>(pixel) + 0.5F; }

inline float TwiceArea(const KernelTriangle& t) {
  return (t[2].x - t[0].x) * (t[1].y - t[0].y) - (t[2].y - t[0].y) * (t[1].x - t[0].x);
}
inline bool HasArea(float area) { return area != 0 && std::isfinite(area); }

/// Three edge functions of float32, positive inside.
struct FloatEdges {
  Box box;
  std::array<float, 3> vx{}, vy{}, a{}, b{}, least{};

  FloatEdges(const KernelTriangle& t, bool is_front, int width, int height) {
    const std::array<KernelVertex, 3> v = is_front ? t : KernelTriangle{t[0], t[2], t[1]};
    const auto [x_min, x_max] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [y_min, y_max] = std::minmax({v[0].y, v[1].y, v[2].y});
    box = {FirstCentreFrom(x_min, width), FirstCentreBeyond(x_max, width),
           FirstCentreFrom(y_min, height), FirstCentreBeyond(y_max, height)};
    for (std::size_t k = 0; k < 3; ++k) {
      const KernelVertex& next = v[(k + 1) % 3];
      vx[k] = v[k].x;
      vy[k] = v[k].y;
      a[k] = next.y - v[k].y;
      b[k] = v[k].x - next.x;
      const bool owns_ties = a[k] > 0 || (a[k] == 0 && b[k] > 0);
      least[k] = owns_ties ? 0 : std::numeric_limits<float>::min();
    }
  }
  float At(std::size_t k, int x, int y) const {
    return (Centre(x) - vx[k]) * a[k] + (Centre(y) - vy[k]) * b[k];
  }
};

inline bool AllReach(const std::array<float, 3>& e, const std::array<float, 3>& least) {
  return e[0] >= least[0] && e[1] >= least[1] && e[2] >= least[2];
}

inline void Incremental(const FloatEdges& edges, Covered& covered) {
  const Box& box = edges.box;
  std::array<float, 3> row{};
  for (std::size_t k = 0; k < 3; ++k) row[k] = edges.At(k, box.x0, box.y0);
  for (int y = box.y0; y < box.y1; ++y) {
    std::vector<bool> inside;
    for (int x = box.x0; x < box.x1; ++x) {
      const int column = x - box.x0;
      std::array<float, 3> e{};
      for (std::size_t k = 0; k < 3; ++k) {
        if (box.IsSmall()) {
          e[k] = row[k];
          for (int i = 0; i < column; ++i) e[k] += edges.a[k];
        } else {
          e[k] = row[k] + edges.a[k] * static_cast<float>(column % 32);
          for (int i = 0; i < column / 32; ++i) e[k] += edges.a[k] * 32.0F;
        }
      }
      inside.push_back(AllReach(e, edges.least));
    }
    // The row ends where 32 consecutive pixels are outside after some that are inside.
    bool was_inside = false;
    for (std::size_t from = 0; from < inside.size(); from += 32) {
      const std::size_t to = std::min(from + 32, inside.size());
      bool any = false;
      for (std::size_t i = from; i < to; ++i) {
        any |= inside[i];
        if (inside[i]) covered.pixels.emplace_back(box.x0 + static_cast<int>(i), y);
      }
      if (was_inside && !any) break;
      was_inside |= any;
    }
    for (std::size_t k = 0; k < 3; ++k) row[k] += edges.b[k];
  }
}

inline void FloatTile(const FloatEdges& edges, int x, int y, Covered& covered, bool& any) {
  const Box& box = edges.box;
  const int tx = box.x0 & ~7;
  const int ty = box.y0 & ~7;
  std::array<float, 3> t{}, reject{}, accept{};
  for (std::size_t k = 0; k < 3; ++k) {
    const float a = edges.a[k];
    const float b = edges.b[k];
    const float row = edges.At(k, tx, ty) + static_cast<float>(y - ty) * b;
    t[k] = row + static_cast<float>(x - tx) * a;
    reject[k] = edges.least[k] - (7 * std::max(a, 0.0F) + 7 * std::max(b, 0.0F));
    accept[k] = edges.least[k] - (7 * std::min(a, 0.0F) + 7 * std::min(b, 0.0F));
  }
  any = AllReach(t, reject);
  if (!any) return;
  const bool all = AllReach(t, accept);
  for (int j = y; j < y + 8; ++j) {
    for (int i = x; i < x + 8; ++i) {
      if (i < box.x0 || i >= box.x1 || j < box.y0 || j >= box.y1) continue;
      std::array<float, 3> e{};
      for (std::size_t k = 0; k < 3; ++k) {
        e[k] = t[k] +
               (static_cast<float>(i - x) * edges.a[k] + static_cast<float>(j - y) * edges.b[k]);
      }
      if (all || AllReach(e, edges.least)) covered.pixels.emplace_back(i, j);
    }
  }
}

inline void FloatTiles(const FloatEdges& edges, Covered& covered) {
  const Box& box = edges.box;
  if (!box.IsSmall()) {
    for (int y = box.y0 & ~7; y < box.y1; y += 8) {
      for (int x = box.x0 & ~7; x < box.x1; x += 8) {
        bool any = false;
        FloatTile(edges, x, y, covered, any);
      }
    }
    return;
  }
  for (int y = box.y0; y < box.y1; ++y) {
    for (int x = box.x0; x < box.x1; ++x) {
      std::array<float, 3> e{};
      for (std::size_t k = 0; k < 3; ++k) {
        e[k] = (edges.At(k, box.x0, box.y0) + edges.b[k] * static_cast<float>(y - box.y0)) +
               edges.a[k] * static_cast<float>(x - box.x0);
      }
      if (AllReach(e, edges.least)) covered.pixels.emplace_back(x, y);
    }
  }
}

inline void Scanline(KernelTriangle t, int width, int height, Covered& covered) {
  for (const std::size_t k : std::array<std::size_t, 3>{0, 1, 0}) {
    if (t[k + 1].y < t[k].y) std::swap(t[k], t[k + 1]);
  }
  const auto [x_min, x_max] = std::minmax({t[0].x, t[1].x, t[2].x});
  const int x0 = FirstCentreFrom(x_min, width);
  const int x1 = FirstCentreFrom(x_max, width);
  const int end = FirstCentreFrom(t[2].y, height);
  for (int row = FirstCentreFrom(t[0].y, height); row < end; ++row) {
    const float y = Centre(row);
    const auto crossing = [&](const KernelVertex& a, const KernelVertex& b) {
      const float k = std::ceil((a.x - 0.5F) + (y - a.y) * ((b.x - a.x) / (b.y - a.y)));
      return std::isnan(k)
                 ? x0
                 : static_cast<int>(std::clamp(k, static_cast<float>(x0), static_cast<float>(x1)));
    };
    const int one = crossing(t[0], t[2]);
    const int other = y < t[1].y ? crossing(t[0], t[1]) : crossing(t[1], t[2]);
    for (int x = std::min(one, other); x < std::max(one, other); ++x) {
      covered.pixels.emplace_back(x, row);
    }
  }
}

/// Coverage of the triangle snapped to 1/256 px, nearest-even; nothing beyond kFixedRange.
inline Covered Fixed(const KernelTriangle& t, int width, int height) {
  Covered covered;
  std::array<std::int64_t, 3> x{}, y{};
  for (std::size_t k = 0; k < 3; ++k) {
    if (!(std::abs(t[k].x) <= kFixedRange && std::abs(t[k].y) <= kFixedRange)) return covered;
    x[k] = std::llrint(static_cast<double>(t[k].x) * 256);
    y[k] = std::llrint(static_cast<double>(t[k].y) * 256);
  }
  const std::int64_t area = (x[2] - x[0]) * (y[1] - y[0]) - (y[2] - y[0]) * (x[1] - x[0]);
  if (area == 0) return covered;
  covered.is_front = area > 0;
  if (area < 0) {
    std::swap(x[1], x[2]);
    std::swap(y[1], y[2]);
  }
  for (int j = 0; j < height; ++j) {
    for (int i = 0; i < width; ++i) {
      bool inside = true;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t a = y[(k + 1) % 3] - y[k];
        const std::int64_t b = x[k] - x[(k + 1) % 3];
        const std::int64_t e = (256 * i + 128 - x[k]) * a + (256 * j + 128 - y[k]) * b;
        inside &= e > 0 || (e == 0 && (a > 0 || (a == 0 && b > 0)));
      }
      if (inside) covered.pixels.emplace_back(i, j);
    }
  }
  return covered;
}

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

/// What the method covers of a target by one triangle.
inline Covered Define(KernelMethod method, const KernelTriangle& t, int width, int height) {
  if (method == KernelMethod::kFixedTiles) return definitions::Fixed(t, width, height);
  if (method == KernelMethod::kExact) return definitions::Exact(t, width, height);
  Covered covered;
  const float area = definitions::TwiceArea(t);
  if (!definitions::HasArea(area)) return covered;
  covered.is_front = area > 0;
  const definitions::FloatEdges edges(t, covered.is_front, width, height);
  switch (method) {
    case KernelMethod::kIncremental:
      if (!edges.box.IsEmpty()) definitions::Incremental(edges, covered);
      break;
    case KernelMethod::kTiles:
      if (!edges.box.IsEmpty()) definitions::FloatTiles(edges, covered);
      break;
    case KernelMethod::kScanline:
    case KernelMethod::kMaskRows:
      definitions::Scanline(t, width, height, covered);
      break;
    case KernelMethod::kFixedTiles:
    case KernelMethod::kExact:
    case KernelMethod::kExactUnsafe:
      break;
  }
  return covered;
}

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

/// What Surface::At returns of every pixel, row by row.
inline std::vector<std::uint64_t> DefineSurface(KernelMethod method, Sink sink,
                                                const KernelScene& scene) {
  const std::uint32_t far = std::bit_cast<std::uint32_t>(std::numeric_limits<float>::infinity());
  const std::uint64_t clear = sink == Sink::kId      ? Surface::kNoTriangle
                              : sink == Sink::kDepth ? far
                                                     : 0;
  std::vector<std::uint64_t> pixels(
      static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height), clear);
  for (std::size_t i = 0; i + 2 < scene.indices.size(); i += 3) {
    const KernelTriangle t{scene.vertices[scene.indices[i]], scene.vertices[scene.indices[i + 1]],
                           scene.vertices[scene.indices[i + 2]]};
    const Covered covered = Define(method, t, scene.width, scene.height);
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

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_TESTS_LIBRARY_KERNEL_DEFINITIONS_H_
