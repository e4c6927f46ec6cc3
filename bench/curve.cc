#include "bench/curve.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/case_drawers.h"
#include "bench/cost_curve.h"

namespace rasterproof::bench {
namespace {

void AddCurves(SceneDrawer& drawer, std::uint32_t method, const CurveOptions& options,
               JudgedCases& cases, BenchResult& result) {
  for (const Parameter& parameter : Parameters()) {
    const auto& names = options.parameters;
    if (!names.empty() && std::ranges::find(names, parameter.name) == names.end()) continue;
    if (options.progress) {
      options.progress(drawer.method().name + " over " + std::string(parameter.name));
    }
    std::vector<BenchPoint> points = ErrorCurve(drawer, parameter, cases);
    if (points.empty()) continue;
    result.curves.push_back({method, ParameterIn(result, parameter), std::move(points)});
  }
}

}  // namespace

std::vector<BenchPoint> ErrorCurve(SceneDrawer& drawer, const Parameter& parameter,
                                   JudgedCases& cases) {
  std::vector<BenchPoint> points;
  for (int k = parameter.least_exponent; k <= parameter.most_exponent; k += parameter.curve_every) {
    const double value = std::ldexp(1.0, k);
    const CaseErrors errors = cases.Of(drawer, parameter, value, WithBounds::kYes);
    if (errors.asked == 0 && std::isnan(errors.share_of_bound)) continue;
    BenchPoint point;
    point.value = value;
    point.asked = errors.asked;
    point.wrong = errors.wrong;
    point.displacement = errors.displacement;
    point.share_of_bound = errors.share_of_bound;
    points.push_back(point);
  }
  return points;
}

void RunCurves(std::span<const std::unique_ptr<Contender>> contenders, const CurveOptions& options,
               BenchResult& result) {
  JudgedCases cases;
  ForEachDrawer(contenders, options.methods, options.end, "error curves", result,
                [&](SceneDrawer& drawer, std::uint32_t method) {
                  AddCurves(drawer, method, options, cases, result);
                });
  RunCostCurves(contenders, options, result);
}

void RunCurves(SceneDrawer& drawer, const CurveOptions& options, BenchResult& result) {
  JudgedCases cases;
  AddCurves(drawer, MethodIn(result, drawer.method()), options, cases, result);
}

}  // namespace rasterproof::bench
