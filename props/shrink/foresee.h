// What shrinking will ask next, for answers that come in rounds.
#ifndef RASTERPROOF_PROPS_SHRINK_FORESEE_H_
#define RASTERPROOF_PROPS_SHRINK_FORESEE_H_

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

#include "core/case.h"

namespace rasterproof::props {

/// What is known of candidates so far, and who collects those that are not.
struct KnownFailures {
  /// Whether the candidate fails; nothing if it is not known. Called once for each candidate.
  std::function<std::optional<bool>(const Case&)> fails;
  /// Takes a candidate without a verdict. Returns whether there is room for more.
  std::function<bool(const Case&)> want;
};

/// Returns all that shrinking changes of a case, as bytes.
std::string BytesOf(const Case& c);

/// Goes the way that Shrink() goes, as far as it is known, and beyond: hands out the candidates
/// that Shrink() may ask about next, the likeliest first. Each possible course is followed, the
/// most probable first, until there is no room for more. How probable it is that a candidate fails
/// is estimated by the ones of its kind that are known.
///
/// Domain:     a case that fails, as for Shrink(), with the same budget.
/// Returns:    the smallest case that is known to fail on Shrink()'s way.
/// Properties: the same calls give the same candidates. If any is handed out, the first is the one
///             that Shrink() needs.
/// Cost:       a shrinking for each course, without its evaluations.
Case Foresee(const Case& failing, const KnownFailures& known, std::uint64_t budget);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_SHRINK_FORESEE_H_
