// Where the triangle as given covers the centre of a pixel, a subject that covers every square that
// a triangle meets covers the pixel. Judged by point samples: no oracle of squares is asked.
#include <array>
#include <vector>

#include "exact/square_coverage.h"
#include "props/judging/squares.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace met_squares_include_covered_centres {

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) {
                  return p.squares && p.squares->must &&
                         p.squares->must->relation == SquareRelation::kIntersects &&
                         KeepsCentres(p, *p.squares->must);
                },
                "coverage with a must region of squares that are met",
                "the profile does not say that squares are covered that a triangle meets", true},
    kDrawsLargeTriangles, kDrawsBothFacings};

// Triangles that the profile may make flat need not be drawn.
CoverageCounts CentresOfSolid(const PlacedCase& c, const DrawOptions& options) {
  std::vector<std::size_t> solid;
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    if (!exact::MayBeFlat(c, t)) solid.push_back(t);
  }
  return CentresOf(c.Only(solid), options);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return CompareEachAndAll(c, subject, MayBe::kMore,
                           "squares: a pixel whose centre is covered is left out", CentresOfSolid);
}

}  // namespace met_squares_include_covered_centres

extern constinit const Property kMetSquaresIncludeCoveredCentres{
    .name = "MetSquaresIncludeCoveredCentres",
    .group = "square",
    .clause =
        "A square that a triangle meets is covered, so every pixel is whose centre it covers: the "
        "relation intersects contains point coverage.",
    .required_by = kSquaresMetClauses,
    .tolerance = kExact,
    .domains = kSquareDomains,
    .gate = SquareGate(met_squares_include_covered_centres::kRules),
    .ask = met_squares_include_covered_centres::Ask,
};

}  // namespace rasterproof::props
