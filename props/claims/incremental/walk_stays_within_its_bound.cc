// Each of the eight walks meets values within the bound that the subject claims for its steps.
//
// They go along x or y, either way, by one pixel or by L.
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/walks.h"

namespace rasterproof::props {
namespace {

Asked Ask(const Case& c, const Description& subject) {
  return WalksStayWithinTheirBound(SomeWalks(c), *subject.edges);
}

}  // namespace

constinit const Property kWalkStaysWithinItsBound{
    .name = "WalkStaysWithinItsBound",
    .group = "incremental",
    .clause =
        "E(x + L, y) = E + L dY, E(x, y + L) = E - L dX and their opposites (Pineda, "
        "SIGGRAPH 1988, section 3.2): each step adds its rounding.",
    .tolerance = kWalkBounds,
    .domains = kMagnitudes,
    .gate = kAsksSteps,
    .ask = Ask,
};

}  // namespace rasterproof::props
