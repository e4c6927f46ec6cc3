// A triangle cut into four at the middles of its edges touches every square that it must touch
// whole: nothing falls between the parts.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>

#include "exact/rational.h"
#include "exact/square_coverage.h"
#include "props/judging/redraw.h"
#include "props/judging/squares.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace subdivision_leaves_no_square_untouched {

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) {
                  return p.squares && p.squares->must &&
                         p.squares->must->relation == SquareRelation::kIntersects &&
                         p.squares->must->geometry == SquareGeometry::kGiven;
                },
                "coverage with a must region of squares that a triangle as given meets",
                "the profile does not say which squares a triangle as given meets", true},
    kDrawsLargeTriangles, kDrawsBothFacings};

// The middle of two vertices, if the scene's precision and a fixed-point input hold it exactly.
std::optional<Vertex> Middle(const PlacedCase& c, const Vertex& a, const Vertex& b) {
  const Vertex middle{a.x / 2 + b.x / 2, a.y / 2 + b.y / 2, a.z / 2 + b.z / 2, 1};
  const auto is_held = [&](double x) {
    return (c.scene.precision == Precision::kFloat64 ||
            x == static_cast<double>(static_cast<float>(x))) &&
           (!c.profile.fixed || c.profile.fixed->IsGiven(x));
  };
  const auto is_half = [](double x, double y, double half) {
    return exact::Rational(x) + y == exact::Rational(half) + half;
  };
  const bool exact = is_half(a.x, b.x, middle.x) && is_half(a.y, b.y, middle.y);
  return exact && is_held(middle.x) && is_held(middle.y) ? std::optional(middle) : std::nullopt;
}

// The first triangle of the case that can be cut exactly into four parts, none of them flat.
struct Cut {
  PlacedCase whole;
  PlacedCase parts;
};

std::optional<Cut> CutOne(const PlacedCase& c, std::size_t t) {
  const std::array<Vertex, 3> v = Corners(c.scene, c.scene.triangles[t]);
  Scene scene = c.scene;
  scene.vertices.assign(v.begin(), v.end());
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<Vertex> middle = Middle(c, v[k], v[(k + 1) % 3]);
    if (!middle) return std::nullopt;
    scene.vertices.push_back(*middle);
  }
  scene.triangles = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}};
  Cut cut{c.Only({t}), c.With(std::move(scene))};
  for (std::size_t part = 0; part < cut.parts.scene.triangles.size(); ++part) {
    if (exact::MayBeFlat(cut.parts, part)) return std::nullopt;
  }
  return cut;
}

Check DrawsTheParts(Cut cut, std::size_t t) {
  Check check;
  check.questions.draws.push_back(
      CountsOf(cut.parts.scene, cut.parts.profile, WholeTarget(cut.parts)));
  check.judge = [cut = std::move(cut), t](const Answers& answers) {
    Verdict verdict = ComparedTo(
        answers.draws[0]->counts, exact::MustCover(cut.whole, WholeTarget(cut.whole)), MayBe::kMore,
        "squares: one that a triangle touches is touched by none of its four parts");
    if (verdict.witness) verdict.witness->triangle = static_cast<int>(t);
    return verdict;
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  constexpr std::size_t kMostCut = 4;
  Checks asked;
  for (std::size_t t = 0; t < c.scene.triangles.size() && asked.checks.size() < kMostCut; ++t) {
    if (auto cut = CutOne(c, t)) asked.checks.push_back(DrawsTheParts(std::move(*cut), t));
  }
  if (!asked.checks.empty()) return asked;
  return NotExercised("no triangle can be cut exactly into four that are surely not flat");
}

}  // namespace subdivision_leaves_no_square_untouched

extern constinit const Property kSubdivisionLeavesNoSquareUntouched{
    .name = "SubdivisionLeavesNoSquareUntouched",
    .group = "square",
    .clause =
        "A square that a triangle meets meets one of the parts of its subdivision: \"so nothing "
        "falls through the cracks\" (Direct3D conservative rasterization 3.2).",
    .required_by = kSquaresMetClauses,
    .tolerance = kExact,
    .domains = kSquareDomains,
    .gate = SquareGate(subdivision_leaves_no_square_untouched::kRules,
                       "a triangle with area that halves exactly"),
    .ask = subdivision_leaves_no_square_untouched::Ask,
};

}  // namespace rasterproof::props
