// Runs a property on a subject over many cases of its domains.
#ifndef RASTERPROOF_PROPS_RUN_CAMPAIGN_H_
#define RASTERPROOF_PROPS_RUN_CAMPAIGN_H_

#include <cstdint>
#include <functional>

#include "core/result.h"
#include "core/subject.h"
#include "props/property.h"

namespace rasterproof::props {

inline constexpr std::uint64_t kDefaultSeed = 1;
inline constexpr std::uint64_t kDefaultCases = 1000;

struct CampaignOptions {
  std::uint64_t seed = kDefaultSeed;
  /// Cases in all, spread evenly over the property's domains: case i is domain i % n, Philox(seed,
  /// i).
  std::uint64_t cases = kDefaultCases;
  std::uint64_t first_case = 0;        ///< for shards and replays
  double seconds = 0;                  ///< stop after this long; 0: no limit
  std::uint64_t shrink_budget = 2000;  ///< evaluations; a minute at most
  /// Called now and then with the number of cases done. May be empty.
  std::function<void(std::uint64_t)> progress;
};

/// Returns what was found. Stops at the first violation and shrinks it.
///
/// A run in which no case put the claim to the test is kNotExercised, never kHolds; a property that
/// does not apply to the subject is kNotApplicable. Domains that the subject cannot take are left
/// out and named in the message. A near-edge domain that gave no sample on or within 256 lattice
/// steps of an edge in all its cases (four at least) makes the run kNotExercised as well: a dead
/// generator is not a pass.
PropertyResult RunCampaign(Subject& subject, const Property& property,
                           const CampaignOptions& options = {});

/// The case that RunCampaign would run as number `index`.
///
/// Error:      InputError if the subject takes scenes of none of the property's domains.
Case DrawCase(const SubjectInfo& info, const Property& property, std::uint64_t seed,
              std::uint64_t index);

/// Runs one property on one given case (replay, saved failures, worst-case files).
///
/// Returns:    what the property says; kViolated if the subject threw; kNotApplicable if the
///             subject or the oracle refused the scene by an InputError.
Verdict RunCase(Subject& subject, const Property& property, const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_CAMPAIGN_H_
