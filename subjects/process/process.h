// A program that draws, on a pipe: any language, any library, nothing of it in this process.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_PROCESS_H_
#define RASTERPROOF_SUBJECTS_PROCESS_PROCESS_H_

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/subject.h"

namespace rasterproof::subjects {

struct ProcessLimits {
  double seconds = 10;                                  ///< for one answer, or one batch
  std::uint64_t bytes = std::uint64_t{4} << 30;         ///< of address space; 0: no limit
  std::uint64_t answer_bytes = std::uint64_t{8} << 30;  ///< of one answer
};

/// A subject that is a child process speaking protocol.h.
///
/// The child is started at the first draw, in a process group of its own, and again after it died
/// or was killed: what follows a fault is judged on a fresh one. Its standard error is passed on.
class ProcessSubject final : public Subject {
 public:
  /// `command` is a program and its arguments; a name without a slash is looked up in PATH.
  ProcessSubject(std::vector<std::string> command, SubjectInfo info, ProcessLimits limits = {});
  ~ProcessSubject() override;

  const SubjectInfo& Info() const override;
  /// Error:      SubjectFault if it died (the signal or status is told), gave no answer in time, or
  ///             answered something else; InputError if it refused the scene or can't be started.
  void Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) override;
  Drawing Show(const DrawJob& job) override;
  /// Sends all requests before it waits for the first answer.
  ///
  /// Error:      where the child breaks down, the job that does it is found by drawing alone, each
  ///             on a fresh child, those that it may have been; if none does it alone, the shortest
  ///             run of jobs that does it, told in the fault of its last one.
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override;
  /// Error:      of its calls: as Draw.
  const EdgeEvaluator* Edges() const override;

 private:
  class Child;
  class ShownEdges;
  std::vector<double> AskValues(Point2 a, Point2 b, Point2 p, std::optional<Step> step, int steps);
  std::vector<DrawOutcome> Ask(std::span<const DrawJob> jobs, double seconds);
  bool BreaksDown(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);
  void Trace(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);
  void TraceRun(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);

  std::vector<std::string> command_;
  SubjectInfo info_;
  ProcessLimits limits_;
  std::uint64_t next_id_ = 1;
  std::unique_ptr<Child> child_;
  std::unique_ptr<ShownEdges> edges_;
};

/// What a program prints, all of it, within the limits.
///
/// Error:      InputError that names `place` if it can't be started, does not end in time, or ends
///             with another status than 0.
std::string OutputOf(const std::vector<std::string>& command, const std::string& place,
                     const ProcessLimits& limits = {});

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_PROCESS_H_
