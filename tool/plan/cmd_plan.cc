// rasterproof plan: what a scene needs, and what can be left out.
#include "tool/plan/cmd_plan.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

#include "core/clock.h"
#include "core/coverage.h"
#include "core/error.h"
#include "core/quoted.h"
#include "exact/coverage.h"
#include "fmt/format.h"
#include "io/case_file.h"
#include "io/output.h"
#include "model/target_profile.h"
#include "reference/plan.h"
#include "report/bench_json.h"
#include "tool/environment.h"
#include "tool/exit_status.h"
#include "tool/plan/plan_error.h"

namespace rasterproof::tool {
namespace {

constexpr int kRepetitions = 15;

struct Timed {
  std::string name;
  reference::PlanDraw draw;
  std::vector<double> nanoseconds;  // of one draw

  double Median() const {
    std::vector<double> sorted = nanoseconds;
    std::ranges::sort(sorted);
    return sorted[sorted.size() / 2];
  }
};

// Draws until two milliseconds of processor time have gone by; the time of one draw.
double TimeOne(const reference::PlanDraw draw, const Scene& scene, const Profile& profile,
               CoverageCounts& counts) {
  constexpr double kEnough = 2e-3;
  const double begun = ProcessSeconds();
  double spent = 0;
  int draws = 0;
  for (; spent < kEnough; ++draws) {
    draw(scene, profile, {}, counts);
    spent = ProcessSeconds() - begun;
  }
  return spent / draws * 1e9;
}

// Times the variants of the plan in turn and prints their medians; all must count as the plan does.
std::string Measured(const reference::Plan& plan, const Scene& scene, const Profile& profile,
                     int& status) {
  const int samples = profile.pattern.samples();
  std::vector<Timed> rows{{"planned", plan.draw, {}}};
  for (const reference::PlanVariant& variant : plan.variants) {
    rows.push_back({variant.kept + " kept", variant.draw, {}});
  }
  CoverageCounts planned(scene.width, scene.height, samples);
  plan.draw(scene, profile, {}, planned);
  std::string text;
  for (Timed& row : rows) {
    CoverageCounts counts(scene.width, scene.height, samples);
    row.draw(scene, profile, {}, counts);
    if (counts == planned) continue;
    text += fmt::format("with {} other samples are covered: the plan is wrong\n", row.name);
    status = kExitViolated;
  }
  CoverageCounts sink(scene.width, scene.height, samples);
  for (int repetition = 0; repetition < kRepetitions; ++repetition) {
    for (Timed& row : rows) {
      row.nanoseconds.push_back(TimeOne(row.draw, scene, profile, sink));
    }
  }
  const double least = rows.front().Median();
  const auto triangles = static_cast<double>(std::max<std::size_t>(1, scene.triangles.size()));
  text += fmt::format("measured    medians of {}, one thread; every variant covers the same\n",
                      kRepetitions);
  for (const Timed& row : rows) {
    text += fmt::format("  {:<28} {:>10.1f} ns per triangle {:>8.2f}\n", row.name,
                        row.Median() / triangles, row.Median() / least);
  }
  return text;
}

// The cheapest method that is proved to meet the stated error; status 4 if none is.
int PlanByError(const PlanOptions& options, const Scene& scene) {
  if (options.bench.empty()) {
    throw InputError("--error", "it needs times",
                     fmt::format("make them with: rasterproof bench --scene {} --json bench.json; "
                                 "then add --bench bench.json",
                                 options.scene.path));
  }
  if (scene.clip_space) {
    throw InputError("--error", "the scene is in clip space, where no edge's error is bounded",
                     "give a scene in window space");
  }
  const BenchResult bench = report::ReadBench(options.bench);
  const std::size_t family = NearestFamily(bench, scene, options.bench);
  const std::vector<ErrorChoice> choices = ErrorChoices(bench, family, scene, options.error);
  const auto chosen = std::ranges::find_if(choices, &ErrorChoice::meets);
  std::string text = fmt::format(
      "scene       {}\nerror       each edge at most {} px off, proved\ntimes       {}: family {} "
      "({}), {}\n",
      scene.name.empty() ? options.scene.path : ShownName(scene.name), options.error, options.bench,
      bench.families[family].name, bench.families[family].summary, bench.setting.processor);
  text += chosen == choices.end()
              ? "method      none: no proved bound is as small\n"
              : fmt::format("method      {} by {}, {:.1f} ns a triangle\n", chosen->method,
                            chosen->target, chosen->nanoseconds);
  text += fmt::format("  {:<28} {:<8} {:>12} {:>10}  {}\n", "method", "target", "ns/triangle", "px",
                      "the bound");
  for (const ErrorChoice& one : choices) {
    const std::string pixels = std::isnan(one.proved) ? "-" : fmt::format("{:.3g}", one.proved);
    text += fmt::format("{} {:<28} {:<8} {:>12.1f} {:>10}  {}\n", one.meets ? "*" : " ", one.method,
                        one.target, one.nanoseconds, pixels, one.why);
  }
  io::WriteStandardOutput(text);
  return chosen == choices.end() ? kExitInconclusive : kExitHolds;
}

}  // namespace

int RunPlan(const PlanOptions& options) {
  RequireHonestEnvironment();
  const Scene scene = LoadScene(options.scene);
  if (options.error >= 0) return PlanByError(options, scene);
  const TargetProfile profile(io::ReadProfile(options.profile), scene);
  if (profile.squares) {
    throw InputError("--profile " + options.profile,
                     "its contract is about whole pixels, and plans sample points",
                     "give a profile of point samples");
  }
  const reference::Needs needs{options.barycentrics, options.depth, options.wireframe};
  const reference::Plan plan = reference::MakePlan(scene, profile, {}, needs);
  std::string text = fmt::format("scene       {}\nprofile     {}\narithmetic  {}\n",
                                 scene.name.empty() ? options.scene.path : ShownName(scene.name),
                                 profile.name, plan.arithmetic);
  for (const reference::PlanReason& reason : plan.reasons) {
    text += fmt::format("  {:<16} {:<28} {}\n", reason.stage, reason.choice, reason.why);
  }
  int status = kExitHolds;
  if (options.verify) {
    const int samples = profile.pattern.samples();
    CoverageCounts planned(scene.width, scene.height, samples);
    plan.draw(scene, profile, {}, planned);
    const CoverageDifference difference = Compare(planned, exact::Coverage(scene, profile));
    text += fmt::format("verified    {} of {} samples differ from the oracle\n", difference.wrong,
                        difference.samples);
    if (difference.wrong != 0) status = kExitViolated;
  }
  if (options.measure) text += Measured(plan, scene, profile, status);
  io::WriteStandardOutput(text);
  return status;
}

}  // namespace rasterproof::tool
