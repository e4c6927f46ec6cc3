#include "props/judging/open_by_call.h"

#include <algorithm>
#include <string_view>

#include "core/clauses/clauses.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"

namespace rasterproof::props {

bool MayChooseByCall(const Profile& profile) {
  const Specification* const of = SpecificationOf(profile);
  if (of == nullptr) return false;
  return std::ranges::none_of(kRepeatableClauses, [&](std::string_view id) {
    const Clause* const clause = FindClause(id);
    return clause != nullptr && (ApiOf(*clause) == of->api || ApiOf(*clause) == of->base);
  });
}

OpenByCall::OpenByCall(const PlacedCase& c) : open_(legal::OpenOfSomeTriangle(c.scene, c.profile)) {
  size_ = static_cast<std::uint64_t>(std::ranges::count(open_, true));
}

CoverageCounts OpenByCall::Expected(const CoverageCounts& observed, CoverageCounts expected) const {
  for (std::size_t s = 0; s < open_.size(); ++s) {
    if (!open_[s]) continue;
    expected.front[s] = observed.front[s];
    expected.back[s] = observed.back[s];
  }
  return expected;
}

std::vector<std::int32_t> OpenByCall::Expected(const std::vector<std::int32_t>& observed,
                                               std::vector<std::int32_t> expected) const {
  for (std::size_t s = 0; s < open_.size(); ++s) {
    if (open_[s]) expected[s] = observed[s];
  }
  return expected;
}

std::optional<OpenByCall> WhereCallsMayDiffer(const PlacedCase& c, bool they_may) {
  if (!they_may) return OpenByCall();
  if (legal::WhyNotJoint(c.scene, c.profile)) return std::nullopt;
  return OpenByCall(c);
}

}  // namespace rasterproof::props
