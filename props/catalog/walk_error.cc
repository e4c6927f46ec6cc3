#include "props/catalog/walk_error.h"

#include <optional>

#include "props/catalog/walks.h"

namespace rasterproof::props {

Verdict WalkStaysWithinItsBound(Subject& subject, const Case& c) {
  if (std::optional<Verdict> refusal = CannotAskWalks(subject, c)) return *refusal;
  return WalksStayWithinTheirBound(*subject.Edges(), SomeWalks(c));
}

}  // namespace rasterproof::props
