// Judges one property on one case, check by check.
//
// CaseJudge draws nothing until Blame(): its caller puts Next() to the subject and hands the
// answers to Take(), so that the draws of many cases can share calls. To run one case on one
// subject, use TryCase() (trial.h), or RunCase() (campaign.h), which also blames a triangle.
#ifndef RASTERPROOF_PROPS_RUN_JUDGE_H_
#define RASTERPROOF_PROPS_RUN_JUDGE_H_

#include <cstddef>
#include <exception>
#include <memory>
#include <new>
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

/// Returns the words for the place of a fault of rasterproof itself: the property and the case. Of
/// several cases, it names the first and says how many come after it.
///
/// Domain:     at least one case.
std::string PlaceOfFault(const Property& property, std::span<const Case> cases);

/// Returns work(). Run code of properties and of the oracle in it: whatever they throw is a fault
/// of rasterproof itself, and becomes a JudgingFault. The exception is SubjectDoesNotRun, which
/// passes. Cases that the oracle does not decide are no fault; the gate excludes them before they
/// come here.
///
/// Error:      JudgingFault, with `place` before what was thrown; SubjectDoesNotRun.
template <class Work>
auto WorkedOut(const std::string& place, const Work& work) {
  try {
    return work();
  } catch (const JudgingFault&) {
    throw;
  } catch (const SubjectDoesNotRun&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw JudgingFault(place +
                       "rasterproof itself ran out of memory (limited by 'ulimit -v', a container "
                       "or the machine); leave out --exhaustive large-target, or lower --jobs");
  } catch (const std::exception& error) {
    throw JudgingFault(place + error.what());
  }
}

/// The judgement of a property on one case, while it is under way. Checks are judged in order. It
/// is done after the last one, or earlier: after the first violation, or the first check whose
/// answers break off. The result sums what the judged checks exercised.
class CaseJudge {
 public:
  /// Places the case and makes the property's checks for it. It may be done at once, because the
  /// gate refuses the case or the property has no checks for it: Result() says why.
  ///
  /// Domain:     a property that asks, and outlives this; so does what the description points to.
  /// Error:      JudgingFault.
  CaseJudge(const Property& property, const Case& c, const Description& subject);
  CaseJudge(const CaseJudge&) = delete;
  CaseJudge& operator=(const CaseJudge&) = delete;

  bool IsDone() const { return trial_.has_value(); }
  /// Returns the questions of the next check, for the subject.
  ///
  /// Domain:     not done.
  Request Next() const;
  /// Judges the next check by the answers to Next().
  ///
  /// Error:      JudgingFault.
  void Take(Answers answers);
  /// Returns the verdict, and what led to it. To learn which triangle causes a violation, call
  /// Blame() first.
  ///
  /// Domain:     done.
  const Trial& Result() const { return *trial_; }

  /// Writes into the verdict which triangle causes the violation. This draws with the subject
  /// again what was not seen yet.
  ///
  /// Domain:     done.
  void Blame(Subject& subject);

  /// Returns all checks, in order, judged or not.
  const std::vector<Check>& AllChecks() const { return checks_.checks; }
  /// Returns the checks after the next one.
  ///
  /// Domain:     not done.
  std::span<const Check> LaterChecks() const {
    return std::span(checks_.checks).subspan(next_ + 1);
  }
  /// Returns PlaceOfFault() of the case.
  const std::string& place() const { return place_; }
  const PlacedCase& Placed() const { return placed_; }

 private:
  void Conclude(Trial trial);
  std::shared_ptr<const DrawnScene> DrawnBy(const Check& check, std::size_t k) const;
  bool CanBeShown(const DrawQuestion& question, const CoverageCounts& counts) const;
  bool IsOfTheCase(const DrawJob& job) const;
  std::shared_ptr<const Drawing> SeenOfTheCase() const;
  void CountDraws(const Check& check);
  void StopBy(const Answers& answers);

  const Property& property_;
  std::string place_;  ///< PlaceOfFault() of the case
  Description subject_;
  PlacedCase placed_;
  Checks checks_;
  std::size_t next_ = 0;
  std::vector<std::shared_ptr<const Drawing>> drawn_;
  Verdict sum_ = Verdict::Held(0);
  DrawsJudged draws_;
  Verdict violation_;  ///< as the property says it
  std::optional<Trial> trial_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_JUDGE_H_
