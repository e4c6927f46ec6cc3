#include "props/float_modes/float_modes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "exact/coverage.h"
#include "props/float_modes/can_touch.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/property.h"
#include "props/run/campaign.h"

namespace rasterproof::props {
namespace {

DrawOutcome DrawCounts(Subject& subject, const Case& c, FloatMode mode) {
  DrawOptions options;
  options.float_mode = mode;
  const DrawQuestion question = WholeCallOf(c.scene, c.profile, options);
  return std::move(subject.DrawMany({&question.job, 1}).front());
}

std::optional<CoverageCounts> CountsIfDrawn(Subject& subject, const Case& c) {
  DrawOutcome outcome = DrawCounts(subject, c, FloatMode::kUsual);
  if (outcome.end.stop != Stop::kNone) return std::nullopt;
  return std::move(outcome.drawing.counts);
}

using Rounding = double (*)(double);

// How a snap rounds in the mode. Toward zero, one that first adds a large number rounds down.
std::vector<Rounding> RoundingsIn(FloatMode mode) {
  const Rounding up = [](double x) { return std::ceil(x); };
  const Rounding down = [](double x) { return std::floor(x); };
  const Rounding toward_zero = [](double x) { return std::trunc(x); };
  if (mode == FloatMode::kUpward) return {up};
  if (mode == FloatMode::kDownward) return {down};
  if (mode == FloatMode::kTowardZero) return {toward_zero, down};
  return {};
}

// Whether the counts are the model's of vertices that were moved to the grid by the rounding, which
// its own snap leaves where they are.
bool IsDrawnAt(const Case& c, Rounding round, const CoverageCounts& drawn) {
  Case moved = c;
  const double grid = std::ldexp(1.0, c.profile.snap.bits);
  for (Vertex& v : moved.scene.vertices) {
    v.x = round(v.x * grid) / grid;
    v.y = round(v.y * grid) / grid;
  }
  moved.scene.precision = Precision::kFloat64;
  const PlacedCase placed(moved);
  if (exact::WhyNotDecided(placed)) return false;
  return Compare(drawn, exact::Coverage(placed, placed.options)).wrong == 0;
}

bool IsTheSnapOf(const Case& c, FloatMode mode, const CoverageCounts& drawn) {
  if (c.profile.snap.IsNone() || c.scene.clip_space) return false;
  return std::ranges::any_of(RoundingsIn(mode),
                             [&](Rounding round) { return IsDrawnAt(c, round, drawn); });
}

}  // namespace

std::vector<UsualDrawing> DrawAsUsual(Subject& subject, const FloatModesPlan& plan) {
  const Property& property = *FindProperty("EnvironmentKeepsCoverage");
  std::vector<UsualDrawing> usual;
  for (std::uint64_t k = 0; k < plan.cases && !(plan.stop && plan.stop()); ++k) {
    Case c = DrawCase(subject.Info(), property, plan.seed, k);
    c.options = {};
    std::optional<CoverageCounts> counts = CountsIfDrawn(subject, c);
    if (k < plan.cases / 2 && counts) {
      const std::optional<CoverageCounts> again = CountsIfDrawn(subject, c);
      if (!again || Compare(*again, *counts).wrong != 0) {
        throw InputError(subject.Info().name + " on " + c.origin,
                         "it draws the same case differently from call to call",
                         "mend that first: check --property EqualDrawsGiveEqualCounts");
      }
    }
    usual.push_back({std::move(c), std::move(counts)});
  }
  return usual;
}

FloatModeResult CompareWithUsual(Subject& subject, const std::vector<UsualDrawing>& usual,
                                 FloatMode mode, FloatMode option,
                                 const std::function<bool()>& stop) {
  FloatModeResult result;
  for (const UsualDrawing& drawing : usual) {
    if (stop && stop()) break;
    if (!drawing.counts) continue;
    ++result.cases;
    if (!CanTouch(mode, drawing.value.scene, subject.Info().input)) continue;
    ++result.touched;
    const DrawOutcome outcome = DrawCounts(subject, drawing.value, option);
    const bool failed = IsBreakdown(outcome.end.stop);
    const bool changed = outcome.end.stop == Stop::kNone &&
                         Compare(outcome.drawing.counts, *drawing.counts).wrong != 0;
    if (!failed && !changed) continue;
    if (!result.first) result.first = drawing.value;
    if (failed) {
      if (result.failed++ == 0) result.why = outcome.end.why;
      continue;
    }
    ++result.changed;
    if (IsTheSnapOf(drawing.value, mode, outcome.drawing.counts)) ++result.by_snap;
  }
  return result;
}

}  // namespace rasterproof::props
