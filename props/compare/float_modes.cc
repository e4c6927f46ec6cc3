#include "props/compare/float_modes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/call_end.h"
#include "core/coverage.h"
#include "core/error.h"
#include "exact/coverage.h"
#include "props/compare/can_touch.h"
#include "props/compare/yardsticks.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/property.h"
#include "props/run/campaign.h"

namespace rasterproof::props {
namespace {

DrawOutcome DrawInMode(Subject& subject, const Case& c, FloatMode mode) {
  DrawOptions options;
  options.float_mode = mode;
  const DrawQuestion question = WholeCallOf(c.scene, c.profile, options);
  return std::move(subject.DrawMany({&question.job, 1}).front());
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

std::vector<UsualDrawing> DrawAsUsual(Subject& subject, std::uint64_t seed, std::uint64_t cases,
                                      const std::function<bool()>& stop) {
  const Property& property = *FindProperty("EnvironmentKeepsCoverage");
  std::vector<UsualDrawing> usual;
  for (std::uint64_t k = 0; k < cases && !(stop && stop()); ++k) {
    Case c = DrawCase(subject.Info(), property, seed, k);
    c.options = {};
    const DrawOutcome outcome = DrawInMode(subject, c, FloatMode::kUsual);
    if (outcome.end.stop != Stop::kNone) continue;
    if (k < cases / 2) {
      const DrawOutcome again = DrawInMode(subject, c, FloatMode::kUsual);
      if (again.end.stop != Stop::kNone ||
          Compare(again.drawing.counts, outcome.drawing.counts).wrong != 0) {
        throw InputError(subject.Info().name + " on " + c.origin,
                         "it draws one case differently from call to call",
                         "correct that first: check --property EqualDrawsGiveEqualCounts");
      }
    }
    usual.push_back({std::move(c), std::make_shared<const Drawing>(outcome.drawing)});
  }
  return usual;
}

Row RowOf(const std::vector<UsualDrawing>& usual) {
  return {
      .cases = usual.size(),
      .at = [&usual](std::uint64_t index) { return usual[static_cast<std::size_t>(index)].value; },
      .draw =
          [&usual](const CaseAtHand& at) {
            return Drawn{{}, usual[static_cast<std::size_t>(at.index)].drawing};
          }};
}

Yardstick ItselfInMode(Subject& subject, FloatMode mode, FloatMode option) {
  return [&subject, mode, option](const CaseAtHand& at) -> Judging {
    if (!CanTouch(mode, at.given.scene, subject.Info().input)) {
      return {"the mode can't change what is drawn"};
    }
    return {"", [&subject, mode, option, &at](const Drawn& drawn) -> Reading {
              const DrawOutcome outcome = DrawInMode(subject, at.given, option);
              if (outcome.end.stop != Stop::kNone) return {.end = outcome.end};
              const CoverageCounts& counts = outcome.drawing.counts;
              Reading reading =
                  Measured(at.placed(), counts, WrongSamples(counts, drawn.drawing->counts));
              reading.is_by_snap = !reading.wrong.empty() && IsTheSnapOf(at.given, mode, counts);
              return reading;
            }};
  };
}

}  // namespace rasterproof::props
