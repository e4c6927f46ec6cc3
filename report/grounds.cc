#include "report/grounds.h"

#include <string>
#include <string_view>
#include <vector>

#include "core/clauses/clauses.h"
#include "fmt/format.h"
#include "fmt/ranges.h"

namespace rasterproof::report {

std::string AuthorityText(const PropertyResult& result) {
  switch (result.authority) {
    case Authority::kClause:
      return fmt::format("required by {}", fmt::join(result.required_by, ", "));
    case Authority::kStatedModel:
      return "by the stated model";
    case Authority::kQuality:
      break;
  }
  return "quality: no clause requires it";
}

std::vector<Evidence> AssumptionsUnder(const Profile& profile) {
  const Specification* specification = SpecificationOf(profile);
  if (specification == nullptr) return {};
  std::vector<Evidence> list;
  for (const Clause* clause : AssumptionsOf(specification->api)) {
    list.push_back({std::string(clause->id), std::string(clause->reading)});
  }
  return list;
}

std::string AssumptionLines(const Profile& profile) {
  std::string lines;
  for (const Evidence& one : AssumptionsUnder(profile)) {
    lines += fmt::format("{:<16} {}: {}\n", "assumed", one.statement, one.by);
  }
  return lines;
}

std::string NotAskedText(const std::vector<Evidence>& list) {
  std::string text;
  for (const Evidence& one : list) {
    text += (text.empty() ? "" : "; ") + one.statement;
    if (!one.by.empty()) text += " (" + one.by + ")";
  }
  return text;
}

void WriteEvidence(io::JsonWriter& json, std::string_view key, const std::vector<Evidence>& list) {
  json.Key(key).BeginArray();
  for (const Evidence& evidence : list) {
    json.BeginObject();
    json.Key("statement").Text(evidence.statement);
    json.Key("by").Text(evidence.by);
    json.EndObject();
  }
  json.EndArray();
}

}  // namespace rasterproof::report
