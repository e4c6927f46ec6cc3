// Samples that two calls with one triangle may show differently.
#ifndef RASTERPROOF_PROPS_JUDGING_OPEN_BY_CALL_H_
#define RASTERPROOF_PROPS_JUDGING_OPEN_BY_CALL_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "props/placed_case.h"

namespace rasterproof::props {

/// Whether every call may be of another legal model: the profile is a specification's, which does
/// not say that equal draws are equal.
bool MayChooseByCall(const Profile& profile);

/// Where two calls may differ, so that properties that compare calls do not look there.
class OpenByCall {
 public:
  /// Nowhere.
  OpenByCall() = default;
  /// At the samples that legal models of the case decide differently.
  ///
  /// Domain:     legal::WhyNotJoint has nothing to say against the case.
  explicit OpenByCall(const PlacedCase& c);

  /// The expected count; there, the observed one.
  CoverageCounts Expected(const CoverageCounts& observed, CoverageCounts expected) const;
  std::vector<std::int32_t> Expected(const std::vector<std::int32_t>& observed,
                                     std::vector<std::int32_t> expected) const;
  /// The decisions without those there.
  std::uint64_t Judged(std::uint64_t decisions) const {
    return decisions - std::min(decisions, size_);
  }

 private:
  std::vector<bool> open_;
  std::uint64_t size_ = 0;
};

/// Where calls with triangles of the case may differ, or nowhere if they may not.
///
/// Returns:    nothing if they may, and it is not known where.
std::optional<OpenByCall> WhereCallsMayDiffer(const PlacedCase& c, bool they_may);
inline constexpr const char* kPlacesNotKnown =
    "calls may differ where legal models do, for the profile does not state where vertices lie";

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_OPEN_BY_CALL_H_
