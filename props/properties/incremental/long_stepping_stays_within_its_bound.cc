// A stepping across the largest target drifts no further than the bound stated for it.
#include "props/judging/stepping.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace long_stepping_stays_within_its_bound {

constexpr int kSteps = 16384;  // the side of the largest target of the APIs in use

Checks Ask(const PlacedCase& c, const Description& subject) {
  return StepsStayWithinTheirBound(LongRows(c, kSteps), *subject.edges);
}

}  // namespace long_stepping_stays_within_its_bound

extern const Property kLongSteppingStaysWithinItsBound;
constinit const Property kLongSteppingStaysWithinItsBound{
    .name = "LongSteppingStaysWithinItsBound",
    .group = "incremental",
    .clause =
        "A stepping over 16384 samples, the largest target of current APIs, drifts by a proven "
        "bound at most.",
    .tolerance = kSteppingBounds,
    .domains = kLongRows,
    .takes_long = true,
    .gate = kAsksSteps,
    .ask = long_stepping_stays_within_its_bound::Ask,
};

}  // namespace rasterproof::props
