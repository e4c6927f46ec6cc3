#include "props/judging/freedom/visible_edge.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "core/elementary.h"

namespace rasterproof::props {
namespace {

using exact::Rational;

struct ExactPart {
  Rational x;
  Rational y;
  Rational dx;
  Rational dy;
};

// `a` lies in front of the eye; b may lie behind it. The point of the edge with w = 0 is then
// a |w_b| + b w_a, and the ray goes from a's place towards it.
ExactPart PartOf(const Vertex& a, const Vertex& b) {
  const Rational x = Rational(a.x) / a.w;
  const Rational y = Rational(a.y) / a.w;
  if (b.w > 0) return {x, y, Rational(b.x) / b.w - x, Rational(b.y) / b.w - y};
  const auto at_the_eye = [&](double of_a, double of_b) {
    return Rational(of_a) * -b.w + Rational(of_b) * a.w;
  };
  return {x, y, at_the_eye(a.x, b.x), at_the_eye(a.y, b.y)};
}

// Of a ray the direction alone matters: its larger component becomes 1.
Point2 RoundedDirection(const ExactPart& part) {
  const Rational size = std::max(part.dx.Abs(), part.dy.Abs());
  if (size.Sign() == 0) return {0, 0};
  return {(part.dx / size).ToDouble(), (part.dy / size).ToDouble()};
}

}  // namespace

VisibleEdge::VisibleEdge(const Vertex& a, const Vertex& b) : a_(a), b_(b) {
  if (!(a_.w > 0)) std::swap(a_, b_);
  seen_ = a_.w > 0;
  if (!seen_) return;
  is_ray_ = !(b_.w > 0);
  if (a_.w == 1 && b_.w == 1) {
    start_ = {a_.x, a_.y};
    along_ = {b_.x - a_.x, b_.y - a_.y};
    return;
  }
  const ExactPart part = PartOf(a_, b_);
  start_ = {part.x.ToDouble(), part.y.ToDouble()};
  along_ = is_ray_ ? RoundedDirection(part) : Point2{part.dx.ToDouble(), part.dy.ToDouble()};
}

double VisibleEdge::Distance(Point2 p) const {
  if (!seen_) return std::numeric_limits<double>::infinity();
  const Point2 to{p.x - start_.x, p.y - start_.y};
  const double square = along_.x * along_.x + along_.y * along_.y;
  if (!std::isfinite(square)) return 0;  // doubles can't tell
  const double share = (to.x * along_.x + to.y * along_.y) / square;
  double part = share > 0 ? share : 0.0;
  if (!is_ray_) part = std::min(part, 1.0);
  const double distance = Hypot(to.x - part * along_.x, to.y - part * along_.y);
  return std::isnan(distance) ? 0 : distance;
}

std::optional<Rational> VisibleEdge::SquaredDistance(Point2 p) const {
  if (!seen_) return std::nullopt;
  const ExactPart part = PartOf(a_, b_);
  const Rational x = Rational(p.x) - part.x;
  const Rational y = Rational(p.y) - part.y;
  const Rational along = x * part.dx + y * part.dy;
  const Rational square = part.dx * part.dx + part.dy * part.dy;
  if (along.Sign() <= 0) return x * x + y * y;
  if (!is_ray_ && along >= square) {
    const Rational beyond_x = x - part.dx;
    const Rational beyond_y = y - part.dy;
    return beyond_x * beyond_x + beyond_y * beyond_y;
  }
  const Rational across = x * part.dy - y * part.dx;
  return across * across / square;
}

int NearestEdge(const std::array<Vertex, 3>& v, Point2 p) {
  int nearest = -1;
  std::optional<Rational> least;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto square = VisibleEdge(v[(i + 1) % 3], v[(i + 2) % 3]).SquaredDistance(p);
    if (!square || (least && *square >= *least)) continue;
    least = square;
    nearest = static_cast<int>(i);
  }
  return nearest;
}

}  // namespace rasterproof::props
