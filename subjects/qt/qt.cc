// Qt 5: QPainter on a QImage, no antialiasing.
#include <QImage>
#include <QPainter>
#include <QPointF>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "kit/bitmap_plugin.h"

namespace {

using rasterproof::kit::Corners;

constexpr double kLimit = 0x1p30;
constexpr int kMaxSide = 32767;

class QtBitmap {
 public:
  bool Resize(int width, int height) {
    if (width > kMaxSide || height > kMaxSide) return false;
    if (painter_ != nullptr && width == width_ && height == height_) return true;
    painter_.reset();
    width_ = width;
    height_ = height;
    pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), 0);
    image_ = QImage(reinterpret_cast<unsigned char*>(pixels_.data()), width, height, 4 * width,
                    QImage::Format_ARGB32_Premultiplied);
    painter_ = std::make_unique<QPainter>(&image_);
    painter_->setRenderHint(QPainter::Antialiasing, false);
    painter_->setPen(Qt::NoPen);
    painter_->setBrush(Qt::white);
    return painter_->isActive();
  }
  void Clear() { pixels_.assign(pixels_.size(), 0); }
  bool Fill(const Corners& corners) {
    if (!rasterproof::kit::AllWithin(corners, -kLimit, kLimit)) return false;
    std::array<QPointF, 3> points;
    for (std::size_t k = 0; k < 3; ++k) points[k] = QPointF(corners[k].x, corners[k].y);
    painter_->drawConvexPolygon(points.data(), 3);
    return true;
  }
  bool Covered(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)] != 0;
  }

 private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint32_t> pixels_;
  QImage image_;
  std::unique_ptr<QPainter> painter_;
};

// QPainter's documentation describes which pixels a shape without antialiasing takes for integer
// coordinates only; nothing is stated of neighbours.
constexpr const char* kProfile = R"({"name": "qt5", "subpixel_bits": 6,
  "snap_rule": "floor", "contract": "none", "coordinate_limit": 32767})";

}  // namespace

const rasterproof_plugin* rasterproof_plugin_describe(void) {
  static const rasterproof_plugin plugin = rasterproof::kit::DescribeBitmap<QtBitmap>(
      "qt5", "QPainter::drawConvexPolygon on a QImage, no antialiasing", kProfile,
      RASTERPROOF_FLOAT64);
  return &plugin;
}
