// Statements C8, C9, C14, C15: what barycentrics interpolate.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "tests/statements/rational_plane.h"

namespace rasterproof::props {
namespace {

using std::nullopt;
using std::optional;

Rational Weighted(const Barycentrics3& l, const Barycentrics3& z) {
  return l[0] * z[0] + l[1] * z[1] + l[2] * z[2];
}

StatementTally DeltasEqualBarycentrics(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Barycentrics3 l = BarycentricsOf(draws.ProperTriangle(), draws.Point());
    const Barycentrics3 z{draws.Number(), draws.Number(), draws.Number()};
    return optional(Weighted(l, z) == z[0] + l[1] * (z[1] - z[0]) + l[2] * (z[2] - z[0]));
  });
}

// The depth at screen position p of the plane through three points in front of the eye, found from
// the plane itself: the point r (p.x, p.y, 1) of the ray that lies in it has depth r.
Rational DepthByPlane(const std::array<Vec3, 3>& v, const Vec2& p) {
  const Vec3 normal = Cross(v[1] - v[0], v[2] - v[0]);
  return Dot(normal, v[0]) / Dot(normal, Vec3{p.x, p.y, Rational(1)});
}

struct Seen {
  std::array<Vec3, 3> v;
  Triangle2 screen;
  Vec2 p;
  Barycentrics3 l;
};

// A triangle in front of the eye and a screen position inside it.
optional<Seen> DrawSeen(Draws& draws) {
  Seen seen{{draws.EyePoint(true), draws.EyePoint(true), draws.EyePoint(true)}, {}, {}, {}};
  if (draws.Coin()) {
    seen.v[1].z = seen.v[0].z;
    seen.v[2].z = seen.v[0].z;
  }
  for (std::size_t i = 0; i < 3; ++i) seen.screen[i] = Projected(seen.v[i]);
  if (Orient2d(seen.screen[0], seen.screen[1], seen.screen[2]).Sign() == 0) return nullopt;
  seen.p = draws.PointInside(seen.screen);
  seen.l = BarycentricsOf(seen.screen, seen.p);
  return seen;
}

StatementTally DepthIsAffineForEqualZOnly(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const optional<Seen> seen = DrawSeen(draws);
    if (!seen) return nullopt;
    const Barycentrics3 z{seen->v[0].z, seen->v[1].z, seen->v[2].z};
    const Rational depth = DepthByPlane(seen->v, seen->p);
    const Rational reciprocal =
        seen->l[0] / z[0] + seen->l[1] / z[1] + seen->l[2] / z[2];  // the correction: 1/z is affine
    const bool equal_z = z[0] == z[1] && z[1] == z[2];
    return depth * reciprocal == Rational(1) && (!equal_z || Weighted(seen->l, z) == depth);
  });
}

// Z = (1, 4, 1) in the middle of edge 01: 5/2 by barycentrics, 8/5 on the plane.
bool DepthIsNotAffine() {
  const std::array<Vec3, 3> v{Vec3{Rational(0), Rational(0), Rational(1)},
                              Vec3{Rational(16), Rational(0), Rational(4)},
                              Vec3{Rational(0), Rational(4), Rational(1)}};
  const Triangle2 screen{Projected(v[0]), Projected(v[1]), Projected(v[2])};
  const Vec2 middle = Rational(0.5) * (screen[0] + screen[1]);
  const Barycentrics3 l = BarycentricsOf(screen, middle);
  return Weighted(l, {Rational(1), Rational(4), Rational(1)}) == Rational(2.5) &&
         DepthByPlane(v, middle) == Rational(8) / Rational(5);
}

StatementTally BarycentricsReproduceAnyPoint(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.Point();
    return optional(Combined(BarycentricsOf(t, p), t) == p);
  });
}

StatementTally ScreenAffineAttributesAreInterpolated(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 slope = draws.Point();
    const Rational offset = draws.Number();
    const auto attribute = [&](const Vec2& at) { return Dot(slope, at) + offset; };
    const Vec2 p = draws.Point();
    return optional(Weighted(BarycentricsOf(t, p),
                             {attribute(t[0]), attribute(t[1]), attribute(t[2])}) == attribute(p));
  });
}

// A colour that runs from 0 to 1 along the edge of C9: its middle on screen is 1/5 of the way.
bool SurfaceColourIsNotAffineOnScreen() {
  // On the plane, the middle of the projected edge is v0 + s (v1 - v0) with depth 8/5 = 1 + 3 s.
  const Rational on_the_surface = (Rational(8) / Rational(5) - Rational(1)) / Rational(3);
  return on_the_surface == Rational(1) / Rational(5) && on_the_surface != Rational(0.5);
}

constexpr std::array kInterpolationStatements{
    Statement{"C8", "Z is Z0 + l1 (Z1 - Z0) + l2 (Z2 - Z0): two multiplications, two additions.",
              Truth::kTrue, "", "", DeltasEqualBarycentrics, nullptr},
    Statement{"C9", "The camera depth is the weighted sum of the vertices' camera depths.",
              Truth::kWrong, "equal depths; otherwise 1/Z is the weighted sum of 1/Z_i",
              "Z = (1, 4, 1), middle of edge 01: 5/2 for 8/5", DepthIsAffineForEqualZOnly,
              DepthIsNotAffine},
    Statement{"C14", "P is the weighted sum of the vertices.", Truth::kTrue, "", "",
              BarycentricsReproduceAnyPoint, nullptr},
    Statement{"C15", "Any attribute is the weighted sum of the vertices' attributes.",
              Truth::kConditional, "an attribute that is affine on the screen",
              "a colour along the edge of C9: 1/2 for 1/5", ScreenAffineAttributesAreInterpolated,
              SurfaceColourIsNotAffineOnScreen},
};

}  // namespace

std::span<const Statement> InterpolationStatements() { return kInterpolationStatements; }

}  // namespace rasterproof::props
