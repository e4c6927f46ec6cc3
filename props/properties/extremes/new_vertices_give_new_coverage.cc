// A scene covers what its own vertices say, though one that differs in a vertex alone came before.
//
// What is kept of a call (set-up, tiles, a whole image) and found again by less than all that it
// was made of shows where a small move changes what is covered: in the model, or, where the profile
// leaves a choice, in every legal model.
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/subject_info.h"
#include "legal/allowed.h"
#include "props/judging/gate.h"
#include "props/judging/legal_counts.h"
#include "props/judging/moved_scenes.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace new_vertices_give_new_coverage {

// Draws the case, then each successor, and the case again.
std::vector<DrawQuestion> DrawsOf(const PlacedCase& c, DrawQuestion of_case,
                                  const SubjectInfo& info,
                                  const std::vector<MovedScene>& successors) {
  std::vector<DrawQuestion> draws{std::move(of_case)};
  for (const MovedScene& successor : successors)
    draws.push_back(ComparisonOf(c.With(successor.scene), info, WholeTarget(c)).question);
  draws.push_back(draws.front());
  return draws;
}

Verdict Judged(const Answers& answers, const legal::Allowed& first,
               const std::vector<MovedScene>& successors) {
  std::uint64_t changed = 0;
  for (const MovedScene& s : successors) changed += s.expected.Apart(first);
  for (std::size_t d = 0; d < answers.draws.size(); ++d) {
    const bool is_the_case = d == 0 || d > successors.size();
    std::string of;
    if (d != 0) of += is_the_case ? ", drawn once more" : ", drawn after the case, with ";
    if (!is_the_case) of += successors[d - 1].change + ",";
    const legal::Allowed& expected = is_the_case ? first : successors[d - 1].expected;
    Verdict verdict = AsAllowed(expected, answers.draws[d]->counts, changed, of);
    if (verdict.outcome == Outcome::kViolated) return OfDraw(d, std::move(verdict));
  }
  return Verdict::Held(changed);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (auto why = WhyNotMoved(c)) return NotExercised(*why);
  Comparison comparison = ComparisonOf(c, subject.info, WholeTarget(c));
  const MovedScenes of(c, comparison.sight);
  if (!of.expected().why_not().empty()) return NotExercised(of.expected().why_not());
  std::vector<MovedScene> successors = of.ByOneVertex();
  if (auto behind = of.BehindTheFirst()) successors.push_back(*std::move(behind));
  if (successors.empty()) return NotExercised("no vertex that moves changes what is covered");
  if (auto other = of.OtherContent()) successors.push_back(*std::move(other));
  Questions questions;
  questions.company = Company::kInOrderAlone;
  questions.draws = DrawsOf(c, std::move(comparison.question), subject.info, successors);
  return OneCheck(std::move(questions),
                  [first = of.expected(), successors = std::move(successors)](
                      const Answers& answers) { return Judged(answers, first, successors); });
}

constexpr std::array kRules{kCountsTies, kStatesSamplePositions};

}  // namespace new_vertices_give_new_coverage

extern constinit const Property kNewVerticesGiveNewCoverage{
    .name = "NewVerticesGiveNewCoverage",
    .group = "extremes",
    .clause = "What a scene covers follows from its own vertices, not from what was drawn before.",
    .required_by = kLegalModelClauses,
    .tolerance = kExact,
    .domains = kNearEdges,
    .is_about_sequence = true,
    .gate = Where(
        {.any_model = true, .rules = new_vertices_give_new_coverage::kRules, .asks_oracle = true},
        "a vertex that can move and change what is covered"),
    .ask = new_vertices_give_new_coverage::Ask,
};

}  // namespace rasterproof::props
