// What a subject drew of the failing cases, and of others around them.
#ifndef RASTERPROOF_PROPS_CAUSE_EVIDENCE_H_
#define RASTERPROOF_PROPS_CAUSE_EVIDENCE_H_

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/case.h"
#include "core/clock.h"
#include "core/drawing.h"
#include "core/result.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// A property that a subject violates, by the cases that show it.
struct FailedProperty {
  const Property* property = nullptr;
  std::vector<Case> cases;  ///< the shrunk one first, then the one that was drawn, if it is known
};

/// The violated property with its shrunken case and the one that was drawn; nothing if the result
/// has no counterexample, or the subject broke down on it: that needs no other cause.
std::optional<FailedProperty> FailedBy(const PropertyResult& result, const SubjectInfo& subject);

/// Some draws of one check, in their order, and what the subject answered.
struct Observation {
  static constexpr std::size_t kAround = ~std::size_t{0};

  std::size_t failure = kAround;  ///< the failed property that asked, or one of the draws around
  std::shared_ptr<const PlacedCase> placed = nullptr;
  Check check = {};                                        ///< its questions alone count
  std::vector<std::shared_ptr<const Drawing>> bases = {};  ///< what earlier checks drew
  std::vector<std::shared_ptr<const Drawing>> seen = {};
  bool is_modelled = true;  ///< suspects can draw all of it
  bool is_wrong = false;    ///< seen otherwise than the stated model draws it
  std::size_t place = 0;    ///< in the order in which they were asked
};

/// What was gathered.
struct Gathered {
  std::vector<Observation> observations;
  bool is_cut_short = false;  ///< time was up before all was asked
};

/// The clock that the subject's draws are limited by: processor time of this thread if it draws
/// here; else a quarter of the time that goes by, as a loaded machine keeps much of that from it.
inline double SecondsOfDraws(const Subject& subject) {
  constexpr double kShare = 0.25;
  return subject.SharesCalls() ? kShare * WallSeconds() : ThreadSeconds();
}

/// Gathers what the subject draws: of each failed property's cases all checks, of a case around
/// them one draw. The failing cases come first.
///
/// Domain:     failed properties of the subject.
/// Returns:    fewer observations if the subject breaks down, or after so many SecondsOfDraws.
Gathered Gather(Subject& subject, std::span<const FailedProperty> failures, double seconds);

/// Whether suspects can draw all that the observation asks, and the profile leaves none of it open.
bool IsModelled(const Observation& observation, const SubjectInfo& info);

/// What a subject drew.
using Seen = std::vector<std::shared_ptr<const Drawing>>;

/// Puts the observation's questions to another subject, and returns what it draws.
Seen DrawnBy(Subject& other, const Observation& observation);

/// Returns whether both are the same: counts, and primitive ids where both show them.
bool AreAlike(const Seen& a, const Seen& b);

/// Returns whether another subject draws what was observed.
inline bool Reproduces(Subject& suspect, const Observation& observation) {
  return AreAlike(DrawnBy(suspect, observation), observation.seen);
}

/// Whether the property asks for values beside coverage about the first of its cases: edge values,
/// barycentrics, depths.
bool AsksForValues(Subject& subject, const FailedProperty& failure);

/// The number of draws in some observations.
std::size_t DrawsOf(std::span<const Observation> observations);

/// The number of scenes that the observations begin with, each counted once, however often it is
/// drawn under the same options. Counting stops at `most`.
std::size_t ScenesOf(std::span<const Observation* const> observations,
                     std::size_t most = ~std::size_t{0});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CAUSE_EVIDENCE_H_
