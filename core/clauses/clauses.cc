#include "core/clauses/clauses.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/profile.h"
#include "core/quoted.h"

namespace rasterproof {

namespace {

// "required" is the default and so is not written in the files.
constexpr std::array<std::string_view, 3> kForces{"required", "allowed", "silent"};

template <typename Row>
struct Field {
  std::string_view name;
  std::string_view Row::* text;
  bool is_required = true;
};

constexpr std::array<Field<Specification>, 4> kSpecificationFields{{
    {"api", &Specification::api},
    {"title", &Specification::title},
    {"edition", &Specification::edition},
    {"base", &Specification::base, false},
}};

constexpr std::array<Field<Clause>, 6> kClauseFields{{
    {"id", &Clause::id},
    {"place", &Clause::place},
    {"sentence", &Clause::sentence},
    {"reading", &Clause::reading},
    {"keys", &Clause::keys, false},
    {"shown_by", &Clause::shown_by, false},
}};

class ClauseReader {
 public:
  explicit ClauseReader(const ClauseFile& file) : file_(file) {}

  Specification Read() {
    std::string_view rest = file_.text;
    while (!rest.empty()) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(line.size() + 1, rest.size()));
      ++line_;
      if (!line.empty() && !line.starts_with('#')) ReadLine(line);
    }
    RequireWhole();
    return std::move(all_);
  }

 private:
  void ReadLine(std::string_view line) {
    const std::size_t colon = std::min(line.find(": "), line.size());
    const std::string_view name = line.substr(0, colon);
    const std::string_view text = line.substr(std::min(colon + 2, line.size()));
    if (text.empty()) Fail(line, "is not a field and its text", "write \"field: text\"");
    if (name == "id") BeginClause(text);
    if (all_.clauses.empty()) return Set<Specification>(all_, kSpecificationFields, name, text);
    if (name != "force" && name != "assumed") {
      return Set<Clause>(all_.clauses.back(), kClauseFields, name, text);
    }
    SetChoice(all_.clauses.back(), line);
  }

  void BeginClause(std::string_view id) {
    RequireWhole();
    if (ApiOf({.id = id}) != all_.api) {
      Fail(id, "is not of this specification", "begin the id with the file's api and a period");
    }
    if (std::ranges::find(all_.clauses, id, &Clause::id) != all_.clauses.end()) {
      Fail(id, "is the id of two clauses", "rename one");
    }
    all_.clauses.emplace_back();
  }

  template <typename Row>
  void Set(Row& row, std::span<const Field<Row>> fields, std::string_view name,
           std::string_view text) const {
    const auto field = std::ranges::find(fields, name, &Field<Row>::name);
    if (field == fields.end()) {
      Fail(name, "is no field", "write one that core/clauses/clauses.cc lists");
    }
    if (!(row.*(field->text)).empty()) Fail(name, "is given twice", "remove one");
    row.*(field->text) = text;
  }

  void SetChoice(Clause& clause, std::string_view line) const {
    if (line == "force: allowed") {
      clause.force = Force::kAllowed;
    } else if (line == "force: silent") {
      clause.force = Force::kSilent;
    } else if (line == "assumed: yes") {
      clause.is_assumed = true;
    } else {
      Fail(line, "is no choice", "write \"force: allowed\", \"force: silent\" or \"assumed: yes\"");
    }
  }

  // Of the specification, or of its last clause.
  void RequireWhole() const {
    if (all_.clauses.empty()) return RequireFields<Specification>(all_, kSpecificationFields);
    RequireFields<Clause>(all_.clauses.back(), kClauseFields);
  }

  template <typename Row>
  void RequireFields(const Row& row, std::span<const Field<Row>> fields) const {
    for (const Field<Row>& field : fields) {
      if (field.is_required && (row.*(field.text)).empty()) {
        Fail(field.name, "is missing above", "add the field");
      }
    }
  }

  [[noreturn]] void Fail(std::string_view what, const char* reason, const char* remedy) const {
    throw InputError(std::string(file_.name) + ": line " + std::to_string(line_),
                     Quoted(what) + " " + reason, remedy);
  }

  ClauseFile file_;
  Specification all_;
  int line_ = 0;
};

}  // namespace

Specification ReadSpecification(const ClauseFile& file) { return ClauseReader(file).Read(); }

std::span<const Specification> Specifications() {
  static const std::vector<Specification> all = [] {
    std::vector<Specification> read;
    for (const ClauseFile& file : ClauseFiles()) read.push_back(ReadSpecification(file));
    return read;
  }();
  return all;
}

const Specification* FindSpecification(std::string_view api) {
  const auto all = Specifications();
  const auto found = std::ranges::find(all, api, &Specification::api);
  return found != all.end() ? &*found : nullptr;
}

const Specification* SpecificationOf(std::string_view profile_name) {
  if (const Specification* named = FindSpecification(profile_name)) return named;
  const bool is_model = profile_name.ends_with("-canonical");
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
