#include "bench/judged_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "bench/exact_triangles.h"
#include "core/evaluators.h"
#include "core/vertex.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "model/segment_distance.h"

namespace rasterproof::bench {
namespace {

// NaN is the least.
void RaiseTo(double& largest, double value) {
  if (!(value <= largest)) largest = value;
}

std::array<Point2, 3> PointsOf(const Scene& scene) {
  std::array<Point2, 3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& v = scene.vertices[k];
    points[k] = scene.clip_space ? Point2{v.x / v.w, v.y / v.w} : WindowPoint(v);
  }
  return points;
}

// An edge value that a method shows of a case: afresh, or stepped to.
struct ShownValue {
  double value = 0;
  double bound = 0;
};

ShownValue ValueOf(const EdgeEvaluator& edges, Point2 a, Point2 b, Point2 p, int steps) {
  if (steps == 0) return {edges.Value(a, b, p), edges.ErrorBound(a, b, p)};
  const Point2 from{p.x - steps, p.y};
  return {edges.Steps(a, b, from, Step{}, steps).back(),
          edges.SteppingErrorBounds(a, b, from, Step{}, steps).back()};
}

// The largest share of its bound that the error of an edge value at the sample is; more than 1 for
// one that is not a number.
double ShareOfBound(const EdgeEvaluator& edges, const HardCase& of) {
  double share = std::numeric_limits<double>::quiet_NaN();
  const Point2 p = of.undrawn.value_or(CentreOf(of.x, of.y));
  const auto v = PointsOf(of.scene);
  for (std::size_t k = 0; k < 3; ++k) {
    const ShownValue shown = ValueOf(edges, v[k], v[(k + 1) % 3], p, of.steps);
    if (!(shown.bound > 0) || !std::isfinite(shown.value)) continue;
    const auto exact = exact::EdgeValue(v[k], v[(k + 1) % 3], p);
    RaiseTo(share, (exact::Rational(shown.value) - exact).Abs().ToDouble() / shown.bound);
  }
  return share;
}

bool HasExactValues(const EdgeEvaluator& edges, const HardCase& of) {
  const Point2 p = CentreOf(of.x, of.y);
  const auto v = PointsOf(of.scene);
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = edges.Value(v[k], v[(k + 1) % 3], p);
    if (!std::isfinite(value)) return false;
    if (exact::EdgeValue(v[k], v[(k + 1) % 3], p) != exact::Rational(value)) return false;
  }
  return true;
}

void AddWrong(const HardCase& one, CaseErrors& errors) {
  ++errors.wrong;
  if (!errors.first_wrong) errors.first_wrong = one;
}

CaseErrors ErrorsOfValues(const EdgeEvaluator& edges, std::span<const HardCase* const> cases) {
  CaseErrors errors;
  errors.asked = cases.size();
  for (const HardCase* one : cases) {
    if (!HasExactValues(edges, *one)) AddWrong(*one, errors);
  }
  return errors;
}

}  // namespace

const std::vector<bool>& JudgedCases::CoveredBy(const Profile& model, Cases& of) const {
  for (const auto& [known, covered] : of.covered) {
    if (known == model) return covered;
  }
  auto& [kept, covered] = of.covered.emplace_back(model, std::vector<bool>{});
  for (const HardCase& one : of.cases) {
    const CoverageCounts counts = exact::Coverage(one.scene, model);
    covered.push_back(counts.Count(counts.Index(one.x, one.y)) != 0);
  }
  return covered;
}

CaseErrors JudgedCases::Of(SceneDrawer& drawer, const Parameter& parameter, double value,
                           WithBounds bounds) {
  Cases& of = known_[{&parameter, value}];
  if (of.cases.empty()) of.cases = parameter.hardest(value);
  std::vector<const HardCase*> taken;
  for (const HardCase& one : of.cases) {
    if (drawer.Takes(one.scene)) taken.push_back(&one);
  }
  if (taken.empty()) return {};
  if (parameter.compared == Compared::kValues) {
    // Of snapped corners, and of exact values shown as the nearest double, nothing is to be learnt.
    const bool is_float =
        drawer.edges() != nullptr && drawer.model().snap.IsNone() && !drawer.method().is_proved;
    return is_float ? ErrorsOfValues(*drawer.edges(), taken) : CaseErrors{};
  }
  CaseErrors errors;
  const std::vector<bool>& covered = CoveredBy(drawer.model(), of);
  const auto answers = drawer.Covers(taken);
  for (std::size_t k = 0; k < taken.size() && k <= answers.size(); ++k) {
    // Behind the last answer it broke down.
    const bool broke_down = k == answers.size();
    const HardCase& one = *taken[k];
    if (bounds == WithBounds::kYes && drawer.edges() != nullptr && !one.scene.clip_space) {
      RaiseTo(errors.share_of_bound, ShareOfBound(*drawer.edges(), one));
    }
    if (one.undrawn || (!broke_down && !answers[k])) continue;
    ++errors.asked;
    const auto at = static_cast<std::size_t>(&one - of.cases.data());
    if (!broke_down && *answers[k] == covered[at]) continue;
    AddWrong(one, errors);
    RaiseTo(errors.displacement, BoundaryDistance(PointsOf(one.scene), CentreOf(one.x, one.y)));
  }
  return errors;
}

}  // namespace rasterproof::bench
