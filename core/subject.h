// A rasterizer under test.
#ifndef RASTERPROOF_CORE_SUBJECT_H_
#define RASTERPROOF_CORE_SUBJECT_H_

#include <chrono>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/clock.h"
#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/drawing.h"
#include "core/error.h"
#include "core/scene.h"
#include "core/subject_info.h"

namespace rasterproof {

class EdgeEvaluator;
class BarycentricEvaluator;

/// Anything that draws triangles.
class Subject {
 public:
  virtual ~Subject() = default;

  /// The subject's own description.
  virtual const SubjectInfo& OwnInfo() const = 0;
  /// The description that it is judged by: the last of JudgeAs(), else its own.
  const SubjectInfo& Info() const { return judged_as_ ? *judged_as_ : OwnInfo(); }
  /// Sets the description that it is judged by. How it draws does not change.
  void JudgeAs(SubjectInfo info) { judged_as_ = std::move(info); }
  /// Draws independent scenes, in order, each onto its own target, in one call if the subject takes
  /// batches. To draw a single scene, see DrawOne.
  ///
  /// Domain:     scenes that Takes() accepts.
  /// Properties: never writes outside the target or the scissor; equal calls give equal drawings.
  /// Returns:    the outcome of each job, in order; if one of them EndsTheCall(), its outcome is
  ///             the last. After a breakdown the next call restarts the subject.
  /// Error:      std::bad_alloc; SubjectDoesNotRun.
  virtual std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs);
  /// Draws the job `repeats` times and returns the time it took: all the subject's work, and, where
  /// the two can be separated, none of the work done here to ask for it.
  ///
  /// Domain:     a job that Takes() accepts; 1 and more repeats.
  /// Returns:    nothing if the subject can't be timed.
  /// Error:      SubjectStop if a draw gives no answer.
  virtual std::optional<DrawTime> TimeDraws(const DrawJob& /*job*/, int /*repeats*/) { return {}; }
  /// True if many draws in one call cost less than one call for each, as with a process.
  virtual bool SharesCalls() const { return false; }
  /// Draws that are not done by then may end with kTooSlow or kDeadline. A subject that runs in
  /// this process can't be stopped and ignores it.
  virtual void SetDeadline(std::chrono::steady_clock::time_point /*deadline*/) {}
  /// Another subject of the same kind, always the same one. It shares no state with this subject.
  /// nullptr if none can be made.
  virtual Subject* Twin() { return nullptr; }
  /// Optional capabilities; nullptr where the subject has none.
  virtual const EdgeEvaluator* Edges() const { return nullptr; }
  virtual const BarycentricEvaluator* Barycentrics() const { return nullptr; }

 protected:
  /// Why a job can't be drawn: its outcome is kNotDrawable, and nothing is thrown.
  virtual std::optional<InputError> WhyNotDrawn(const DrawJob& /*job*/) const { return {}; }
  /// Draws one job. A subject in this process overrides this function or Draw, or both; the default
  /// of each calls the other. EndOf() turns an exception into the end of the call.
  ///
  /// Returns:    everything that the subject shows, drawn onto zeros.
  virtual Drawing Show(const DrawJob& job);
  /// Adds the coverage of every triangle of the scene to `counts`.
  virtual void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts);

 private:
  std::optional<SubjectInfo> judged_as_;
};

/// Draws one job. To draw many, Subject::DrawMany can do so in one call.
///
/// Error:      SubjectStop if there is no drawing. As DrawMany.
Drawing DrawOne(Subject& subject, const DrawJob& job);

/// Adds the subject's coverage of the scene to `counts`.
///
/// Error:      as DrawOne.
void DrawOnto(Subject& subject, const Scene& scene, const DrawOptions& options,
              CoverageCounts& counts);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUBJECT_H_
