#include "props/engine/pulled.h"

#include <algorithm>
#include <chrono>

#include "exact/edge.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"
#include "props/judging/gate.h"
#include "props/run/campaign.h"
#include "props/run/case_order.h"
#include "props/run/conclude.h"
#include "props/run/counterexample.h"
#include "props/run/description.h"
#include "props/run/judge.h"
#include "props/run/property_domains.h"
#include "props/run/submit.h"
#include "props/shrink/foresee.h"

namespace rasterproof::props {
namespace {

constexpr int kConfirmed = 2;  // answers that a smallest case rests on
constexpr int kOnceMore = 1 << 20;

// No time passes: how long answers take says nothing about the subject.
CampaignOptions WithoutClock(CampaignOptions options) {
  options.now = [] { return std::chrono::steady_clock::time_point(); };
  options.seconds = 0;
  options.time_limit = 0;
  return options;
}

// The trial of a case; nothing if an answer is missing.
std::optional<Trial> TryAnswered(KnownAnswers& answers, const Property& property, const Case& c) {
  const std::uint64_t before = answers.missed();
  Trial trial = TryCase(answers, property, c);
  return answers.missed() == before ? std::optional(std::move(trial)) : std::nullopt;
}

// Wants the questions of checks, whatever comes of those before them.
void AskAll(KnownAnswers& answers, const PlacedCase& placed, std::span<const Check> checks) {
  for (const Check& check : checks) {
    const Check alone{check.questions, {}};
    const Request request{&placed, &alone, nullptr};
    Submit(answers, {&request, 1});
  }
}

// Judges as far as the answers reach, as TryCase(), and wants what is missing. Adds the oracle's
// decisions that judging took.
//
// Returns:    whether the judge is done.
bool JudgeAnswered(KnownAnswers& answers, CaseJudge& judge, TierCounts& tiers) {
  return WorkedOut(judge.place(), [&] {
    while (!judge.IsDone()) {
      const exact::TierScope scope;
      const std::uint64_t before = answers.missed();
      const Request next = judge.Next();
      Answers seen = std::move(Submit(answers, {&next, 1}).front());
      if (answers.missed() != before) {
        AskAll(answers, judge.Placed(), judge.LaterChecks());
        return false;
      }
      judge.Take(std::move(seen));
      tiers += scope.Counts();
    }
    return true;
  });
}

bool EndsTheRun(const Trial& trial) {
  return trial.verdict.outcome == Outcome::kViolated ||
         trial.verdict.outcome == Outcome::kInconclusive;
}

}  // namespace

std::optional<bool> PulledShrinking::Fails(KnownAnswers& answers, const Case& candidate) {
  const std::string bytes = BytesOf(candidate);
  if (const auto it = fails_.find(bytes); it != fails_.end()) return it->second;
  const std::optional<Trial> trial = TryAnswered(answers, property_, candidate);
  if (!trial) return std::nullopt;
  return fails_[bytes] = trial->verdict.outcome == Outcome::kViolated;
}

bool PulledShrinking::GoOn(KnownAnswers& answers) {
  if (!answers.HasRoom()) return false;
  const std::uint64_t missed = answers.missed();
  const std::size_t wanted = answers.wanted();
  Case smallest = failing_;
  if (!property_.draws_own_scenes) {
    const auto fails = [&](const Case& candidate) { return Fails(answers, candidate); };
    const auto want = [&](const Case& candidate) {
      const CaseJudge judge(property_, candidate, DescriptionOf(answers));
      AskAll(answers, judge.Placed(), judge.AllChecks());
      return answers.HasRoom() && answers.wanted() < wanted + answers.size().of_a_shrinking;
    };
    smallest = Foresee(failing_, {fails, want}, budget_);
  }
  // Is it so once more, and which triangle is it? And is the first one still so?
  answers.AskUpTo(kConfirmed);
  TryCase(answers, property_, smallest);
  answers.AskUpTo(answers.missed() == missed ? 1 : kOnceMore);
  TryCase(answers, property_, failing_);
  answers.AskUpTo(1);
  RunCase(answers, property_, smallest);
  return answers.missed() == missed && answers.wanted() == wanted;
}

// Names and draws the cases as the campaign does.
class PulledCheck::Cases {
 public:
  Cases(KnownAnswers& answers, const Property& property, const CampaignOptions& options)
      : info_(answers.Info()),
        options_(options),
        order_(info_, property, options.seed),
        is_applicable_(!DoesNotApply(property.gate, AsJudged(DescriptionOf(answers))) &&
                       (options.world == nullptr ? !order_.IsEmpty()
                                                 : WhyNotGiven(*options.world, info_).empty())) {}

  bool IsApplicable() const { return is_applicable_; }
  Case Draw(std::uint64_t number) const {
    const std::uint64_t index = options_.first_case + number;
    const bool is_of_world = options_.world != nullptr;
    return DrawCase(info_, is_of_world ? NameOfCase(*options_.world, index) : order_.Name(index));
  }

 private:
  const SubjectInfo& info_;
  const CampaignOptions& options_;
  CaseOrder order_;
  bool is_applicable_;
};

PulledCheck::PulledCheck(const Property& property, CampaignOptions options)
    : property_(property), options_(WithoutClock(std::move(options))), end_(options_.cases) {}
PulledCheck::~PulledCheck() = default;

// A case under judgement. Its checks are made once, however many rounds its answers take.
struct PulledCheck::Waiting {
  Waiting(std::size_t place, const Property& property, const Case& c, const Description& subject)
      : number(place), judge(property, c, subject), tiers(scope.Counts()) {}

  std::size_t number;
  exact::TierScope scope;  ///< of the judge's making
  CaseJudge judge;
  TierCounts tiers;
};

// Returns whether every case is judged up to the one that ends the run.
bool PulledCheck::JudgeCases(KnownAnswers& answers) {
  const auto is_done = [&](Waiting& one) {
    if (!JudgeAnswered(answers, one.judge, one.tiers)) return false;
    judged_[one.number] = Judged{one.judge.Result(), one.tiers};
    if (EndsTheRun(one.judge.Result())) end_ = std::min<std::uint64_t>(end_, one.number + 1);
    return true;
  };
  waiting_.remove_if([&](Waiting& one) { return one.number >= end_ || is_done(one); });
  const Description description = DescriptionOf(answers);
  while (judged_.size() < end_ && answers.HasRoom()) {
    const std::size_t number = judged_.size();
    judged_.emplace_back();
    waiting_.emplace_back(number, property_, cases_->Draw(number), description);
    if (is_done(waiting_.back())) waiting_.pop_back();
  }
  waiting_.remove_if([&](const Waiting& one) { return one.number >= end_; });
  return waiting_.empty() && judged_.size() >= end_;
}

// What TryTogether() gives of the next cases.
std::vector<Trial> PulledCheck::Given(std::span<const Case> cases, std::size_t& given) const {
  std::vector<Trial> trials;
  while (trials.size() < cases.size()) {
    const Judged& judged = *judged_[given++];
    exact::CreditTiers(judged.tiers);
    trials.push_back(judged.trial);
    if (EndsTheRun(judged.trial)) break;
  }
  return trials;
}

bool PulledCheck::GoOn(KnownAnswers& answers) {
  if (result_) return true;
  if (property_.is_about_sequence) {
    result_ = NothingRun(answers.Info(), property_, options_.seed, options_.world);
    result_->end = End::kNotApplicable;
    result_->why = "it needs a sequence of calls, and answers have no order";
    Conclude(answers.Info(), property_, *result_);
    return true;
  }
  if (!cases_) cases_ = std::make_unique<Cases>(answers, property_, options_);
  if (cases_->IsApplicable()) {
    if (!JudgeCases(answers)) return false;
    const bool has_failed =
        end_ != 0 && judged_.size() >= end_ &&
        judged_[static_cast<std::size_t>(end_ - 1)]->trial.verdict.outcome == Outcome::kViolated;
    if (has_failed && !shrinking_)
      shrinking_.emplace(property_, cases_->Draw(end_ - 1), options_.shrink_budget);
    if (shrinking_ && !shrinking_->GoOn(answers)) return false;
  }
  const std::uint64_t before = answers.missed();
  std::size_t given = 0;
  CampaignOptions options = options_;
  options.tried = [&](std::span<const Case> cases) { return Given(cases, given); };
  PropertyResult result = RunCampaign(answers, property_, options);
  if (answers.missed() != before) return false;
  result_ = std::move(result);
  judged_.clear();
  return true;
}

PulledProgress PulledCheck::progress() const {
  return {result_ ? end_ : judged_.size() - waiting_.size(), end_};
}

PulledShrink::PulledShrink(const Property& property, Case failing, const CampaignOptions& options)
    : property_(property),
      failing_(std::move(failing)),
      options_(WithoutClock(options)),
      shrinking_(property, failing_, options_.shrink_budget) {}

bool PulledShrink::GoOn(KnownAnswers& answers) {
  if (result_) return true;
  CaseJudge judge(property_, failing_, DescriptionOf(answers));
  TierCounts tiers;
  const bool may_fail =
      !JudgeAnswered(answers, judge, tiers) || judge.Result().verdict.outcome == Outcome::kViolated;
  if (may_fail && !shrinking_.GoOn(answers)) return false;
  const std::uint64_t before = answers.missed();
  Counterexample found = ShrinkFailing(answers, property_, failing_, options_);
  if (answers.missed() != before) return false;
  result_ = std::move(found);
  return true;
}

const std::vector<DrawJob>& PulledEngine::Next() {
  if (!round_.empty()) return round_;
  while (done_ < works_.size() && works_[done_]->GoOn(answers_)) ++done_;
  for (std::size_t k = done_ + 1; k < works_.size() && answers_.HasRoom(); ++k) {
    works_[k]->GoOn(answers_);
  }
  if (done_ < works_.size()) round_ = answers_.TakeWanted();
  return round_;
}

bool PulledEngine::Answer(std::span<const DrawOutcome> outcomes) {
  bool is_the_same = true;
  for (std::size_t k = 0; k < std::min(outcomes.size(), round_.size()); ++k) {
    is_the_same = answers_.Learn(round_[k], outcomes[k]) && is_the_same;
  }
  round_.clear();
  return is_the_same;
}

PulledProgress PulledEngine::progress() const {
  PulledProgress sum;
  for (const std::unique_ptr<PulledWork>& work : works_) {
    const PulledProgress one = work->progress();
    sum.done += one.done;
    sum.of += one.of;
  }
  return sum;
}

}  // namespace rasterproof::props
