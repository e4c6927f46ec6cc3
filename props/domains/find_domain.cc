// Domains by name, by number, and by what a subject takes.
#include <algorithm>
#include <cstdint>
#include <string_view>

#include "props/domains/domain.h"

namespace rasterproof::props {

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
