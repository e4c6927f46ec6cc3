#include "tool/list/list_clauses.h"

#include <algorithm>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/clauses/clauses.h"
#include "core/error.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/json_writer.h"
#include "props/property.h"

namespace rasterproof::tool {
namespace {

std::vector<std::string_view> EnforcedBy(const Clause& clause) {
  std::vector<std::string_view> names;
  for (const props::Property& property : props::Catalog()) {
    if (std::ranges::count(property.required_by, clause.id) != 0 ||
        std::ranges::count(property.required_with_error, clause.id) != 0) {
      names.push_back(property.name);
    }
  }
  return names;
}

std::string LinesOf(const Clause& clause) {
  std::string text =
      fmt::format("  {} ({}; {}{})\n    says:     {}\n    read as:  {}\n", clause.id, clause.place,
                  ForceName(clause.force), clause.is_assumed ? ", assumed" : "", clause.sentence,
                  clause.reading);
  if (!clause.keys.empty()) text += fmt::format("    keys:     {}\n", clause.keys);
  const auto names = EnforcedBy(clause);
  if (!names.empty()) text += fmt::format("    enforced: {}\n", fmt::join(names, ", "));
  if (!clause.shown_by.empty()) text += fmt::format("    shown by: {}\n", clause.shown_by);
  return text;
}

void WriteClause(io::JsonWriter& json, const Clause& clause) {
  json.BeginObject();
  json.Key("id").Text(clause.id);
  json.Key("place").Text(clause.place);
  json.Key("force").Text(ForceName(clause.force));
  json.Key("assumed").Bool(clause.is_assumed);
  json.Key("sentence").Text(clause.sentence);
  json.Key("reading").Text(clause.reading);
  json.Key("keys").BeginArray();
  for (const ClauseKey& key : KeysOf(clause)) {
    json.BeginObject();
    json.Key("key").Text(key.key);
    json.Key("value").Text(key.value);
    json.EndObject();
  }
  json.EndArray();
  json.Key("enforced_by").BeginArray();
  for (const std::string_view name : EnforcedBy(clause)) json.Text(name);
  json.EndArray();
  json.Key("shown_by").Text(clause.shown_by);
  json.EndObject();
}

std::vector<Specification> SpecificationsWith(std::string_view prefix) {
  std::vector<Specification> found;
  std::vector<std::string_view> apis;
  for (const Specification& one : Specifications()) {
    apis.push_back(one.api);
    Specification part = one;
    if (!one.title.starts_with(prefix)) {
      std::erase_if(part.clauses,
                    [&](const Clause& clause) { return !clause.id.starts_with(prefix); });
    }
    if (!part.clauses.empty() || prefix.empty()) found.push_back(std::move(part));
  }
  if (found.empty()) {
    throw InputError("list clauses " + std::string(prefix), "no clause has this prefix",
                     fmt::format("clauses begin with {}", fmt::join(apis, ", ")));
  }
  return found;
}

}  // namespace

std::string ListClauses(std::string_view prefix) {
  std::string text;
  for (const Specification& one : SpecificationsWith(prefix)) {
    text += fmt::format("{}\n  as read: {}\n", one.title, one.edition);
    for (const Clause& clause : one.clauses) text += LinesOf(clause);
  }
  return text;
}

std::string ClausesToJson(std::string_view prefix) {
  io::JsonWriter json;
  json.BeginArray();
  for (const Specification& one : SpecificationsWith(prefix)) {
    json.BeginObject();
    json.Key("api").Text(one.api);
    json.Key("title").Text(one.title);
    json.Key("edition").Text(one.edition);
    json.Key("base").Text(one.base);
    json.Key("clauses").BeginArray();
    for (const Clause& clause : one.clauses) WriteClause(json, clause);
    json.EndArray();
    json.EndObject();
  }
  json.EndArray();
  return json.Finish();
}

}  // namespace rasterproof::tool
