// Statements C1 to C7, C10 to C13, C16, C17: inside tests, winding and tie rules.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

#include "exact/coverage.h"
#include "tests/statements/rational_plane.h"

namespace rasterproof::props {
namespace {

using std::nullopt;
using std::optional;

Vec2 At(double x, double y) { return {Rational(x), Rational(y)}; }
StatementTally RightOfAnUpwardEdgeIsPositive(std::uint64_t seed, int count) {
  // This defines "right" without a rotation: of two points at one height beside an upward edge, the
  // one of greater x is the right one.
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Vec2 a = draws.Point();
    const Vec2 b = draws.Point();
    const Rational rise = b.y - a.y;
    if (rise.Sign() <= 0) return nullopt;  // upward on the page, y up
    const Rational part = draws.Part();
    const Rational right = draws.Number();
    const Vec2 p{a.x + part * (b.x - a.x) + right, a.y + part * rise};
    return Edge(a, b, p).Sign() == right.Sign();
  });
}

// With y down the edge (0,4) -> (0,0) goes up the page; (1,2) is to its right, and E = -4.
bool RightIsNegativeWithYDown() { return Edge(At(0, 4), At(0, 0), At(1, 2)) == Rational(-4); }

bool AllPositiveInside(const Triangle2& t, const Vec2& p) {
  return Edge(t[0], t[1], p).Sign() > 0 && Edge(t[1], t[2], p).Sign() > 0 &&
         Edge(t[2], t[0], p).Sign() > 0;
}

StatementTally ClockwiseInteriorIsPositive(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.ProperTriangle();
    if (Orient2d(t[0], t[1], t[2]).Sign() > 0) return nullopt;  // clockwise with y up
    const Vec2 centroid = Rational(1) / Rational(3) * (t[0] + t[1] + t[2]);
    const Rational e = Edge(t[0], t[1], centroid);
    return AllPositiveInside(t, centroid) && e * e == SquaredDoubleArea(t[0], t[1], centroid);
  });
}

// In raster coordinates (0,0), (4,0), (0,4) goes right, then down: clockwise on the page.
bool ClockwiseInteriorIsNegativeWithYDown() {
  const Triangle2 t{At(0, 0), At(4, 0), At(0, 4)};
  return Edge(t[0], t[1], At(1, 1)).Sign() < 0 && Edge(t[1], t[2], At(1, 1)).Sign() < 0 &&
         Edge(t[2], t[0], At(1, 1)).Sign() < 0;
}

// C3: the two calls as the text writes them.
struct Vec2f {};
struct Vec3f {};
using AsWritten = bool(const Vec2f&, const Vec3f&, const Vec2f&);
template <class V1>
constexpr bool kBothCallsCompile = std::is_invocable_v<AsWritten*, Vec2f, V1, Vec2f> &&
                                   std::is_invocable_v<AsWritten*, V1, Vec3f, Vec2f>;

bool NoTypeOfV1FitsBothCalls() { return !kBothCallsCompile<Vec2f> && !kBothCallsCompile<Vec3f>; }

StatementTally OneTypeFitsAllCalls(std::uint64_t, int count) {
  using Corrected = bool(const Vec2f&, const Vec2f&, const Vec2f&);
  const auto times = static_cast<std::uint64_t>(count);
  return {times, times, std::is_invocable_v<Corrected*, Vec2f, Vec2f, Vec2f> ? times : 0};
}

bool PassesInclusively(const Triangle2& t, const Vec2& p) {
  return Edge(t[0], t[1], p).Sign() >= 0 && Edge(t[1], t[2], p).Sign() >= 0 &&
         Edge(t[2], t[0], p).Sign() >= 0;
}

// Two triangles on either side of the edge ac, both with a positive area.
struct Quad {
  Triangle2 first;
  Triangle2 second;
};
optional<Quad> DrawQuad(Draws& draws) {
  const Vec2 a = draws.Point();
  const Vec2 b = draws.Point();
  const Vec2 c = draws.Point();
  const Vec2 d = draws.Point();
  if (Edge(a, b, c).Sign() <= 0 || Edge(a, c, d).Sign() <= 0) return nullopt;
  return Quad{{a, b, c}, {a, c, d}};
}

StatementTally InclusiveTestsCountOnceOffTheEdges(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const optional<Quad> quad = DrawQuad(draws);
    if (!quad) return nullopt;
    const Vec2 p = draws.PointInside(draws.Coin() ? quad->first : quad->second);
    if (Edge(quad->first[0], quad->first[2], p).Sign() == 0) return nullopt;
    return PassesInclusively(quad->first, p) != PassesInclusively(quad->second, p);
  });
}

bool InclusiveTestsCountTheDiagonalTwice() {
  const Vec2 p = At(1, 1);
  return PassesInclusively({At(0, 0), At(0, 2), At(2, 2)}, p) &&
         PassesInclusively({At(0, 0), At(2, 2), At(2, 0)}, p);
}

StatementTally QuotientsAreBarycentricsForPositiveArea(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.ProperTriangle();
    if (Edge(t[0], t[1], t[2]).Sign() < 0) return nullopt;
    const Vec2 p = draws.Coin() ? draws.PointInside(t) : draws.Point();
    const Barycentrics3 l = BarycentricsOf(t, p);
    return PassesInclusively(t, p) == IsInside(t, p) && Combined(l, t) == p;
  });
}

// (0,0), (2,2), (4,4) and P = (1,1): three zeros pass the test and are divided by a zero area. And
// a sample inside a triangle of negative area never passes.
bool DegenerateTrianglePassesAndDividesByZero() {
  const Triangle2 flat{At(0, 0), At(2, 2), At(4, 4)};
  const Triangle2 reversed{At(0, 0), At(4, 0), At(0, 4)};
  return PassesInclusively(flat, At(1, 1)) && Edge(flat[0], flat[1], flat[2]).Sign() == 0 &&
         IsInside(reversed, At(1, 1)) && !PassesInclusively(reversed, At(1, 1));
}

StatementTally EdgesOverTheAreaAreBarycentrics(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.Point();
    const Barycentrics3 l = BarycentricsOf(t, p);
    return optional(Combined(l, t) == p && l[0] + l[1] + l[2] == Rational(1));
  });
}

bool AllWithinOne(const Barycentrics3& l) {
  for (const Rational& barycentric : l) {
    if (barycentric.Sign() < 0 || barycentric > Rational(1)) return false;
  }
  return true;
}

StatementTally InsideIsNoBarycentricNegative(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const Vec2 p = draws.Coin() ? draws.PointInside(t) : draws.Point();
    const Barycentrics3 l = BarycentricsOf(t, p);
    // The sum is one inside and outside; with it, "at most one" follows from "not negative".
    return optional(l[0] + l[1] + l[2] == Rational(1) && IsInside(t, p) == AllWithinOne(l));
  });
}

bool SumIsOneOutsideToo() {
  const Triangle2 t{At(0, 0), At(4, 0), At(0, 4)};
  const Barycentrics3 l = BarycentricsOf(t, At(2, -1));
  return !IsInside(t, At(2, -1)) && l[0] + l[1] + l[2] == Rational(1);
}

// Left edge, by its meaning: not horizontal, and the third vertex is to the right of its line.
bool IsLeft(const Vec2& a, const Vec2& b, const Vec2& third) {
  if (a.y == b.y) return false;
  const Rational x = a.x + (third.y - a.y) / (b.y - a.y) * (b.x - a.x);
  return third.x > x;
}

StatementTally AscendingEdgesAreLeft(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const Triangle2 t = draws.ProperTriangle();
    // One condition on the numbers, two readings on the page.
    if (Orient2d(t[0], t[1], t[2]).Sign() > 0) return nullopt;
    bool holds = true;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2& a = t[i];
      const Vec2& b = t[(i + 1) % 3];
      holds = holds && (b.y > a.y) == IsLeft(a, b, t[(i + 2) % 3]);
    }
    return holds;
  });
}

// y down, clockwise: the left edge (0,4) -> (0,0) descends in Y.
bool LeftEdgeDescendsForClockwiseWithYDown() {
  const Vec2 start = At(0, 4);
  const Vec2 end = At(0, 0);
  return IsLeft(start, end, At(4, 0)) && end.y < start.y;
}

// Top edge with y down, by its meaning: horizontal, the interior below.
bool IsTop(const Vec2& a, const Vec2& b, const Vec2& third) { return a.y == b.y && third.y > a.y; }

// A sample in the middle of an edge belongs to the triangle under exact::kTopLeft.
bool OwnsMiddle(const Triangle2& t, std::size_t i) {
  const Vec2 middle = Rational(0.5) * (t[i] + t[(i + 1) % 3]);
  return exact::Covers({ToPoint(t[0]), ToPoint(t[1]), ToPoint(t[2])}, ToPoint(middle), kTopLeft);
}

// A triangle with a horizontal edge from its first to its second vertex.
optional<Triangle2> DrawWithHorizontalEdge(Draws& draws) {
  Triangle2 t = draws.ProperTriangle();
  t[1].y = t[0].y;
  if (Orient2d(t[0], t[1], t[2]).Sign() == 0) return nullopt;
  return t;
}

StatementTally TopEdgesOwnTheirSamples(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const optional<Triangle2> t = DrawWithHorizontalEdge(draws);
    if (!t) return nullopt;
    return OwnsMiddle(*t, 0) == IsTop((*t)[0], (*t)[1], (*t)[2]);
  });
}

// y down, (0,4), (4,4), (2,0): reading "above" as greater y calls the bottom edge a top edge.
bool GreaterYIsBelowWithYDown() {
  const Triangle2 t{At(0, 4), At(4, 4), At(2, 0)};
  return t[0].y > t[2].y && !IsTop(t[0], t[1], t[2]) && !OwnsMiddle(t, 0);
}

// Top-left by flags: strictly inside, or on edges that are all top or left.
bool CoversByFlags(const Triangle2& t, const Vec2& p) {
  const Barycentrics3 l = BarycentricsOf(t, p);
  for (std::size_t i = 0; i < 3; ++i) {
    if (l[i].Sign() < 0) return false;
    if (l[i].Sign() > 0) continue;
    const Vec2& a = t[(i + 1) % 3];
    const Vec2& b = t[(i + 2) % 3];
    if (!IsTop(a, b, t[i]) && !IsLeft(a, b, t[i])) return false;
  }
  return true;
}

StatementTally ShiftEqualsTopLeft(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Triangle2 t = draws.ProperTriangle();
    const std::array<Point2, 3> points{ToPoint(t[0]), ToPoint(t[1]), ToPoint(t[2])};
    // Vertices, middles of edges (exact: coordinates are multiples of 2^-8) and anything else.
    bool holds = exact::Covers(points, points[0], kTopLeft) == CoversByFlags(t, t[0]);
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec2 middle = Rational(0.5) * (t[i] + t[(i + 1) % 3]);
      holds = holds && exact::Covers(points, ToPoint(middle), kTopLeft) == CoversByFlags(t, middle);
    }
    const Vec2 p = draws.Point();
    return optional(holds && exact::Covers(points, ToPoint(p), kTopLeft) == CoversByFlags(t, p));
  });
}

// Directions around a hub, counter-clockwise with y up, no two of them opposite neighbours.
constexpr std::array<Point2, 6> kSpokes{{{1, 0}, {1, 2}, {-1, 1}, {-2, -1}, {0, -1}, {2, -1}}};

StatementTally HubIsOwnedOnce(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec2 hub = draws.Point();
    std::array<Vec2, kSpokes.size()> rim;
    for (std::size_t k = 0; k < rim.size(); ++k) {
      rim[k] = hub + draws.Positive() * At(kSpokes[k].x, kSpokes[k].y);
    }
    bool holds = true;
    for (const TieRule& rule :
         {TieRule{}, TieRule{-1, +1}, TieRule{+1, -1}, TieRule{-1, -1}, TieRule{+1, +1, true},
          TieRule{-1, +1, true}, TieRule{+1, -1, true}, TieRule{-1, -1, true}}) {
      int owners = 0;
      for (std::size_t k = 0; k < rim.size(); ++k) {
        const Vec2& next = rim[(k + 1) % rim.size()];
        if (exact::Covers({ToPoint(hub), ToPoint(rim[k]), ToPoint(next)}, ToPoint(hub), rule)) {
          ++owners;
        }
      }
      holds = holds && owners == 1;
    }
    return optional(holds);
  });
}

StatementTally TopIsIndependentOfWinding(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) -> optional<bool> {
    const optional<Triangle2> t = DrawWithHorizontalEdge(draws);
    if (!t) return nullopt;
    const Triangle2 reversed{(*t)[1], (*t)[0], (*t)[2]};
    // Ascending or not changes with the winding: that definition of a left edge depends on it.
    const bool was_ascending = (*t)[2].y > (*t)[1].y;
    const bool is_ascending = (*t)[1].y > (*t)[2].y;
    return IsTop((*t)[0], (*t)[1], (*t)[2]) == IsTop(reversed[0], reversed[1], reversed[2]) &&
           OwnsMiddle(*t, 0) == OwnsMiddle(reversed, 0) && was_ascending != is_ascending;
  });
}

bool TopEdgeStaysTopWhenReversed() {
  return IsTop(At(0, 0), At(4, 0), At(2, 4)) && IsTop(At(4, 0), At(0, 0), At(2, 4));
}

StatementTally ReversalNegates(std::uint64_t seed, int count) {
  return Over(seed, count, [](Draws& draws) {
    const Vec2 u = draws.Point();
    const Vec2 v = draws.Point();
    const Vec2 p = draws.Point();
    return optional(Cross(u, v) == -Cross(v, u) && Edge(u, v, p) == -Edge(v, u, p));
  });
}

constexpr std::array kCoverageStatements{
    Statement{"C1", "A point to the right of the edge has a positive value.", Truth::kConditional,
              "y up", "y down: (0,4) -> (0,0) goes up the page, (1,2) is to its right, E = -4",
              RightOfAnUpwardEdgeIsPositive, RightIsNegativeWithYDown},
    Statement{
        "C2", "Inside a clockwise triangle all three values are positive, and are areas.",
        Truth::kConditional, "y up",
        "raster axes: (0,0), (4,0), (0,4) is clockwise on the page, at (1,1) all are negative",
        ClockwiseInteriorIsPositive, ClockwiseInteriorIsNegativeWithYDown},
    Statement{"C3", "edgeFunction(Vec2f, Vec3f, Vec2f) is called with (V0, V1, p) and (V1, V2, p).",
              Truth::kWrong, "one vector type for all three parameters",
              "no type of V1 compiles in both calls", OneTypeFitsAllCalls, NoTypeOfV1FitsBothCalls},
    Statement{"C4", "A pixel is the triangle's if all three values are at least zero.",
              Truth::kConditional, "no sample lies on an edge",
              "the square (0,0)-(2,2) split by its diagonal: (1,1) passes for both halves",
              InclusiveTestsCountOnceOffTheEdges, InclusiveTestsCountTheDiagonalTwice},
    Statement{
        "C5", "If all three values are at least zero, dividing by the area gives the barycentrics.",
        Truth::kWrong, "area > 0, tested before",
        "(0,0), (2,2), (4,4), P = (1,1): passes, 0/0; and every triangle of negative area fails",
        QuotientsAreBarycentricsForPositiveArea, DegenerateTrianglePassesAndDividesByZero},
    Statement{"C6", "w0 = E12 / area, w1 = E20 / area, w2 = E01 / area belong to v0, v1, v2.",
              Truth::kTrue, "", "", EdgesOverTheAreaAreBarycentrics, nullptr},
    Statement{"C7", "Barycentrics are arbitrary; inside means all in [0, 1] and a sum of one.",
              Truth::kImprecise, "the sum is one at every point, and inside means none is negative",
              "(0,0), (4,0), (0,4), P = (2,-1): outside, and the sum is one",
              InsideIsNoBarycentricNegative, SumIsOneOutsideToo},
    Statement{"C10", "A left edge is one of ascending Y.", Truth::kConditional,
              "clockwise with y up, or counter-clockwise with y down",
              "y down, clockwise: (0,0), (4,0), (0,4) has the left edge (0,4) -> (0,0)",
              AscendingEdgesAreLeft, LeftEdgeDescendsForClockwiseWithYDown},
    Statement{"C11", "A top edge is a horizontal one above the third point.", Truth::kConditional,
              "above on the page: smaller y with y down",
              "y down, (0,4), (4,4), (2,0): the edge of greater y is the bottom",
              TopEdgesOwnTheirSamples, GreaterYIsBelowWithYDown},
    Statement{"C12",
              "The top-left rule is the strict test at the sample moved by (+e, +e^2), y down.",
              Truth::kTrue, "", "", ShiftEqualsTopLeft, nullptr},
    Statement{"C13", "Under each of the eight shifts one triangle of a closed fan owns its hub.",
              Truth::kTrue, "", "", HubIsOwnedOnce, nullptr},
    Statement{"C16", "What left and top edges are depends on the winding.", Truth::kImprecise,
              "left by ascending Y does; top, and left by where the interior is, do not",
              "(0,0), (4,0), (2,4) and its reverse have the same top edge",
              TopIsIndependentOfWinding, TopEdgeStaysTopWhenReversed},
    Statement{"C17", "Exchanging the vectors of a cross product negates it.", Truth::kTrue, "", "",
              ReversalNegates, nullptr},
};

}  // namespace

std::span<const Statement> CoverageStatements() { return kCoverageStatements; }

}  // namespace rasterproof::props
