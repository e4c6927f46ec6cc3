#include "core/clauses/clauses.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "core/profile.h"

namespace rasterproof {

// All files of core/clauses/, one after the other; core/CMakeLists.txt embeds them.
extern const char* const kClauseFiles;

namespace {

constexpr std::string_view kCanonical = "-canonical";

// "required" is the default and so is not written in the files.
constexpr std::array<std::string_view, 3> kForces{"required", "allowed", "silent"};

template <typename Row>
struct Field {
  std::string_view name;
  std::string_view Row::* text;
};

constexpr std::array<Field<Specification>, 4> kSpecificationFields{{
    {"api", &Specification::api},
    {"title", &Specification::title},
    {"edition", &Specification::edition},
    {"base", &Specification::base},
}};

constexpr std::array<Field<Clause>, 6> kClauseFields{{
    {"id", &Clause::id},
    {"place", &Clause::place},
    {"sentence", &Clause::sentence},
    {"reading", &Clause::reading},
    {"keys", &Clause::keys},
    {"shown_by", &Clause::shown_by},
}};

// Returns whether the row has a field of this name, which is then set.
template <typename Row>
bool Set(Row& row, std::span<const Field<Row>> fields, std::string_view name,
         std::string_view text) {
  const auto field = std::ranges::find(fields, name, &Field<Row>::name);
  if (field == fields.end()) return false;
  row.*(field->text) = text;
  return true;
}

bool SetChoice(Clause& clause, std::string_view name, std::string_view text) {
  if (name == "assumed") {
    clause.is_assumed = text == "yes";
    return clause.is_assumed;
  }
  const auto force = std::ranges::find(kForces, text);
  if (name != "force" || force == kForces.end()) return false;
  clause.force = static_cast<Force>(force - kForces.begin());
  return true;
}

// A line "api: ..." begins a specification, "id: ..." a clause of it.
bool ReadLine(std::string_view line, std::vector<Specification>& all) {
  const std::size_t colon = std::min(line.find(": "), line.size());
  const std::string_view name = line.substr(0, colon);
  const std::string_view text = line.substr(std::min(colon + 2, line.size()));
  if (name == "api") all.emplace_back();
  if (text.empty() || all.empty()) return false;
  std::vector<Clause>& clauses = all.back().clauses;
  if (name == "id") clauses.emplace_back();
  if (clauses.empty()) return Set<Specification>(all.back(), kSpecificationFields, name, text);
  return Set<Clause>(clauses.back(), kClauseFields, name, text) ||
         SetChoice(clauses.back(), name, text);
}

}  // namespace

std::vector<Specification> ReadSpecifications(std::string_view text) {
  std::vector<Specification> all;
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (line.empty() || line.starts_with('#') || ReadLine(line, all)) continue;
    throw InputError("core/clauses/: \"" + std::string(line) + "\"", "not a field of a clause",
                     "write one of those in core/clauses/clauses.cc, then \": \" and its text");
  }
  return all;
}

std::span<const Specification> Specifications() {
  static const std::vector<Specification> all = ReadSpecifications(kClauseFiles);
  return all;
}

const Specification* FindSpecification(std::string_view api) {
  const auto all = Specifications();
  const auto found = std::ranges::find(all, api, &Specification::api);
  return found != all.end() ? &*found : nullptr;
}

const Specification* SpecificationOf(std::string_view profile_name) {
  if (const Specification* named = FindSpecification(profile_name)) return named;
  const bool is_model = profile_name.ends_with(kCanonical);
  if (is_model || !PresetProfile(profile_name)) return nullptr;
  const Specification* longest = nullptr;
  for (const Specification& one : Specifications()) {
    if (!profile_name.starts_with(one.api)) continue;
    if (profile_name[one.api.size()] != '-') continue;
    if (longest == nullptr || one.api.size() > longest->api.size()) longest = &one;
  }
  return longest;
}

const Specification* SpecificationOf(const Profile& profile) {
  const std::string& set = profile.specification;
  return SpecificationOf(std::string_view(set.empty() ? profile.name : set));
}

std::string_view ApiOf(const Clause& clause) { return clause.id.substr(0, clause.id.find('.')); }

const Clause* FindClause(std::string_view id) {
  const Specification* specification = FindSpecification(id.substr(0, id.find('.')));
  if (specification == nullptr) return nullptr;
  const auto found = std::ranges::find(specification->clauses, id, &Clause::id);
  return found != specification->clauses.end() ? &*found : nullptr;
}

std::string_view ForceName(Force force) { return kForces[static_cast<std::size_t>(force)]; }

std::vector<ClauseKey> KeysOf(const Clause& clause) {
  constexpr std::string_view kBetween = "; ";
  std::vector<ClauseKey> keys;
  std::string_view rest = clause.keys;
  while (!rest.empty()) {
    const std::string_view one = rest.substr(0, rest.find(kBetween));
    rest.remove_prefix(one.size());
    if (!rest.empty()) rest.remove_prefix(kBetween.size());
    const std::size_t equals = one.find('=');
    const bool is_any = equals == std::string_view::npos;
    keys.push_back({one.substr(0, equals), is_any ? std::string_view() : one.substr(equals + 1)});
  }
  return keys;
}

std::vector<const Clause*> AssumptionsOf(std::string_view api) {
  const Specification* specification = FindSpecification(api);
  if (specification == nullptr) return {};
  std::vector<const Clause*> assumptions = AssumptionsOf(specification->base);
  for (const Clause& clause : specification->clauses) {
    if (clause.is_assumed) assumptions.push_back(&clause);
  }
  return assumptions;
}

}  // namespace rasterproof
