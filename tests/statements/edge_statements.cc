// Statements H1 to H12: what an edge function is, its signs, its areas and its increments.
#include <array>
#include <cstdint>
#include <span>

#include "exact/edge.h"
#include "tests/statements/rational_plane.h"

namespace rasterproof::props {
namespace {

using std::nullopt;
using std::optional;

Vec2 At(double x, double y) { return {Rational(x), Rational(y)}; }
Vec2 Negated(const Vec2& v) { return {-v.x, -v.y}; }
// Right of a direction as seen on the page. Turning clockwise is x' = y, y' = -x with y up, and the
// opposite with y down.
Vec2 RightOf(const Vec2& direction, bool y_up) {
  const Vec2 counter_clockwise_y_up = Rotated(direction);
  return y_up ? Negated(counter_clockwise_y_up) : counter_clockwise_y_up;
}

StatementTally IsADeterminant(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec2 a = draws.Point();
    const Vec2 b = draws.Point();
    const Vec2 p = draws.Point();
    const Rational e = (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
    return optional(e == Cross(p - a, b - a) && e == -Orient2d(a, b, p) &&
                    e == exact::EdgeValue(ToPoint(a), ToPoint(b), ToPoint(p)));
  });
}

StatementTally IsPositiveOnTheRight(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Vec2 a = draws.Point();
    const Vec2 d = draws.Point();
    if (Dot(d, d).Sign() == 0) return nullopt;
    const Rational to_the_right = draws.Number();
    const Vec2 p = a + draws.Number() * d + to_the_right * RightOf(d, /*y_up=*/true);
    return Edge(a, a + d, p).Sign() == to_the_right.Sign();
  });
}

// V0 = (0,0), V1 = (1,0), P = (0,-1), y down: P is one to the left of the direction, and E = +1.
bool IsPositiveOnTheLeftWithYDown() {
  const Vec2 a = At(0, 0);
  const Vec2 b = At(1, 0);
  const Vec2 left = Negated(RightOf(b - a, /*y_up=*/false));
  return left == At(0, -1) && Edge(a, b, a + left) == Rational(1);
}

StatementTally PositiveMeansRightHanded(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Vec2 u = draws.Point();
    if (Dot(u, u).Sign() == 0) return nullopt;
    const Rational turn = draws.Number();  // > 0: v lies counter-clockwise of u, y up
    const Vec2 v = draws.Number() * u + turn * Rotated(u);
    return Cross(u, v).Sign() == turn.Sign();
  });
}

// u = (1,0), v = (0,1) with y down: v points down the page, clockwise of u, and det[u; v] = 1.
bool RightHandedTurnsClockwiseWithYDown() {
  const Vec2 u = At(1, 0);
  const Vec2 clockwise_on_the_page = RightOf(u, /*y_up=*/false);
  return clockwise_on_the_page == At(0, 1) && Cross(u, clockwise_on_the_page) == Rational(1);
}

StatementTally HalfIsTheArea(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.AnyTriangle();
    if (Orient2d(t[0], t[1], t[2]).Sign() < 0) return nullopt;
    const Rational e = Edge(t[0], t[2], t[1]);
    return e.Sign() >= 0 && e * e == SquaredDoubleArea(t[0], t[1], t[2]);
  });
}

// A = (0,0), B = (0,1), C = (1,0): E_AC(B) = -1, and no area is negative.
bool HalfIsNegativeForTheOtherWinding() {
  return Edge(At(0, 0), At(1, 0), At(0, 1)) == Rational(-1);
}

// lambda by the edges C->B, A->C, B->A over E_AC(B).
Barycentrics3 BarycentricsByReversedEdges(const Triangle2& t, const Vec2& p) {
  const Rational whole = Edge(t[0], t[2], t[1]);
  return {Edge(t[2], t[1], p) / whole, Edge(t[0], t[2], p) / whole, Edge(t[1], t[0], p) / whole};
}

StatementTally BarycentricsByReversedEdgesAreRight(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.Point();
    const Barycentrics3 l = BarycentricsByReversedEdges(t, p);
    // Reproducing the point and summing to one determines the barycentrics.
    return optional(Combined(l, t) == p && l[0] + l[1] + l[2] == Rational(1));
  });
}

bool AreAreas(const Triangle2& t, const Vec2& p) {
  const auto is_area = [](const Rational& e, const Rational& square) {
    return e.Sign() >= 0 && e * e == square;
  };
  return is_area(Edge(t[2], t[1], p), SquaredDoubleArea(p, t[1], t[2])) &&
         is_area(Edge(t[0], t[2], p), SquaredDoubleArea(t[0], p, t[2])) &&
         is_area(Edge(t[1], t[0], p), SquaredDoubleArea(t[0], t[1], p));
}

StatementTally NumeratorsAreAreas(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.ProperTriangle();
    if (Orient2d(t[0], t[1], t[2]).Sign() < 0) return nullopt;
    return AreAreas(t, draws.PointInside(t));
  });
}

bool NumeratorsAreNegativeForTheOtherWinding() {
  return !AreAreas({At(0, 0), At(0, 4), At(4, 0)}, At(1, 1));
}

StatementTally SumIsOneEverywhere(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Barycentrics3 l = BarycentricsByReversedEdges(draws.ProperTriangle(), draws.Point());
    return optional(l[0] + l[1] + l[2] == Rational(1));
  });
}

StatementTally EightIncrementsHold(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec2 a = draws.Point();
    const Vec2 b = draws.Point();
    const Vec2 p = draws.Point();
    const Vec2 d = b - a;
    bool holds = true;
    for (const Rational& length : {Rational(1), draws.Number()}) {
      const Rational e = Edge(a, b, p);
      const Vec2 x{length, Rational(0)};
      const Vec2 y{Rational(0), length};
      holds = holds && Edge(a, b, p + x) == e + length * d.y &&
              Edge(a, b, p - x) == e - length * d.y && Edge(a, b, p + y) == e - length * d.x &&
              Edge(a, b, p - y) == e + length * d.x;
    }
    return optional(holds);
  });
}

// A number that counts the operations done with it.
struct Counted {
  Rational value;
  int* operations;
};
Counted operator+(const Counted& a, const Counted& b) {
  ++*a.operations;
  return {a.value + b.value, a.operations};
}
Counted operator-(const Counted& a, const Counted& b) {
  ++*a.operations;
  return {a.value - b.value, a.operations};
}
Counted operator*(const Counted& a, const Counted& b) {
  ++*a.operations;
  return {a.value * b.value, a.operations};
}

StatementTally OneAdditionReplacesFiveOperations(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    int operations = 0;
    const auto number = [&] { return Counted{draws.Number(), &operations}; };
    const Counted x = number();
    const Counted y = number();
    const Counted start_x = number();
    const Counted start_y = number();
    const Counted dx = number();
    const Counted dy = number();
    const Counted e = (x - start_x) * dy - (y - start_y) * dx;
    const int direct = operations;
    (void)(e + dy);
    const int step = operations - direct;
    (void)(e + Counted{Rational(16), &operations} * dy);
    const int stride = operations - direct - step;
    return optional(direct == 5 && step == 1 && stride == 2);
  });
}

StatementTally IsTheZOfACrossProduct(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec2 u = draws.Point();
    const Vec2 v = draws.Point();
    const Vec3 product = Cross(Vec3{u.x, u.y, Rational(0)}, Vec3{v.x, v.y, Rational(0)});
    const Vec3 swapped = Cross(Vec3{v.x, v.y, Rational(0)}, Vec3{u.x, u.y, Rational(0)});
    return optional(product.x.Sign() == 0 && product.y.Sign() == 0 && product.z == Cross(u, v) &&
                    swapped.z == -product.z);
  });
}

StatementTally IsZeroExactlyOnTheLine(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Vec2 a = draws.Point();
    const Vec2 d = draws.Point();
    if (Dot(d, d).Sign() == 0) return nullopt;
    const Rational off = draws.Coin() ? Rational(0) : draws.Number();
    const Vec2 p = a + draws.Number() * d + off * Rotated(d);
    return (Edge(a, a + d, p).Sign() == 0) == (off.Sign() == 0);
  });
}

bool AllPositive(const Triangle2& t, const Vec2& p) {
  return Edge(t[0], t[1], p).Sign() > 0 && Edge(t[1], t[2], p).Sign() > 0 &&
         Edge(t[2], t[0], p).Sign() > 0;
}

StatementTally InteriorIsWhereAllArePositive(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.ProperTriangle();
    if (Edge(t[0], t[1], t[2]).Sign() < 0) return nullopt;
    const Vec2 p = draws.Coin() ? draws.PointInside(t) : draws.Point();
    const Barycentrics3 l = BarycentricsOf(t, p);
    const bool interior = l[0].Sign() > 0 && l[1].Sign() > 0 && l[2].Sign() > 0;
    return AllPositive(t, p) == interior;
  });
}

bool InteriorIsAllNegativeForTheOtherWinding() {
  const Triangle2 t{At(0, 0), At(4, 0), At(0, 4)};
  return IsInside(t, At(1, 1)) && !AllPositive(t, At(1, 1));
}

constexpr std::array kEdgeStatements{
    Statement{"H1", "The edge function is the determinant of the point's and the edge's vectors.",
              Truth::kTrue, "", "", IsADeterminant, nullptr},
    Statement{"H2", "It is positive to the right of the directed edge and negative to the left.",
              Truth::kConditional, "y up",
              "y down: V0 = (0,0), V1 = (1,0), P = (0,-1) is left, E = 1", IsPositiveOnTheRight,
              IsPositiveOnTheLeftWithYDown},
    Statement{"H3", "A positive determinant means a right-handed pair of vectors.",
              Truth::kConditional, "y up",
              "y down: u = (1,0), v = (0,1) turns clockwise on the page, det = 1",
              PositiveMeansRightHanded, RightHandedTurnsClockwiseWithYDown},
    Statement{"H4", "Half of E_AC(B) is the area of ABC.", Truth::kConditional,
              "orient2d(A, B, C) >= 0", "A = (0,0), B = (0,1), C = (1,0): E_AC(B) = -1",
              HalfIsTheArea, HalfIsNegativeForTheOtherWinding},
    Statement{"H5",
              "lambda_A = E_CB(P) / E_AC(B), lambda_B = E_AC(P) / E_AC(B), "
              "lambda_C = E_BA(P) / E_AC(B).",
              Truth::kTrue, "", "", BarycentricsByReversedEdgesAreRight, nullptr},
    Statement{"H6", "Their numerators are twice the areas of the three parts.", Truth::kConditional,
              "orient2d(A, B, C) > 0 and P in the triangle",
              "A = (0,0), B = (0,4), C = (4,0), P = (1,1)", NumeratorsAreAreas,
              NumeratorsAreNegativeForTheOtherWinding},
    Statement{"H7", "The barycentrics sum to one.", Truth::kTrue, "", "", SumIsOneEverywhere,
              nullptr},
    Statement{"H8", "A step of 1 or L along x or y adds or subtracts dY, dX or L times them.",
              Truth::kTrue, "", "", EightIncrementsHold, nullptr},
    Statement{"H9", "A step costs one addition in place of five operations.", Truth::kTrue, "", "",
              OneAdditionReplacesFiveOperations, nullptr},
    Statement{"H10", "It is the z of the cross product of the vectors with z = 0.", Truth::kTrue,
              "", "", IsTheZOfACrossProduct, nullptr},
    Statement{"H11", "It is zero exactly on the line.", Truth::kTrue, "", "",
              IsZeroExactlyOnTheLine, nullptr},
    Statement{"H12", "The interior is where the functions of AB, BC and CA are all positive.",
              Truth::kConditional,
              "E_AB(C) > 0: clockwise with y up, counter-clockwise with y down",
              "(0,0), (4,0), (0,4), P = (1,1): all negative", InteriorIsWhereAllArePositive,
              InteriorIsAllNegativeForTheOtherWinding},
};

}  // namespace

std::span<const Statement> EdgeStatements() { return kEdgeStatements; }

}  // namespace rasterproof::props
