// Judges several cases at a time, so that their draws share calls to the subject.
#ifndef RASTERPROOF_PROPS_RUN_LOOK_AHEAD_H_
#define RASTERPROOF_PROPS_RUN_LOOK_AHEAD_H_

#include <functional>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/subject.h"
#include "props/property.h"
#include "props/run/trial.h"

namespace rasterproof::props {

/// Judges every case, the next checks of all of them in one call. The verdicts are those of
/// TryCase() on each, unless what a subject draws depends on other scenes.
///
/// Domain:     a property that asks, and whose draws may share calls; at least one case.
/// Returns:    what came of the cases, in their order; fewer if the last one is violated or
///             inconclusive, or `stop`, which is asked before each, said so.
/// Error:      JudgingFault, which names the first case where it is met in the draws of many;
///             SubjectDoesNotRun.
std::vector<Trial> TryTogether(Subject& subject, const Property& property,
                               std::span<const Case> cases, const std::function<bool()>& stop = {});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_LOOK_AHEAD_H_
