#include "tests/baseline/recording.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/drawing.h"
#include "core/evaluators.h"
#include "tests/baseline/case_digest.h"

namespace rasterproof::baseline {
namespace {

using Points3 = std::array<Point2, 3>;
using Numbers3 = std::array<double, 3>;

void AddPoint(Point2 p, Digest& digest) { digest.Number(p.x).Number(p.y); }

void AddPoints(const Points3& points, Digest& digest) {
  for (const Point2& p : points) AddPoint(p, digest);
}

void AddQuery(int form, const Points3& v, Point2 p, Digest& digest) {
  digest.Integer(form);
  AddPoints(v, digest);
  AddPoint(p, digest);
}

class RecordingEdges final : public EdgeEvaluator {
 public:
  RecordingEdges(const EdgeEvaluator& edges, Record& record) : edges_(edges), record_(record) {}

  double Value(Point2 a, Point2 b, Point2 p) const override {
    AddPoints({a, b, p}, record_.edges.Next());
    return edges_.Value(a, b, p);
  }
  double ErrorBound(Point2 a, Point2 b, Point2 p) const override {
    return edges_.ErrorBound(a, b, p);
  }
  std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
    Digest& digest = record_.steps.Next();
    AddPoints({a, b, p}, digest);
    digest.Integer(step.along_y).Integer(step.sign).Integer(step.length).Integer(steps);
    return edges_.Steps(a, b, p, step, steps);
  }
  std::vector<double> SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                          int steps) const override {
    return edges_.SteppingErrorBounds(a, b, p, step, steps);
  }

 private:
  const EdgeEvaluator& edges_;
  Record& record_;
};

class RecordingBarycentrics final : public BarycentricEvaluator {
 public:
  RecordingBarycentrics(const BarycentricEvaluator& barycentrics, Record& record)
      : barycentrics_(barycentrics), record_(record) {}

  Numbers3 Barycentrics(BarycentricForm form, const Points3& v, Point2 p) const override {
    AddQuery(static_cast<int>(form), v, p, record_.barycentrics.Next());
    return barycentrics_.Barycentrics(form, v, p);
  }
  Numbers3 BarycentricErrorBounds(BarycentricForm form, const Points3& v, Point2 p) const override {
    return barycentrics_.BarycentricErrorBounds(form, v, p);
  }
  double SumErrorBound(BarycentricForm form, const Points3& v, Point2 p) const override {
    return barycentrics_.SumErrorBound(form, v, p);
  }
  double Interpolate(InterpolationForm form, const std::array<Corner, 3>& v,
                     const Numbers3& attribute, Point2 p) const override {
    Digest& digest = record_.interpolations.Next().Integer(static_cast<int>(form));
    for (std::size_t i = 0; i < 3; ++i) {
      AddPoint(v[i].at, digest);
      digest.Number(v[i].w).Number(attribute[i]);
    }
    AddPoint(p, digest);
    return barycentrics_.Interpolate(form, v, attribute, p);
  }
  double InterpolationErrorBound(InterpolationForm form, const std::array<Corner, 3>& v,
                                 const Numbers3& attribute, Point2 p) const override {
    return barycentrics_.InterpolationErrorBound(form, v, attribute, p);
  }
  Numbers3 EdgeDistances(WireframeForm form, const Points3& v, Point2 p) const override {
    AddQuery(static_cast<int>(form), v, p, record_.distances.Next());
    return barycentrics_.EdgeDistances(form, v, p);
  }

 private:
  const BarycentricEvaluator& barycentrics_;
  Record& record_;
};

class RecordingSubject final : public Subject {
 public:
  RecordingSubject(std::unique_ptr<Subject> subject, Record& record)
      : subject_(std::move(subject)), record_(record) {
    if (subject_->Edges() != nullptr) edges_.emplace(*subject_->Edges(), record);
    if (subject_->Barycentrics() != nullptr)
      barycentrics_.emplace(*subject_->Barycentrics(), record);
  }

  const SubjectInfo& OwnInfo() const override { return subject_->OwnInfo(); }
  const EdgeEvaluator* Edges() const override { return edges_ ? &*edges_ : nullptr; }
  const BarycentricEvaluator* Barycentrics() const override {
    return barycentrics_ ? &*barycentrics_ : nullptr;
  }
  bool SharesCalls() const override { return subject_->SharesCalls(); }
  Subject* Twin() override { return subject_->Twin(); }
  void SetDeadline(std::chrono::steady_clock::time_point deadline) override {
    subject_->SetDeadline(deadline);
  }

  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    std::vector<DrawOutcome> outcomes = subject_->DrawMany(jobs);
    // Behind a breakdown none is drawn.
    record_.calls.Next().Word(outcomes.size());
    for (const DrawJob& job : jobs.first(std::min(jobs.size(), outcomes.size()))) {
      RecordDraw(SceneOf(job), job.options, job.samples);
      if (job.onto != nullptr) Add(*job.onto, record_.draws.digest);
    }
    return outcomes;
  }

 private:
  void RecordDraw(const Scene& scene, const DrawOptions& options, int samples) {
    Add(scene, record_.calls.digest);
    Digest& digest = record_.draws.Next().Integer(samples);
    AddDrawn(scene, digest);
    Add(options, digest);
  }

  std::unique_ptr<Subject> subject_;
  Record& record_;
  std::optional<RecordingEdges> edges_;
  std::optional<RecordingBarycentrics> barycentrics_;
};

}  // namespace

std::unique_ptr<Subject> Recording(std::unique_ptr<Subject> subject, Record& record) {
  return std::make_unique<RecordingSubject>(std::move(subject), record);
}

}  // namespace rasterproof::baseline
