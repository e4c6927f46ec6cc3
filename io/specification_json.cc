#include "io/specification_json.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

#include "core/clauses/clauses.h"
#include "core/profile_keys.h"
#include "core/quoted.h"

namespace rasterproof::io {
namespace {

// The first key by which two different profiles say different things.
std::string FirstDifference(const Profile& a, const Profile& b) {
  const ProfileKey& key = *std::ranges::find_if(kProfileKeys, [&](const ProfileKey& one) {
    Profile alike = a;
    one.member.copy(b, alike);
    return alike != a;
  });
  return Quoted(key.name);
}

}  // namespace

Profile BeginningOf(const JsonValue& value) {
  const std::optional<JsonValue> named = value.Find("specification");
  if (!named) return {};
  std::optional<Profile> set = PresetProfile(named->RequireString());
  if (!set || SpecificationOf(*set) == nullptr) {
    throw named->Error(Quoted(named->text()) + " is not a specification's legal set",
                       "write d3d11, vulkan, gl or webgpu");
  }
  set->specification = set->name;
  // A number of bits that is stated is the one there is.
  if (value.Find("subpixel_bits")) set->freedom.least_bits.reset();
  return *std::move(set);
}

void RequireWithinItsSpecification(const JsonValue& value, const Profile& profile) {
  if (profile.specification.empty() || IsFilledIn(profile)) return;
  Profile filled = FilledIn(*PresetProfile(profile.specification), profile);
  filled.name = profile.name;
  filled.specification = profile.specification;
  const bool has_too_few_bits = filled == profile;
  const std::string key = has_too_few_bits ? "\"subpixel_bits\"" : FirstDifference(profile, filled);
  throw value.Get("specification")
      .Error(Quoted(profile.specification) + " does not leave this " + key + " to a device",
             has_too_few_bits ? "write no fewer than the specification asks for"
                              : "leave that key out, or \"specification\"");
}

}  // namespace rasterproof::io
