// rasterproof list: what there is to choose from.
#include "tool/list/cmd_list.h"

#include <memory>
#include <optional>
#include <string>

#include "core/error.h"
#include "core/freedom.h"
#include "core/profile.h"
#include "core/profile_keys.h"
#include "core/square_presets.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/output.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"
#include "props/judging/gate.h"
#include "props/property.h"
#include "props/run/description.h"
#include "subjects/mutants/mutants.h"
#include "tool/exit_status.h"
#include "tool/list/list_clauses.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

std::string ListSubjects() {
  std::string text = "subjects\n";
  for (const std::string& name : SubjectNames()) {
    const auto subject = MakeSubject(name);
    const SubjectInfo& info = subject->Info();
    const char* space = info.takes_window && info.takes_clip ? "window, clip"
                        : info.takes_clip                    ? "clip"
                                                             : "window";
    text += fmt::format("  {:<38} {:<7} {:<12} {:<5} {}\n", name,
                        info.input == Precision::kFloat32 ? "float32" : "float64", space,
                        info.states_exact ? "exact" : "", info.summary);
  }
  return text;
}

// All properties, or those that apply to the subject by what it says of itself.
std::string ListProperties(const std::string& subject) {
  std::optional<props::Description> described;
  std::unique_ptr<Subject> made;
  if (!subject.empty()) {
    made = MakeSubject(subject);
    described = props::AsJudged(props::DescriptionOf(*made));
  }
  std::string text = "properties\n";
  for (const props::Property& property : props::Catalog()) {
    if (described && props::DoesNotApply(property.gate, *described)) continue;
    text += fmt::format("  {} ({})\n    enforces: {}\n    applies:  {}\n    limit:    {}\n",
                        property.name, property.group, property.clause,
                        props::WordsOf(property.gate), property.tolerance);
    if (!property.required_by.empty()) {
      text += fmt::format("    required: {}\n", fmt::join(property.required_by, ", "));
    }
    if (!property.required_with_error.empty()) {
      text += fmt::format("    required: {}, where the subject states its error\n",
                          fmt::join(property.required_with_error, ", "));
    }
  }
  return text;
}

std::string ListDomains() {
  std::string text = "domains\n";
  for (const props::Domain& domain : props::Domains()) {
    text += fmt::format("  {:<24} {:<10} {}\n", domain.name, domain.near_edge ? "near-edge" : "",
                        domain.summary);
  }
  return text;
}

std::string ListWorlds() {
  std::string text = "worlds\n";
  for (const props::World& world : props::Worlds()) {
    text += fmt::format("  {:<24} {:>11} cases  {}\n", world.name, world.cases, world.summary);
  }
  return text;
}

std::string RoundingText(const Profile& profile) {
  if (profile.freedom.any_rounding) return "any rounding";
  if (profile.freedom.snap_tolerance == 0) return std::string(SnapRuleName(profile.snap.rule));
  return fmt::format("within {} of a step", profile.freedom.snap_tolerance);
}

std::string GridText(const Profile& profile) {
  const auto bits = [&](const std::string& number) {
    return number + " subpixel bits, " + RoundingText(profile);
  };
  if (profile.freedom.least_bits)
    return bits(fmt::format("at least {}", *profile.freedom.least_bits));
  return profile.snap.IsNone() ? "no snap" : bits(fmt::format("{}", profile.snap.bits));
}

std::string TiesText(const Profile& profile) {
  switch (profile.freedom.ties) {
    case TieOwnership::kStated:
      return std::string(TieRuleName(profile.tie_rule));
    case TieOwnership::kAxisAligned:
      return "any consistent tie rule";
    case TieOwnership::kPerEdge:
      return "one owner for each sample of a common edge";
    case TieOwnership::kOpen:
      break;
  }
  return "ties open";
}

std::string ListProfiles() {
  std::string text = "profiles\n";
  for (const std::string_view name : kPresetProfiles) {
    const Profile profile = *PresetProfile(name);
    text += fmt::format("  {:<21} {:<9} {}, {}, coordinates up to {:a}\n", name,
                        HasOneModel(profile) ? "model" : "legal set", GridText(profile),
                        TiesText(profile), profile.coordinate_limit);
  }
  for (const SquarePresetInfo& preset : kSquarePresets) {
    text += fmt::format("  {:<21} {:<9} {} ({}){}\n", preset.name, "squares", preset.summary,
                        preset.source,
                        preset.assumed.empty() ? "" : fmt::format("; assumed: {}", preset.assumed));
  }
  return text;
}

std::string ListKeys() {
  std::string text = "profile keys\n";
  for (const ProfileKey& key : kProfileKeys) {
    const std::string_view example = key.member.example;
    text += fmt::format("  {} ({})\n    values:  {}\n{}    default: {}\n    says:    {}\n",
                        key.name, KeyKindName(key.kind), key.values,
                        example.empty() ? "" : fmt::format("    example: {}\n", example),
                        key.usual.empty() ? "none" : key.usual, key.says);
  }
  return text;
}

std::string ListMutants() {
  std::string text = "mutants and legal variants: sound rasterizers, but ...\n";
  for (const subjects::MutantInfo& mutant : subjects::Mutants()) {
    text += fmt::format("  {:<34} {}\n", mutant.name, mutant.change);
  }
  return text;
}

}  // namespace

int RunList(const ListOptions& options) {
  if (options.json && options.what != "clauses") {
    throw InputError("--json", "only clauses are listed as JSON", "write list clauses --json");
  }
  if (!options.prefix.empty() && options.what != "clauses") {
    throw InputError(options.prefix, "only clauses can be listed by prefix",
                     "write list clauses " + options.prefix + ", or leave it out");
  }
  if (!options.subject.empty() && options.what != "properties") {
    throw InputError("--subject " + options.subject, "only properties apply to a subject",
                     "write list properties --subject " + options.subject);
  }
  std::string text;
  const bool all = options.what == "all";
  if (all || options.what == "subjects") text += ListSubjects();
  if (all || options.what == "properties") text += ListProperties(options.subject);
  if (all || options.what == "domains") text += ListDomains();
  if (all || options.what == "worlds") text += ListWorlds();
  if (all || options.what == "profiles") text += ListProfiles();
  if (all || options.what == "mutants") text += ListMutants();
  if (options.what == "keys") text += ListKeys();
  if (options.what == "clauses")
    text += options.json ? ClausesToJson(options.prefix) : ListClauses(options.prefix);
  io::WriteStandardOutput(text);
  return kExitHolds;
}

}  // namespace rasterproof::tool
