// Judging a case, check by check.
#ifndef RASTERPROOF_PROPS_RUN_JUDGE_H_
#define RASTERPROOF_PROPS_RUN_JUDGE_H_

#include <cstddef>
#include <exception>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/call_end.h"
#include "core/case.h"
#include "core/question.h"
#include "core/subject.h"
#include "core/verdict.h"
#include "props/placed_case.h"
#include "props/property.h"
#include "props/run/submit.h"
#include "props/run/trial.h"

namespace rasterproof::props {

/// Where a fault of ours is met: in a property on a case, or on one of many.
///
/// Domain:     at least one case.
std::string PlaceOfFault(const Property& property, std::span<const Case> cases);

/// Runs the work of properties and the oracle: whatever they throw is a fault of ours. Cases that
/// the oracle does not decide never get here: the gate reports them.
///
/// Error:      JudgingFault, which names the place. SubjectDoesNotRun.
template <class Work>
auto WorkedOut(const std::string& place, const Work& work) {
  try {
    return work();
  } catch (const JudgingFault&) {
    throw;
  } catch (const SubjectDoesNotRun&) {
    throw;
  } catch (const std::exception& error) {
    throw JudgingFault(place + error.what());
  }
}

/// A case that is being judged. Its checks are judged in order, up to the first violated one or the
/// first whose answers end early; what they exercised adds up.
class CaseJudge {
 public:
  /// Asks the property's checks of the case.
  ///
  /// Domain:     a property that asks, and a description; both outlive this.
  /// Error:      JudgingFault.
  CaseJudge(const Property& property, const Case& c, const Description& subject);
  CaseJudge(const CaseJudge&) = delete;
  CaseJudge& operator=(const CaseJudge&) = delete;

  bool IsDone() const { return trial_.has_value(); }
  /// The next check.
  ///
  /// Domain:     not done.
  Request Next() const;
  /// Judges the next check.
  ///
  /// Error:      JudgingFault.
  void Take(Answers answers);
  /// What came of it.
  ///
  /// Domain:     done.
  const Trial& Result() const { return *trial_; }

  /// Finds out who is to blame for the violation that was found, and writes it into the verdict.
  ///
  /// Domain:     done.
  void Blame(Subject& subject);

  /// Every check, in order: what is asked if none is violated.
  const std::vector<Check>& AllChecks() const { return checks_.checks; }
  const PlacedCase& Placed() const { return placed_; }

 private:
  void Conclude(Trial trial);
  std::shared_ptr<const DrawnScene> DrawnBy(const Check& check, std::size_t k) const;
  void StopBy(const Answers& answers);

  const Property& property_;
  std::string place_;  ///< of a fault of ours
  Description subject_;
  PlacedCase placed_;
  Checks checks_;
  std::size_t next_ = 0;
  std::vector<std::shared_ptr<const Drawing>> drawn_;
  Verdict sum_ = Verdict::Held(0);
  Verdict violation_;  ///< as the property says it
  std::optional<Trial> trial_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_JUDGE_H_
