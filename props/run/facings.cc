#include "props/run/facings.h"

#include <chrono>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "core/evaluators.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/snap_clip.h"
#include "model/snap_scene.h"
#include "model/target_model.h"
#include "props/run/parts.h"

namespace rasterproof::props {
namespace {

class FacingSubject final : public Subject {
 public:
  explicit FacingSubject(std::unique_ptr<Subject> subject)
      : subject_(std::move(subject)), info_(subject_->Info()) {
    info_.coverage = CoverageKind::kFacingCounts;
  }
  const SubjectInfo& Info() const override { return info_; }
  const EdgeEvaluator* Edges() const override { return subject_->Edges(); }
  const WeightEvaluator* Weights() const override { return subject_->Weights(); }

  Subject& Whole() override { return subject_->Whole(); }
  bool SharesCalls() const override { return subject_->SharesCalls(); }
  void SetDeadline(std::chrono::steady_clock::time_point deadline) override {
    subject_->SetDeadline(deadline);
  }

  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    const DrawJob job{scene, options, counts.samples};
    counts += DrawMany({&job, 1}).front().Get().counts;
  }

  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    const CoverageKind coverage = subject_->Info().coverage;
    std::vector<Part> parts;
    std::vector<std::size_t> owners;
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      for (Part& part : FacingParts(jobs[k], coverage, info_.profile)) {
        parts.push_back(std::move(part));
        owners.push_back(k);
      }
    }
    std::vector<DrawJob> part_jobs;
    for (const Part& part : parts) part_jobs.push_back(part.job);
    const std::vector<DrawOutcome> drawn = subject_->DrawMany(part_jobs);
    std::vector<DrawOutcome> outcomes(jobs.size());
    for (std::size_t k = 0; k < jobs.size(); ++k) {
      const Scene& scene = *jobs[k].scene;
      outcomes[k].drawing.counts = CoverageCounts(scene.width, scene.height, jobs[k].samples);
    }
    for (std::size_t n = 0; n < drawn.size(); ++n) {
      DrawOutcome& outcome = outcomes[owners[n]];
      if (drawn[n].error == nullptr) {
        AddPart(parts[n], coverage, drawn[n].drawing.counts, outcome.drawing.counts);
      } else if (outcome.error == nullptr) {
        outcome.error = drawn[n].error;
      }
    }
    if (drawn.size() < parts.size()) outcomes.resize(owners[drawn.size() - 1] + 1);
    return outcomes;
  }

 private:
  std::unique_ptr<Subject> subject_;
  SubjectInfo info_;
};

}  // namespace

std::unique_ptr<Subject> WithFacings(std::unique_ptr<Subject> subject) {
  if (subject->Info().coverage == CoverageKind::kFacingCounts) return subject;
  return std::make_unique<FacingSubject>(std::move(subject));
}

}  // namespace rasterproof::props
