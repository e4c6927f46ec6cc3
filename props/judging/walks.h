// The walks that the incremental claims take over a case.
#ifndef RASTERPROOF_PROPS_JUDGING_WALKS_H_
#define RASTERPROOF_PROPS_JUDGING_WALKS_H_

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/evaluators.h"
#include "core/question.h"
#include "core/verdict.h"
#include "props/judging/edge_queries.h"
#include "props/judging/gate.h"
#include "props/property.h"

namespace rasterproof::props {

/// A walk of `steps` steps along an edge's plane, from a sample of the target.
struct WalkQuery {
  EdgeQuery from;
  Step step;
  int steps = 0;
};

/// What a claim about walks needs.
inline constexpr Gate kAsksSteps{
    .shows = Shows::kSteps, .promise = Promise::kNone, .unwrapped = true};

/// The position after n steps. Exact: a sample location plus at most 2^16 whole pixels.
Point2 AfterSteps(const WalkQuery& walk, int n);

/// The eight walks, by one pixel and by L = 2, 8 and 16, as far as the target reaches.
std::vector<WalkQuery> SomeWalks(const Case& c);

/// A single-pixel walk from a corner of the target, `steps` long or as long as the profile's limit
/// lets it be. Bits of the case choose the edge and the direction.
std::vector<WalkQuery> LongWalks(const Case& c, int steps);

/// Asks for the values that the walk meets.
StepsQuestion StepsOf(const WalkQuery& walk);

/// The bounds that the subject states on them.
std::vector<double> BoundsOf(const WalkQuery& walk, const EdgeBounds& bounds);

/// Whether each value met is within the bound claimed for it: a check for each walk.
Asked WalksStayWithinTheirBound(std::span<const WalkQuery> walks, const EdgeBounds& bounds);

/// A violation if a walk has not steps + 1 values and as many bounds.
std::optional<Verdict> WrongLength(const WalkQuery& walk, std::size_t values, std::size_t bounds);

/// "after n steps of (dx, dy)" for messages.
std::string StepsText(const WalkQuery& walk, int n);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_WALKS_H_
