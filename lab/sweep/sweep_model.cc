#include "lab/sweep/sweep_model.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "core/drawing.h"
#include "core/profile.h"
#include "core/verdict.h"
#include "fmt/format.h"
#include "legal/allowed.h"
#include "props/judging/gate.h"
#include "props/placed_case.h"
#include "props/property.h"
#include "props/run/description.h"

namespace rasterproof::lab {
namespace {

const char* PropertyFor(const props::PlacedCase& c) {
  if (!c.profile.freedom.IsNone()) return "OneLegalModelExplainsTheMesh";
  return c.scene.clip_space ? "ClipSpaceCoverageEqualsTheModel" : "CoverageEqualsTheModel";
}

// Of the gate of the property by which `check` judges such a case.
std::string WhyNotJudged(const SubjectInfo& info, const Case& given, const props::PlacedCase& c) {
  const props::Gate& gate = props::FindProperty(PropertyFor(c))->gate;
  props::Description subject{.info = info};
  if (TakesToWindow(given.profile, given.scene)) subject = props::AsJudged(subject);
  if (const auto verdict = props::FlatnessNotDecided(c, false)) return verdict->message;
  if (const auto verdict = props::Refusal(gate, subject, c)) return verdict->message;
  return "";
}

// The drawing of a build that draws the base's but for these samples.
Drawing Changed(Drawing drawing, const std::vector<ChangedSample>& changes, std::size_t number) {
  for (const ChangedSample& change : changes) {
    if (change.number_of_case != number) continue;
    if (!drawing.primitive_ids.empty()) {
      const auto id = static_cast<std::int32_t>(change.front);
      drawing.primitive_ids[change.sample] = id;
      drawing.counts.front[change.sample] = id == kNoPrimitive ? 0 : 1;
      continue;
    }
    drawing.counts.front[change.sample] = change.front;
    drawing.counts.back[change.sample] = change.back;
  }
  return drawing;
}

}  // namespace

props::Judging ModelOfCase(const SubjectInfo& info, const Case& given) {
  Case whole = given;
  whole.options = {};
  const props::PlacedCase c = props::Place(whole, true);
  if (std::string why = WhyNotJudged(info, whole, c); !why.empty()) return {std::move(why)};
  legal::Sight sight{.coverage = info.coverage};
  if (ShowsPrimitiveIds(info)) sight.ids = info.fragments.visible;
  const legal::Allowed allowed(c, sight);
  return {allowed.why_not(), [allowed](const props::Drawn& drawn) {
            return props::Reading{.wrong = allowed.Wrong(*drawn.drawing)};
          }};
}

Cell DistanceFromModel(const SweepRunner& runner, const SweepOutcome& outcome,
                       const std::vector<props::Judging>& models) {
  const props::Row row{
      .cases = models.size(),
      .at = [&](std::uint64_t k) { return runner.cases()[k]; },
      .draw = [&](const props::CaseAtHand& at) -> props::Drawn {
        const Drawing* const base = runner.BaseDrawing(at.index);
        if (base == nullptr ||
            std::ranges::find(outcome.changes, ChangedSample{at.index}) != outcome.changes.end()) {
          return {{Stop::kRefused, "the base or this build refuses it"}, nullptr};
        }
        return {{}, std::make_shared<const Drawing>(Changed(*base, outcome.changes, at.index))};
      }};
  return props::CompareRow(row, {{[&](const props::CaseAtHand& at) { return models[at.index]; }}})
      .front();
}

std::string DistanceText(const Cell& distance) {
  if (distance.cases == 0) return fmt::format("not compared with the model: {}", distance.why);
  std::string text =
      fmt::format("{} of {} samples away from the model, in {} of {} cases", distance.wrong_samples,
                  distance.samples, distance.wrong, distance.cases);
  if (distance.excused != 0) {
    text += fmt::format("; not judged: {} of all {} cases ({})", distance.excused,
                        distance.cases + distance.excused, distance.why);
  }
  return text;
}

}  // namespace rasterproof::lab
