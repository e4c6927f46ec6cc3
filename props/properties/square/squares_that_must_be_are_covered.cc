// Each triangle alone, and the mesh, covers every square that the profile says it must, and a flat
// triangle that must be drawn covers at least one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>
#include <utility>

#include "core/profile.h"
#include "exact/square_coverage.h"
#include "props/judging/redraw.h"
#include "props/judging/squares.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace squares_that_must_be_are_covered {

constexpr std::array kRules{kMustCoverSquares, kDrawsLargeTriangles};

CoverageCounts LeastOf(const PlacedCase& c, const DrawOptions& options) {
  return exact::MustCover(c, options);
}

// A pixel from every side of the target, so that no square is one beyond it.
bool IsWellInside(const PlacedCase& c, const Triangle& t) {
  const double far =
      1 + std::max(0.0, c.profile.squares->may ? c.profile.squares->may->half_width : 0.0);
  return std::ranges::all_of(Corners(c.scene, t), [&](const Vertex& v) {
    return v.x >= far && v.y >= far && v.x <= c.scene.width - far && v.y <= c.scene.height - far;
  });
}

bool MustShowSomewhere(const PlacedCase& c, std::size_t number) {
  const Triangle& t = c.scene.triangles[number];
  const bool names_twice = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  return c.profile.squares->flat == FlatSquares::kDrawn && !names_twice && IsWellInside(c, t) &&
         exact::MayBeFlat(c, number);
}

Check ShowsSomewhere(const PlacedCase& c, std::size_t t) {
  Check check;
  check.questions.draws.push_back(CountsOf(c.Only({t}).scene, c.profile, WholeTarget(c)));
  check.judge = [t](const Answers& answers) {
    const CoverageCounts& counts = answers.draws[0]->counts;
    for (std::size_t k = 0; k < counts.size(); ++k) {
      if (counts.Count(k) != 0) return Verdict::Held(1);
    }
    Witness witness;
    witness.triangle = static_cast<int>(t);
    witness.observed = {"no square"};
    witness.expected = {"one square at least"};
    return Verdict::Violated(1, "squares: a flat triangle that must be drawn falls through",
                             std::move(witness));
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  Checks asked = CompareEachAndAll(c, subject, MayBe::kMore,
                                   "squares: one that must be covered is left out", LeastOf);
  constexpr std::size_t kMostFlat = 16;
  for (std::size_t t = 0; t < std::min(kMostFlat, c.scene.triangles.size()); ++t) {
    if (MustShowSomewhere(c, t)) asked.checks.push_back(ShowsSomewhere(c, t));
  }
  return asked;
}

}  // namespace squares_that_must_be_are_covered

extern constinit const Property kSquaresThatMustBeAreCovered{
    .name = "SquaresThatMustBeAreCovered",
    .group = "square",
    .clause =
        "Every square of the profile's must region is covered: \"never produce false negatives\" "
        "(Direct3D conservative rasterization 3.2), \"if any part of the primitive covers any part "
        "of the pixel\" (Vulkan), \"no matter how small the intersection\" (PDF).",
    .required_by = kSquaresThatMustBeClauses,
    .tolerance = kExact,
    .domains = kSquareDomains,
    .gate = SquareGate(squares_that_must_be_are_covered::kRules),
    .ask = squares_that_must_be_are_covered::Ask,
};

}  // namespace rasterproof::props
