// A scene drawn after one that differs in a single vertex covers what it covers without that draw.
//
// A cached result that is found by only a part of its inputs looks like a draw on a coarser grid.
// If the profile leaves the grid free, only a copy of the subject that never saw the first scene
// distinguishes the two.
#include <array>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/freedom.h"
#include "core/profile.h"
#include "props/judging/gate.h"
#include "props/judging/moved_scenes.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace earlier_scenes_leave_no_trace {

DrawQuestion ByTwin(DrawQuestion draw) {
  draw.by_twin = true;
  return draw;
}

// Compares draw k of the subject after the case with draw k of its twin.
Verdict AreAlike(const Answers& answers, const std::vector<std::string>& changes) {
  for (std::size_t k = 0; k < changes.size(); ++k) {
    const std::size_t behind = 1 + k;
    const Verdict same =
        SameCounts(answers.draws[behind]->counts, answers.draws[behind + changes.size()]->counts, 0,
                   "that of a copy of the subject that did not draw the case, with " + changes[k]);
    if (same.outcome == Outcome::kViolated) return OfDraw(behind, same);
  }
  return Verdict::Held(changes.size());
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  const PlacedCase canonical = c.Under(Freedom{});
  if (auto why = WhyNotMoved(canonical)) return NotExercised(*why);
  const MovedScenes of(canonical, {});
  std::vector<MovedScene> moved = of.ByOneVertex();
  if (auto behind = of.BehindTheFirst()) moved.push_back(*std::move(behind));
  if (moved.empty()) return NotExercised("no vertex that moves changes what is covered");
  Questions questions;
  questions.company = Company::kInOrderAlone;
  questions.draws.push_back(WholeCallOf(c.scene, c.profile, c.options));
  std::vector<std::string> changes;
  for (const MovedScene& scene : moved) {
    questions.draws.push_back(WholeCallOf(scene.scene, c.profile, c.options));
    changes.push_back(scene.change);
  }
  for (std::size_t k = 0; k < moved.size(); ++k) {
    questions.draws.push_back(ByTwin(questions.draws[1 + k]));
  }
  return OneCheck(std::move(questions),
                  [changes](const Answers& a) { return AreAlike(a, changes); });
}

constexpr std::array kRules{kCountsTies, kStatesSamplePositions};

}  // namespace earlier_scenes_leave_no_trace

extern constinit const Property kEarlierScenesLeaveNoTrace{
    .name = "EarlierScenesLeaveNoTrace",
    .group = "extremes",
    .clause = "A scene covers the same whatever was drawn before it.",
    .required_by = kRepeatableClauses,
    .tolerance = kExact,
    .domains = kNearEdges,
    .is_about_sequence = true,
    .gate = Where({.shows = Shows::kTwin,
                   .any_model = true,
                   .rules = earlier_scenes_leave_no_trace::kRules,
                   .asks_oracle = true},
                  "a vertex that can move and change what the canonical "
                  "model covers"),
    .ask = earlier_scenes_leave_no_trace::Ask,
};

}  // namespace rasterproof::props
