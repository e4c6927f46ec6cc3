// Occlusion culling with a bit a pixel: draw what hides, then ask which boxes are seen.
//
// The wall is closed, and its mesh is a hard one: slanted slivers a tenth of a pixel wide. Exact
// coverage leaves no gap between them, so no box behind the wall is drawn for nothing. Float32 edge
// functions, each triangle by itself, leave cracks.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "kit/rasterize.h"

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr int kWallLeft = 320, kWallRight = 1600, kWallTop = 180, kWallBottom = 900;
constexpr int kBox = 4;  // pixels a side

struct Mesh {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
};

// Slivers from the wall's upper side to its lower one, leaning by up to 40 pixels.
Mesh Wall(int slivers) {
  Mesh mesh;
  for (int i = 0; i <= slivers; ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(slivers);
    const float width = kWallRight - kWallLeft;
    const float foot = part + 0.125F * part * (1 - part);
    mesh.positions.insert(mesh.positions.end(), {kWallLeft + width * part, kWallTop, 0});
    mesh.positions.insert(mesh.positions.end(), {kWallLeft + width * foot, kWallBottom, 0});
    if (i == slivers) break;
    const auto v = static_cast<std::uint32_t>(2 * i);
    mesh.indices.insert(mesh.indices.end(), {v, v + 1, v + 2, v + 1, v + 3, v + 2});
  }
  return mesh;
}

// One bit a pixel.
struct Mask {
  static constexpr std::size_t kPitch = kWidth / 8;
  std::vector<std::byte> bits = std::vector<std::byte>(kPitch * kHeight);

  bool IsSet(int x, int y) const {
    const std::byte eight =
        bits[static_cast<std::size_t>(y) * kPitch + static_cast<unsigned>(x) / 8];
    return (std::to_integer<int>(eight) >> (x % 8) & 1) != 0;
  }
  void Set(int x, int y) {
    bits[static_cast<std::size_t>(y) * kPitch + static_cast<unsigned>(x) / 8] |=
        static_cast<std::byte>(1 << (x % 8));
  }
};

// Whether any pixel of the box's rectangle is open. All boxes lie behind the wall.
bool IsSeen(const Mask& mask, int left, int top) {
  for (int y = top; y < top + kBox; ++y) {
    for (int x = left; x < left + kBox; ++x) {
      if (!mask.IsSet(x, y)) return true;
    }
  }
  return false;
}

// What many rasterizers do: float32 edge functions with the top-left rule, a triangle at a time.
void DrawInFloat32(const Mesh& mesh, Mask& mask) {
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const float* v[3];
    for (std::size_t k = 0; k < 3; ++k) v[k] = &mesh.positions[3 * mesh.indices[t + k]];
    float least = v[0][0], most = v[0][0];
    for (const float* p : v) {
      least = p[0] < least ? p[0] : least;
      most = p[0] > most ? p[0] : most;
    }
    for (int y = kWallTop; y < kWallBottom; ++y) {
      for (int x = static_cast<int>(least); x <= static_cast<int>(most); ++x) {
        const float px = static_cast<float>(x) + 0.5F, py = static_cast<float>(y) + 0.5F;
        bool inside = true;
        for (int k = 0; k < 3; ++k) {
          const float *a = v[k], *b = v[(k + 1) % 3];
          const float e = (px - a[0]) * (b[1] - a[1]) - (py - a[1]) * (b[0] - a[0]);
          inside &= e > 0 || (e == 0 && b[1] > a[1]);
        }
        if (inside) mask.Set(x, y);
      }
    }
  }
}

struct Seen {
  int in_all = 0;
  int behind_the_wall = 0;
};
Seen CountSeen(const Mask& mask) {
  Seen seen;
  for (int top = 0; top < kHeight; top += kBox) {
    for (int left = 0; left < kWidth; left += kBox) {
      if (!IsSeen(mask, left, top)) continue;
      ++seen.in_all;
      seen.behind_the_wall +=
          left >= kWallLeft && left < kWallRight && top >= kWallTop && top < kWallBottom;
    }
  }
  return seen;
}

int main() {
  const Mesh wall = Wall(12800);
  Mask exact;
  rasterproof::Rasterize({.positions = wall.positions, .indices = wall.indices},
                         {.output = rasterproof::RasterOutput::kMask,
                          .width = kWidth,
                          .height = kHeight,
                          .pitch = Mask::kPitch,
                          .memory = exact.bits});
  const Seen seen = CountSeen(exact);
  std::printf("wall: %zu slivers; boxes: %d\n", wall.indices.size() / 3,
              kWidth / kBox * (kHeight / kBox));
  std::printf("exact: %d boxes seen, %d of them through the wall\n", seen.in_all,
              seen.behind_the_wall);

  Mask rounded;
  DrawInFloat32(wall, rounded);
  const Seen leaked = CountSeen(rounded);
  std::printf("float32: %d boxes seen, %d of them through the wall\n", leaked.in_all,
              leaked.behind_the_wall);
  return seen.behind_the_wall == 0 ? 0 : 1;
}
