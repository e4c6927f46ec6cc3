// The runs of steps that the incremental properties take over a case.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_STEPPING_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_STEPPING_H_

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/evaluators.h"
#include "core/question.h"
#include "core/verdict.h"
#include "props/judging/gate.h"
#include "props/judging/values/edge_queries.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// A stepping of `steps` steps along an edge's plane, from a sample of the target.
struct SteppingQuery {
  EdgeQuery from;
  Step step;
  int steps = 0;
};

/// The gate of a property about stepping.
inline constexpr Gate kAsksSteps{
    .shows = Shows::kSteps, .contract = ContractNeeded::kNone, .unwrapped = true};

/// The position after n steps. Exact: a sample location plus at most 2^16 whole pixels.
Point2 AfterSteps(const SteppingQuery& stepping, int n);

/// The eight ways of stepping, by one pixel and by L = 2, 8 and 16, as far as the target reaches.
std::vector<SteppingQuery> SomeSteppingQueries(const PlacedCase& c);

/// A single-pixel stepping from a corner of the target, `steps` long or as long as the profile's
/// limit lets it be. Bits of the case choose the edge and the direction.
std::vector<SteppingQuery> LongRows(const PlacedCase& c, int steps);

/// Asks for the values that the steps meet.
StepsQuestion StepsOf(const SteppingQuery& stepping);

/// The bounds that the subject states on them.
std::vector<double> BoundsOf(const SteppingQuery& stepping, const EdgeBounds& bounds);

/// Whether each value met is within the bound stated for it: all steppings in one check.
Checks StepsStayWithinTheirBound(std::span<const SteppingQuery> steppings,
                                 const EdgeBounds& bounds);

/// A violation if a run of steps has not steps + 1 values and as many bounds.
std::optional<Verdict> WrongLength(const SteppingQuery& stepping, std::size_t values,
                                   std::size_t bounds);

/// "after n steps of (dx, dy)" for messages.
std::string StepsText(const SteppingQuery& stepping, int n);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_STEPPING_H_
