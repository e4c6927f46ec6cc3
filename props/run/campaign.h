// Runs a property on a subject over many cases of its domains.
#ifndef RASTERPROOF_PROPS_RUN_CAMPAIGN_H_
#define RASTERPROOF_PROPS_RUN_CAMPAIGN_H_

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

#include "core/case.h"
#include "core/result.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "props/domains/worlds.h"
#include "props/property.h"
#include "props/run/campaign_options.h"

namespace rasterproof::props {

/// Returns what was found. Stops at the first violation and shrinks it.
///
/// kHolds         some case put the property to the test, and none failed.
/// kNotExercised  none did. Also if a near-edge domain gave no sample on or within 256 lattice
///                steps of an edge in all its cases (four at least): a dead generator is no pass.
/// kNotApplicable the property does not apply to the subject, as its gate says before any case is
///                drawn, or to none of the cases. Domains that the subject can't take are left out
///                and named in the message. Also if the subject can't be given the world.
/// kInconclusive  a case was too slow to judge; the counterexample does not fail again, and then
///                the message has both answers; the subject refused more cases than put
///                the property to the test, or all that were drawn for one place (case_places.h);
///                nothing hard was reached, or the subject changed its front or its grid between
///                cases (Conclude); or the run was stopped. The message says which, and what was
///                exercised so far.
///
/// Error:      JudgingFault; SubjectDoesNotRun.
PropertyResult RunCampaign(Subject& subject, const Property& property,
                           const CampaignOptions& options = {});

/// The case that RunCampaign would run as number `number`, counted from 0.
///
/// Error:      InputError if the subject takes scenes of none of the property's domains.
Case DrawCase(const SubjectInfo& info, const Property& property, std::uint64_t seed,
              std::uint64_t number);

/// Runs one property on one given case (replay, saved failures, worst-case files).
///
/// Returns:    the verdict of TryCase(); a violation names the triangle that causes it, where a
///             single one is known to.
Verdict RunCase(Subject& subject, const Property& property, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_CAMPAIGN_H_
