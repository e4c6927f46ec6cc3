// A program that draws, on a pipe: any language, any library, nothing of it in this process.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_PROCESS_H_
#define RASTERPROOF_SUBJECTS_PROCESS_PROCESS_H_

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/evaluators.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {

struct ProcessLimits {
  double seconds = 10;                           ///< of its own time, for one answer
  std::uint64_t bytes = std::uint64_t{4} << 30;  ///< of address space; 0: no limit
};

/// A subject that is a child process speaking protocol.h.
///
/// The child is started at the first draw, in a process group of its own, and again after it died
/// or was killed: what follows a fault is judged on a fresh one. Its standard error is passed on.
///
/// Limits count its own time (own_time.h). A draw that takes longer is asked for once more, alone,
/// on a fresh process, with ten times the limit: three times in the subject's life, if the deadline
/// leaves room for it. No answer then either: it hangs, and so does whatever takes
/// longer than the limit from then on. An answer within the limit counts: it was slow once. All
/// else is kTooSlow. The first answer of a batch is due within the limit, and a batch that
/// takes longer is asked for in parts.
class ProcessSubject final : public Subject {
 public:
  using Clock = std::chrono::steady_clock;

  /// Who wrote the program.
  enum class Program : std::uint8_t {
    kOurs,     ///< it runs, and hosts what may end it
    kTheUsers  ///< it may not run at all: SubjectDoesNotRun
  };

  /// `command` is a program and its arguments; a name without a slash is looked up in PATH.
  ProcessSubject(std::vector<std::string> command, SubjectInfo info, ProcessLimits limits = {},
                 Program program = Program::kOurs);
  ~ProcessSubject() override;

  const SubjectInfo& OwnInfo() const override;
  /// Sends all requests before it waits for the first answer.
  ///
  /// Returns:    where the child breaks down, the job that does it is found by drawing alone, each
  ///             on a fresh child, those that it may have been; if none does it alone, the shortest
  ///             run of jobs that does it, named in the end of its last one. kTooSlow also if the
  ///             command was interrupted; kNotDrawable also if the program can't be started.
  /// Error:      SubjectDoesNotRun if the user's program ends by itself before its first answer,
  ///             and once more where it is asked for one plain triangle alone.
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override;
  /// By one request with repeats where the program takes them, else by as many requests in one
  /// call, so that reading and answering are part of it. The time is of its whole process group.
  std::optional<DrawTime> TimeDraws(const DrawJob& job, int repeats) override;
  /// Error:      of its calls: SubjectStop; SubjectDoesNotRun.
  const EdgeEvaluator* Edges() const override;
  bool SharesCalls() const override { return true; }
  void SetDeadline(Clock::time_point deadline) override;
  /// On a process of its own, with the same limits.
  Subject* Twin() override;

 private:
  class Child;
  class OutOfTime;
  struct Call;
  class ShownEdges;
  std::unique_ptr<Child> TakeChild();
  void RequireThatItRuns();
  std::vector<std::vector<double>> AskValues(std::span<EdgeRequest> requests);
  std::string CallText(std::uint64_t first_id, std::span<const DrawJob> jobs) const;
  Call Ask(std::span<const DrawJob> jobs, double seconds);
  std::vector<DrawOutcome> AskSome(std::span<const DrawJob> jobs);
  DrawOutcome AskAlone(const DrawJob& job);
  DrawOutcome AskAgain(const DrawJob& job, const OutOfTime& slow);
  void TryLonger(const OutOfTime& slow, const std::function<double(double)>& ask);
  bool BreaksDown(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);
  void Trace(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);
  void TraceAlone(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);
  void TraceRun(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);

  std::vector<std::string> command_;
  SubjectInfo info_;
  ProcessLimits limits_;
  std::uint64_t next_id_ = 1;
  Clock::time_point deadline_ = Clock::time_point::max();
  int tries_left_;
  bool may_not_run_;    ///< it has given no answer yet
  bool hangs_ = false;  ///< has been seen to
  std::size_t most_in_a_batch_ = static_cast<std::size_t>(-1);
  std::unique_ptr<Child> child_;
  std::unique_ptr<ShownEdges> edges_;
  std::unique_ptr<ProcessSubject> twin_;
};

/// Asks a fresh process of the program for one plain triangle.
///
/// Error:      SubjectDoesNotRun, with its last words on standard error, if it ends by itself
///             before it says anything.
void RequireThatItAnswers(const std::vector<std::string>& command, const SubjectInfo& info,
                          const ProcessLimits& limits);

/// What a program prints, all of it: at most 1 MiB, within the limits but at least 10 s.
///
/// Error:      InputError that names `place` if it can't be started, does not end in time, or ends
///             with another status than 0; SubjectStop if the command was interrupted.
std::string OutputOf(const std::vector<std::string>& command, const std::string& place,
                     const ProcessLimits& limits = {});

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_PROCESS_H_
