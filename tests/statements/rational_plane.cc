#include "tests/statements/rational_plane.h"

namespace rasterproof::props {

Barycentrics3 BarycentricsOf(const Triangle2& t, const Vec2& p) {
  const Rational area = Edge(t[0], t[1], t[2]);
  return {Edge(t[1], t[2], p) / area, Edge(t[2], t[0], p) / area, Edge(t[0], t[1], p) / area};
}

Vec2 Combined(const Barycentrics3& l, const Triangle2& t) {
  return l[0] * t[0] + l[1] * t[1] + l[2] * t[2];
}

bool IsInside(const Triangle2& t, const Vec2& p) {
  const Barycentrics3 l = BarycentricsOf(t, p);
  return l[0].Sign() >= 0 && l[1].Sign() >= 0 && l[2].Sign() >= 0;
}

Rational SquaredDoubleArea(const Vec2& a, const Vec2& b, const Vec2& c) {
  // 16 T^2 = 4 r s - (r + s - q)^2 with r, s, q the squared sides.
  const Rational r = Dot(b - a, b - a);
  const Rational s = Dot(c - b, c - b);
  const Rational q = Dot(a - c, a - c);
  const Rational difference = r + s - q;
  return (Rational(4) * r * s - difference * difference) / Rational(4);
}

Rational SquaredDistance(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Rational edge = Edge(a, b, p);
  return edge * edge / Dot(b - a, b - a);
}

Rational Draws::Number() {
  if (Coin()) return Rational(static_cast<double>(bits_.Int(-4, 4)));
  return Rational(static_cast<double>(bits_.Int(-0x2000, 0x2000)) / 256.0);
}

Rational Draws::Part() { return Rational(static_cast<double>(bits_.Int(0, 8))) / Rational(8); }

Rational Draws::Positive() { return Rational(static_cast<double>(bits_.Int(1, 0x1000)) / 256.0); }

Triangle2 Draws::ProperTriangle() {
  Triangle2 t = AnyTriangle();
  while (Orient2d(t[0], t[1], t[2]).Sign() == 0) t = AnyTriangle();
  return t;
}

Vec2 Draws::PointInside(const Triangle2& t) {
  const Rational along = Part();
  const Rational across = Part();
  return t[0] + along * ((t[1] - t[0]) + across * (t[2] - t[1]));
}

Vec3 Draws::EyePoint(bool in_front) {
  const Rational z = Positive();
  return {Number(), Number(), !in_front && Coin() ? -z : z};
}

StatementTally Over(std::uint64_t seed, int count,
                    const std::function<std::optional<bool>(Draws&)>& trial) {
  StatementTally tally;
  for (int i = 0; i < count; ++i) {
    Draws draws(seed, static_cast<std::uint64_t>(i));
    const std::optional<bool> held = trial(draws);
    ++tally.drawn;
    if (!held) continue;
    ++tally.met;
    if (*held) ++tally.held;
  }
  return tally;
}

}  // namespace rasterproof::props
