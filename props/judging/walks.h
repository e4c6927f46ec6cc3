// The walks that the incremental claims take over a case.
#ifndef RASTERPROOF_PROPS_JUDGING_WALKS_H_
#define RASTERPROOF_PROPS_JUDGING_WALKS_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/evaluators.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/judging/edge_queries.h"

namespace rasterproof::props {

/// A walk of `steps` steps along an edge's plane, from a sample of the target.
struct WalkQuery {
  EdgeQuery from;
  Step step;
  int steps = 0;
};

/// The verdict to give if the subject shows no walks or the case has no edges to walk along.
std::optional<Verdict> CannotAskWalks(const Subject& subject, const Case& c);

/// The position after n steps. Exact: a sample location plus at most 2^16 whole pixels.
Point2 AfterSteps(const WalkQuery& walk, int n);

/// The eight walks, by one pixel and by L = 2, 8 and 16, as far as the target reaches.
std::vector<WalkQuery> SomeWalks(const Case& c);

/// A single-pixel walk from a corner of the target, `steps` long or as long as the profile's limit
/// lets it be. Bits of the case choose the edge and the direction.
std::vector<WalkQuery> LongWalks(const Case& c, int steps);

/// Compares the values met with the exact ones.
/// Holds if each is within the bound claimed for it.
Verdict WalksStayWithinTheirBound(const EdgeEvaluator& edges, std::span<const WalkQuery> walks);

/// A violation if the subject's answer to a walk has not steps + 1 entries.
std::optional<Verdict> WrongLength(const WalkQuery& walk, std::size_t values, std::size_t bounds,
                                   std::uint64_t exercised);

/// "after n steps of (dx, dy)" for messages.
std::string StepsText(const WalkQuery& walk, int n);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_WALKS_H_
