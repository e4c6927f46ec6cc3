// Steppings meet values within the bound that the subject states for their steps: each of the eight
// along x or y, either way, by one pixel or by L, and one across the largest target.
#include "props/judging/values/stepping.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace {

constexpr int kSteps = 16384;  // the side of the largest target of the APIs in use

}  // namespace

// Each of the eight steppings meets values within the bound that the subject states for its steps.
//
// They go along x or y, either way, by one pixel or by L.
extern constinit const Property kSteppingStaysWithinItsBound{
    .name = "SteppingStaysWithinItsBound",
    .group = "incremental",
    .clause =
        "E(x + L, y) = E + L dY, E(x, y + L) = E - L dX and their opposites (Pineda, "
        "SIGGRAPH 1988, section 3.2): each step adds its rounding.",
    .tolerance = kSteppingBounds,
    .domains = kMagnitudes,
    .gate = kAsksSteps,
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return StepsStayWithinTheirBound(SomeSteppingQueries(c), *subject.edges);
        },
};

// A stepping across the largest target drifts no further than the bound stated for it.
extern constinit const Property kLongSteppingStaysWithinItsBound{
    .name = "LongSteppingStaysWithinItsBound",
    .group = "incremental",
    .clause =
        "A stepping over 16384 samples, the largest target of current APIs, drifts by a proven "
        "bound at most.",
    .tolerance = kSteppingBounds,
    .domains = kLongRows,
    .takes_long = true,
    .gate = kAsksSteps,
    .ask =
        [](const PlacedCase& c, const Description& subject) {
          return StepsStayWithinTheirBound(LongRows(c, kSteps), *subject.edges);
        },
};

}  // namespace rasterproof::props
