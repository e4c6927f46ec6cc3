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
      box_(box),
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
  // Each product carries three roundings and the difference one: 4u away across, to first order.
  // The right-hand side rounds by less than 4u of itself. 8u in all.
  constexpr double kRounding = 0x1p-50;
  return std::fabs(q.x * d.y - q.y * d.x) <=
         reach_ * across + kRounding * (away + reach_) * (across + reach_);
}

bool ClippedTriangle::MayDecide(Point2 p) const {
  if (!IsClipped()) return false;
  if (!IsInner(p)) return true;
  for (std::size_t e = 0; e < 3; ++e) {
    if (leaves_[e] && IsBeside(e, p)) return true;
  }
  return false;
}

// The triangle and a square of `by` on each axis around each of its points are apart from p if one
// of these separates them: an axis, or the direction of an edge.
bool ClippedTriangle::IsFarFrom(Point2 p, double moved) const {
  const double by = reach_ + moved;
  const auto [left, right] = std::minmax({corners_[0].x, corners_[1].x, corners_[2].x});
  const auto [top, bottom] = std::minmax({corners_[0].y, corners_[1].y, corners_[2].y});
  if (p.x < left - by || p.x > right + by || p.y < top - by || p.y > bottom + by) return true;
  for (std::size_t e = 0; e < 3; ++e) {
    const Point2 a = corners_[e];
    const Point2 b = corners_[(e + 1) % 3];
    const Point2 c = corners_[(e + 2) % 3];
    const Point2 d{b.x - a.x, b.y - a.y};
    const Point2 q{p.x - a.x, p.y - a.y};
    const Point2 r{c.x - a.x, c.y - a.y};
    const double across = std::fabs(d.x) + std::fabs(d.y);
    const double away = std::max(std::fabs(q.x) + std::fabs(q.y), std::fabs(r.x) + std::fabs(r.y));
    // As in IsBeside(), of both values.
    constexpr double kRounding = 0x1p-49;
    const double margin = by * across + kRounding * (away + by) * (across + by);
    const double of_p = q.x * d.y - q.y * d.x;
    const double of_c = r.x * d.y - r.y * d.x;
    if (of_p > std::max(0.0, of_c) + margin || of_p < std::min(0.0, of_c) - margin) return true;
  }
  return false;
}

bool ClippedTriangle::Keeps(std::size_t e, Point2 p) const {
  if (IsBeside(e, p)) return false;
  const std::size_t next = (e + 1) % 3;
  if (is_outside_[e] == is_outside_[next]) return true;
  // Beyond the end that is inside, the line of a short new edge can go anywhere.
  const Point2 inside = corners_[is_outside_[e] ? next : e];
  const Point2 outside = corners_[is_outside_[e] ? e : next];
  return (p.x - inside.x) * (outside.x - inside.x) + (p.y - inside.y) * (outside.y - inside.y) > 0;
}

std::optional<std::size_t> ClippedTriangle::OnlyMovedEdge(Point2 p) const {
  if (!IsInner(p)) return std::nullopt;
  std::optional<std::size_t> only;
  for (std::size_t e = 0; e < 3; ++e) {
    if (!leaves_[e] || Keeps(e, p)) continue;
    if (only || !IsBeside(e, p)) return std::nullopt;
    only = e;
  }
  const auto stretch = only ? StraightStretchOf(*only) : std::nullopt;
  if (!stretch) return std::nullopt;
  const double at = stretch->along_y ? p.y : p.x;
  const double first = stretch->along_y ? stretch->first[0].y : stretch->first[0].x;
  const double last = stretch->along_y ? stretch->last[0].y : stretch->last[0].x;
  return first < at && at < last ? only : std::nullopt;
}

// With t along the longer axis and u across: u(t) is the edge. The ends of its remaining part lie
// within the reach of the given ends, or of where it crosses the box or lies beyond.
std::optional<StraightStretch> ClippedTriangle::StraightStretchOf(std::size_t e) const {
  Point2 a = corners_[e];
  Point2 b = corners_[(e + 1) % 3];
  StraightStretch stretch;
  stretch.along_y = std::fabs(b.y - a.y) > std::fabs(b.x - a.x);
  const auto turned = [&](Point2 p) { return stretch.along_y ? Point2{p.y, p.x} : p; };
  const WindowBox box = stretch.along_y ? WindowBox{box_.y0, box_.x0, box_.y1, box_.x1} : box_;
  a = turned(a);
  b = turned(b);
  stretch.rises = a.x < b.x;
  if (!stretch.rises) std::swap(a, b);
  if (!(a.x < b.x)) return std::nullopt;
  const double slope = (b.y - a.y) / (b.x - a.x);
  double first = std::max(a.x, box.x0);
  double last = std::min(b.x, box.x1);
  if (slope != 0) {
    const auto [enters, exits] =
        std::minmax({a.x + (box.y0 - a.y) / slope, a.x + (box.y1 - a.y) / slope});
    first = std::max(first, enters);
    last = std::min(last, exits);
  } else if (a.y < box.y0 || a.y > box.y1) {
    return std::nullopt;
  }
  const double largest =
      std::max({std::fabs(a.x), std::fabs(a.y), std::fabs(b.x), std::fabs(b.y), 1.0});
  // With u = 2^-53: the slope carries three roundings, a crossing two more of at most twice
  // `largest`, its sums with the corner and the margin one each of at most three times that: 16u.
  // Below, slope (t - a.x) carries five of twice `largest`, its sums with a.y and `off` one each of
  // at most twice that, and `off` five of its own 2 reach_ <= 2 largest: 24u. 32u in all.
  constexpr double kRounding = 0x1p-48;
  first += 2 * reach_ + kRounding * largest;
  last -= 2 * reach_ + kRounding * largest;
  if (!(first < last)) return std::nullopt;
  const double off = reach_ * (1 + std::fabs(slope)) + kRounding * largest;
  const auto pair_at = [&](double t) {
    const double u = a.y + slope * (t - a.x);
    return std::array{turned({t, u - off}), turned({t, u + off})};
  };
  stretch.first = pair_at(first);
  stretch.last = pair_at(last);
  return stretch;
}

}  // namespace rasterproof::legal
