// The time that a run may take, and who may end it sooner.
#ifndef RASTERPROOF_PROPS_RUN_BUDGET_H_
#define RASTERPROOF_PROPS_RUN_BUDGET_H_

#include <chrono>

#include "core/subject.h"
#include "props/run/campaign.h"

namespace rasterproof::props {

/// Keeps the subject's deadline in step with the run's; lifts it at the end.
class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  /// Begins now.
  ///
  /// Domain:     a subject and options that outlive it.
  Budget(Subject& subject, const CampaignOptions& options);
  ~Budget();
  Budget(const Budget&) = delete;
  Budget& operator=(const Budget&) = delete;

  Clock::time_point Now() const;
  /// In seconds.
  double Since(Clock::time_point start) const;
  bool IsUp() const { return Now() >= end_; }
  bool IsStopped() const { return options_.stop && options_.stop(); }
  /// Gives the subject `seconds` from now on, or the rest of the run if that is less.
  void GiveSubject(double seconds);
  /// Gives the subject the rest of the run from now on.
  void GiveSubjectAll();
  /// Another one has the rest of the run.
  void GiveAll(Subject& other) const { other.SetDeadline(end_); }

 private:
  Clock::time_point In(double seconds) const;

  Subject& subject_;
  const CampaignOptions& options_;
  Clock::time_point end_ = Clock::time_point::max();
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_BUDGET_H_
