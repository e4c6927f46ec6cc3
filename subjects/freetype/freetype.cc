// FreeType's monochrome rasterizer: an outline of three points, without drop-out control.
#include <ft2build.h>

#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <array>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <vector>

#include "kit/bitmap_plugin.h"

namespace {

using rasterproof::kit::Corners;

// FreeType's coordinates are 26.6: this conversion is the snap of the profile.
constexpr double kOne = 64;
constexpr double kLimit = 262143;  // FT_Outline_Render refuses outlines beyond 0x1000000 / 64
constexpr int kMaxSide = 32767;

class FreetypeBitmap {
 public:
  FreetypeBitmap() {
    if (FT_Init_FreeType(&library_) != 0) throw std::runtime_error("FT_Init_FreeType failed");
  }
  ~FreetypeBitmap() { FT_Done_FreeType(library_); }
  FreetypeBitmap(const FreetypeBitmap&) = delete;
  FreetypeBitmap& operator=(const FreetypeBitmap&) = delete;

  bool Resize(int width, int height) {
    if (width > kMaxSide || height > kMaxSide) return false;
    stride_ = (static_cast<std::size_t>(width) + 7) / 8;
    bits_.assign(stride_ * static_cast<std::size_t>(height), 0);
    bitmap_ = {};
    bitmap_.rows = static_cast<unsigned>(height);
    bitmap_.width = static_cast<unsigned>(width);
    bitmap_.pitch = -static_cast<int>(stride_);  // the first row in memory is the one of least y
    bitmap_.buffer = bits_.data();
    bitmap_.num_grays = 2;
    bitmap_.pixel_mode = FT_PIXEL_MODE_MONO;
    return true;
  }
  void Clear() { bits_.assign(bits_.size(), 0); }
  bool Fill(const Corners& corners) {
    if (!rasterproof::kit::AllWithin(corners, -kLimit, kLimit)) return false;
    std::array<FT_Vector, 3> points{};
    for (std::size_t k = 0; k < 3; ++k) {
      points[k] = {std::lrint(corners[k].x * kOne), std::lrint(corners[k].y * kOne)};
    }
    std::array<char, 3> tags{FT_CURVE_TAG_ON, FT_CURVE_TAG_ON, FT_CURVE_TAG_ON};
    short last = 2;
    FT_Outline outline{};
    outline.n_contours = 1;
    outline.n_points = 3;
    outline.points = points.data();
    outline.tags = tags.data();
    outline.contours = &last;
    outline.flags = FT_OUTLINE_IGNORE_DROPOUTS | FT_OUTLINE_HIGH_PRECISION;
    return FT_Outline_Get_Bitmap(library_, &outline, &bitmap_) == 0;
  }
  bool Covered(int x, int y) const {
    const auto column = static_cast<std::size_t>(x);
    const unsigned byte = bits_[static_cast<std::size_t>(y) * stride_ + column / 8];
    return (byte >> (7 - column % 8) & 1U) != 0;
  }

 private:
  FT_Library library_ = nullptr;
  FT_Bitmap bitmap_{};
  std::size_t stride_ = 0;
  std::vector<unsigned char> bits_;
};

// TrueType's rule, which FT_RASTER_FLAG_DEFAULT follows, takes centres on any outline as inside:
// two outlines with a common edge share the samples on it.
constexpr const char* kProfile = R"({"name": "freetype-mono", "subpixel_bits": 6,
  "snap_rule": "nearest-even", "tie_rule": "inclusive", "contract": "none",
  "coordinate_limit": 32767})";

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = rasterproof::kit::DescribeBitmap<FreetypeBitmap>(
      "freetype-mono", "FT_Outline_Get_Bitmap, FT_PIXEL_MODE_MONO", kProfile, RASTERPROOF_FLOAT64);
  return &plugin;
}
