// Statements W1 to W16: barycentrics that belong to edges, and wireframes drawn with them.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "tests/statements/rational_plane.h"

namespace rasterproof::props {
namespace {

using std::nullopt;
using std::optional;

Vec2 At(double x, double y) { return {Rational(x), Rational(y)}; }

// The text numbers barycentrics by edges: ABP, BCP, PCA over ABC.
Barycentrics3 ByEdge(const Triangle2& t, const Vec2& p) {
  const Rational whole = Orient2d(t[0], t[1], t[2]);
  return {Orient2d(t[0], t[1], p) / whole, Orient2d(t[1], t[2], p) / whole,
          Orient2d(p, t[2], t[0]) / whole};
}

StatementTally EdgeBarycentricsBelongToCAB(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.Point();
    const Barycentrics3 by_edge = ByEdge(t, p);
    const Barycentrics3 by_vertex = BarycentricsOf(t, p);
    return optional(by_edge[0] == by_vertex[2] && by_edge[1] == by_vertex[0] &&
                    by_edge[2] == by_vertex[1]);
  });
}

StatementTally VerticesAreUnitBarycentrics(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const auto is = [&](const Vec2& p, double l0, double l1, double l2) {
      return ByEdge(t, p) == Barycentrics3{Rational(l0), Rational(l1), Rational(l2)};
    };
    return optional(is(t[0], 0, 1, 0) && is(t[1], 0, 0, 1) && is(t[2], 1, 0, 0));
  });
}

// As the code computes them: lengths of cross products, and one minus the others.
Barycentrics3 ByLengths(const Triangle2& t, const Vec2& p) {
  const Rational whole = Cross(t[1] - t[0], t[2] - t[1]).Abs();
  const Rational l0 = Cross(t[1] - t[0], p - t[1]).Abs() / whole;
  const Rational l1 = Cross(t[2] - t[1], p - t[2]).Abs() / whole;
  return {l0, l1, Rational(1) - l0 - l1};
}

StatementTally LengthsAreRightInside(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.PointInside(t);
    return optional(ByLengths(t, p) == ByEdge(t, p));
  });
}

Vec2 OutsidePoint() { return At(2, -1); }
Triangle2 RightTriangle() { return {At(0, 0), At(4, 0), At(0, 4)}; }

// At (2,-1) the barycentrics are (-1/4, 3/4, 1/2), and by lengths (1/4, 3/4, 0).
bool LengthsMakeAnOutsidePointLookInside() {
  const Barycentrics3 right{Rational(-0.25), Rational(0.75), Rational(0.5)};
  const Barycentrics3 wrong{Rational(0.25), Rational(0.75), Rational(0)};
  return ByEdge(RightTriangle(), OutsidePoint()) == right &&
         ByLengths(RightTriangle(), OutsidePoint()) == wrong;
}

StatementTally SignedAreasSumToOne(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.AnyTriangle();
    if (Orient2d(t[0], t[1], t[2]).Sign() == 0) return nullopt;
    const Barycentrics3 l = ByEdge(t, draws.Point());
    return l[0] + l[1] + l[2] == Rational(1);
  });
}

bool UnsignedAreasSumToMoreOutside() {
  const Barycentrics3 l = ByEdge(RightTriangle(), OutsidePoint());
  return l[0].Abs() + l[1].Abs() + l[2].Abs() == Rational(1.5);
}

StatementTally BarycentricIsADistanceInHeights(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.Point();
    const Barycentrics3 l = ByEdge(t, p);
    // lambda_0 is about edge AB, whose opposite vertex is C.
    const Rational height = SquaredDistance(t[0], t[1], t[2]);
    return optional(l[0] * l[0] * height == SquaredDistance(t[0], t[1], p) &&
                    ByEdge(t, t[2])[0] == Rational(1));
  });
}

bool BarycentricIsNotADistanceInPixels() {
  const Triangle2 t = RightTriangle();
  return ByEdge(t, t[2])[0] == Rational(1) && SquaredDistance(t[0], t[1], t[2]) == Rational(16);
}

// |d lambda_0 / dx| + |d lambda_0 / dy|, from its gradient: (-dY, dX) / area of edge AB.
Rational TotalChange(const Triangle2& t) {
  const Vec2 d = t[1] - t[0];
  return (d.x.Abs() + d.y.Abs()) / Orient2d(t[0], t[1], t[2]).Abs();
}

// Squared distance from AB at which lambda_0 reaches TotalChange * width.
Rational SquaredReach(const Triangle2& t, const Rational& width) {
  const Rational lambda = TotalChange(t) * width;
  return lambda * lambda * SquaredDistance(t[0], t[1], t[2]);
}

StatementTally DerivativeWidthIsBetweenOneAndRootTwo(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Rational w = draws.Positive();
    const Rational reach = SquaredReach(t, w);
    const Vec2 d = t[1] - t[0];
    const bool along_an_axis = d.x.Sign() == 0 || d.y.Sign() == 0;
    return optional(reach >= w * w && reach <= Rational(2) * w * w &&
                    along_an_axis == (reach == w * w));
  });
}

bool DiagonalEdgesAreDrawnWider() {
  return SquaredReach({At(0, 0), At(4, 4), At(0, 4)}, Rational(1)) == Rational(2);
}

// GLSL's step(edge, x): 0 where x < edge, else 1.
int Step(const Rational& edge, const Rational& x) { return x < edge ? 0 : 1; }
bool IsEdgeByFormula(const Rational& lambda, const Rational& width) { return lambda <= width; }
bool IsEdgeByCode(const Rational& lambda, const Rational& width) { return Step(width, lambda) < 1; }

StatementTally FormulaAndCodeAgreeOffEquality(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Rational lambda = draws.Part();
    const Rational width = draws.Part();
    if (lambda == width) return nullopt;
    return IsEdgeByFormula(lambda, width) == IsEdgeByCode(lambda, width);
  });
}

bool FormulaAndCodeDifferAtEquality() {
  return IsEdgeByFormula(Rational(0.25), Rational(0.25)) &&
         !IsEdgeByCode(Rational(0.25), Rational(0.25));
}

Triangle2 Reconstructed(const Vec2& p, const Rational& u, const Rational& v, const Vec2& dpdu,
                        const Vec2& dpdv) {
  const Vec2 a = p - u * dpdu - v * dpdv;
  return {a, a + dpdu, a + dpdv};
}

StatementTally VerticesAreReconstructed(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Rational u = draws.Part();
    const Rational v = draws.Part();
    const Vec2 dpdu = t[1] - t[0];
    const Vec2 dpdv = t[2] - t[0];
    const Vec2 p = t[0] + u * dpdu + v * dpdv;
    const Barycentrics3 by_edge{v, Rational(1) - u - v, u};
    return optional(Reconstructed(p, u, v, dpdu, dpdv) == t && ByEdge(t, p) == by_edge);
  });
}

// u, v as barycentrics of A and B: P = u A + v B + (1 - u - v) C has dP/du = A - C, dP/dv = B - C.
bool OtherParametersReconstructAnotherVertex() {
  const Triangle2 t = RightTriangle();
  const Triangle2 found =
      Reconstructed(At(1, 1), Rational(0.5), Rational(0.25), t[0] - t[2], t[1] - t[2]);
  return found[0] == t[2] && !(found[0] == t[0]);
}

// |(a . b / b . b) b - a|, squared: the part of a that is perpendicular to b.
Rational SquaredHeight(const Vec2& a, const Vec2& b) {
  const Vec2 off = Dot(a, b) / Dot(b, b) * b - a;
  return Dot(off, off);
}

StatementTally ProjectionGivesTheAltitudeFromA(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 a = t[1] - t[0];
    const Vec2 b = t[2] - t[1];
    return optional(SquaredHeight(a, b) == SquaredDistance(t[1], t[2], t[0]));
  });
}

Triangle2 NarrowTriangle() { return {At(0, 0), At(4, 0), At(0, 2)}; }

// Sides named after the opposite vertex: a = BC, b = CA. The result is the altitude from B.
bool OppositeNamingGivesTheAltitudeFromB() {
  const Triangle2 t = NarrowTriangle();
  const Rational height = SquaredHeight(t[2] - t[1], t[0] - t[2]);
  return height == SquaredDistance(t[2], t[0], t[1]) && height != SquaredDistance(t[1], t[2], t[0]);
}

// Squared heights with a = AB, b = BC, c = CA: H_a from A, H_b from B, H_c from C.
Barycentrics3 SquaredHeights(const Triangle2& t) {
  const Vec2 a = t[1] - t[0];
  const Vec2 b = t[2] - t[1];
  const Vec2 c = t[0] - t[2];
  return {SquaredHeight(a, b), SquaredHeight(b, c), SquaredHeight(c, a)};
}

StatementTally DistancesPairBarycentricAndHeightOfOneVertex(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.Point();
    const Barycentrics3 l = ByEdge(t, p);
    const Barycentrics3 h = SquaredHeights(t);
    return optional(l[0] * l[0] * h[2] == SquaredDistance(t[0], t[1], p) &&
                    l[1] * l[1] * h[0] == SquaredDistance(t[1], t[2], p) &&
                    l[2] * l[2] * h[1] == SquaredDistance(t[2], t[0], p));
  });
}

// D_b = H_a lambda_2 and D_c = H_b lambda_1, as printed, at P = (1, 1/2).
bool PrintedPairingIsSwapped() {
  const Triangle2 t = NarrowTriangle();
  const Vec2 p = At(1, 0.5);
  const Barycentrics3 l = ByEdge(t, p);
  const Barycentrics3 h = SquaredHeights(t);
  return l[2] * l[2] * h[0] != SquaredDistance(t[1], t[2], p) &&
         l[1] * l[1] * h[1] != SquaredDistance(t[2], t[0], p);
}

// Squared distance from the segment ab.
Rational SquaredSegmentDistance(const Vec2& a, const Vec2& b, const Vec2& p) {
  const Vec2 d = b - a;
  const Rational part = Dot(p - a, d) / Dot(d, d);
  if (part.Sign() <= 0) return Dot(p - a, p - a);
  if (part >= Rational(1)) return Dot(p - b, p - b);
  return SquaredDistance(a, b, p);
}

struct Nearest {
  Rational line;
  Rational segment;
};
Nearest NearestEdge(const Triangle2& t, const Vec2& p) {
  Nearest nearest{SquaredDistance(t[0], t[1], p), SquaredSegmentDistance(t[0], t[1], p)};
  for (std::size_t i = 1; i < 3; ++i) {
    const Vec2& a = t[i];
    const Vec2& b = t[(i + 1) % 3];
    const Rational line = SquaredDistance(a, b, p);
    const Rational segment = SquaredSegmentDistance(a, b, p);
    if (line < nearest.line) nearest.line = line;
    if (segment < nearest.segment) nearest.segment = segment;
  }
  return nearest;
}

StatementTally NearestLineIsNearestEdgeInside(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Nearest nearest = NearestEdge(t, draws.PointInside(t));
    return optional(nearest.line == nearest.segment);
  });
}

// (10, 0) lies on the line through A and B, six pixels from the edge.
bool LineIsNearerThanEdgeOutside() {
  const Nearest nearest = NearestEdge(RightTriangle(), At(10, 0));
  return nearest.line.Sign() == 0 && nearest.segment == Rational(36);
}

StatementTally ProjectionEqualsCrossOverBase(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Vec2 a = draws.Point();
    const Vec2 b = draws.Point();
    if (Dot(b, b).Sign() == 0) return nullopt;
    return SquaredHeight(a, b) == Cross(a, b) * Cross(a, b) / Dot(b, b);
  });
}

bool EqualVerticesDivideByZero() {
  const Vec2 side = At(1, 1) - At(1, 1);
  return Dot(side, side).Sign() == 0;
}

StatementTally EdgeBarycentricsReproduceThePoint(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.Point();
    const Barycentrics3 l = ByEdge(t, p);
    return optional(l[0] * t[2] + l[1] * t[0] + l[2] * t[1] == p);
  });
}

StatementTally InterpolatedUnitsAreScreenBarycentricsForEqualW(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Barycentrics3 l = BarycentricsOf(draws.ProperTriangle(), draws.Point());
    const Rational w = draws.Positive();
    const Rational over_w = l[0] / w + l[1] / w + l[2] / w;
    return optional(l[0] / w / over_w == l[0]);
  });
}

// w = (1, 4, 1), middle of edge 01: interpolated with perspective (4/5, 1/5, 0), on screen 1/2.
bool InterpolatedUnitsAreSurfaceBarycentrics() {
  const Rational first = Rational(0.5);
  const Rational second = Rational(0.5) / Rational(4);
  return first / (first + second) == Rational(4) / Rational(5);
}

StatementTally InsideBarycentricsAreNotNegative(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Barycentrics3 l = ByEdge(t, draws.PointInside(t));
    return optional(l[0].Sign() >= 0 && l[1].Sign() >= 0 && l[2].Sign() >= 0);
  });
}

StatementTally BarycentricVanishesOnItsEdge(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Rational s = draws.Part();
    const auto on = [&](std::size_t i) { return t[i] + s * (t[(i + 1) % 3] - t[i]); };
    return optional(ByEdge(t, on(0))[0].Sign() == 0 && ByEdge(t, on(1))[1].Sign() == 0 &&
                    ByEdge(t, on(2))[2].Sign() == 0);
  });
}

constexpr std::array kWireframeStatements{
    Statement{"W1", "lambda_0 = ABP/ABC, lambda_1 = BCP/ABC, lambda_2 = PCA/ABC go with C, A, B.",
              Truth::kTrue, "", "", EdgeBarycentricsBelongToCAB, nullptr},
    Statement{"W2", "At A the barycentrics are (0,1,0), at B (0,0,1), at C (1,0,0).", Truth::kTrue,
              "", "", VerticesAreUnitBarycentrics, nullptr},
    Statement{"W3", "The areas may be taken as lengths of cross products.", Truth::kConditional,
              "P in the closed triangle",
              "(0,0), (4,0), (0,4), P = (2,-1): (1/4, 3/4, 0) for (-1/4, 3/4, 1/2)",
              LengthsAreRightInside, LengthsMakeAnOutsidePointLookInside},
    Statement{"W4", "The barycentrics sum to one because the areas are normalised.",
              Truth::kConditional, "signed areas, the whole not zero",
              "unsigned at the point of W3: 3/2", SignedAreasSumToOne,
              UnsignedAreasSumToMoreOutside},
    Statement{"W5", "lambda_i is the signed distance from edge i, +1 at its vertex.",
              Truth::kConditional, "in units of that height, not of pixels",
              "(0,0), (4,0), (0,4): 1 at C, four pixels from AB", BarycentricIsADistanceInHeights,
              BarycentricIsNotADistanceInPixels},
    Statement{
        "W6", "lambda_i <= (|d/dx| + |d/dy|) W draws edges of one width.", Truth::kConditional,
        "barycentrics affine on screen; widths between W and sqrt(2) W, W only along the axes",
        "a diagonal edge: sqrt(2) W", DerivativeWidthIsBetweenOneAndRootTwo,
        DiagonalEdgesAreDrawnWider},
    Statement{"W7", "The shader's step() is the formula's lambda <= width.", Truth::kMismatch,
              "lambda is not equal to the width", "lambda = width = 1/4: formula yes, code no",
              FormulaAndCodeAgreeOffEquality, FormulaAndCodeDifferAtEquality},
    Statement{"W8", "A = P - u dPdu - v dPdv, B = A + dPdu, C = A + dPdv.", Truth::kConditional,
              "P = A + u (B - A) + v (C - A); then lambda = (v, 1 - u - v, u)",
              "u and v as barycentrics of A and B: C is found in A's place",
              VerticesAreReconstructed, OtherParametersReconstructAnotherVertex},
    Statement{"W9", "H_a = |(a.b / b.b) b - a| is the height of A.", Truth::kConditional,
              "a = AB, b = BC, c = CA", "a opposite A in (0,0), (4,0), (0,2): the height of B",
              ProjectionGivesTheAltitudeFromA, OppositeNamingGivesTheAltitudeFromB},
    Statement{"W10", "The distances are D_a = H_c l0, D_b = H_a l2, D_c = H_b l1.", Truth::kWrong,
              "D_a = H_c l0, D_b = H_a l1, D_c = H_b l2",
              "(0,0), (4,0), (0,2), P = (1,1/2): both swapped ones differ",
              DistancesPairBarycentricAndHeightOfOneVertex, PrintedPairingIsSwapped},
    Statement{"W11", "min D <= W finds what is within W of an edge.", Truth::kConditional,
              "P in the closed triangle: D measures lines, not segments",
              "(0,0), (4,0), (0,4), P = (10,0): on a line, six pixels from the edge",
              NearestLineIsNearestEdgeInside, LineIsNearerThanEdgeOutside},
    Statement{"W12", "Heights are found by projection.", Truth::kConditional,
              "b is not the null vector; then it is |a x b| / |b|", "two equal vertices: 0/0",
              ProjectionEqualsCrossOverBase, EqualVerticesDivideByZero},
    Statement{"W13", "P = lambda_0 C + lambda_1 A + lambda_2 B.", Truth::kTrue, "", "",
              EdgeBarycentricsReproduceThePoint, nullptr},
    Statement{
        "W14", "Unit vectors given as vertex attributes come out as the fragment's barycentrics.",
        Truth::kConditional, "equal w, or interpolation without perspective",
        "w = (1, 4, 1), middle of edge 01: 4/5 for 1/2",
        InterpolatedUnitsAreScreenBarycentricsForEqualW, InterpolatedUnitsAreSurfaceBarycentrics},
    Statement{"W15", "Inside no barycentric is negative.", Truth::kTrue, "", "",
              InsideBarycentricsAreNotNegative, nullptr},
    Statement{"W16", "On AB lambda_0 is zero, on BC lambda_1, on CA lambda_2.", Truth::kTrue, "",
              "", BarycentricVanishesOnItsEdge, nullptr},
};

}  // namespace

std::span<const Statement> WireframeStatements() { return kWireframeStatements; }

}  // namespace rasterproof::props
