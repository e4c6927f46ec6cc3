#include "tool/sweep/sweep_model.h"

#include <algorithm>

#include "core/profile.h"
#include "core/verdict.h"
#include "fmt/format.h"
#include "legal/allowed.h"
#include "props/judging/gate.h"
#include "props/property.h"
#include "props/run/description.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

const char* PropertyFor(const props::PlacedCase& c) {
  if (!c.profile.freedom.IsNone()) return "OneLegalModelExplainsTheMesh";
  return c.scene.clip_space ? "ClipSpaceCoverageEqualsTheModel" : "CoverageEqualsTheModel";
}

// Of the gate of the property by which `check` judges such a case.
std::string WhyNotJudged(const SubjectInfo& info, const Case& given, const props::PlacedCase& c) {
  const props::Gate& gate = RequireProperty(PropertyFor(c)).gate;
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

ModelOfCase::ModelOfCase(const SubjectInfo& info, const Case& given) {
  Case whole = given;
  whole.options = {};
  const props::PlacedCase c = props::Place(whole, true);
  why_not_ = WhyNotJudged(info, whole, c);
  if (!why_not_.empty()) return;
  legal::Sight sight{.coverage = info.coverage};
  if (ShowsPrimitiveIds(info)) sight.ids = info.fragments.visible;
  allowed_.emplace(c, sight);
  why_not_ = allowed_->why_not();
}

std::uint64_t ModelOfCase::Away(const Drawing& drawn) const {
  return allowed_->Wrong(drawn).size();
}

void AddDistance(const SweepRunner& runner, std::size_t number, const ModelOfCase& model,
                 const SweepOutcome& outcome, DistanceFromModel& sum) {
  const Drawing* const base = runner.BaseDrawing(number);
  const bool is_refused =
      base == nullptr ||
      std::ranges::find(outcome.changes, ChangedSample{number}) != outcome.changes.end();
  if (is_refused || !model.why_not().empty()) {
    if (sum.cases_not_judged++ != 0) return;
    sum.why_not = is_refused ? "the base or this build refuses it" : model.why_not();
    return;
  }
  const std::uint64_t away = model.Away(Changed(*base, outcome.changes, number));
  ++sum.cases;
  sum.samples += base->counts.size();
  sum.samples_away += away;
  if (away != 0) ++sum.cases_away;
}

std::string DistanceText(const DistanceFromModel& distance) {
  if (distance.cases == 0) {
    return fmt::format("not compared with the model: {}", distance.why_not);
  }
  std::string text =
      fmt::format("{} of {} samples away from the model, in {} of {} cases", distance.samples_away,
                  distance.samples, distance.cases_away, distance.cases);
  if (distance.cases_not_judged != 0) {
    text += fmt::format("; not judged: {} of all {} cases ({})", distance.cases_not_judged,
                        distance.cases + distance.cases_not_judged, distance.why_not);
  }
  return text;
}

}  // namespace rasterproof::tool
