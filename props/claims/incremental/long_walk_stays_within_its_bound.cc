// A walk across the largest target drifts no further than the bound claimed for it.
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/walks.h"

namespace rasterproof::props {
namespace {

constexpr int kSteps = 16384;  // the side of the largest target of the APIs in use

Asked Ask(const Case& c, const Description& subject) {
  return WalksStayWithinTheirBound(LongWalks(c, kSteps), *subject.edges);
}

}  // namespace

constinit const Property kLongWalkStaysWithinItsBound{
    .name = "LongWalkStaysWithinItsBound",
    .group = "incremental",
    .clause =
        "A walk over 16384 samples, the largest target of current APIs, drifts by a proven "
        "bound at most.",
    .tolerance = kWalkBounds,
    .domains = kLongWalks,
    .takes_long = true,
    .gate = kAsksSteps,
    .ask = Ask,
};

}  // namespace rasterproof::props
