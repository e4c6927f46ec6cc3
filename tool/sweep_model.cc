#include "tool/sweep_model.h"

#include <algorithm>

#include "core/profile.h"
#include "core/verdict.h"
#include "exact/coverage.h"
#include "exact/primitive_ids.h"
#include "fmt/format.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "props/judging/gate.h"
#include "props/judging/redraw.h"
#include "props/property.h"
#include "props/run/description.h"
#include "tool/resolve.h"

namespace rasterproof::tool {
namespace {

bool ShowsIds(CoverageKind kind) {
  return kind == CoverageKind::kPrimitiveIds || kind == CoverageKind::kFragments;
}

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

ModelOfCase::ModelOfCase(const SubjectInfo& info, const Case& given)
    : kind_(info.coverage), visible_(info.fragments.visible) {
  Case whole = given;
  whole.options = {};
  const props::PlacedCase c = props::Place(whole, true);
  why_not_ = WhyNotJudged(info, whole, c);
  if (!why_not_.empty()) return;
  const bool has_free_triangles = props::Place(whole, false).numbers.has_value();
  const bool is_free = has_free_triangles || !c.profile.freedom.IsNone();
  if (is_free) why_not_ = legal::WhyNotJoint(c.scene, c.profile).value_or("");
  if (why_not_.empty()) FindCounts(c, is_free);
}

void ModelOfCase::FindCounts(const props::PlacedCase& c, bool is_free) {
  if (is_free) {
    numbers_ = legal::DecidedSamples(c.scene, c.profile).counts;
    return;
  }
  least_ = most_ = exact::Coverage(c, c.options);
  const bool shares_ties = c.profile.shares_edge_samples && c.profile.tie_rule.IsConsistent();
  if (shares_ties) most_ = props::CoverageUnder(c, {.inclusive = true}, c.options);
  if (!shares_ties && ShowsIds(kind_)) ids_ = exact::PrimitiveIds(c, c.options, visible_);
}

bool ModelOfCase::IsLegal(const CoverageCounts& drawn, std::size_t k) const {
  const bool counts = kind_ == CoverageKind::kFacingCounts || kind_ == CoverageKind::kCounts;
  if (!numbers_.empty()) {
    constexpr std::uint64_t kNone = 1;
    if (!counts && drawn.Count(k) != 0) return (numbers_[k] & ~kNone) != 0;
    const std::uint32_t most = legal::kMostCounted;
    return (numbers_[k] >> std::min(drawn.Count(k), most) & 1U) != 0;
  }
  const auto is_between = [](auto low, auto value, auto high) {
    return low <= value && value <= high;
  };
  if (kind_ == CoverageKind::kFacingCounts) {
    return is_between(least_.front[k], drawn.front[k], most_.front[k]) &&
           is_between(least_.back[k], drawn.back[k], most_.back[k]);
  }
  if (counts) return is_between(least_.Count(k), drawn.Count(k), most_.Count(k));
  return drawn.Count(k) == 0 ? least_.Count(k) == 0 : most_.Count(k) != 0;
}

std::uint64_t ModelOfCase::Away(const Drawing& drawn) const {
  std::uint64_t away = 0;
  for (std::size_t k = 0; k < drawn.counts.size(); ++k) {
    const bool is_right =
        ids_.empty() ? IsLegal(drawn.counts, k) : drawn.primitive_ids[k] == ids_[k];
    if (!is_right) ++away;
  }
  return away;
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
