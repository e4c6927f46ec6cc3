// Statements E1 to E12: projected edges, their normals, and edges without a division.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "exact/homogeneous.h"
#include "tests/statements/rational_plane.h"

namespace rasterproof::props {
namespace {

using std::nullopt;
using std::optional;

Vec3 Eye(double x, double y, double z) { return {Rational(x), Rational(y), Rational(z)}; }
Vec2 At(double x, double y) { return {Rational(x), Rational(y)}; }
Vec3 OnTheImage(const Vec2& p) { return {p.x, p.y, Rational(1)}; }

// The direction of the projected edge.
Vec2 ProjectedDirection(const Vec3& v0, const Vec3& v1) { return Projected(v1) - Projected(v0); }

// As printed: anchored at the unprojected V0.
Rational AsPrinted(const Vec3& v0, const Vec3& v1, const Vec2& p) {
  return Dot(p - Flat(v0), Rotated(ProjectedDirection(v0, v1)));
}
// Anchored at the projected V0: the edge function of the projected edge.
Rational Corrected(const Vec3& v0, const Vec3& v1, const Vec2& p) {
  return Dot(p - Projected(v0), Rotated(ProjectedDirection(v0, v1)));
}
Rational WithoutDivision(const Vec3& v0, const Vec3& v1, const Vec2& p) {
  return Dot(Cross(v0, v1), OnTheImage(p));
}

StatementTally PrintedFormNeedsAnAnchorThatIsProjected(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    Vec3 v0 = draws.EyePoint(false);
    if (draws.Coin()) v0.z = Rational(1);
    const Vec3 v1 = draws.EyePoint(false);
    const Vec2 p = draws.Point();
    const Rational through_origin = Dot(Flat(v0), Rotated(ProjectedDirection(v0, v1)));
    const Rational difference = AsPrinted(v0, v1, p) - Corrected(v0, v1, p);
    const bool right = v0.z == Rational(1) || through_origin.Sign() == 0;
    return optional(difference == (Rational(1) / v0.z - Rational(1)) * through_origin &&
                    right == (difference.Sign() == 0));
  });
}

// V0 = (1,0,2), V1 = (0,1,1), P = (1/2,1/2): +1/4 for -1/4.
bool PrintedFormHasTheWrongSign() {
  const Vec3 v0 = Eye(1, 0, 2);
  const Vec3 v1 = Eye(0, 1, 1);
  const Vec2 p = At(0.5, 0.5);
  return AsPrinted(v0, v1, p) == Rational(0.25) && Corrected(v0, v1, p) == Rational(-0.25);
}

StatementTally TripleProductIsTheScaledEdge(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec3 v0 = draws.EyePoint(false);
    const Vec3 v1 = draws.EyePoint(false);
    const Vec2 p = draws.Point();
    const Rational triple = WithoutDivision(v0, v1, p);
    // ... and the oracle's homogeneous value, taken from V1 to V0, is its negative.
    const auto vertex = [](const Vec3& v) {
      return Vertex{v.x.ToDouble(), v.y.ToDouble(), 0, v.z.ToDouble()};
    };
    const Rational oracle =
        exact::HomogeneousEdgeValue(vertex(v0), vertex(v1), {p.x.ToDouble(), p.y.ToDouble()});
    return optional(triple == v0.z * v1.z * Corrected(v0, v1, p) && oracle == -triple);
  });
}

StatementTally TripleProductInTwoDimensions(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec3 v0 = draws.EyePoint(false);
    const Vec3 v1 = draws.EyePoint(false);
    const Vec2 p = draws.Point();
    const Vec2 direction = v0.z * Flat(v1) - v1.z * Flat(v0);
    return optional(WithoutDivision(v0, v1, p) ==
                    Dot(p, Rotated(direction)) - Dot(Flat(v0), Rotated(Flat(v1))));
  });
}

StatementTally CrossProductIsTheNormal(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Vec3 v0 = draws.EyePoint(false);
    const Vec3 v1 = draws.EyePoint(false);
    const Rational scale = v0.z * v1.z;
    if (scale.Sign() <= 0) return nullopt;
    return Flat(Cross(v0, v1)) == scale * Rotated(ProjectedDirection(v0, v1));
  });
}

// V0 = (0,0,1), V1 = (1,0,-1): the cross product points up, the projected normal down.
bool CrossProductPointsTheOtherWayForMixedSigns() {
  const Vec3 v0 = Eye(0, 0, 1);
  const Vec3 v1 = Eye(1, 0, -1);
  return Flat(Cross(v0, v1)) == At(0, 1) && Rotated(ProjectedDirection(v0, v1)) == At(0, -1);
}

StatementTally ScalingKeepsTheSign(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Vec3 v0 = draws.EyePoint(false);
    const Vec3 v1 = draws.EyePoint(false);
    if ((v0.z * v1.z).Sign() <= 0) return nullopt;
    const Vec2 p = draws.Point();
    return WithoutDivision(v0, v1, p).Sign() == Corrected(v0, v1, p).Sign();
  });
}

bool ScalingFlipsTheSignForMixedSigns() {
  const Vec3 v0 = Eye(0, 0, 1);
  const Vec3 v1 = Eye(1, 0, -1);
  const Vec2 p = At(0, 1);
  return WithoutDivision(v0, v1, p).Sign() == 1 && Corrected(v0, v1, p).Sign() == -1;
}

StatementTally RotationIsCounterClockwiseWithYUp(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec2 u = draws.Point();
    const Vec2 r = Rotated(u);
    return optional(Dot(u, r).Sign() == 0 && Cross(u, r) == Dot(u, u) && Dot(r, r) == Dot(u, u));
  });
}

// With y down (0, 1) points down the page: turning right into down is clockwise.
bool RotationIsClockwiseWithYDown() { return Rotated(At(1, 0)) == At(0, 1); }

StatementTally RotationGivesTheInwardNormal(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.ProperTriangle();
    if (Orient2d(t[0], t[1], t[2]).Sign() < 0) return nullopt;  // counter-clockwise with y up
    return Dot(Rotated(t[1] - t[0]), t[2] - t[0]).Sign() > 0;
  });
}

bool RotationGivesTheOutwardNormalForTheOtherWinding() {
  return Dot(Rotated(At(0, 4) - At(0, 0)), At(4, 0) - At(0, 0)).Sign() < 0;
}

StatementTally ThirdComponentDoesNotMatter(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec3 v0 = draws.EyePoint(false);
    const Vec3 v1 = draws.EyePoint(false);
    const Vec2 p = draws.Point();
    const Vec2 normal = Rotated(ProjectedDirection(v0, v1));
    const Rational z_of_difference = v1.z / v1.z - v0.z / v0.z;
    const Vec3 offset{p.x - v0.x, p.y - v0.y, Rational(1) - v0.z};
    return optional(Dot(offset, Vec3{normal.x, normal.y, z_of_difference}) == AsPrinted(v0, v1, p));
  });
}

// The segment from the eye to V meets the plane z = 1 at V / z, if V is not before that plane.
bool MeetsTheImagePlane(const Vec3& v) {
  const Rational part = Rational(1) / v.z;
  return part.Sign() > 0 && part <= Rational(1);
}

StatementTally ProjectedEdgeLiesInTheTriangleWithTheEye(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Vec3 v0 = draws.EyePoint(true);
    const Vec3 v1 = draws.EyePoint(true);
    if (v0.z < Rational(1) || v1.z < Rational(1)) return nullopt;
    const Vec3 normal = Cross(v0, v1);
    return MeetsTheImagePlane(v0) && MeetsTheImagePlane(v1) && Dot(normal, v0).Sign() == 0 &&
           Dot(normal, v1).Sign() == 0 && Dot(normal, OnTheImage(Projected(v0))).Sign() == 0;
  });
}

bool ProjectedEndLiesOutsideForANearVertex() { return !MeetsTheImagePlane(Eye(0, 0, 0.5)); }

// Returns whether the ray r (p, 1), r > 0, meets the triangle, by the plane and the barycentrics of
// the point in it.
optional<bool> RayHits(const std::array<Vec3, 3>& v, const Vec2& p) {
  const Vec3 normal = Cross(v[1] - v[0], v[2] - v[0]);
  const Rational along = Dot(normal, OnTheImage(p));
  if (along.Sign() == 0) return nullopt;  // the ray runs along the plane
  const Rational r = Dot(normal, v[0]) / along;
  if (r.Sign() <= 0) return false;
  const Vec3 hit{r * p.x, r * p.y, r};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = v[i];
    const Vec3& b = v[(i + 1) % 3];
    if (Dot(normal, Cross(b - a, hit - a)).Sign() < 0) return false;
  }
  return true;
}

StatementTally SameSignsAsTheDeterminantMeanAHit(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const std::array<Vec3, 3> v{draws.EyePoint(false), draws.EyePoint(false),
                                draws.EyePoint(false)};
    const int determinant = Dot(Cross(v[0], v[1]), v[2]).Sign();
    const Vec2 p = draws.Point();
    const optional<bool> hits = RayHits(v, p);
    if (determinant == 0 || !hits) return nullopt;
    bool same = true;
    for (std::size_t i = 0; i < 3; ++i) {
      same = same && WithoutDivision(v[(i + 1) % 3], v[(i + 2) % 3], p).Sign() * determinant >= 0;
    }
    return same == *hits;
  });
}

StatementTally OffsetAlongTheNormalTellsTheSide(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 edge = t[1] - t[0];
    const Rational facing = Orient2d(t[0], t[1], t[2]);
    const Vec2 inward = Rational(static_cast<double>(facing.Sign())) * Rotated(edge);
    const Vec2 p = draws.Point();
    // The same side as the third vertex, whatever the winding.
    return Dot(inward, p - t[0]).Sign() ==
           Edge(t[0], t[1], p).Sign() * Edge(t[0], t[1], t[2]).Sign();
  });
}

StatementTally DivisionMovesVerticesIntoTheImage(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec3 v = draws.EyePoint(false);
    const Vec3 image = OnTheImage(Projected(v));
    // On the plane z = 1 and on the line through the eye and V.
    const Vec3 off_line = Cross(image, v);
    return optional(image.z == Rational(1) && off_line.x.Sign() == 0 && off_line.y.Sign() == 0 &&
                    off_line.z.Sign() == 0);
  });
}

constexpr std::array kHomogeneousStatements{
    Statement{"E1", "e(P) = (P - V0)_xy . R(V1/z1 - V0/z0)_xy is the projected edge's function.",
              Truth::kWrong,
              "anchored at V0/z0; as printed only if z0 = 1 or the projected line meets the origin",
              "V0 = (1,0,2), V1 = (0,1,1), P = (1/2,1/2): +1/4 for -1/4",
              PrintedFormNeedsAnAnchorThatIsProjected, PrintedFormHasTheWrongSign},
    Statement{"E2", "(V0 x V1) . (P, 1) is z0 z1 times the projected edge's function.",
              Truth::kTrue, "", "", TripleProductIsTheScaledEdge, nullptr},
    Statement{"E3", "(V0 x V1)_xy is the projected edge's normal.", Truth::kConditional,
              "z0 z1 > 0", "V0 = (0,0,1), V1 = (1,0,-1): it points the other way",
              CrossProductIsTheNormal, CrossProductPointsTheOtherWayForMixedSigns},
    Statement{"E4", "Scaling by z0 z1 removes the divisions and keeps the sign.",
              Truth::kConditional, "z0 z1 > 0, and the anchor is scaled too",
              "V0 = (0,0,1), V1 = (1,0,-1), P = (0,1): +1 for -1", ScalingKeepsTheSign,
              ScalingFlipsTheSignForMixedSigns},
    Statement{"E5", "It is P . R(z0 V1 - z1 V0) - V0 . R(V1), in x and y.", Truth::kTrue, "", "",
              TripleProductInTwoDimensions, nullptr},
    Statement{"E6", "x' = -y, y' = x is a counter-clockwise rotation.", Truth::kConvention, "y up",
              "y down: it turns right, (1,0), into down, (0,1)", RotationIsCounterClockwiseWithYUp,
              RotationIsClockwiseWithYDown},
    Statement{"E7", "That rotation of an edge is its inward normal.", Truth::kConvention,
              "counter-clockwise with y up", "(0,0), (0,4), (4,0): outward",
              RotationGivesTheInwardNormal, RotationGivesTheOutwardNormalForTheOtherWinding},
    Statement{"E8", "The same formula without the restriction to x and y.", Truth::kImprecise,
              "the third component of V1/z1 - V0/z0 is zero, so it makes no difference", "",
              ThirdComponentDoesNotMatter, nullptr},
    Statement{"E9",
              "The projected edge is where the image plane cuts the triangle of the eye and the "
              "edge, and V0 x V1 is \"this plane's\" normal.",
              Truth::kImprecise, "both ends beyond the image plane; the plane of eye and edge",
              "V0 at half the plane's depth: its projection lies outside that triangle",
              ProjectedEdgeLiesInTheTriangleWithTheEye, ProjectedEndLiesOutsideForANearVertex},
    Statement{"E10",
              "The ray through P meets the triangle in front of the eye exactly if no "
              "(Vj x Vk) . (P, 1) has the sign opposite to det(V0, V1, V2).",
              Truth::kTrue, "", "", SameSignsAsTheDeterminantMeanAHit, nullptr},
    Statement{"E11", "The inward normal times the offset from the edge tells the side.",
              Truth::kTrue, "", "", OffsetAlongTheNormalTellsTheSide, nullptr},
    Statement{"E12", "Dividing by z moves every vertex into the image plane.", Truth::kTrue, "", "",
              DivisionMovesVerticesIntoTheImage, nullptr},
};

}  // namespace

std::span<const Statement> HomogeneousStatements() { return kHomogeneousStatements; }

}  // namespace rasterproof::props
