// rasterproof bench --limits: the cliffs of methods and subjects alone.
#include <algorithm>
#include <filesystem>
#include <iterator>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/case_drawers.h"
#include "bench/contender.h"
#include "bench/limits.h"
#include "core/bench_result.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "report/bench_json.h"
#include "report/limits_text.h"
#include "tool/bench/cmd_bench.h"
#include "tool/bench/limits.h"
#include "tool/progress.h"
#include "tool/resolve.h"
#include "tool/subject_kinds.h"

namespace rasterproof::tool {
namespace {

// By which model each method's cases are judged: its own.
struct Models {
  std::vector<Profile> by_method;

  void Keep(std::uint32_t method, const Profile& model) {
    if (by_method.size() <= method) by_method.resize(method + 1);
    by_method[method] = model;
  }
};

void Save(const std::string& folder, const BenchResult& result, const Models& models) {
  io::MakeFolder(folder);
  for (const BenchCliff& cliff : result.cliffs) {
    if (!cliff.scene) continue;
    const BenchMethod& method = result.methods[cliff.method];
    const std::string& parameter = result.parameters[cliff.parameter].name;
    const std::string name = std::filesystem::path(method.name).stem().string();
    io::CaseFile file;
    file.value.scene = *cliff.scene;
    file.value.profile = models.by_method[cliff.method];
    file.value.origin = fmt::format("{} {:.17g}, sample of pixel ({}, {})", parameter,
                                    cliff.first_failing, cliff.x, cliff.y);
    file.subject = method.name;
    file.property = "CoverageEqualsTheModel";
    const auto path = std::filesystem::path(folder) / fmt::format("{}-{}.json", name, parameter);
    io::WriteFile(path.string(), io::CaseToJson(file));
  }
}

std::vector<std::string> OutsideNames(const BenchOptions& options) {
  std::vector<std::string> names;
  for (const std::string& file : options.plugins)
    names.push_back(std::string(kPluginPrefix) + file);
  std::ranges::copy(ProgramNames(options), std::back_inserter(names));
  return names;
}

}  // namespace

void PrintLimits(std::span<const std::unique_ptr<bench::Contender>> contenders,
                 const BenchOptions& options, BenchResult& result) {
  if (!options.save.empty()) io::RequireFolderCanBe(options.save);
  Models models;
  {
    Progress progress;
    bench::LimitOptions limits;
    limits.methods = options.subjects;
    limits.progress = [&](const std::string& stage) { progress.Stage(stage); };
    limits.with_curves = !options.json.empty();
    const std::vector<std::string> outside = OutsideNames(options);
    std::erase_if(limits.methods, IsOutside);
    if (outside.empty() || !limits.methods.empty()) {
      bench::RunLimits(contenders, limits, result);
      for (const auto& contender : contenders) {
        models.Keep(bench::MethodIn(result, contender->method()), contender->model());
      }
    }
    for (const std::string& name : outside) {
      const std::unique_ptr<Subject> subject = MakeSubject(name);
      RequireSamples(subject->Info());
      const auto drawer = bench::DrawerOf(*subject);
      bench::RunLimits(*drawer, limits, result);
      models.Keep(bench::MethodIn(result, drawer->method()), drawer->model());
    }
  }
  if (!options.save.empty()) Save(options.save, result, models);
  if (!options.json.empty()) io::WriteFile(options.json, report::BenchToJson(result));
  io::WriteStandardOutput(report::LimitsToTable(result));
}

}  // namespace rasterproof::tool
