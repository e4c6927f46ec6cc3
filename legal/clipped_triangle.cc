#include "legal/clipped_triangle.h"

#include <algorithm>
#include <cmath>

namespace rasterproof::legal {
namespace {

constexpr double kReachWithoutGrid = 1;

// The nearest places to the middle of the box that a vertex made on one of its sides can have.
WindowBox InnerOf(const WindowBox& box, const Snap& grid) {
  if (grid.IsNone()) {
    constexpr double kFar = kReachWithoutGrid;
    return {box.x0 + kFar, box.y0 + kFar, box.x1 - kFar, box.y1 - kFar};
  }
  const auto up = [&](double x) {
    return std::ldexp(std::ceil(std::ldexp(x, grid.bits)), -grid.bits);
  };
  return {up(box.x0), up(box.y0), -up(-box.x1), -up(-box.y1)};
}

}  // namespace

ClippedTriangle::ClippedTriangle(const std::array<Point2, 3>& corners,
                                 const std::array<bool, 3>& is_outside, const WindowBox& box,
                                 const Snap& grid)
    : corners_(corners),
      is_outside_(is_outside),
      leaves_{is_outside[0] || is_outside[1], is_outside[1] || is_outside[2],
              is_outside[2] || is_outside[0]},
      reach_(grid.IsNone() ? kReachWithoutGrid : std::ldexp(1.0, -grid.bits)),
      inner_(InnerOf(box, grid)) {}

// The edge moved by less than the reach on each axis sweeps a hexagon.
bool ClippedTriangle::IsBeside(std::size_t e, Point2 p) const {
  const Point2 a = corners_[e];
  const Point2 b = corners_[(e + 1) % 3];
  const auto [left, right] = std::minmax(a.x, b.x);
  const auto [top, bottom] = std::minmax(a.y, b.y);
  if (p.x < left - reach_ || p.x > right + reach_ || p.y < top - reach_ || p.y > bottom + reach_)
    return false;
  const Point2 d{b.x - a.x, b.y - a.y};
  const Point2 q{p.x - a.x, p.y - a.y};
  const double across = std::fabs(d.x) + std::fabs(d.y);
  const double away = std::fabs(q.x) + std::fabs(q.y);
  constexpr double kRounding = 0x1p-45;
  return std::fabs(q.x * d.y - q.y * d.x) <=
         reach_ * across + kRounding * (away + reach_) * (across + reach_);
}

bool ClippedTriangle::MayDecide(Point2 p) const {
  if (!IsClipped()) return false;
  const bool is_inner = p.x > inner_.x0 && p.x < inner_.x1 && p.y > inner_.y0 && p.y < inner_.y1;
  if (!is_inner) return true;
  for (std::size_t e = 0; e < 3; ++e) {
    if (leaves_[e] && IsBeside(e, p)) return true;
  }
  return false;
}

bool ClippedTriangle::Keeps(std::size_t e, Point2 p) const {
  if (IsBeside(e, p)) return false;
  const std::size_t next = (e + 1) % 3;
  if (is_outside_[e] == is_outside_[next]) return true;
  // Behind the end that is inside, the line of a short new edge can go anywhere.
  const Point2 inside = corners_[is_outside_[e] ? next : e];
  const Point2 outside = corners_[is_outside_[e] ? e : next];
  return (p.x - inside.x) * (outside.x - inside.x) + (p.y - inside.y) * (outside.y - inside.y) > 0;
}

}  // namespace rasterproof::legal
