// pixman: triangles added to a one-bit mask, one at a time.
#include <pixman.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "kit/bitmap_plugin.h"

namespace {

using rasterproof::kit::Corner;
using rasterproof::kit::Corners;

// pixman's coordinates are 16.16: this conversion is the snap of the profile.
constexpr double kOne = 65536;
constexpr double kLeast = -32768;
constexpr double kGreatest = 32767;

pixman_point_fixed_t Fixed(const Corner& c) {
  return {static_cast<pixman_fixed_t>(std::llrint(c.x * kOne)),
          static_cast<pixman_fixed_t>(std::llrint(c.y * kOne))};
}

class PixmanBitmap {
 public:
  bool Resize(int width, int height) {
    if (width > kGreatest || height > kGreatest) return false;
    if (image_ != nullptr && width == width_ && height == height_) return true;
    width_ = width;
    height_ = height;
    words_ = (static_cast<std::size_t>(width) + 31) / 32;
    bits_.assign(words_ * static_cast<std::size_t>(height), 0);
    image_.reset(pixman_image_create_bits(PIXMAN_a1, width, height, bits_.data(),
                                          static_cast<int>(words_ * 4)));
    return image_ != nullptr;
  }
  void Clear() { bits_.assign(bits_.size(), 0); }
  bool Fill(const Corners& corners) {
    if (!rasterproof::kit::AllWithin(corners, kLeast, kGreatest)) return false;
    const pixman_triangle_t triangle{Fixed(corners[0]), Fixed(corners[1]), Fixed(corners[2])};
    pixman_add_triangles(image_.get(), 0, 0, 1, &triangle);
    return true;
  }
  bool Covered(int x, int y) const {
    const auto column = static_cast<std::size_t>(x);
    return (bits_[static_cast<std::size_t>(y) * words_ + column / 32] >> (column % 32) & 1U) != 0;
  }

 private:
  struct Unreference {
    void operator()(pixman_image_t* image) const { pixman_image_unref(image); }
  };
  int width_ = 0;
  int height_ = 0;
  std::size_t words_ = 0;  ///< of 32 pixels, a row
  std::vector<std::uint32_t> bits_;
  std::unique_ptr<pixman_image_t, Unreference> image_;
};

// Nothing in its interface says which samples belong to a triangle; that triangles which share an
// edge tile is what the X Render extension, whose implementation it is, states of them.
constexpr const char* kProfile = R"({"name": "pixman", "subpixel_bits": 16,
  "snap_rule": "nearest-even", "contract": "watertight", "coordinate_limit": 32767})";

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = rasterproof::kit::DescribeBitmap<PixmanBitmap>(
      "pixman", "pixman_add_triangles into a1", kProfile, RASTERPROOF_FLOAT64);
  return &plugin;
}
