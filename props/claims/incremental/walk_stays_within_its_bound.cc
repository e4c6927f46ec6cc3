// Each of the eight walks (along x or y, either way, by one pixel or by L) meets values within the bound that the subject claims for that many steps.
#include <optional>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/walks.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWalks(subject, c)) return *refusal;
  return WalksStayWithinTheirBound(*subject.Edges(), SomeWalks(c));
}

}  // namespace

constinit const Property kWalkStaysWithinItsBound{
    .name = "WalkStaysWithinItsBound",
    .group = "incremental",
    .clause =
        "E(x + L, y) = E + L dY, E(x, y + L) = E - L dX and their opposites (Pineda, "
        "SIGGRAPH 1988, section 3.2): each step adds its rounding.",
    .precondition = kEdgeValues,
    .tolerance = kWalkBounds,
    .domains = kMagnitudes,
    .check = Judge,
};

}  // namespace rasterproof::props
