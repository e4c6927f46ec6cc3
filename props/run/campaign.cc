#include "props/run/campaign.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "exact/edge.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/domains/worlds.h"
#include "props/judging/gate.h"
#include "props/run/budget.h"
#include "props/run/case_order.h"
#include "props/run/conclude.h"
#include "props/run/counterexample.h"
#include "props/run/description.h"
#include "props/run/look_ahead.h"
#include "props/run/property_domains.h"
#include "props/run/trial.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kCasesPerProgress = 16;
// A subject outside that takes so long over each case of a call is slow. The clock counts what a
// loaded machine keeps from it, too: a call takes so long in all, at least.
constexpr double kSlowSeconds = 1;
constexpr double kSlowCall = 5;

// So many properties may wait a whole time limit for the first answer of a subject that hangs: it
// may be one that takes long to start.
constexpr int kMostSilent = 3;

// How long a case takes, roughly.
std::uint64_t SizeOf(const Case& c) {
  const auto samples = std::uint64_t{1} * static_cast<std::uint64_t>(c.scene.width) *
                       static_cast<std::uint64_t>(c.scene.height) *
                       static_cast<std::uint64_t>(c.profile.pattern.samples());
  return samples * (1 + c.scene.triangles.size());
}

bool HasNoAnswer(const Trial& trial) { return EndsTheCall(trial.stop); }

// Cases that are drawn together, with their numbers.
struct Block {
  std::vector<std::uint64_t> indices;
  std::vector<Case> cases;
};

// One run. The same cases in the same order every time, unless the subject is slow.
class Campaign {
 public:
  Campaign(Subject& subject, const Property& property, const CampaignOptions& options)
      : subject_(subject),
        property_(property),
        options_(options),
        pace_(options.pace != nullptr ? *options.pace : own_pace_),
        is_outside_(subject.SharesCalls()),
        budget_(subject, options_),
        order_(subject.Info(), property, options.seed),
        result_(NothingRun(subject.Info(), property, options.seed, options.world)) {
    options_.pace = &pace_;
  }

  PropertyResult Run() {
    const auto start = budget_.Now();
    const exact::TierScope scope;
    RunBlocks();
    if (result_.end == End::kAllRun) result_.tiers = scope.Counts();
    result_.seconds = budget_.Since(start);
    Conclude(subject_.Info(), property_, result_);
    return std::move(result_);
  }

 private:
  void EndWith(End end, std::string why = {}) {
    result_.end = end;
    result_.why = std::move(why);
  }

  std::string WhyNotApplicable() const {
    const auto why = DoesNotApply(property_.gate, AsJudged(DescriptionOf(subject_)));
    if (why) return *why;
    return options_.world == nullptr ? "" : WhyNotGiven(*options_.world, subject_.Info());
  }

  void RunBlocks() {
    if (std::string why = WhyNotApplicable(); !why.empty()) {
      return EndWith(End::kNotApplicable, std::move(why));
    }
    if (options_.world == nullptr && order_.IsEmpty()) return;
    for (std::uint64_t done = 0; done < options_.cases;) {
      const Block block = DrawBlock(done);
      done += block.cases.size();
      const std::size_t together = GoOneByOne() ? 1 : block.cases.size();
      for (std::size_t first = 0; first < block.cases.size(); first += together) {
        if (budget_.IsStopped()) return EndWith(End::kInterrupted);
        if (budget_.IsUp()) return EndWith(End::kTimeUp);
        RunTogether(block, first, together);
        if (result_.end != End::kAllRun) return;
      }
    }
  }

  // A slow subject may be stopped after any case: it gets the small ones first.
  bool GoOneByOne() const {
    return !is_outside_ || property_.is_about_sequence || pace_.is_slow || pace_.hangs;
  }

  CaseName NameOf(std::uint64_t index) const {
    if (options_.world != nullptr) return NameOfCase(*options_.world, index);
    return order_.Name(index);
  }

  Block DrawBlock(std::uint64_t done) const {
    const std::size_t most = GoOneByOne() && !pace_.is_slow ? 1 : options_.batch;
    std::vector<std::pair<std::uint64_t, Case>> drawn;
    for (std::uint64_t n = done; n < std::min<std::uint64_t>(done + most, options_.cases); ++n) {
      const std::uint64_t index = options_.first_case + n;
      drawn.emplace_back(index, DrawCase(subject_.Info(), NameOf(index)));
    }
    if (pace_.is_slow) {
      const auto size_and_number = [](const auto& entry) {
        return std::pair(SizeOf(entry.second), entry.first);
      };
      std::ranges::sort(drawn, {}, size_and_number);
    }
    Block block;
    for (auto& [index, c] : drawn) {
      block.indices.push_back(index);
      block.cases.push_back(std::move(c));
    }
    return block;
  }

  // Ends the run if it ends with one of these cases.
  void RunTogether(const Block& block, std::size_t first, std::size_t count) {
    const std::span<const Case> cases(block.cases.data() + first, count);
    const auto began = budget_.Now();
    if (pace_.hangs && options_.time_limit > 0) {
      budget_.GiveSubject(pace_.LimitAfterAHang(options_.time_limit));
    }
    const std::vector<Trial> trials = TryAll(cases);
    const double took = budget_.Since(began);
    const double slow = std::max(kSlowCall, kSlowSeconds * static_cast<double>(count));
    if (is_outside_ && took >= slow) pace_.is_slow = true;
    if (std::ranges::none_of(trials, &HasNoAnswer)) pace_.Answered(took);
    for (std::size_t k = 0; k < trials.size(); ++k) {
      const Trial& trial = trials[k];
      const bool no_answer = trial.verdict.outcome == Outcome::kInconclusive;
      // What breaks down as the run is stopped may have been stopped with it.
      if ((no_answer || IsBreakdown(trial.stop)) && budget_.IsStopped())
        return EndWith(End::kInterrupted);
      // The case does not count: it is the run's time that was up, not the subject's.
      if (trial.stop == Stop::kDeadline && budget_.IsUp()) return EndWith(End::kTimeUp);
      const std::uint64_t index = block.indices[first + k];
      AddCase(options_.world == nullptr ? order_.PlaceOf(index) : 0, cases[k], trial.verdict,
              result_);
      result_.draws += trial.draws;
      if (options_.judged) options_.judged(cases[k], trial.verdict);
      if (no_answer) return TooSlow(cases[k], trial.verdict);
      if (trial.verdict.outcome == Outcome::kViolated) {
        return Failed({cases, k, trial});
      }
      if (options_.progress && result_.cases % kCasesPerProgress == 0) {
        options_.progress(result_.cases);
      }
    }
    if (trials.size() < cases.size()) EndWith(End::kInterrupted);
  }

  std::vector<Trial> TryAll(std::span<const Case> cases) {
    if (options_.tried) return options_.tried(cases);
    if (cases.size() == 1) return {TryCase(subject_, property_, cases.front())};
    return TryTogether(subject_, property_, cases, options_.stop);
  }

  void TooSlow(const Case& c, const Verdict& verdict) {
    if (is_outside_) pace_.is_slow = true;
    const std::string why =
        pace_.hangs ? "no answer in time; after a hang, cases of other properties get less"
                    : verdict.message;
    ++pace_.silent;
    EndWith(End::kInconclusive, c.origin + ": " + why);
  }

  void Failed(const Failure& failure) {
    if (failure.trial.stop == Stop::kHung) {
      pace_.hangs = true;
      ++pace_.silent;
    }
    EndWith(End::kFailed);
    Counterexample& found = result_.counterexample.emplace(
        Investigate(subject_, property_, failure, options_, budget_));
    found.failing_case = failure.company[failure.at].origin;
  }

  Subject& subject_;
  const Property& property_;
  CampaignOptions options_;
  Pace own_pace_;
  Pace& pace_;
  bool is_outside_;
  Budget budget_;
  CaseOrder order_;
  PropertyResult result_;
};

}  // namespace

void Pace::Answered(double seconds) {
  if (seconds > slowest) slowest = seconds;
  silent = 0;
}

double Pace::LimitAfterAHang(double time_limit) const {
  if (slowest == 0 && silent < kMostSilent) return time_limit;
  return std::clamp(10 * slowest, time_limit / 10, time_limit);
}

Case DrawCase(const SubjectInfo& info, const Property& property, std::uint64_t seed,
              std::uint64_t number) {
  const CaseOrder order(info, property, seed);
  if (order.IsEmpty()) {
    throw InputError(std::string(property.name), "the subject takes no scene of its domains",
                     "choose another property or subject");
  }
  return DrawCase(info, order.Name(number));
}

Verdict RunCase(Subject& subject, const Property& property, const Case& c) {
  return TryCase(subject, property, c, Blaming::kWhoItWas).verdict;
}

PropertyResult RunCampaign(Subject& subject, const Property& property,
                           const CampaignOptions& options) {
  return Campaign(subject, property, options).Run();
}

}  // namespace rasterproof::props
