// Searches for cases in which a result is as wrong as it gets: the largest error over its bound.
#ifndef RASTERPROOF_LAB_CLIMB_CLIMB_H_
#define RASTERPROOF_LAB_CLIMB_CLIMB_H_

#include <cstdint>
#include <functional>
#include <optional>

#include "core/case.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/property.h"

namespace rasterproof::lab {

struct ClimbOptions {
  std::uint64_t seed = 1;
  std::uint64_t evaluations = 20'000;
  /// A case that it sets out from as well, one that the subject takes.
  std::optional<Case> from = {};
  /// Called now and then with the number of evaluations. May be empty.
  std::function<void(std::uint64_t)> progress = {};
  /// Asked between evaluations: true ends the search. May be empty.
  std::function<bool()> stop = {};
};

/// What a search ended with.
struct Climbed {
  /// The case of the largest error / bound; nothing if none had an error. Or the one that violated
  /// the property, with which the search ends.
  std::optional<Case> best;
  Verdict verdict;         ///< of `best`
  double drawn_ratio = 0;  ///< the largest error / bound of the drawn cases that it set out from
  std::uint64_t evaluations = 0;
};

/// Climbs from drawn cases by changes of single coordinates' bits: steps of ulps, flipped bits,
/// powers of two, another vertex's coordinate; what is at least as wrong as the least wrong one
/// kept takes its place. The same seed gives the same result.
///
/// Domain:     a property with a bound: verdicts of others have no error, and nothing is found.
/// Error:      InputError if the subject takes scenes of none of the property's domains;
///             JudgingFault.
Climbed ClimbRatio(Subject& subject, const props::Property& property, const ClimbOptions& options);

}  // namespace rasterproof::lab

#endif  // RASTERPROOF_LAB_CLIMB_CLIMB_H_
