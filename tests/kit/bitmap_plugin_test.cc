// A plugin from a class that fills bitmaps: what it counts, and what it refuses.
#include "kit/bitmap_plugin.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace rasterproof::kit {
namespace {

// Covers the one pixel that the first corner lies in.
class FirstCorner {
 public:
  bool Resize(int width, int height) {
    width_ = width;
    pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), false);
    return width <= 8;
  }
  void Clear() { pixels_.assign(pixels_.size(), false); }
  bool Fill(const Corners& corners) {
    if (!AllWithin(corners, 0, 7)) return false;
    pixels_[Index(static_cast<int>(corners[0].x), static_cast<int>(corners[0].y))] = true;
    return true;
  }
  bool Covered(int x, int y) const { return pixels_[Index(x, y)]; }

 private:
  std::size_t Index(int x, int y) const { return static_cast<std::size_t>(y * width_ + x); }
  int width_ = 0;
  std::vector<bool> pixels_;
};

// Knows where its pixel lies, and counts how often it is read.
class Touching : public FirstCorner {
 public:
  bool Fill(const Corners& corners) {
    const int x = static_cast<int>(corners[0].x), y = static_cast<int>(corners[0].y);
    touched_ = {x - 1, y - 1, x + 1, y + 1};
    return FirstCorner::Fill(corners);
  }
  bool Covered(int x, int y) const {
    ++reads;
    return FirstCorner::Covered(x, y);
  }
  PixelBox Touched() const { return touched_; }

  static inline int reads = 0;

 private:
  PixelBox touched_;
};

class NeverThere : public FirstCorner {
 public:
  NeverThere() { throw std::runtime_error("no such library"); }
};

constexpr std::array<std::int32_t, 9> kTriangles{0, 1, 2, 0, 2, 1, 1, 2, 0};

struct Drawing {
  std::int32_t status = 0;
  std::array<std::uint32_t, 12> front{};  ///< 3 rows of 2 pixels and 2 counts beside them
};

template <class Bitmap>
Drawing Draw(double x, int width = 2) {
  const rasterproof_plugin plugin =
      DescribeBitmap<Bitmap>("name", "summary", "real", RASTERPROOF_FLOAT64);
  const std::array<double, 12> vertices{x, 2, 0, 1, 0, 0, 0, 1, 1, 1, 0, 1};
  rasterproof_scene scene{};
  scene.width = width;
  scene.height = 3;
  scene.vertices = vertices.data();
  scene.triangles = kTriangles.data();
  scene.vertex_count = 3;
  scene.triangle_count = 3;
  Drawing drawing;
  rasterproof_target target{};
  target.samples = 1;
  target.stride = 4;
  target.front = drawing.front.data();
  void* const state = plugin.open();
  drawing.status = plugin.draw(state, &scene, &target);
  plugin.close(state);
  return drawing;
}

TEST(BitmapPlugin, CountsEveryTriangleOnItsOwn) {
  const Drawing drawing = Draw<FirstCorner>(1);
  EXPECT_EQ(drawing.status, 0);
  // Two triangles begin with (1, 2), one with (0, 0). The counts beside the rows stay as they are.
  EXPECT_EQ(drawing.front, (std::array<std::uint32_t, 12>{1, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 0}));
}

TEST(BitmapPlugin, ReadsWhereTheBitmapWasTouchedAlone) {
  EXPECT_EQ(Draw<Touching>(1).front, Draw<FirstCorner>(1).front);
  // A box of 2 x 2 at (1, 2) twice, and what lies on the target of the one around (0, 0).
  EXPECT_EQ(Touching::reads, 2 * 4 + 1);
}

TEST(BitmapPlugin, RefusesWhatTheBitmapRefuses) {
  EXPECT_NE(Draw<FirstCorner>(8).status, 0);
  EXPECT_NE(Draw<FirstCorner>(std::numeric_limits<double>::quiet_NaN()).status, 0);
  EXPECT_NE(Draw<FirstCorner>(1, 9).status, 0);
}

TEST(BitmapPlugin, RefusesEverythingWithoutItsLibrary) { EXPECT_NE(Draw<NeverThere>(1).status, 0); }

}  // namespace
}  // namespace rasterproof::kit
