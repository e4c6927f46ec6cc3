// Figures as pixels: each shape's share of a pixel is the distance of its border from the centre.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "report/figure.h"
#include "report/letters.h"

namespace rasterproof::report {
namespace {

class Canvas {
 public:
  Canvas(const Figure& figure, double scale)
      : scale_(scale),
        image_(static_cast<int>(std::ceil(figure.width * scale)),
               static_cast<int>(std::ceil(figure.height * scale)), kPaper) {}

  void Draw(const Shape& shape) {
    switch (shape.kind) {
      case ShapeKind::kPolygon:
        return DrawPolygon(shape);
      case ShapeKind::kLine:
        return DrawLine(shape);
      case ShapeKind::kDot:
        return DrawDot(shape);
      case ShapeKind::kText:
        return DrawText(shape);
    }
  }

  io::Image Take() { return std::move(image_); }

 private:
  Point2 Scaled(Point2 p) const { return {p.x * scale_, p.y * scale_}; }

  // Blends `colour` into the pixels near the points, each by share(centre) clamped to [0, 1].
  template <class Share>
  void Blend(const std::vector<Point2>& near, double margin, Colour colour, double opacity,
             const Share& share) {
    double x0 = std::numeric_limits<double>::infinity();
    double y0 = x0;
    double x1 = -x0;
    double y1 = -x0;
    for (const Point2 p : near) {
      x0 = std::min(x0, p.x - margin);
      y0 = std::min(y0, p.y - margin);
      x1 = std::max(x1, p.x + margin);
      y1 = std::max(y1, p.y + margin);
    }
    const auto within = [](double v, int side) {
      return static_cast<int>(std::clamp(v, 0.0, static_cast<double>(side)));
    };
    const int first = within(std::floor(x0), image_.width);
    const int last = within(std::ceil(x1), image_.width);
    for (int y = within(std::floor(y0), image_.height); y < within(std::ceil(y1), image_.height);
         ++y) {
      for (int x = first; x < last; ++x) {
        const double t = opacity * std::clamp(share(Point2{x + 0.5, y + 0.5}), 0.0, 1.0);
        if (t > 0) image_.At(x, y) = Mix(image_.At(x, y), colour, t);
      }
    }
  }

  void DrawPolygon(const Shape& shape) {
    std::vector<Point2> outline;
    double area = 0;
    for (const Point2 p : shape.points) outline.push_back(Scaled(p));
    const std::size_t n = outline.size();
    for (std::size_t k = 0; k < n; ++k) {
      const Point2 a = outline[k];
      const Point2 b = outline[(k + 1) % n];
      area += a.x * b.y - a.y * b.x;
    }
    const double turn = area < 0 ? -1 : 1;
    Blend(outline, 1, shape.colour, shape.opacity, [&](Point2 p) {
      double share = 1;
      for (std::size_t k = 0; k < n; ++k) {
        const Point2 a = outline[k];
        const Point2 b = outline[(k + 1) % n];
        const double length = std::hypot(b.x - a.x, b.y - a.y);
        if (length == 0) continue;
        const double side = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
        share = std::min(share, turn * side / length + 0.5);
      }
      return share;
    });
  }

  void DrawLine(const Shape& shape) {
    const Point2 a = Scaled(shape.points[0]);
    const Point2 b = Scaled(shape.points[1]);
    const Point2 d{b.x - a.x, b.y - a.y};
    const double length = std::hypot(d.x, d.y);
    if (length == 0) return;
    const double half = shape.size * scale_ / 2;
    Blend({a, b}, half + 1, shape.colour, shape.opacity, [&](Point2 p) {
      // Square ends, as SVG draws them.
      const double along = ((p.x - a.x) * d.x + (p.y - a.y) * d.y) / length;
      const double across = ((p.x - a.x) * d.y - (p.y - a.y) * d.x) / length;
      return std::min({half - std::fabs(across), along, length - along}) + 0.5;
    });
  }

  void DrawDot(const Shape& shape) {
    const Point2 centre = Scaled(shape.points[0]);
    const double radius = shape.size * scale_;
    Blend({centre}, radius + 1, shape.colour, shape.opacity,
          [&](Point2 p) { return radius + 0.5 - std::hypot(p.x - centre.x, p.y - centre.y); });
  }

  // A letter advances by 6 of its dots: a dot is a tenth of the text's size.
  void DrawText(const Shape& shape) {
    const Point2 baseline = Scaled(shape.points[0]);
    const double dot = shape.size * scale_ * kAdvance / (kLetterWidth + 1);
    double left = baseline.x;
    for (const char c : shape.text) {
      // Of a character outside ASCII only the first byte shows.
      if ((static_cast<unsigned char>(c) >> 6) == 2) continue;
      for (int row = 0; row < kLetterHeight; ++row) {
        for (int column = 0; column < kLetterWidth; ++column) {
          if (!IsInk(c, column, row)) continue;
          const Point2 at{left + column * dot, baseline.y + (row - kLetterAscent) * dot};
          const std::vector<Point2> square{at, {at.x + dot, at.y + dot}};
          // The share of the pixel that the square covers, so that dots side by side join.
          Blend(square, 0, shape.colour, shape.opacity, [&](Point2 p) {
            const double wide = std::min(p.x + 0.5, at.x + dot) - std::max(p.x - 0.5, at.x);
            const double high = std::min(p.y + 0.5, at.y + dot) - std::max(p.y - 0.5, at.y);
            return std::max(0.0, wide) * std::max(0.0, high);
          });
        }
      }
      left += (kLetterWidth + 1) * dot;
    }
  }

  double scale_;
  io::Image image_;
};

}  // namespace

io::Image FigureToImage(const Figure& figure, double scale) {
  Canvas canvas(figure, scale);
  for (const Shape& shape : figure.shapes) canvas.Draw(shape);
  return canvas.Take();
}

}  // namespace rasterproof::report
