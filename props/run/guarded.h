// What a subject's own calls throw, told apart from faults of ours.
#ifndef RASTERPROOF_PROPS_RUN_GUARDED_H_
#define RASTERPROOF_PROPS_RUN_GUARDED_H_

#include <memory>

#include "core/evaluators.h"
#include "core/subject.h"
#include "core/subject_info.h"

namespace rasterproof::props {

/// A subject that draws by the given one, and throws nothing but what Subject says.
///
/// A type of somebody else's may throw anything. Caught at its own call, that is its fault and no
/// one else's: "it threw: ...", as a SubjectFault. std::bad_alloc goes through: memory that ran out
/// is nobody's finding.
///
/// Domain:     a subject that outlives this one, and that throws nothing of ours (no PutOff).
class GuardedSubject final : public Subject {
 public:
  explicit GuardedSubject(Subject& subject);
  explicit GuardedSubject(std::unique_ptr<Subject> subject);
  ~GuardedSubject() override;

  const SubjectInfo& Info() const override { return subject_.Info(); }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override;
  Drawing Show(const DrawJob& job) override;
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override;
  Subject& Whole() override;
  bool SharesCalls() const override { return subject_.SharesCalls(); }
  void SetDeadline(std::chrono::steady_clock::time_point deadline) override;
  const EdgeEvaluator* Edges() const override;
  const WeightEvaluator* Weights() const override;

 private:
  class GuardedEdges;
  class GuardedWeights;

  std::unique_ptr<Subject> owned_;
  Subject& subject_;
  std::unique_ptr<GuardedSubject> whole_;
  std::unique_ptr<GuardedEdges> edges_;
  std::unique_ptr<GuardedWeights> weights_;
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_GUARDED_H_
