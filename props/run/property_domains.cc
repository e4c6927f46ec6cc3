#include "props/run/property_domains.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/hash_text.h"
#include "props/run/own_transform.h"

namespace rasterproof::props {
namespace {

const Domain* SuitableDomain(std::string_view name, const SubjectInfo& info) {
  const Domain* domain = FindDomain(name);
  return domain != nullptr && Suits(*domain, info) ? domain : nullptr;
}

Case DrawWorldCase(const SubjectInfo& info, const World& world, const CaseName& name) {
  const std::string place = "case '" + ToText(name) + "'";
  if (name.index >= world.cases || name.seed != 0) {
    const std::string last = ToText(NameOfCase(world, world.cases - 1));
    throw InputError(place, "the world " + name.domain + " has no such case",
                     "its cases are " + ToText(NameOfCase(world, 0)) + " to " + last);
  }
  const std::string why = WhyNotGiven(world, info);
  if (!why.empty()) {
    throw InputError(place, "subject " + info.name + " can't take it: " + why,
                     "choose another subject");
  }
  Case c = CaseOfWorld(world, name.index, info);
  c.origin = ToText(name);
  c.name = name;
  return c;
}

}  // namespace

std::vector<const Domain*> DomainsFor(const SubjectInfo& info, const Property& property) {
  std::vector<const Domain*> domains;
  for (const std::string_view name : property.domains) {
    const Domain* domain = SuitableDomain(name, info);
    if (domain == nullptr) continue;
    domains.insert(domains.end(),
                   OwnsTransform(info) ? domain->in_a_round_behind_transforms : domain->in_a_round,
                   domain);
  }
  return domains;
}

std::string LeftOutDomains(const SubjectInfo& info, const Property& property) {
  std::string left_out;
  for (const std::string_view name : property.domains) {
    const Domain* domain = FindDomain(name);
    if (domain == nullptr || Suits(*domain, info)) continue;
    // What the profile does not state is no scene that the subject could not take.
    if (domain->is_stated != nullptr && !domain->is_stated(info.profile)) continue;
    left_out +=
        left_out.empty() ? "domains skipped, since the subject takes no such scenes: " : ", ";
    left_out += name;
  }
  return left_out;
}

std::uint64_t FirstIndex(std::string_view property) {
  constexpr std::uint64_t kWindows = 10'000;
  constexpr std::uint64_t kWindow = 1000;
  return Fnv1a(property) % kWindows * kWindow;
}

CaseName NameOfCase(const World& world, std::uint64_t index) {
  return {std::string(world.name), index, 0};
}

CaseName NameOfCase(const std::vector<const Domain*>& domains, std::uint64_t first,
                    std::uint64_t seed, std::uint64_t number) {
  const std::uint64_t round = number / domains.size();
  const auto place = domains.begin() + static_cast<std::ptrdiff_t>(number % domains.size());
  const auto times = static_cast<std::uint64_t>(std::ranges::count(domains, *place));
  const auto before = static_cast<std::uint64_t>(std::count(domains.begin(), place, *place));
  return {std::string((*place)->name), first + round * times + before, seed};
}

Case DrawCase(const SubjectInfo& info, const CaseName& name) {
  if (const World* world = FindWorld(name.domain)) return DrawWorldCase(info, *world, name);
  const std::string text = ToText(name);
  const Domain* domain = FindDomain(name.domain);
  if (domain == nullptr) {
    throw InputError("case '" + text + "'", "there is no domain or world " + name.domain,
                     "'rasterproof list domains' and 'list worlds' name all that there are");
  }
  if (!Suits(*domain, info)) {
    throw InputError("case '" + text + "'",
                     "subject " + info.name + " takes no scenes of domain " + name.domain +
                         ", or its profile does not state what they are about",
                     "choose another domain, subject or profile");
  }
  PhiloxSource bits(name.seed, name.index, domain->number);
  Case c = DrawNamed(*domain, bits, info);
  c.origin = text;
  c.name = name;
  return c;
}

Case DrawNamed(const Domain& domain, BitSource& bits, const SubjectInfo& info) {
  Case c = PutBehindTransform(domain.draw(bits, AsSeenByRecipes(info)), info, bits);
  c.scene.name = domain.name;
  return c;
}

}  // namespace rasterproof::props
