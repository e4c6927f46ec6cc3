// Occlusion culling with a bit a pixel: draw what hides, then ask which boxes may be seen.
//
// The wall is a hard mesh: slanted slivers a tenth of a pixel wide, and sides that cut through
// pixels. Three ways to draw it, each with its mistake or without:
// - float32 edge functions at pixels' centres, each triangle by itself, leave cracks, so that boxes
//   behind the wall are drawn for nothing;
// - exact coverage of centres leaves none, but a pixel whose centre is covered may be open at its
//   sides: boxes that peek out beside the wall are culled, and pop;
// - inner coverage sets the pixels that the wall as a whole covers to their last point, whatever
//   its inner edges: no box is culled that can be seen.
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "library/rasterize.h"

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr float kWallLeft = 320.25F, kWallWidth = 1280.5F, kWallTop = 180.375F;
constexpr float kWallBottom = 899.625F, kLean = 40;   // its foot is further to the right
constexpr float kBox = 4;                             // pixels a side
constexpr float kBoxLeft = 0.375F, kBoxTop = 0.125F;  // of the first

struct Mesh {
  std::vector<float> positions;
  std::vector<std::uint32_t> indices;
};

// Slivers from the wall's upper side to its lower one.
Mesh Wall(int slivers) {
  Mesh mesh;
  for (int i = 0; i <= slivers; ++i) {
    const float part = static_cast<float>(i) / static_cast<float>(slivers);
    const float foot = part + 0.03125F * part * (1 - part);
    mesh.positions.insert(mesh.positions.end(), {kWallLeft + kWallWidth * part, kWallTop, 0});
    mesh.positions.insert(mesh.positions.end(),
                          {kWallLeft + kLean + kWallWidth * foot, kWallBottom, 0});
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

// A box's rectangle. All boxes lie behind the wall.
struct Box {
  float left, top;

  float right() const { return left + kBox; }
  float bottom() const { return top + kBox; }
};

// Whether every pixel that the box meets is set: of its rectangle, the whole pixels around it.
bool IsHidden(const Mask& mask, const Box& box) {
  for (int y = static_cast<int>(box.top); static_cast<float>(y) < box.bottom(); ++y) {
    for (int x = static_cast<int>(box.left); static_cast<float>(x) < box.right(); ++x) {
      if (!mask.IsSet(x, y)) return false;
    }
  }
  return true;
}

// Whether the box lies behind the wall as a whole: doubles hold these products exactly.
bool IsBehindTheWall(const Box& box) {
  if (box.top < kWallTop || box.bottom() > kWallBottom) return false;
  const auto height = double{kWallBottom} - double{kWallTop};
  // How far a corner lies right of the line from (x, top) to (x + lean, bottom), times height.
  const auto beyond = [&](float x, float y, float from) {
    return (double{x} - from) * height - (double{y} - kWallTop) * kLean;
  };
  return beyond(box.left, box.bottom(), kWallLeft) >= 0 &&
         beyond(box.right(), box.top, kWallLeft + kWallWidth) <= 0;
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
    for (int y = static_cast<int>(kWallTop); y < static_cast<int>(kWallBottom) + 1; ++y) {
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

struct Tally {
  int behind = 0;  // the wall as a whole
  int culled = 0;
  int culled_and_seen = 0;
};
Tally Cull(const char* name, const Mask& mask) {
  Tally tally;
  for (Box box{kBoxLeft, kBoxTop}; box.bottom() <= kHeight; box.top += kBox) {
    for (box.left = kBoxLeft; box.right() <= kWidth; box.left += kBox) {
      const bool is_behind = IsBehindTheWall(box), is_hidden = IsHidden(mask, box);
      tally.behind += is_behind;
      tally.culled += is_hidden;
      tally.culled_and_seen += is_hidden && !is_behind;
    }
  }
  std::printf("%-8s culls %d of %d boxes behind the wall, and %d that can be seen\n", name,
              tally.culled - tally.culled_and_seen, tally.behind, tally.culled_and_seen);
  return tally;
}

Mask Drawn(const Mesh& mesh, rasterproof::RasterOutput output) {
  Mask mask;
  rasterproof::Rasterize({.positions = mesh.positions, .indices = mesh.indices},
                         {.output = output,
                          .width = kWidth,
                          .height = kHeight,
                          .pitch = Mask::kPitch,
                          .memory = mask.bits});
  return mask;
}

int main() {
  const Mesh wall = Wall(12800);
  Mask rounded;
  DrawInFloat32(wall, rounded);
  Cull("float32", rounded);
  Cull("centres", Drawn(wall, rasterproof::RasterOutput::kMask));
  const Tally inner = Cull("inner", Drawn(wall, rasterproof::RasterOutput::kInnerMask));
  return inner.culled > 0 && inner.culled_and_seen == 0 ? 0 : 1;
}
