#include "bench/limits.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/case_drawers.h"
#include "bench/cliff.h"
#include "bench/cost_curve.h"
#include "bench/curve.h"
#include "bench/judged_cases.h"
#include "bench/parameter.h"

namespace rasterproof::bench {
namespace {

// What is worked out of the cases, once for all drawers.
class Limits {
 public:
  Limits(const LimitOptions& options, BenchResult& result) : options_(options), result_(result) {}

  void AddCliffs(SceneDrawer& drawer, std::uint32_t method) {
    ForEachParameter(drawer.method().name + ": ", [&](const Parameter& parameter) {
      std::optional<BenchCliff> cliff = FindCliff(drawer, parameter, cases_);
      if (!cliff) return;
      cliff->method = method;
      cliff->parameter = ParameterIn(result_, parameter);
      cliff->proved_to = ProvedTo(drawer.method(), parameter);
      result_.cliffs.push_back(std::move(*cliff));
    });
  }

  void AddCurves(SceneDrawer& drawer, std::uint32_t method) {
    ForEachParameter(drawer.method().name + " over ", [&](const Parameter& parameter) {
      std::vector<BenchPoint> points = ErrorCurve(drawer, parameter, cases_);
      if (points.empty()) return;
      result_.curves.push_back({method, ParameterIn(result_, parameter), std::move(points)});
    });
  }

 private:
  template <class Add>
  void ForEachParameter(const std::string& doing, const Add& add) const {
    for (const Parameter& parameter : Parameters()) {
      if (!IsAsked(parameter.name, options_.parameters)) continue;
      if (options_.progress) options_.progress(doing + std::string(parameter.name));
      add(parameter);
    }
  }

  const LimitOptions& options_;
  BenchResult& result_;
  JudgedCases cases_;
};

}  // namespace

void RunLimits(std::span<const std::unique_ptr<Contender>> contenders, const LimitOptions& options,
               BenchResult& result) {
  Limits limits(options, result);
  const auto run = [&](const std::string& what, auto add) {
    ForEachDrawer(
        contenders, options.methods, options.end, what, result,
        [&](SceneDrawer& drawer, std::uint32_t method) { (limits.*add)(drawer, method); });
  };
  run("limits", &Limits::AddCliffs);
  if (!options.with_curves) return;
  run("error curves", &Limits::AddCurves);
  RunCostCurves(contenders, options, result);
}

void RunLimits(SceneDrawer& drawer, const LimitOptions& options, BenchResult& result) {
  Limits limits(options, result);
  const std::uint32_t method = MethodIn(result, drawer.method());
  limits.AddCliffs(drawer, method);
  if (options.with_curves) limits.AddCurves(drawer, method);
}

}  // namespace rasterproof::bench
