// From a case that failed to the result of its run: is it so alone, how small can it get, and is it
// so again?
#ifndef RASTERPROOF_PROPS_RUN_COUNTEREXAMPLE_H_
#define RASTERPROOF_PROPS_RUN_COUNTEREXAMPLE_H_

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/case.h"
#include "core/result.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/property.h"
#include "props/run/budget.h"
#include "props/run/campaign.h"
#include "props/run/trial.h"

namespace rasterproof::props {

/// The evaluations that may hang while a case is shrunk.
inline constexpr int kMostHangs = 8;
/// The time limits (Pace) that they may take in all while a case that hung is shrunk.
inline constexpr double kMostHangLimits = 2;

/// Runs a failing case once more, alone.
///
/// Returns:    violated with what is said then. If it does not fail again: inconclusive with both
///             answers; violated all the same for properties about sequences of calls, which say
///             themselves that equal draws are equal, and if it could not be run again.
Counterexample RunOnceMore(Subject& subject, const Property& property, const Case& failing,
                           const Verdict& seen);

/// A case that failed, by its trial, among the cases that shared calls with it.
struct Failure {
  std::span<const Case> company;  ///< itself included
  std::size_t at = 0;             ///< which of them
  Trial trial;
};

/// Judges the case alone, shrinks it and runs the smallest one once more. The first and the last of
/// these are drawn by a fresh subject if the options make one: what a subject remembers of other
/// draws is company as well. A case that hung is judged on the same subject, once.
///
/// An evaluation gets one time limit in all, or what the pace leaves of it after a hang. That is no
/// time to prove that a case hangs: shrinking ends after kMostHangs that took it, and what hung
/// hangs again if it has no answer then.
/// What is violated in company alone is violated if the company does it again; what broke down is,
/// whatever comes of that. Ends in time when the budget does, or if it is stopped; then the message
/// says so.
Counterexample Investigate(Subject& subject, const Property& property, const Failure& failure,
                           const CampaignOptions& options, Budget& budget);

/// Runs the case, and shrinks it by the same rules if it fails.
///
/// Returns:    what came of it: as given, and with its own outcome, if it is not violated.
Counterexample ShrinkFailing(Subject& subject, const Property& property, const Case& failing,
                             const CampaignOptions& options);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_COUNTEREXAMPLE_H_
