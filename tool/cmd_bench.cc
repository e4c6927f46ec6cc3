// rasterproof bench: error against run time, every method from the same inputs in one run.
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <vector>

#include "bench/bench.h"
#include "bench/contender.h"
#include "bench/family.h"
#include "core/bench_result.h"
#include "core/error.h"
#include "exact/environment.h"
#include "fmt/chrono.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "report/bench_svg.h"
#include "report/bench_text.h"
#include "subjects/plugin/plugin.h"
#include "tool/commands.h"
#include "tool/limits.h"
#include "tool/progress.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

// Below this, families are small and kernels draw by the machine's best vectors.
constexpr double kFullFrom = 180;

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
  setting.command = options.command;
  setting.date = fmt::format("{:%Y-%m-%d}", fmt::gmtime(std::chrono::system_clock::now()));
  setting.seed = options.seed;
  setting.is_quick = options.budget < kFullFrom;
  return setting;
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

std::vector<bench::FamilyInput> FamiliesOf(const BenchOptions& options) {
  std::vector<bench::FamilyInput> families;
  const auto size =
      options.budget < kFullFrom ? bench::FamilySize::kQuick : bench::FamilySize::kFull;
  const bool all = options.families.empty() && options.scenes.empty();
  std::vector<std::string> known;
  for (const bench::FamilyKind& kind : bench::FamilyKinds()) {
    known.emplace_back(kind.name);
    if (!all && std::ranges::find(options.families, kind.name) == options.families.end()) continue;
    families.push_back(bench::MakeFamily(kind, size, options.seed));
  }
  for (const std::string& name : options.families) {
    if (std::ranges::find(known, name) != known.end()) continue;
    throw InputError("--family " + name, "there is no such family",
                     fmt::format("choose of {}", fmt::join(known, ", ")));
  }
  for (const std::string& path : options.scenes) families.push_back(FromFile(path, options));
  return families;
}

std::vector<std::unique_ptr<bench::Contender>> ContendersOf(const BenchOptions& options) {
  auto contenders = bench::OwnContenders(
      options.budget < kFullFrom ? bench::ContenderChoice::kQuick : bench::ContenderChoice::kFull);
  if (options.subjects.empty()) return contenders;
  const auto is_asked = [&](const std::string& name) {
    return std::ranges::find(options.subjects, name) != options.subjects.end();
  };
  for (const std::string& name : options.subjects) {
    const bool is_known = std::ranges::any_of(
        contenders, [&](const auto& contender) { return contender->method().name == name; });
    if (!is_known) {
      throw InputError("--subject " + name, "it is no method that bench draws",
                       "see the names in the table of: rasterproof bench --family ties");
    }
  }
  // The baselines and their twins stay: ratios are to them.
  std::erase_if(contenders, [&](const auto& contender) {
    const std::string& name = contender->method().name;
    return !bench::IsBaseline(name) && !is_asked(name);
  });
  return contenders;
}

// A plugin in this process: what it does wrong it does to this program.
std::unique_ptr<Subject> PluginOf(const std::string& file) {
  subjects::LoadedPlugin loaded = subjects::LoadPlugin(file);
  SubjectInfo info = loaded.subject->OwnInfo();
  info.name = std::filesystem::path(file).filename().string();
  info.profile = io::ParseProfile(loaded.profile, file);
  if (info.profile.pattern != SamplePattern{} || !info.profile.by_target_size.empty()) {
    throw InputError("--plugin " + file, "its samples are not the pixels' centres",
                     "time one that samples pixel centres, by one model for all targets");
  }
  loaded.subject->JudgeAs(info);
  return std::move(loaded.subject);
}

}  // namespace

int RunBench(const BenchOptions& options) {
  RequireHonestEnvironment();
  auto contenders = ContendersOf(options);
  if (options.limits) {
    BenchResult found;
    found.setting = SettingOf(options);
    PrintLimits(contenders, options, found);
    return kExitHolds;
  }
  std::vector<std::unique_ptr<Subject>> plugins;
  for (const std::string& file : options.plugins) {
    plugins.push_back(PluginOf(file));
    contenders.push_back(bench::MakeSubjectContender(*plugins.back()));
  }
  const std::vector<bench::FamilyInput> families = FamiliesOf(options);
  BenchResult result;
  result.setting = SettingOf(options);
  {
    Progress progress;
    progress.Stage("bench");
    bench::BenchOptions bench_options;
    // Rounds take half: samples and errors are counted besides, and the least rounds take as long
    // as they take.
    bench_options.seconds_per_family = 0.5 * options.budget / static_cast<double>(families.size());
    bench_options.judged_pixels = options.budget < kFullFrom ? 500'000 : 4'000'000;
    bench_options.progress = [&](const std::string& stage) { progress.Stage(stage); };
    for (const bench::FamilyInput& family : families) {
      bench::RunFamily(family, contenders, bench_options, result);
    }
  }
  if (!options.json.empty()) io::WriteFile(options.json, report::BenchToJson(result));
  if (!options.svg.empty()) io::WriteFile(options.svg, report::BenchToSvg(result));
  io::WriteStandardOutput(report::BenchToTable(result));
  return kExitHolds;
}

}  // namespace rasterproof::tool
