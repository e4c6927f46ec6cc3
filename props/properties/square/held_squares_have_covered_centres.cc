// A subject that covers only squares that lie within a triangle covers no pixel whose centre the
// triangle as given does not cover. Judged by point samples: no oracle of squares is asked.
#include <array>

#include "props/judging/squares.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace held_squares_have_covered_centres {

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) {
                  return p.squares && p.squares->may &&
                         p.squares->may->relation == SquareRelation::kContains &&
                         KeepsCentres(p, *p.squares->may);
                },
                "coverage with a may region of squares that are held",
                "the profile lets squares be covered that do not lie within a triangle", true},
    kDrawsLargeTriangles, kDrawsBothFacings};

Checks Ask(const PlacedCase& c, const Description& subject) {
  return CompareEachAndAll(c, subject, MayBe::kLess,
                           "squares: a pixel is covered whose centre is not", CentresOf);
}

}  // namespace held_squares_have_covered_centres

extern constinit const Property kHeldSquaresHaveCoveredCentres{
    .name = "HeldSquaresHaveCoveredCentres",
    .group = "square",
    .clause =
        "Only squares within a triangle are covered, so no pixel is whose centre lies outside: the "
        "relation contains is within point coverage.",
    .required_by = kSquaresHeldClauses,
    .tolerance = kExact,
    .domains = kSquareDomains,
    .gate = SquareGate(held_squares_have_covered_centres::kRules),
    .ask = held_squares_have_covered_centres::Ask,
};

}  // namespace rasterproof::props
