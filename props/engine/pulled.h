// Runs check, shrinking and infer on a subject whose answers arrive later: the caller pulls.
//
//     PulledEngine engine(info);
//     const PulledCheck& check = engine.Add(std::make_unique<PulledCheck>(property, options));
//     for (auto jobs = engine.Next(); !jobs.empty(); jobs = engine.Next()) {
//       engine.Answer(draw(jobs));
//     }
//     ... check.result()
//
// What is found is what RunCampaign(), ShrinkFailing() and Infer() find, because they are what runs
// last, on a subject that knows all its answers. Before that, each work hands out what it will ask.
// The engine uses no file, no thread and no clock. For a subject that answers at once, call those
// functions.
#ifndef RASTERPROOF_PROPS_ENGINE_PULLED_H_
#define RASTERPROOF_PROPS_ENGINE_PULLED_H_

#include <cstddef>
#include <cstdint>
#include <deque>
#include <list>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/case.h"
#include "core/counters.h"
#include "core/drawing.h"
#include "core/result.h"
#include "core/subject_info.h"
#include "props/engine/known_answers.h"
#include "props/property.h"
#include "props/run/campaign_options.h"
#include "props/run/trial.h"

namespace rasterproof::props {

struct PulledProgress {
  std::uint64_t done = 0;
  std::uint64_t of = 0;
};

/// Something to be found out about a subject, as far as its answers reach.
class PulledWork {
 public:
  virtual ~PulledWork() = default;
  /// Goes on as far as the answers reach, and wants those that it needs from there on.
  ///
  /// Returns:    whether the result is there. If not, something is wanted, or there is no room.
  /// Error:      JudgingFault.
  virtual bool GoOn(KnownAnswers& answers) = 0;
  virtual PulledProgress progress() const = 0;
};

/// Shrinks a failing case, a batch of candidates a round.
class PulledShrinking {
 public:
  PulledShrinking(const Property& property, Case failing, std::uint64_t budget)
      : property_(property), failing_(std::move(failing)), budget_(budget) {}

  /// Returns whether the way to the smallest case is known, and what is asked about that one.
  bool GoOn(KnownAnswers& answers);
  std::uint64_t judged() const { return fails_.size(); }

 private:
  std::optional<bool> Fails(KnownAnswers& answers, const Case& candidate);

  const Property& property_;
  Case failing_;
  std::uint64_t budget_;
  std::map<std::string, bool> fails_;  ///< of each candidate that is judged
};

/// RunCampaign().
class PulledCheck final : public PulledWork {
 public:
  /// Domain:     a property that outlives this. Of the options, those about time play no part.
  PulledCheck(const Property& property, CampaignOptions options);
  ~PulledCheck() override;

  bool GoOn(KnownAnswers& answers) override;
  /// Cases that are judged.
  PulledProgress progress() const override;
  bool has_result() const { return result_.has_value(); }
  /// kNotApplicable for properties about sequences of calls, because answers have no order. Domain:
  /// has_result().
  const PropertyResult& result() const { return *result_; }

 private:
  class Cases;
  struct Waiting;
  struct Judged {
    Trial trial;
    TierCounts tiers;
  };

  bool JudgeCases(KnownAnswers& answers);
  std::vector<Trial> Given(std::span<const Case> cases, std::size_t& given) const;

  const Property& property_;
  CampaignOptions options_;
  std::unique_ptr<Cases> cases_;
  std::deque<std::optional<Judged>> judged_;  ///< by the number of the case; nothing: it waits
  std::list<Waiting> waiting_;                ///< in the order of their numbers
  std::uint64_t end_;                         ///< one past the case that ends the run
  std::optional<PulledShrinking> shrinking_;
  std::optional<PropertyResult> result_;
};

/// ShrinkFailing().
class PulledShrink final : public PulledWork {
 public:
  PulledShrink(const Property& property, Case failing, const CampaignOptions& options);

  bool GoOn(KnownAnswers& answers) override;
  /// Candidates that are judged.
  PulledProgress progress() const override { return {shrinking_.judged(), options_.shrink_budget}; }
  /// Domain: GoOn() was true.
  const Counterexample& result() const { return *result_; }

 private:
  const Property& property_;
  Case failing_;
  CampaignOptions options_;
  PulledShrinking shrinking_;
  std::optional<Counterexample> result_;
};

/// Works of one subject, which share its answers and its rounds.
class PulledEngine {
 public:
  explicit PulledEngine(const SubjectInfo& info, RoundSize size = {},
                        KnownAnswers::Spelling spelling = {})
      : answers_(info, size, std::move(spelling)) {}

  template <class Work>
  const Work& Add(std::unique_ptr<Work> work) {
    const Work& added = *work;
    works_.push_back(std::move(work));
    return added;
  }
  /// Returns the draws of the next round; none if every work has its result. A round that is not
  /// answered is asked again.
  ///
  /// Error:      JudgingFault.
  const std::vector<DrawJob>& Next();
  /// Takes what Subject::DrawMany() returned for the first of Next()'s draws.
  ///
  /// Returns:    false if a draw had another answer before: no result counts.
  bool Answer(std::span<const DrawOutcome> outcomes);
  /// Sums those of the works.
  PulledProgress progress() const;
  KnownAnswers& answers() { return answers_; }
  const KnownAnswers& answers() const { return answers_; }

  /// Returns the answers so far. An engine with the same works that loads them goes on from there.
  std::string save() const { return answers_.Save(); }
  /// Error:      InputError if these are no saved answers.
  void load(std::string_view saved) { answers_.Load(saved); }

 private:
  KnownAnswers answers_;
  std::vector<std::unique_ptr<PulledWork>> works_;
  std::size_t done_ = 0;  ///< the first works that have their results
  std::vector<DrawJob> round_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_ENGINE_PULLED_H_
