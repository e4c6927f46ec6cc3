// rasterproof list: what there is to choose from.
#include <string>

#include "core/profile.h"
#include "fmt/format.h"
#include "io/output.h"
#include "props/domains/domain.h"
#include "props/property.h"
#include "subjects/mutants/mutants.h"
#include "tool/asked.h"
#include "tool/commands.h"
#include "tool/session.h"

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

std::string ListProperties() {
  std::string text = "properties\n";
  for (const props::Property& property : props::Catalog()) {
    text += fmt::format("  {} ({})\n    enforces: {}\n    applies:  {}\n    limit:    {}\n",
                        property.name, property.group, property.clause,
                        props::WordsOf(property.gate), property.tolerance);
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

std::string ListProfiles() {
  std::string text = "profiles\n";
  for (const std::string_view name : kPresetProfiles) {
    const Profile profile = *PresetProfile(name);
    const std::string snap = profile.snap.IsNone()
                                 ? "no snap"
                                 : fmt::format("{} subpixel bits, {}", profile.snap.bits,
                                               SnapRuleName(profile.snap.rule));
    text += fmt::format("  {:<10} {}, {}, coordinates up to {:a}\n", name, snap,
                        TieRuleName(profile.tie_rule), profile.coordinate_limit);
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
  std::string text;
  const bool all = options.what == "all";
  if (all || options.what == "subjects") text += ListSubjects();
  if (all || options.what == "properties") text += ListProperties();
  if (all || options.what == "domains") text += ListDomains();
  if (all || options.what == "profiles") text += ListProfiles();
  if (all || options.what == "mutants") text += ListMutants();
  io::WriteStandardOutput(text);
  return kExitHolds;
}

}  // namespace rasterproof::tool
