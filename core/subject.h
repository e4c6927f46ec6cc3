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
  /// Adds the coverage of every triangle of the scene to `counts`.
  ///
  /// Domain:     a scene that Takes() accepts; counts of the scene's and the profile's shape.
  /// Properties: never writes outside the target or the scissor; equal calls give equal counts.
  /// Error:      SubjectRefusal if it refuses the scene; SubjectFault if it broke down over it, and
  ///             SubjectTooSlow if it took longer than it may (the next call starts it afresh).
  virtual void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) = 0;
  /// Draws onto a target of its own and gives back all that the subject shows.
  ///
  /// Error:      as Draw.
  virtual Drawing Show(const DrawJob& job);
  /// Draws independent scenes, in order, each onto a target of its own: in one call where the
  /// subject takes batches.
  ///
  /// Returns:    one outcome for each job; fewer if the subject broke down, and then the last one
  ///             holds what it threw. A scene that it refuses is no breakdown.
  virtual std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs);
  /// Draws the job so many times, and tells what that took: all that the subject does over them,
  /// and nothing of what is done here to ask for it, where the two can be told apart.
  ///
  /// Domain:     a job that Takes() accepts; 1 and more repeats.
  /// Returns:    nothing if it can't tell.
  /// Error:      as Draw.
  virtual std::optional<DrawTime> TimeDraws(const DrawJob& /*job*/, int /*repeats*/) { return {}; }
  /// True if many draws in one call cost less than each in a call of its own: of a process.
  virtual bool SharesCalls() const { return false; }
  /// Draws that are not done by then may end with SubjectTooSlow. What runs in this process can't
  /// be stopped, and pays no heed.
  virtual void SetDeadline(std::chrono::steady_clock::time_point /*deadline*/) {}
  /// Another subject of its kind, one for all of this one's life: it shares nothing with this one,
  /// not even what this one has drawn. nullptr where none can be made.
  virtual Subject* Twin() { return nullptr; }
  /// Optional capabilities; nullptr where the subject has none.
  virtual const EdgeEvaluator* Edges() const { return nullptr; }
  virtual const BarycentricEvaluator* Barycentrics() const { return nullptr; }

 private:
  std::optional<SubjectInfo> judged_as_;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_SUBJECT_H_
