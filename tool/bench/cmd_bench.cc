// rasterproof bench: error against run time, every method from the same inputs in one run.
#include "tool/bench/cmd_bench.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/bench.h"
#include "bench/contender.h"
#include "bench/cost_curve.h"
#include "bench/family.h"
#include "bench/fingerprint.h"
#include "bench/limits.h"
#include "bench/parameter.h"
#include "bench/scene_drawer.h"
#include "bench/stages.h"
#include "core/bench_result.h"
#include "core/clock.h"
#include "core/error.h"
#include "exact/environment.h"
#include "fmt/chrono.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "io/scene_set.h"
#include "library/kernels/kernel.h"
#include "report/bench_changes.h"
#include "report/bench_json.h"
#include "report/bench_svg.h"
#include "report/bench_text.h"
#include "report/value_text.h"
#include "subjects/plugin/plugin.h"
#include "tool/bench/fingerprints.h"
#include "tool/bench/limits.h"
#include "tool/bench/values.h"
#include "tool/commit.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/outside.h"
#include "tool/progress.h"
#include "tool/scene_source.h"
#include "tool/shared_files.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {
namespace {

namespace kernels = library::kernels;

// Below this, families are small and kernels draw by the machine's best vectors.
constexpr double kFullFrom = 180;
constexpr double kAllRivalsFrom = 120;  // below this, few rivals draw

std::string ProcessorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    const std::size_t colon = line.find(": ");
    if (line.starts_with("model name") && colon != std::string::npos) return line.substr(colon + 2);
  }
  return "unknown processor";
}

BenchSetting SettingOf(const BenchOptions& options) {
  const exact::Environment environment = exact::InspectEnvironment();
  BenchSetting setting;
  setting.processor =
      fmt::format("{}, {} processors", ProcessorName(), sysconf(_SC_NPROCESSORS_ONLN));
  setting.compiler = environment.compiler;
  setting.flags = environment.flags;
  setting.commit = kCommit;
  setting.command = options.command;
  setting.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::now()));
  setting.seed = options.seed;
  setting.is_quick = options.budget < kFullFrom;
  return setting;
}

// What a library's compiler was told, from the options that it leaves in debug information or by
// -frecord-gcc-switches. Empty if the file does not tell.
std::string MarchOf(const std::string& file) {
  constexpr std::string_view kOption = "-march=";
  const std::string bytes = io::ReadFile(file);
  const std::size_t at = bytes.find(kOption);
  if (at == std::string::npos) return "";
  const std::size_t from = at + kOption.size();
  const std::size_t end = bytes.find_first_not_of(
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-+._", from);
  return bytes.substr(from, std::min(end, bytes.size()) - from);
}

std::optional<kernels::Target> TargetOf(const std::string& name) {
  if (name.empty()) return std::nullopt;
  std::vector<std::string_view> known;
  for (const kernels::Target target : kernels::SupportedTargets()) {
    if (NameOf(target) == name) return target;
    known.push_back(NameOf(target));
  }
  throw InputError("--target " + name, "this machine has no such instruction set",
                   fmt::format("choose of {}", fmt::join(known, ", ")));
}

bench::FamilyInput FromFile(const std::string& path, const BenchOptions& options) {
  SceneOptions scene_options;
  scene_options.path = path;
  scene_options.width = options.width;
  scene_options.height = options.height;
  Scene scene = LoadScene(scene_options);
  scene.name = std::filesystem::path(path).stem().string();
  return bench::FamilyOf(std::move(scene), "The scene " + path);
}

// The real scenes of the set that lies beside the command, as families.
std::vector<io::SceneEntry> RealScenes() {
  std::vector<io::SceneEntry> entries;
  if (const auto set = FindShared(kSceneSet)) entries = io::ReadSceneSet(*set);
  std::erase_if(entries, [](const io::SceneEntry& entry) { return !entry.real; });
  return entries;
}

// Nothing, and a word of it, where nobody asked for it and its file is not there: a mesh comes with
// another package.
std::optional<bench::FamilyInput> FromSet(const io::SceneEntry& entry, bool is_asked) {
  if (!is_asked && !std::filesystem::exists(entry.path)) {
    fmt::print(stderr, "rasterproof: family {} left out: no file {}\n", entry.name, entry.path);
    return std::nullopt;
  }
  Scene scene = LoadScene({entry.path, entry.camera, entry.project, entry.width, entry.height});
  scene.name = entry.name;
  return bench::FamilyOf(std::move(scene), entry.summary);
}

std::vector<bench::FamilyInput> FamiliesOf(const BenchOptions& options) {
  std::vector<bench::FamilyInput> families;
  const auto size =
      options.budget < kFullFrom ? bench::FamilySize::kQuick : bench::FamilySize::kHalf;
  const bool all = options.families.empty() && options.scenes.empty();
  std::vector<std::string> known;
  for (const bench::FamilyKind& kind : bench::FamilyKinds()) {
    known.emplace_back(kind.name);
    if (!all && std::ranges::find(options.families, kind.name) == options.families.end()) continue;
    families.push_back(bench::MakeFamily(kind, size, options.seed));
  }
  for (const io::SceneEntry& entry : RealScenes()) {
    known.push_back(entry.name);
    if (!all && std::ranges::find(options.families, entry.name) == options.families.end()) continue;
    if (auto family = FromSet(entry, !all)) families.push_back(std::move(*family));
  }
  for (const std::string& name : options.families) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw InputError("--family " + name, "there is no such family",
                     fmt::format("choose of {}", fmt::join(known, ", ")));
  }
  for (const std::string& path : options.scenes) families.push_back(FromFile(path, options));
  return families;
}

bench::ContenderChoice ChoiceOf(const BenchOptions& options) {
  if (options.budget >= kFullFrom) return bench::ContenderChoice::kFull;
  const bool is_short = options.budget < kAllRivalsFrom && options.target.empty();
  return is_short ? bench::ContenderChoice::kFew : bench::ContenderChoice::kQuick;
}

std::vector<std::unique_ptr<bench::Contender>> ContendersOf(const BenchOptions& options) {
  auto contenders = bench::OwnContenders(ChoiceOf(options), TargetOf(options.target));
  if (options.subjects.empty()) return contenders;
  const auto is_asked = [&](const std::string& name) {
    return std::ranges::find(options.subjects, name) != options.subjects.end();
  };
  for (const std::string& name : options.subjects) {
    if (IsOutside(name)) continue;
    const bool is_known = std::ranges::any_of(
        contenders, [&](const auto& contender) { return contender->method().name == name; });
    if (!is_known) {
      throw InputError("--subject " + name, "bench has no such method",
                       "'rasterproof bench --family ties' names all; for your own give a .subject "
                       "file, --plugin or --exec");
    }
  }
  // The baselines and their twins stay, ratios are to them, and the floor, which is under all.
  std::erase_if(contenders, [&](const auto& contender) {
    const std::string& name = contender->method().name;
    return !bench::IsBaseline(name) && name != bench::kFloor && !is_asked(name);
  });
  return contenders;
}

// The models that samples in the pixels' centres can be judged by.
void RequireCentres(const Profile& profile, const std::string& place) {
  if (profile.pattern == SamplePattern{} && profile.by_target_size.empty()) return;
  throw InputError(place, "it does not sample pixel centres, by one model for all targets",
                   "give a subject that does");
}

std::unique_ptr<Subject> ProgramOf(const std::string& name) {
  std::unique_ptr<Subject> subject = ResolveOutside(name)();
  RequireCentres(subject->Info().profile, name);
  return subject;
}

// A plugin in this process: what it does wrong it does to this program.
std::unique_ptr<Subject> PluginOf(const std::string& file) {
  subjects::LoadedPlugin loaded = subjects::LoadPlugin(file);
  SubjectInfo info = loaded.subject->OwnInfo();
  info.name = std::filesystem::path(file).filename().string();
  info.profile = io::ParseProfile(loaded.profile, file);
  RequireCentres(info.profile, "--plugin " + file);
  loaded.subject->JudgeAs(info);
  return std::move(loaded.subject);
}

// All contenders of a run, first the project's, then the user's.
struct Contenders {
  std::vector<std::unique_ptr<Subject>> libraries;
  /// The user's, each in a separate process: the programs, and copies of the libraries, which draw
  /// each family first. In the order of the contenders.
  std::vector<std::unique_ptr<Subject>> outside;
  std::vector<std::unique_ptr<bench::Contender>> list;
  std::size_t own = 0;  ///< of the list: the project's

  explicit Contenders(const BenchOptions& options) : list(ContendersOf(options)) {
    own = list.size();
    // Of the first draw of a family: some of these follow.
    const double most_seconds = std::max(5.0, options.budget / 10);
    // In its own time, however loaded the machine is; and none is shown to hang.
    OutsideLimits().seconds = most_seconds;
    OutsideLimits().long_waits = 0;
    for (const std::string& file : options.plugins) {
      libraries.push_back(PluginOf(file));
      outside.push_back(ResolveOutside(std::string(kPluginPrefix) + file)());
      list.push_back(bench::MakeSubjectContender(*libraries.back(), MarchOf(file),
                                                 outside.back().get(), most_seconds));
    }
    for (const std::string& name : ProgramNames(options)) {
      outside.push_back(ProgramOf(name));
      list.push_back(
          bench::MakeProgramContender(*outside.back(), most_seconds, NameOf(*outside.back())));
    }
  }

  // The name that a program's description states, unless another one has it.
  std::string NameOf(const Subject& program) const {
    const SubjectInfo& info = program.Info();
    const bool is_taken = std::ranges::any_of(
        list, [&](const auto& other) { return other->method().name == info.stated_name; });
    return info.stated_name.empty() || is_taken ? info.name : info.stated_name;
  }

  std::span<const std::unique_ptr<bench::Contender>> Own() const {
    return std::span(list).first(own);
  }
};

// Seconds of one draw of next to nothing: what asking it costs.
double SecondsOfAsking(Subject& subject) {
  Scene tiny;
  tiny.width = tiny.height = 8;
  tiny.vertices = {{1, 1}, {1, 2}, {2, 1}};
  tiny.triangles = {{0, 1, 2}};
  if (!Takes(subject.Info(), tiny)) return 0;
  const DrawJob job(std::move(tiny), {}, 1);
  DrawOne(subject, job);  // starts it
  return Timed([&] { DrawOne(subject, job); }).wall_seconds;
}

// Where each method ends, and how it gets there: costs of all sizes where there is time.
void AddLimits(const Contenders& contenders, double end, Progress& progress, BenchResult& result) {
  bench::LimitOptions limits;
  limits.end = end;
  limits.progress = [&](const std::string& stage) { progress.Stage(stage); };
  if (result.setting.is_quick) {
    for (const bench::Parameter& parameter : bench::Parameters()) {
      limits.parameters.emplace_back(parameter.name);
    }
  } else {
    limits.most_triangles = 1'000'000;
  }
  bench::RunLimits(contenders.Own(), limits, result);
  for (std::size_t k = 0; k < contenders.outside.size(); ++k) {
    const bench::Contender& contender = *contenders.list[contenders.own + k];
    const double one = SecondsOfAsking(*contenders.outside[k]);
    constexpr int kDrawsOfLimits = 4000;
    if (WallSeconds() + kDrawsOfLimits * one > end) {
      result.not_measured.push_back("limits: " + contender.method().name);
      continue;
    }
    const auto drawer = bench::DrawerOf(*contenders.outside[k], contender.method());
    bench::RunLimits(*drawer, limits, result);
  }
}

// Draws how each method decides one sample over neighbouring inputs, and measures how far each
// stage of a frame moves it. Only the project's methods: a user's library might crash on inputs
// that no family has.
void AddPictures(const Contenders& contenders, double end, Progress& progress,
                 BenchResult& result) {
  if (WallSeconds() > end) {
    result.not_measured.emplace_back("fingerprints");
    result.not_measured.emplace_back("stages of a frame");
    return;
  }
  progress.Stage("fingerprints");
  const std::array steps{bench::kFingerprintSteps[0], bench::kFingerprintSteps[2]};
  RunFingerprints(contenders.Own(), steps, "", result);
  progress.Stage("stages");
  bench::RunStages(result.setting.is_quick ? 4 : 2, result);
}

// What is begun is measured whole: the first family always, another one while there is time for one
// as long as those before.
void AddFamilies(const Contenders& contenders, const BenchOptions& options, double end,
                 Progress& progress, BenchResult& result) {
  bench::BenchOptions bench_options;
  bench_options.least_rounds = 6;  // that give an interval of 95 %
  bench_options.judged_pixels = options.budget < kFullFrom ? 200'000 : 1'000'000;
  bench_options.progress = [&](const std::string& stage) { progress.Stage(stage); };
  constexpr double kLeastOfAUsers = 5;  // seconds: at any budget it draws the first family
  const double begun = WallSeconds();
  const std::vector<bench::FamilyInput> families = FamiliesOf(options);
  auto left = static_cast<double>(families.size());
  for (const bench::FamilyInput& family : families) {
    const double remaining = end - WallSeconds();
    const std::size_t measured = result.families.size();
    const double of_one =
        measured == 0 ? 0 : (WallSeconds() - begun) / static_cast<double>(measured);
    bench_options.seconds_per_family = remaining / left--;
    bench_options.seconds_of_users = std::max(measured == 0 ? kLeastOfAUsers : 0, remaining / 2);
    if (measured != 0 && remaining < of_one) {
      result.not_measured.push_back(
          fmt::format("families: {} with {:.1f} s left, of which one takes {:.1f}", family.name,
                      std::max(0.0, remaining), of_one));
    } else {
      bench::RunFamily(family, contenders.list, bench_options, result);
    }
  }
}

BenchResult Measured(const BenchOptions& options) {
  const double begun = WallSeconds();
  const Contenders contenders(options);
  BenchResult result;
  result.setting = SettingOf(options);
  result.setting.load_before = LoadOfMachine();
  Progress progress;
  progress.Stage("bench");
  for (const auto& contender : contenders.list) result.methods.push_back(contender->method());
  const bool is_whole = options.families.empty() && options.scenes.empty();
  constexpr double kShareOfFamilies = 0.7;
  const double end = begun + options.budget;
  const double end_of_families = is_whole ? begun + kShareOfFamilies * options.budget : end;
  AddFamilies(contenders, options, end_of_families, progress, result);
  if (is_whole) {
    AddLimits(contenders, end, progress, result);
    AddPictures(contenders, end, progress, result);
  }
  result.setting.load_after = LoadOfMachine();
  return result;
}

int FingerprintsAlone(const BenchOptions& options) {
  const Contenders contenders(options);
  BenchResult result;
  result.setting = SettingOf(options);
  const std::vector<std::string> without =
      RunFingerprints(contenders.list, bench::kFingerprintSteps, options.folder, result);
  for (const std::string& why : without) fmt::print(stderr, "rasterproof: {}\n", why);
  if (!options.json.empty()) io::WriteFile(options.json, report::BenchToJson(result));
  io::WriteStandardOutput(FingerprintTable(result));
  return kExitHolds;
}

// How times grow, alone.
int Growth(const BenchOptions& options) {
  BenchResult result;
  result.setting = SettingOf(options);
  result.setting.load_before = LoadOfMachine();
  {
    Progress progress;
    bench::LimitOptions limits;
    limits.parameters = {"target", "threads", "triangles"};
    limits.methods = options.subjects;
    limits.most_triangles = 10'000'000;
    limits.end = WallSeconds() + options.budget;
    limits.progress = [&](const std::string& stage) { progress.Stage(stage); };
    const auto contenders =
        bench::OwnContenders(bench::ContenderChoice::kQuick, TargetOf(options.target));
    bench::RunCostCurves(contenders, limits, result);
  }
  result.setting.load_after = LoadOfMachine();
  if (!options.json.empty()) io::WriteFile(options.json, report::BenchToJson(result));
  io::WriteStandardOutput(report::CostsToTable(result));
  return kExitHolds;
}

// Whether one of the user's own was measured on no family at all.
bool LacksAUsers(const BenchResult& result) {
  for (std::size_t k = 0; k < result.methods.size(); ++k) {
    if (!result.methods[k].is_users) continue;
    if (std::ranges::find(result.rows, k, &BenchRow::method) == result.rows.end()) return true;
  }
  return false;
}

}  // namespace

std::vector<std::string> ProgramNames(const BenchOptions& options) {
  std::vector<std::string> names;
  std::ranges::copy_if(options.subjects, std::back_inserter(names), IsOutside);
  for (const std::string& command : options.programs) {
    names.push_back(std::string(kExecPrefix) + command);
  }
  return names;
}

double LoadOfMachine() {
  double load = std::numeric_limits<double>::quiet_NaN();
  return getloadavg(&load, 1) == 1 ? load : std::numeric_limits<double>::quiet_NaN();
}

int RunBench(const BenchOptions& options) {
  RequireHonestEnvironment();
  for (const std::string& file : {options.json, options.svg}) {
    const std::filesystem::path folder = std::filesystem::path(file).parent_path();
    if (!folder.empty()) io::RequireFolderCanBe(folder.string());
  }
  if (options.values) {
    BenchResult found;
    if (options.from.empty()) {
      found.setting = SettingOf(options);
      found.setting.load_before = LoadOfMachine();
    } else {
      found = report::ReadBench(options.from);
    }
    PrintValues(options, found);
    return kExitHolds;
  }
  if (options.growth) return Growth(options);
  if (options.limits) {
    const auto contenders = ContendersOf(options);
    BenchResult found;
    found.setting = SettingOf(options);
    PrintLimits(contenders, options, found);
    return kExitHolds;
  }
  if (options.fingerprint) return FingerprintsAlone(options);
  std::optional<BenchResult> before;
  if (!options.against.empty()) before = report::ReadBench(options.against);
  const BenchResult result = options.from.empty() ? report::AsRecorded(Measured(options))
                                                  : report::ReadBench(options.from);
  if (!options.json.empty()) io::WriteFile(options.json, report::BenchToJson(result));
  if (!options.svg.empty()) io::WriteFile(options.svg, report::BenchToSvg(result));
  if (!before) {
    if (!result.families.empty()) io::WriteStandardOutput(report::BenchToTable(result));
    io::WriteStandardOutput(report::ValuesToTable(result));
    return LacksAUsers(result) ? kExitInconclusive : kExitHolds;
  }
  io::WriteStandardOutput(report::BenchChangesText(*before, result));
  const bool is_worse = std::ranges::any_of(report::BenchChanges(*before, result),
                                            &report::BenchChange::IsForTheWorse);
  return is_worse ? kExitViolated : kExitHolds;
}

}  // namespace rasterproof::tool
