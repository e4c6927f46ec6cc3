#include "tool/resolve.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/clauses/clauses.h"
#include "core/error.h"
#include "core/float_environment.h"
#include "core/profile_keys.h"
#include "core/quoted.h"
#include "core/square_presets.h"
#include "core/suggestion.h"
#include "exact/coverage.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/renamed.h"
#include "tool/progress.h"
#include "tool/shared_files.h"

namespace rasterproof::tool {
namespace {

constexpr std::array<std::pair<std::string_view, exact::Decider>, 3> kOracles{{
    {"exact", exact::Decider::kFast},
    {"exact-integers", exact::Decider::kIntegers},
    {"exact-cgal", exact::Decider::kCgal},
}};

// The oracle in the place of a subject, so that it can be compared with any other and with itself.
class OracleSubject final : public Subject {
 public:
  OracleSubject(std::string_view name, exact::Decider decider, const Profile& profile)
      : decider_(decider) {
    info_.name = name;
    info_.profile = profile;
    info_.summary = "the oracle, decided by " + std::string(exact::DeciderName(decider));
    info_.input = Precision::kFloat64;
    info_.takes_clip = true;
    info_.states_exact = true;
  }
  const SubjectInfo& OwnInfo() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    const FloatEnvironment sane;
    counts += exact::Coverage(scene, info_.profile, options, decider_);
  }

 private:
  SubjectInfo info_;
  exact::Decider decider_;
};

}  // namespace

void JudgeBy(const Profile& profile, Subject& subject) {
  SubjectInfo info = subject.Info();
  // The subject's statements are about its own profile.
  info.states_exact = info.states_exact && SameModel(info.profile, profile);
  // The judging profile does not change what the subject can be given.
  const std::optional<FixedInput> fixed = info.profile.fixed;
  info.profile = profile;
  if (!profile.fixed) info.profile.fixed = fixed;
  info.profile.name = io::ProfileName(info.profile);
  subject.JudgeAs(std::move(info));
}

namespace {

// The set with the numbers that the subject states of its device.
Profile ReportedBy(const Subject& subject, const Profile& set) {
  const SubjectInfo& info = subject.Info();
  Profile filled = FilledIn(set, info.profile);
  if (!filled.guard_band) filled.guard_band = set.guard_band;  // it says nothing of clipping
  if (filled == set) return set;
  filled.specification = set.name;
  filled.name = set.name + " of " + info.name;
  if (IsFilledIn(filled)) return filled;
  throw InputError(fmt::format("subject '{}'", info.name),
                   fmt::format("it states {} subpixel bits, and {} asks for {}",
                               filled.freedom.least_bits.value_or(filled.snap.bits), set.name,
                               set.freedom.least_bits.value_or(filled.snap.bits)),
                   "judge it without --device");
}

// A device's numbers can be put into a specification's legal set alone.
void RequireLegalSet(const std::optional<Profile>& profile) {
  const bool is_preset = profile && PresetProfile(profile->name) == *profile;
  if (is_preset && SpecificationOf(*profile) != nullptr) return;
  throw InputError("option --device",
                   profile
                       ? fmt::format("profile {} is not a specification's legal set", profile->name)
                       : "no profile is given for the device's numbers",
                   "give --profile d3d11, vulkan, gl or webgpu");
}

// What makes the subject of that name, as often as it is called; nothing if there is none.
SubjectMaker MakerOf(const std::string& name, const Profile& of_oracle) {
  SubjectMaker make;
  if (IsOracle(name)) {
    MakeOracle(name, of_oracle);  // throws if it can't decide by this profile
    make = [name, of_oracle] { return MakeOracle(name, of_oracle); };
  } else if (const SubjectKind* kind = BuiltInKind(name)) {
    make = [name, kind] { return kind->make(name); };
  }
  if (!make) return Kinds().outside == nullptr ? SubjectMaker() : Kinds().outside(name);
  if (!IsOwn(name)) return make;
  throw InputError(fmt::format("subject '{}'", name),
                   "a type of your own has the name of one of rasterproof's subjects",
                   "rename the type");
}

}  // namespace

bool IsOurs(const std::string& name) {
  return IsOracle(name) || BuiltInKind(name) != nullptr || IsOwn(name);
}

bool IsOracle(std::string_view name) {
  return std::ranges::find(kOracles, name, [](const auto& o) { return o.first; }) != kOracles.end();
}

std::vector<std::string> SubjectNames() {
  std::vector<std::string> names = BuiltInNames();
  for (const auto& oracle : kOracles) names.emplace_back(oracle.first);
  for (const std::string& own : OwnNames()) names.push_back(own);
  return names;
}

void NotePreset(const Profile& profile) {
  static std::set<std::string> said;
  for (const SquarePresetInfo& preset : kSquarePresets) {
    if (preset.name != profile.name || PresetProfile(profile.name) != profile) continue;
    if (preset.assumed.empty() || !said.insert(profile.name).second) return;
    Tell(fmt::format("note: profile {} follows {}; assumed: {}\n", profile.name, preset.source,
                     preset.assumed));
  }
  if (!IsCanonicalPreset(profile.name) || PresetProfile(profile.name) != profile) return;
  if (!said.insert(profile.name).second) return;
  Tell(
      fmt::format("note: profile {} is only one of the API's legal models ({} subpixel bits, {}, "
                  "{}); profile {} allows all\n",
                  profile.name, profile.snap.bits, SnapRuleName(profile.snap.rule),
                  TieRuleName(profile.tie_rule), profile.name.substr(0, profile.name.find('-'))));
}

void RequireSamples(const SubjectInfo& info) {
  if (!info.profile.squares) return;
  throw InputError(
      fmt::format("subject '{}'", info.name),
      fmt::format("its profile {} is about whole pixels, not samples", info.profile.name),
      "judge it by rasterproof check, or state a profile of samples by --profile");
}

std::unique_ptr<Subject> MakeOracle(std::string_view name, const Profile& profile) {
  for (const auto& [oracle, decider] : kOracles) {
    if (name != oracle) continue;
    if (decider != exact::Decider::kFast && !profile.scanline_rounding.IsNone()) {
      throw InputError(
          fmt::format("subject '{}'", name),
          fmt::format("it does not decide the rounded crossings of profile {}", profile.name),
          "use --subject exact, or a profile without scanline_rounding");
    }
    return std::make_unique<OracleSubject>(name, decider, profile);
  }
  return nullptr;
}

SubjectFactory ResolveSubject(const std::string& name, const std::string& profile, bool device,
                              std::size_t list_length, SubjectMaker make) {
  const std::optional<Profile> by =
      profile.empty() ? std::nullopt : std::optional(io::ReadProfile(profile));
  if (device) RequireLegalSet(by);
  if (!make) make = MakerOf(name, by.value_or(Profile{}));
  if (!make) {
    throw InputError(
        fmt::format("subject '{}'", name), "there is no such subject",
        name.ends_with(".so")
            ? fmt::format("a library is given as --plugin {}", name)
            : fmt::format("{}give plugin:PATH, exec:COMMAND, FILE.subject, or choose one of{}",
                          Suggestion(name, SubjectNames()), ListedNames(SubjectNames())));
  }
  if (list_length != 0) {
    make = [make = std::move(make), list_length] {
      std::unique_ptr<Subject> subject = make();
      SubjectInfo info = subject->Info();
      info.list_length = list_length;
      subject->JudgeAs(std::move(info));
      return subject;
    };
  }
  if (!by || IsOracle(name)) return {name, std::move(make)};
  return {name, [make = std::move(make), profile = *by, device] {
            std::unique_ptr<Subject> subject = make();
            JudgeBy(device ? ReportedBy(*subject, profile) : profile, *subject);
            return subject;
          }};
}

std::unique_ptr<Subject> MakeSubject(const std::string& name, const std::string& profile,
                                     std::size_t list_length) {
  return ResolveSubject(name, profile, /*device=*/false, list_length).Make();
}

}  // namespace rasterproof::tool
