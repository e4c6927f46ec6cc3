// cairo: a path of one triangle, filled without antialiasing.
#include <cairo.h>

#include <cstddef>
#include <cstring>
#include <memory>

#include "kit/bitmap_plugin.h"

namespace {

using rasterproof::kit::Corner;
using rasterproof::kit::Corners;

// Beyond this its own 24.8 coordinates overflow.
constexpr double kLimit = 8388607;
constexpr int kMaxSide = 32767;

class CairoBitmap {
 public:
  bool Resize(int width, int height) {
    if (width > kMaxSide || height > kMaxSide) return false;
    if (context_ != nullptr && width == width_ && height == height_) return true;
    width_ = width;
    height_ = height;
    surface_.reset(cairo_image_surface_create(CAIRO_FORMAT_A8, width, height));
    context_.reset(cairo_create(surface_.get()));
    cairo_set_antialias(context_.get(), CAIRO_ANTIALIAS_NONE);
    cairo_set_source_rgba(context_.get(), 1, 1, 1, 1);
    data_ = cairo_image_surface_get_data(surface_.get());
    stride_ = static_cast<std::size_t>(cairo_image_surface_get_stride(surface_.get()));
    return cairo_status(context_.get()) == CAIRO_STATUS_SUCCESS;
  }
  void Clear() {
    cairo_surface_flush(surface_.get());
    std::memset(data_, 0, stride_ * static_cast<std::size_t>(height_));
    cairo_surface_mark_dirty(surface_.get());
  }
  bool Fill(const Corners& corners) {
    if (!rasterproof::kit::AllWithin(corners, -kLimit, kLimit)) return false;
    cairo_new_path(context_.get());
    for (const Corner& c : corners) cairo_line_to(context_.get(), c.x, c.y);
    cairo_close_path(context_.get());
    cairo_fill(context_.get());
    cairo_surface_flush(surface_.get());
    return cairo_status(context_.get()) == CAIRO_STATUS_SUCCESS;
  }
  bool Covered(int x, int y) const {
    return data_[static_cast<std::size_t>(y) * stride_ + static_cast<std::size_t>(x)] != 0;
  }

 private:
  struct DestroySurface {
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
  };
  struct DestroyContext {
    void operator()(cairo_t* context) const { cairo_destroy(context); }
  };
  int width_ = 0;
  int height_ = 0;
  std::unique_ptr<cairo_surface_t, DestroySurface> surface_;
  std::unique_ptr<cairo_t, DestroyContext> context_;
  unsigned char* data_ = nullptr;
  std::size_t stride_ = 0;
};

// The documentation of CAIRO_ANTIALIAS_NONE states a bilevel mask and no more.
constexpr const char* kProfile = R"({"name": "cairo", "subpixel_bits": 8,
  "snap_rule": "nearest-even", "contract": "none", "coordinate_limit": 8388607})";

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = rasterproof::kit::DescribeBitmap<CairoBitmap>(
      "cairo", "cairo_fill, CAIRO_ANTIALIAS_NONE, A8 image surface", kProfile, RASTERPROOF_FLOAT64);
  return &plugin;
}
