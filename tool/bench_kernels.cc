// rasterproof bench --kernels: fast rasterizers on the same scenes in one run.
#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/kernel_scenes.h"
#include "bench/kernels.h"
#include "core/error.h"
#include "core/kernel_bench_result.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "model/target_model.h"
#include "reference/kernels/kernel.h"
#include "report/kernel_bench.h"
#include "subjects/plugin/plugin.h"
#include "tool/commands.h"
#include "tool/progress.h"
#include "tool/session.h"

namespace rasterproof::tool {
namespace {

namespace kernels = reference::kernels;

constexpr std::string_view kBunny = "/usr/share/glmark2/models/bunny.obj";

// What the names say, of all there is; all of it where there are none.
template <class T>
std::vector<T> Chosen(const std::string& option, const std::vector<std::string>& names,
                      std::span<const T> all) {
  std::vector<T> chosen;
  std::string known;
  for (const T& one : all) {
    known += known.empty() ? "" : ", ";
    known += NameOf(one);
  }
  for (const std::string& name : names) {
    const auto found = std::ranges::find(all, name, [](const T& one) { return NameOf(one); });
    if (found == all.end()) {
      throw InputError(fmt::format("{} {}", option, name), "there is no such one here",
                       "choose of " + known);
    }
    chosen.push_back(*found);
  }
  return names.empty() ? std::vector<T>(all.begin(), all.end()) : chosen;
}

bench::KernelInput FromFile(const std::string& path, const BenchOptions& options) {
  SceneOptions scene_options;
  scene_options.path = path;
  scene_options.project = "window";
  scene_options.width = options.width;
  scene_options.height = options.height;
  bench::KernelInput input = bench::KernelInputFrom(LoadScene(scene_options));
  input.name = std::filesystem::path(path).stem().string();
  input.summary = path;
  return input;
}

bench::KernelInput Made(const bench::KernelSceneKind& kind, const BenchOptions& options) {
  bench::KernelInput input = kind.make(options.width, options.height, options.seed);
  input.name = kind.name;
  input.summary = kind.summary;
  return input;
}

// The scene of a name or of a file.
bench::KernelInput InputOf(const std::string& name, const BenchOptions& options) {
  const auto kinds = bench::KernelSceneKinds();
  const auto kind = std::ranges::find(kinds, name, &bench::KernelSceneKind::name);
  if (kind != kinds.end()) return Made(*kind, options);
  return FromFile(name == "bunny" ? std::string(kBunny) : name, options);
}

// A plugin in this process: what it does wrong it does to this program.
bench::Rival RivalOf(const std::string& file, const BenchOptions& options) {
  subjects::LoadedPlugin loaded = subjects::LoadPlugin(file);
  std::shared_ptr<Subject> subject = std::move(loaded.subject);
  const Profile profile =
      ForTarget(io::ParseProfile(loaded.profile, file), options.width, options.height);
  if (profile.pattern.samples() != 1) {
    throw InputError("--plugin " + file, "it has several samples a pixel",
                     "time one that samples pixel centres");
  }
  SubjectInfo info = subject->OwnInfo();
  info.profile = profile;
  subject->JudgeAs(info);
  return {.name = std::filesystem::path(file).stem().string(),
          .coverage = info.coverage,
          .draw = [subject](const Scene& scene, CoverageCounts& counts) {
            subject->Draw(scene, {}, counts);
          }};
}

std::vector<std::string> SceneNames(const BenchOptions& options) {
  if (!options.scenes.empty()) return options.scenes;
  std::vector<std::string> names;
  for (const bench::KernelSceneKind& kind : bench::KernelSceneKinds()) {
    names.emplace_back(kind.name);
  }
  if (std::filesystem::exists(kBunny)) names.emplace_back("bunny");
  return names;
}

}  // namespace

int RunBenchKernels(const BenchOptions& options) {
  RequireHonestEnvironment();
  const auto targets = kernels::SupportedTargets();
  bench::KernelBenchOptions bench_options;
  bench_options.targets = options.targets.empty() ? std::vector{targets.back()}
                                                  : Chosen("--target", options.targets, targets);
  bench_options.sinks =
      Chosen("--sink", options.sinks, std::span<const kernels::Sink>(kernels::kSinks));
  bench_options.methods = Chosen("--method", options.methods,
                                 std::span<const kernels::KernelMethod>(kernels::kKernelMethods));
  bench_options.repetitions = options.repetitions;
  if (options.methods.empty()) bench_options.rivals.push_back(bench::RowsRival());
  for (const std::string& file : options.plugins) {
    bench_options.rivals.push_back(RivalOf(file, options));
  }
  KernelBenchResult result;
  result.width = options.width;
  result.height = options.height;
  result.repetitions = options.repetitions;
  result.seed = options.seed;
  {
    Progress progress;
    bench_options.progress = [&](const std::string& stage) { progress.Stage(stage); };
    bench::BenchKernelLimits(bench_options, result);
    for (const std::string& name : SceneNames(options)) {
      const bench::KernelInput input = InputOf(name, options);
      bench::BenchKernelScene(input, bench_options, result);
    }
  }
  if (!options.json.empty()) io::WriteFile(options.json, report::KernelBenchToJson(result));
  io::WriteStandardOutput(report::KernelBenchToTable(result));
  return kExitHolds;
}

}  // namespace rasterproof::tool
