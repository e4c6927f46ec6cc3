// GD: gdImageFilledPolygon. Integer coordinates; pixel (i, j) has its sample at (i, j).
#include <gd.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <memory>

#include "kit/bitmap_plugin.h"

namespace {

using rasterproof::kit::Corners;

constexpr double kLimit = 0x1p30;
constexpr int kMaxSide = 32767;

class GdBitmap {
 public:
  bool Resize(int width, int height) {
    if (width > kMaxSide || height > kMaxSide) return false;
    if (image_ != nullptr && width == image_->sx && height == image_->sy) return true;
    image_.reset(gdImageCreate(width, height));
    if (image_ == nullptr) return false;
    clear_ = gdImageColorAllocate(image_.get(), 0, 0, 0);
    set_ = gdImageColorAllocate(image_.get(), 255, 255, 255);
    return true;
  }
  void Clear() {
    gdImageFilledRectangle(image_.get(), 0, 0, image_->sx - 1, image_->sy - 1, clear_);
  }
  // The conversion to whole pixels is the snap of the profile.
  bool Fill(const Corners& corners) {
    if (!rasterproof::kit::AllWithin(corners, -kLimit, kLimit)) return false;
    std::array<gdPoint, 3> points{};
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = {static_cast<int>(std::lrint(corners[k].x)),
                   static_cast<int>(std::lrint(corners[k].y))};
    }
    gdImageFilledPolygon(image_.get(), points.data(), 3, set_);
    return true;
  }
  bool Covered(int x, int y) const { return image_->pixels[y][x] == set_; }

 private:
  struct Destroy {
    void operator()(gdImage* image) const { gdImageDestroy(image); }
  };
  std::unique_ptr<gdImage, Destroy> image_;
  int clear_ = 0;
  int set_ = 0;
};

// Its manual says no more than "filled polygon"; the outline is drawn as well, so that neighbours
// overlap by design.
constexpr const char* kProfile = R"({"name": "gd", "subpixel_bits": 0,
  "snap_rule": "nearest-even", "tie_rule": "inclusive", "sample_locations": [[0, 0]],
  "contract": "none", "coordinate_limit": "0x1p30"})";

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = rasterproof::kit::DescribeBitmap<GdBitmap>(
      "gd", "gdImageFilledPolygon", kProfile, RASTERPROOF_FLOAT64);
  return &plugin;
}
