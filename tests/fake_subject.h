// A subject that tests make from functions.
#ifndef RASTERPROOF_TESTS_FAKE_SUBJECT_H_
#define RASTERPROOF_TESTS_FAKE_SUBJECT_H_

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/evaluators.h"
#include "core/scene.h"
#include "core/subject.h"
#include "core/subject_info.h"

namespace rasterproof {

/// Draws by one function, or shows by one; the members below change the rest.
class FakeSubject final : public Subject {
 public:
  /// Adds the coverage to the counts.
  using DrawFunction = std::function<void(const Scene&, const DrawOptions&, CoverageCounts&)>;
  using ShowFunction = std::function<Drawing(const DrawJob&)>;

  /// It takes no other floating-point mode: it may draw by the oracle, which needs the usual one.
  FakeSubject(SubjectInfo own, DrawFunction draw) : info(std::move(own)), draw_(std::move(draw)) {
    info.takes_float_modes = false;
  }
  /// A subject that shows more than coverage.
  static FakeSubject Showing(SubjectInfo own, ShowFunction show) {
    FakeSubject subject(std::move(own), nullptr);
    subject.show_ = std::move(show);
    return subject;
  }
  /// A subject to which many draws in one call are cheaper, as those in other processes are.
  static FakeSubject Outside(SubjectInfo own, DrawFunction draw) {
    FakeSubject subject(std::move(own), std::move(draw));
    subject.shares_calls = true;
    return subject;
  }

  const SubjectInfo& OwnInfo() const override { return info; }
  bool SharesCalls() const override { return shares_calls; }
  const EdgeEvaluator* Edges() const override { return edges; }
  const BarycentricEvaluator* Barycentrics() const override { return barycentrics; }
  void SetDeadline(std::chrono::steady_clock::time_point deadline) override {
    if (on_deadline) on_deadline(deadline);
  }
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override {
    calls.push_back(jobs.size());
    if (on_call) on_call(jobs);
    std::vector<DrawOutcome> outcomes = Subject::DrawMany(jobs);
    if (on_answer) on_answer(outcomes);
    return outcomes;
  }

  SubjectInfo info;
  bool shares_calls = false;
  const EdgeEvaluator* edges = nullptr;
  const BarycentricEvaluator* barycentrics = nullptr;
  std::function<void(std::chrono::steady_clock::time_point)> on_deadline;
  std::function<void(std::span<const DrawJob>)> on_call;
  std::function<void(std::vector<DrawOutcome>&)> on_answer;  ///< may change what the call returns

  std::vector<std::size_t> calls;  ///< the number of jobs of each call
  std::size_t draws = 0;           ///< jobs begun

 protected:
  Drawing Show(const DrawJob& job) override {
    if (!show_) return Subject::Show(job);
    ++draws;
    return show_(job);
  }
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override {
    if (!draw_) return Subject::Draw(scene, options, counts);
    ++draws;
    draw_(scene, options, counts);
  }

 private:
  DrawFunction draw_;
  ShowFunction show_;
};

/// Turns counts by facing into what a subject of this kind shows.
inline void HideFacings(CoverageKind kind, CoverageCounts& counts) {
  if (kind == CoverageKind::kFacingCounts) return;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    counts.front[k] += std::exchange(counts.back[k], 0);
    if (kind != CoverageKind::kCounts) counts.front[k] = std::min(counts.front[k], 1U);
  }
}

}  // namespace rasterproof

#endif  // RASTERPROOF_TESTS_FAKE_SUBJECT_H_
