#include "props/run/counterexample.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "core/call_end.h"
#include "props/run/look_ahead.h"
#include "props/shrink/shrink.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kEvaluationsPerProgress = 16;

std::string AnswerText(const Verdict& verdict) {
  std::string text(OutcomeName(verdict.outcome));
  if (!verdict.message.empty()) text += ": " + verdict.message;
  if (!verdict.witness || verdict.witness->observed.empty()) return text;
  const Witness& w = *verdict.witness;
  if (w.x >= 0) text += ", at pixel (" + std::to_string(w.x) + ", " + std::to_string(w.y) + ")";
  return text + " observed " + TextOfValue(w.observed) + ", expected " + TextOfValue(w.expected);
}

std::string TwoAnswersText(const Verdict& one, const Verdict& other) {
  return "first " + AnswerText(one) + "; then " + AnswerText(other);
}

Counterexample NotDeterministic(const Case& c, const Verdict& seen, const Verdict& then) {
  return {c, seen, Outcome::kInconclusive,
          "the subject is not deterministic: its counterexample does not fail again; " +
              TwoAnswersText(seen, then),
          0};
}

// A breakdown is a finding, whatever comes of a second try.
Counterexample BrokeDownOnce(Counterexample found) {
  found.outcome = Outcome::kViolated;
  found.message = found.verdict.message + "; it did not happen again: " + found.message;
  return found;
}

Counterexample Violated(const Case& c, const Verdict& verdict) {
  return {c, verdict, Outcome::kViolated, verdict.message, 0};
}

// Holds a fresh subject if one can be made; if not, or if the run is stopped meanwhile, the given
// one.
class FreshSubject {
 public:
  FreshSubject(Subject& subject, const CampaignOptions& options, const Budget& budget)
      : subject_(subject) {
    if (!options.afresh || budget.IsStopped()) return;
    made_ = options.afresh();
    if (made_ != nullptr) budget.GiveAll(*made_);
  }

  Subject& Get() const { return made_ == nullptr ? subject_ : *made_; }

 private:
  Subject& subject_;
  std::unique_ptr<Subject> made_;
};

// Judges smaller and smaller cases, as long as it may.
class Shrinking {
 public:
  Shrinking(Subject& subject, const Property& property, const CampaignOptions& options,
            Budget& budget, const Failure& failure)
      : subject_(subject),
        property_(property),
        options_(options),
        budget_(budget),
        hung_(failure.trial.stop == Stop::kHung),
        first_(failure.trial.verdict),
        last_(first_) {}

  bool Hung() const { return hung_; }
  const Verdict& Last() const { return last_; }    ///< of the last case that failed
  const std::string& Cut() const { return cut_; }  ///< why it ended early; empty if it did not
  int hangs() const { return hangs_; }
  std::uint64_t evaluations() const { return evaluations_; }

  /// The case that failed in company.
  Verdict JudgeAlone(const Case& c) {
    if (hung_) return JudgeInOneLimit(c);
    return TryCase(FreshSubject(subject_, options_, budget_).Get(), property_, c).verdict;
  }

  Case Smallest(const Case& failing) {
    if (property_.draws_own_scenes) return failing;
    began_ = budget_.Now();
    budget_.GiveSubject(options_.shrink_seconds);
    const auto fails = [this](const Case& candidate) { return Fails(candidate); };
    Case smallest = Shrink(failing, fails, options_.shrink_budget).minimal;
    budget_.GiveSubjectAll();
    return smallest;
  }

 private:
  // What hung hangs again if it gives no answer now.
  Verdict JudgeInOneLimit(const Case& c) {
    const auto began = budget_.Now();
    const bool has_pace = hung_ && options_.pace != nullptr;
    const double limit =
        has_pace ? options_.pace->LimitAfterAHang(options_.time_limit) : options_.time_limit;
    if (limit > 0) budget_.GiveSubject(limit);
    const Trial trial = TryCase(subject_, property_, c);
    const bool no_answer =
        IsBreakdown(trial.stop) || trial.verdict.outcome == Outcome::kInconclusive;
    const bool took_a_limit = limit > 0 && budget_.Since(began) >= limit;
    if (has_pace && !no_answer) options_.pace->Answered(budget_.Since(began));
    if (!no_answer || !took_a_limit) return trial.verdict;
    ++hangs_;
    if (has_pace) hang_seconds_ += limit;
    return hung_ ? first_ : trial.verdict;
  }

  std::string WhyToCut() const {
    if (budget_.IsStopped()) return "interrupted";
    const double most_seconds = kMostHangLimits * options_.time_limit;
    if (hangs_ >= kMostHangs || (hangs_ > 0 && hang_seconds_ >= most_seconds)) {
      const std::string times = std::to_string(hangs_);
      return hung_ ? "it hung " + times + " times"
                   : times + " smaller cases were too slow to judge";
    }
    const bool is_late = budget_.IsUp() || budget_.Since(began_) >= options_.shrink_seconds;
    return is_late ? "it ran out of time" : "";
  }

  bool Fails(const Case& candidate) {
    if (cut_.empty()) cut_ = WhyToCut();
    if (!cut_.empty()) return false;
    if (options_.shrinking && evaluations_ % kEvaluationsPerProgress == 0) {
      options_.shrinking(evaluations_);
    }
    ++evaluations_;
    const Verdict verdict = JudgeInOneLimit(candidate);
    // What breaks down as the run is stopped may have been stopped with it.
    if (verdict.outcome != Outcome::kViolated || budget_.IsStopped()) return false;
    last_ = verdict;
    return true;
  }

  Subject& subject_;
  const Property& property_;
  const CampaignOptions& options_;
  Budget& budget_;
  bool hung_;
  Verdict first_;
  Verdict last_;
  Budget::Clock::time_point began_;
  std::uint64_t evaluations_ = 0;
  int hangs_ = 0;
  double hang_seconds_ = 0;
  std::string cut_;
};

bool MayGoOn(const Budget& budget) { return !budget.IsUp() && !budget.IsStopped(); }

// The case holds alone. Its company is to blame if it does it again; otherwise nobody knows.
Counterexample InCompany(Subject& subject, const Property& property, const Failure& failure,
                         const Verdict& alone, const CampaignOptions& options, Budget& budget) {
  const Case& c = failure.company[failure.at];
  const Verdict& seen = failure.trial.verdict;
  const auto is_violated = [](const Trial& trial) {
    return trial.verdict.outcome == Outcome::kViolated;
  };
  const auto is_inconclusive = [](const Trial& trial) {
    return trial.verdict.outcome == Outcome::kInconclusive;
  };
  if (MayGoOn(budget)) {
    budget.GiveSubjectAll();
    const std::vector<Trial> again = TryTogether(subject, property, failure.company, options.stop);
    if (std::ranges::none_of(again, is_violated) && std::ranges::none_of(again, is_inconclusive) &&
        MayGoOn(budget)) {
      Counterexample once = NotDeterministic(c, seen, alone);
      return IsBreakdown(failure.trial.stop) ? BrokeDownOnce(std::move(once)) : once;
    }
  }
  return {c, seen, Outcome::kViolated,
          seen.message +
              "; alone the case does not fail: what the subject draws depends on other "
              "scenes; " +
              TwoAnswersText(seen, alone),
          0};
}

// The smallest case once more; and if that was luck, the one that failed first.
Counterexample Confirmed(Subject& subject, const Property& property, const Case& smallest,
                         const Verdict& seen, const Failure& failure,
                         const CampaignOptions& options, const Budget& budget) {
  Counterexample found =
      RunOnceMore(FreshSubject(subject, options, budget).Get(), property, smallest, seen);
  const Case& failing = failure.company[failure.at];
  if (found.outcome == Outcome::kViolated) return found;
  const bool broke_down = IsBreakdown(failure.trial.stop);
  if (smallest == failing) return broke_down ? BrokeDownOnce(std::move(found)) : found;
  Counterexample first = RunOnceMore(FreshSubject(subject, options, budget).Get(), property,
                                     failing, failure.trial.verdict);
  if (first.outcome != Outcome::kViolated) {
    return broke_down ? BrokeDownOnce(std::move(first)) : found;
  }
  first.message += "; smaller cases fail only sometimes";
  return first;
}

}  // namespace

Counterexample RunOnceMore(Subject& subject, const Property& property, const Case& failing,
                           const Verdict& seen) {
  const Verdict again = RunCase(subject, property, failing);
  if (again.outcome == Outcome::kViolated) return Violated(failing, again);
  Counterexample once = Violated(failing, seen);
  if (again.outcome == Outcome::kInconclusive) {
    once.message += "; a second run could not be judged: " + again.message;
    return once;
  }
  if (!property.is_about_sequence) return NotDeterministic(failing, seen, again);
  once.message += "; not every time: " + TwoAnswersText(seen, again);
  return once;
}

Counterexample Investigate(Subject& subject, const Property& property, const Failure& failure,
                           const CampaignOptions& options, Budget& budget) {
  const Case& failing = failure.company[failure.at];
  Shrinking shrinking(subject, property, options, budget, failure);
  if (options.shrinking) options.shrinking(0);
  // Earlier draws are company as well. Whoever breaks down is on a fresh process already.
  const bool may_be_company =
      options.afresh && !property.is_about_sequence && !IsBreakdown(failure.trial.stop);
  if ((failure.company.size() > 1 || may_be_company) && MayGoOn(budget)) {
    const Verdict alone = shrinking.JudgeAlone(failing);
    const bool could_be_judged = alone.outcome != Outcome::kInconclusive;
    if (alone.outcome != Outcome::kViolated && could_be_judged && !budget.IsStopped()) {
      return InCompany(subject, property, failure, alone, options, budget);
    }
  }
  const Case smallest = shrinking.Smallest(failing);
  Counterexample found = Violated(smallest, shrinking.Last());
  // What hung once would cost a time limit each time.
  if (!shrinking.Hung() && MayGoOn(budget)) {
    found = Confirmed(subject, property, smallest, shrinking.Last(), failure, options, budget);
  }
  found.evaluations = shrinking.evaluations();
  if (shrinking.Hung() && shrinking.hangs() > 0) {
    found.message += "; smaller cases that did not answer soon counted as hangs";
  }
  if (!shrinking.Cut().empty()) found.message += "; shrinking stopped: " + shrinking.Cut();
  return found;
}

Counterexample ShrinkFailing(Subject& subject, const Property& property, const Case& failing,
                             const CampaignOptions& options) {
  Budget budget(subject, options);
  const Failure failure{{&failing, 1}, 0, TryCase(subject, property, failing)};
  const Verdict& verdict = failure.trial.verdict;
  if (verdict.outcome != Outcome::kViolated) {
    return {failing, verdict, verdict.outcome, verdict.message, 0};
  }
  return Investigate(subject, property, failure, options, budget);
}

}  // namespace rasterproof::props
