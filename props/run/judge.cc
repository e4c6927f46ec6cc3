#include "props/run/judge.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "core/drawing.h"
#include "core/quoted.h"
#include "exact/coverage.h"
#include "props/codec/codec.h"
#include "props/judging/redraw.h"
#include "props/run/description.h"

namespace rasterproof::props {
namespace {

Answers SubmitOne(Subject& subject, const Request& request) {
  return std::move(Submit(subject, {&request, 1}).front());
}

// Why a draw of the checks is no question to the subject, though the case is: its scene, which the
// property made, exceeds a limit. Where the subject may refuse it, it may.
std::optional<Verdict> DrawsBeyond(BoundBy limits, const Checks& asked, const Profile& profile) {
  for (const Check& check : asked.checks) {
    const std::vector<DrawQuestion>& draws = check.questions.draws;
    for (std::size_t d = 0; d < draws.size(); ++d) {
      if (std::ranges::find(check.may_be_refused, d) != check.may_be_refused.end()) continue;
      const DrawJob& job = draws[d].job;
      const auto why = job.triangles ? WhyBeyond(limits, SceneOf(job), profile)
                                     : WhyBeyond(limits, *job.scene, profile);
      if (why)
        return Verdict::NotExercised("the property's own scene is beyond the limits: " + *why);
    }
  }
  return std::nullopt;
}

}  // namespace

std::string PlaceOfFault(const Property& property, std::span<const Case> cases) {
  const Case& first = cases.front();
  const std::string among =
      cases.size() == 1 ? "" : " or one of the " + std::to_string(cases.size() - 1) + " behind it";
  return std::string(property.name) + " on " +
         (first.origin.empty() ? "scene " + ShownName(first.scene.name) : first.origin) + among +
         ": ";
}

CaseJudge::CaseJudge(const Property& property, const Case& c, const Description& subject)
    : property_(property),
      place_(PlaceOfFault(property, {&c, 1})),
      subject_(TakesToWindow(c.profile, c.scene) ? AsJudged(subject) : subject),
      placed_(WorkedOut(place_, [&] { return Place(c, property.gate.judges_degenerates); })) {
  WorkedOut(place_, [&] {
    if (auto refusal = FlatnessNotDecided(placed_, property.gate.judges_degenerates)) {
      return Conclude({*std::move(refusal)});
    }
    if (auto refusal = Refusal(property.gate, subject_, placed_)) {
      return Conclude({*std::move(refusal)});
    }
    checks_ = property.ask(placed_, subject_);
    if (checks_.checks.empty()) return Conclude({checks_.otherwise});
    if (auto beyond = DrawsBeyond(property.gate.bound_by, checks_, placed_.profile))
      Conclude({*std::move(beyond)});
  });
}

void CaseJudge::Conclude(Trial trial) {
  trial.verdict = RenumberWitness(placed_, std::move(trial.verdict));
  trial.draws = draws_;
  trial_ = std::move(trial);
}

Request CaseJudge::Next() const { return {&placed_, &checks_.checks[next_], &drawn_}; }

// What draw k of the check's own drew, as the subject was given it; nothing if that is the case.
std::shared_ptr<const DrawnScene> CaseJudge::DrawnBy(const Check& check, std::size_t k) const {
  const DrawJob& job = check.questions.draws[k].job;
  const Case value = placed_.Value();
  Case drawn = value;
  drawn.scene = SceneOf(job);
  if (SameCase(drawn, value)) return nullptr;
  if (placed_.before) {
    std::optional<Scene> given = placed_.before->AsGiven(drawn.scene);
    if (!given) return nullptr;
    drawn.scene = *std::move(given);
  }
  return std::make_shared<DrawnScene>(std::move(drawn.scene), job.options);
}

// Whether its counts are those that one draw onto an empty target has by facing. The facings of
// parts are those of the case as given: a transform's owner is given another scene.
bool CaseJudge::CanBeShown(const DrawQuestion& question, const CoverageCounts& counts) const {
  const bool is_by_facing = subject_.info.coverage == CoverageKind::kFacingCounts ||
                            (question.parts == Parts::kFacings && !placed_.before);
  return is_by_facing && question.fill == 0 && !question.onto_the_last && !question.by_twin &&
         counts.size() != 0 && counts.size() <= kMostCompared;
}

bool CaseJudge::IsOfTheCase(const DrawJob& job) const {
  const Case value = placed_.Value();
  return !placed_.numbers &&
         SameCase({SceneOf(job), value.profile, job.options, value.origin}, value);
}

// Of the checks judged so far.
std::shared_ptr<const Drawing> CaseJudge::SeenOfTheCase() const {
  std::size_t k = 0;
  for (const Check& check : std::span(checks_.checks).first(next_)) {
    for (const DrawQuestion& question : check.questions.draws) {
      const std::shared_ptr<const Drawing>& drawing = drawn_[k++];
      if (CanBeShown(question, drawing->counts) && IsOfTheCase(question.job)) return drawing;
    }
  }
  return nullptr;
}

// In the space in which the subject was given them.
void CaseJudge::CountDraws(const Check& check) {
  for (const DrawQuestion& question : check.questions.draws) {
    const Scene& scene = *question.job.scene;
    const bool is_clip = scene.clip_space || placed_.before.has_value();
    ++(is_clip ? draws_.clip : draws_.window);
    const auto samples = static_cast<std::uint64_t>(scene.width) *
                         static_cast<std::uint64_t>(scene.height) *
                         static_cast<std::uint64_t>(question.job.samples);
    draws_.largest_target = std::max(draws_.largest_target, samples);
  }
}

void CaseJudge::StopBy(const Answers& answers) {
  switch (answers.end.stop) {
    case Stop::kNone:
      return;
    case Stop::kRefused:
      return Conclude({Verdict::Refused(answers.end.why), answers.end.stop});
    case Stop::kNotDrawable:
      return Conclude({Verdict::NotApplicable(answers.end.why), answers.end.stop});
    case Stop::kBrokeDown:
    case Stop::kHung: {
      Trial trial{Verdict::Violated(1, "the subject failed: " + answers.end.why, Witness{}),
                  answers.end.stop};
      trial.verdict.broke_down = true;
      if (answers.stopped_at) {
        trial.verdict.drawn = DrawnBy(checks_.checks[next_], *answers.stopped_at);
      }
      trial_ = std::move(trial);
      return;
    }
    case Stop::kTooSlow:
    case Stop::kOutOfMemory:
    case Stop::kDeadline:
      trial_ = {Verdict::Inconclusive(answers.end.why), answers.end.stop};
      return;
  }
}

void CaseJudge::Take(Answers answers) {
  if (answers.end.stop != Stop::kNone) return StopBy(answers);
  const Check& check = checks_.checks[next_++];
  drawn_.insert(drawn_.end(),
                answers.draws.begin() + static_cast<std::ptrdiff_t>(check.bases.size()),
                answers.draws.end());
  Verdict verdict = WorkedOut(place_, [&] { return check.judge(answers); });
  if (verdict.exercised != 0) CountDraws(check);
  sum_.exercised += verdict.exercised;
  sum_.not_judged += verdict.not_judged;
  sum_.in_gaps += verdict.in_gaps;
  sum_.indistinct += verdict.indistinct;
  sum_.worst_ratio = std::max(sum_.worst_ratio, verdict.worst_ratio);
  if (!sum_.front_sign) sum_.front_sign = verdict.front_sign;
  if (!sum_.grids) sum_.grids = verdict.grids;
  if (sum_.message.empty()) sum_.message = verdict.message;
  if (verdict.outcome == Outcome::kViolated) {
    verdict.exercised = sum_.exercised;
    verdict.not_judged = sum_.not_judged;
    const std::size_t bases = check.bases.size();
    if (verdict.failed_draw && *verdict.failed_draw >= bases) {
      verdict.drawn = DrawnBy(check, *verdict.failed_draw - bases);
    }
    if (verdict.drawn == nullptr) {
      verdict.seen = SeenOfTheCase();
    } else if (const auto& drawing = answers.draws[*verdict.failed_draw];
               CanBeShown(check.questions.draws[*verdict.failed_draw - bases], drawing->counts)) {
      verdict.seen = drawing;
    }
    violation_ = verdict;
    return Conclude({std::move(verdict)});
  }
  if (next_ < checks_.checks.size()) return;
  if (sum_.exercised != 0) {
    sum_.outcome = Outcome::kHolds;
    sum_.message.clear();
  }
  Conclude({sum_});
}

void CaseJudge::Blame(Subject& subject) {
  const bool is_said = trial_->verdict.outcome != Outcome::kViolated || IsBreakdown(trial_->stop);
  if (is_said || property_.blame == nullptr || !violation_.witness) return;
  // If the oracle cannot decide the case, no triangle is blamed.
  if (exact::WhyNotDecided(placed_)) return;
  const Checks round =
      WorkedOut(place_, [&] { return property_.blame(placed_, violation_, subject_); });
  const std::shared_ptr<const Drawing> seen = SeenOfTheCase();
  for (const Check& check : round.checks) {
    const std::vector<DrawQuestion>& draws = check.questions.draws;
    const bool is_seen = seen != nullptr && draws.size() == 1 && IsOfTheCase(draws[0].job);
    Answers answers;
    if (is_seen) {
      answers.draws.push_back(seen);
    } else {
      answers = SubmitOne(subject, {&placed_, &check, &drawn_});
    }
    // What was seen stays so, whatever becomes of less of the case.
    if (EndsTheCall(answers.end.stop)) return;
    if (answers.end.stop != Stop::kNone) continue;
    const Verdict blamed = WorkedOut(place_, [&] { return check.judge(answers); });
    if (blamed.outcome != Outcome::kViolated) continue;
    violation_.witness = blamed.witness;
    violation_.drawn = nullptr;  // its triangle is one of the case's
    violation_.seen = seen;
    return Conclude({violation_});
  }
}

Trial TryCase(Subject& subject, const Property& property, const Case& c, Blaming blaming) {
  const Description description = DescriptionOf(subject);
  CaseJudge hand(property, c, description);
  WorkedOut(PlaceOfFault(property, {&c, 1}), [&] {
    while (!hand.IsDone()) hand.Take(SubmitOne(subject, hand.Next()));
    if (blaming == Blaming::kWhoItWas) hand.Blame(subject);
  });
  return hand.Result();
}

}  // namespace rasterproof::props
