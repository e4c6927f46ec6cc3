// Draws put off, so that many of them go in one call; and draws answered from what came back.
#ifndef RASTERPROOF_PROPS_RUN_BATCHING_H_
#define RASTERPROOF_PROPS_RUN_BATCHING_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/drawing.h"
#include "core/evaluators.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "props/property.h"
#include "props/run/trial.h"

namespace rasterproof::props {

/// What a property asked a subject to draw over one case, in order, and what came of it.
struct DrawLedger {
  std::vector<DrawJob> jobs;
  std::vector<DrawOutcome> outcomes;  ///< of the first of the jobs

  bool HasOpenJobs() const { return outcomes.size() < jobs.size(); }
};

/// What becomes of a draw that a ledger has no outcome for.
enum class OnMiss : std::uint8_t {
  kPutOff,        ///< it is added to the jobs, and the property's run ends there (PutOff is thrown)
  kDrawNow,       ///< the rasterizer draws it
  kCoverNothing,  ///< it is added, and covers nothing
  kRefuse         ///< an InputError is thrown
};

/// Thrown through a property whose draw was put off. No std::exception, so that no property takes
/// it for a failure; RunCasesInBatches handles it.
struct PutOff {};

/// A rasterizer whose draws can be taken from a ledger. Below whatever splits or judges its draws.
/// What the rasterizer's own calls throw is its fault (GuardedSubject).
class BatchingSubject final : public Subject {
 public:
  explicit BatchingSubject(std::unique_ptr<Subject> behind);
  /// No rasterizer at all: every draw goes by a ledger.
  explicit BatchingSubject(SubjectInfo info);

  const SubjectInfo& Info() const override { return info_; }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override;
  Drawing Show(const DrawJob& job) override;
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override;
  void SetDeadline(std::chrono::steady_clock::time_point deadline) override;
  const EdgeEvaluator* Edges() const override;
  const WeightEvaluator* Weights() const override;

  /// From here on draws go by the ledger. kPutOff, kDrawNow: the n-th draw gets the n-th outcome,
  /// so a property that is run again draws what it drew before. Otherwise equal draws are one.
  void Follow(DrawLedger& ledger, OnMiss on_miss);
  /// From here on draws go to the rasterizer.
  void FollowNone() { ledger_ = nullptr; }
  /// The rasterizer itself, whatever ledger is followed.
  ///
  /// Domain:     there is one.
  Subject& Behind() { return *behind_; }

 private:
  const DrawOutcome* Find(const DrawJob& job);
  DrawOutcome Missing(const DrawJob& job);

  std::unique_ptr<Subject> behind_;
  SubjectInfo info_;
  DrawLedger* ledger_ = nullptr;
  OnMiss on_miss_ = OnMiss::kPutOff;
  std::size_t next_ = 0;
};

/// The subject's BatchingSubject, or nullptr if it has none.
BatchingSubject* BatchingOf(Subject& subject);

/// Runs the property on every case, the first draws of all of them in a few calls; one half of the
/// cases is judged while the other half is drawn. The verdicts are those of TryCase() on each,
/// unless what a subject draws depends on other scenes.
///
/// Returns:    what came of the cases, in their order; fewer if the last one is violated or
///             inconclusive, or `stop`, which is asked before each, said so.
/// Error:      as TryCase.
std::vector<Trial> RunCasesInBatches(Subject& subject, BatchingSubject& batching,
                                     const Property& property, std::span<const Case> cases,
                                     const std::function<bool()>& stop = {});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_BATCHING_H_
