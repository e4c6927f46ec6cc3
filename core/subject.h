// A rasterizer under test, and what it can be asked.
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
#include "core/scene.h"
#include "core/subject_info.h"

namespace rasterproof {

class EdgeEvaluator;
class BarycentricEvaluator;

/// Anything that draws triangles.
class Subject {
 public:
  virtual ~Subject() = default;

  /// What it says of itself.
  virtual const SubjectInfo& OwnInfo() const = 0;
  /// What it is judged as: what it says of itself, unless somebody else said otherwise.
  const SubjectInfo& Info() const { return judged_as_ ? *judged_as_ : OwnInfo(); }
  /// From here on it is judged as this. It draws as before.
  void JudgeAs(SubjectInfo info) { judged_as_ = std::move(info); }
  /// Draws independent scenes, in order, each onto a target of its own: in one call where the
  /// subject takes batches.
  ///
  /// Domain:     scenes that Takes() accepts.
  /// Properties: never writes outside the target or the scissor; equal calls give equal drawings.
  /// Returns:    what came of each job; fewer if one of them EndsTheCall(), and then of that one
  ///             last. After a breakdown the next call starts the subject afresh.
  /// Error:      std::bad_alloc; SubjectDoesNotRun.
  virtual std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs);
  /// Draws the job so many times, and tells what that took: all that the subject does over them,
  /// and nothing of what is done here to ask for it, where the two can be told apart.
  ///
  /// Domain:     a job that Takes() accepts; 1 and more repeats.
  /// Returns:    nothing if it can't tell.
  /// Error:      SubjectStop if a draw gives no answer.
  virtual std::optional<DrawTime> TimeDraws(const DrawJob& /*job*/, int /*repeats*/) { return {}; }
  /// True if many draws in one call cost less than each in a call of its own: of a process.
  virtual bool SharesCalls() const { return false; }
  /// Draws that are not done by then may end with kTooSlow or kDeadline. What runs in this process
  /// can't be stopped, and pays no heed.
  virtual void SetDeadline(std::chrono::steady_clock::time_point /*deadline*/) {}
  /// Another subject of its kind, one for all of this one's life: it shares nothing with this one,
  /// not even what this one has drawn. nullptr where none can be made.
  virtual Subject* Twin() { return nullptr; }
  /// Optional capabilities; nullptr where the subject has none.
  virtual const EdgeEvaluator* Edges() const { return nullptr; }
  virtual const BarycentricEvaluator* Barycentrics() const { return nullptr; }

 protected:
  /// How a subject in this process draws one job. It overrides one of these two, or both, and each
  /// makes do with the other; whatever they throw is how the call ended (EndOf).
  ///
  /// Returns:    all that the subject shows, drawn onto zeros.
  virtual Drawing Show(const DrawJob& job);
  /// Adds the coverage of every triangle of the scene to `counts`.
  virtual void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts);

 private:
  std::optional<SubjectInfo> judged_as_;
};

/// Draws one job.
///
/// Error:      SubjectStop if there is no drawing. As DrawMany.
Drawing DrawOne(Subject& subject, const DrawJob& job);

/// Adds what the subject draws of the scene to `counts`.
///
/// Error:      as DrawOne.
void DrawOnto(Subject& subject, const Scene& scene, const DrawOptions& options,
              CoverageCounts& counts);

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUBJECT_H_
