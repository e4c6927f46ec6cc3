#include "props/domains/domain.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

namespace rasterproof::props {

// The build makes these of the rows in recipes_*.cc.
extern const Domain* const kAllDomains[];
extern const std::size_t kNumberOfDomains;

std::span<const Domain> Domains() {
  static const std::vector<Domain> all = [] {
    std::vector<Domain> domains;
    for (std::size_t k = 0; k < kNumberOfDomains; ++k) domains.push_back(*kAllDomains[k]);
    std::ranges::sort(domains, {}, &Domain::listed);
    return domains;
  }();
  return all;
}

const Domain* FindDomain(std::string_view name) {
  const auto found = std::ranges::find(Domains(), name, &Domain::name);
  return found == Domains().end() ? nullptr : &*found;
}

const Domain* DomainOfNumber(std::uint16_t number) {
  const auto found = std::ranges::find(Domains(), number, &Domain::number);
  return found == Domains().end() ? nullptr : &*found;
}

bool Suits(const Domain& domain, const SubjectInfo& info) {
  if (domain.is_stated != nullptr && !domain.is_stated(info.profile)) return false;
  if (info.profile.fixed && domain.non_finite) return false;
  // A transform of its own says nothing of what lies behind the eye; that of a map takes none.
  if (info.profile.transform && (info.takes_clip || info.profile.transform->map))
    return !domain.clip;
  if (!PlacesClipSpace(info.profile) || StatesGuardBand(info.profile)) {
    return !domain.clip && info.takes_window;
  }
  return domain.clip ? info.takes_clip : info.takes_window || info.takes_clip;
}

}  // namespace rasterproof::props
