// Each of the eight steppings meets values within the bound that the subject states for its steps.
//
// They go along x or y, either way, by one pixel or by L.
#include "props/judging/stepping.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace stepping_stays_within_its_bound {

Checks Ask(const PlacedCase& c, const Description& subject) {
  return StepsStayWithinTheirBound(SomeSteppingQueries(c), *subject.edges);
}

}  // namespace stepping_stays_within_its_bound

extern const Property kSteppingStaysWithinItsBound;
constinit const Property kSteppingStaysWithinItsBound{
    .name = "SteppingStaysWithinItsBound",
    .group = "incremental",
    .clause =
        "E(x + L, y) = E + L dY, E(x, y + L) = E - L dX and their opposites (Pineda, "
        "SIGGRAPH 1988, section 3.2): each step adds its rounding.",
    .tolerance = kSteppingBounds,
    .domains = kMagnitudes,
    .gate = kAsksSteps,
    .ask = stepping_stays_within_its_bound::Ask,
};

}  // namespace rasterproof::props
