// A part of an image, its pixels as squares, with the scene's edges over it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "report/palette.h"
#include "report/picture.h"
#include "report/view_geometry.h"

namespace rasterproof::report {
namespace {

constexpr int kLeastForEdges = 4;
constexpr int kLeastForBorders = 8;
constexpr int kLeastForCentres = 16;

class EnlargedImage {
 public:
  EnlargedImage(const io::Image& image, PixelRect view, int scale)
      : view_(view),
        scale_(scale),
        drawn_((view.x1 - view.x0) * scale, (view.y1 - view.y0) * scale) {
    for (int y = 0; y < drawn_.height; ++y) {
      for (int x = 0; x < drawn_.width; ++x) drawn_.At(x, y) = ColourOf(image, x, y);
    }
  }

  void DrawSegment(Point2 a, Point2 b) {
    const auto part =
        ClipSegment(a, b, {double(view_.x0), double(view_.y0), double(view_.x1), double(view_.y1)});
    if (!part) return;
    const Point2 p = Place((*part)[0]);
    const Point2 q = Place((*part)[1]);
    const int steps = 2 * static_cast<int>(std::hypot(q.x - p.x, q.y - p.y)) + 1;
    for (int k = 0; k <= steps; ++k) {
      const double t = double(k) / steps;
      Dot({p.x + t * (q.x - p.x), p.y + t * (q.y - p.y)}, scale_ < 16 ? 1 : 2);
    }
  }

  void DrawCentres() {
    for (int y = view_.y0; y < view_.y1; ++y) {
      for (int x = view_.x0; x < view_.x1; ++x)
        Dot(Place({x + 0.5, y + 0.5}), std::max(2, scale_ / 8));
    }
  }

  const io::Image& drawn() const { return drawn_; }

 private:
  Colour ColourOf(const io::Image& image, int x, int y) const {
    const bool is_border = scale_ >= kLeastForBorders && (x % scale_ == 0 || y % scale_ == 0);
    if (is_border) return kGrid;
    return image.pixels[static_cast<std::size_t>(view_.y0 + y / scale_) *
                            static_cast<std::size_t>(image.width) +
                        static_cast<std::size_t>(view_.x0 + x / scale_)];
  }
  Point2 Place(Point2 p) const { return {(p.x - view_.x0) * scale_, (p.y - view_.y0) * scale_}; }
  // A square of ink around the place.
  void Dot(Point2 p, int side) {
    const int x0 = static_cast<int>(std::floor(p.x - (side - 1) / 2.0));
    const int y0 = static_cast<int>(std::floor(p.y - (side - 1) / 2.0));
    for (int y = std::max(y0, 0); y < std::min(y0 + side, drawn_.height); ++y) {
      for (int x = std::max(x0, 0); x < std::min(x0 + side, drawn_.width); ++x)
        drawn_.At(x, y) = kInk;
    }
  }

  PixelRect view_;
  int scale_;
  io::Image drawn_;
};

}  // namespace

io::Image Enlarged(const io::Image& image, const Scene& scene, PixelRect view, int scale,
                   YAxis y_axis) {
  EnlargedImage canvas(image, view, scale);
  if (scale >= kLeastForCentres) canvas.DrawCentres();
  if (scale < kLeastForEdges) return canvas.drawn();
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    auto corners = WindowCorners(scene, static_cast<int>(t));
    if (!corners) continue;
    for (Point2& p : *corners) p.y = y_axis == YAxis::kUp ? scene.height - p.y : p.y;
    for (std::size_t k = 0; k < 3; ++k) canvas.DrawSegment((*corners)[k], (*corners)[(k + 1) % 3]);
  }
  return canvas.drawn();
}

}  // namespace rasterproof::report
