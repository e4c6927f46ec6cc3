#include "tool/resolve_case.h"

#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/quoted.h"
#include "core/suggestion.h"
#include "fmt/format.h"
#include "io/renamed.h"
#include "props/domains/domain.h"
#include "props/run/property_domains.h"
#include "tool/session.h"

namespace rasterproof::tool {

const props::Property& RequireProperty(const std::string& name) {
  if (const props::Property* property = props::FindProperty(name)) return *property;
  std::vector<std::string> names;
  for (const props::Property& property : props::Catalog()) names.emplace_back(property.name);
  throw InputError(
      fmt::format("property '{}'", name), "there is no such property" + io::RenamedText(name),
      Suggestion(name, names) + "'rasterproof list properties' names all that there are");
}

const props::World& RequireWorld(const std::string& place, const std::string& name) {
  if (const props::World* world = props::FindWorld(name)) return *world;
  std::vector<std::string_view> names;
  for (const props::World& world : props::Worlds()) names.push_back(world.name);
  throw InputError(place, "there is no world " + Printable(name),
                   Suggestion(name, names) + "'rasterproof list worlds' names all that there are");
}

CaseName RequireCaseName(const std::string& name) {
  CaseName parsed = props::ParseCaseName(name);
  if (props::FindDomain(parsed.domain) == nullptr && props::FindWorld(parsed.domain) == nullptr) {
    std::vector<std::string> names;
    for (const props::Domain& domain : props::Domains()) names.emplace_back(domain.name);
    for (const props::World& world : props::Worlds()) names.emplace_back(world.name);
    throw InputError(
        fmt::format("case '{}'", name),
        fmt::format("there is no domain or world '{}'{}", parsed.domain,
                    io::RenamedText(parsed.domain)),
        Suggestion(parsed.domain, names) + "'rasterproof list domains' and 'list worlds' name all");
  }
  return parsed;
}

Case CaseFor(const Subject& subject, const GivenCase& given) {
  if (given.name) return props::DrawCase(subject.Info(), *given.name);
  Case c = given.value;
  c.profile = subject.Info().profile;
  RequireTakes(subject, c.scene, given.place);
  return c;
}

}  // namespace rasterproof::tool
