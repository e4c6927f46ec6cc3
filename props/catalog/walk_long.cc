#include "props/catalog/walk_long.h"

#include <optional>

#include "props/catalog/walks.h"

namespace rasterproof::props {
namespace {

constexpr int kSteps = 16384;  // the side of the largest target of the APIs in use

}  // namespace

Verdict LongWalkStaysWithinItsBound(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWalks(subject, c)) return *refusal;
  return WalksStayWithinTheirBound(*subject.Edges(), LongWalks(c, kSteps));
}

}  // namespace rasterproof::props
