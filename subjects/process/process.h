// A program that draws, on a pipe: in any language, with any library, outside this process.
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

#include "core/call_end.h"
#include "core/evaluators.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "subjects/process/limits.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {

/// A subject that is a child process speaking protocol.h.
///
/// The child is started at the first draw, in its own process group, and restarted after it died or
/// was killed: the draws after a fault go to a fresh process. Its standard error is passed on.
///
/// Limits count its own time (own_time.h). An answer is waited for ten times as long as the limit,
/// at most three times in the subject's life, and only if the deadline leaves room. If none came,
/// the subject hangs: that is told, whether a fresh process does it again when it is asked the same
/// alone, or not. If one came late, the draw is repeated alone on a fresh process: an answer within
/// the limit counts, and everything else is kTooSlow. Once a fresh process did not answer either,
/// every draw over the limit is a hang. The first answer of a batch is due within the limit; one
/// that takes longer makes later batches smaller, and one without an answer is sent in parts.
///
/// A process that ended is asked the same once more, on a fresh process without the limit on
/// memory: if it takes more than the limit, that is kOutOfMemory, and the limit is named. A user's
/// program may end with status 0 between two answers; what it was asked meanwhile goes to a fresh
/// process.
class ProcessSubject final : public Subject {
 public:
  using Clock = std::chrono::steady_clock;

  /// Who wrote the program.
  enum class Program : std::uint8_t {
    kOurs,     ///< it runs, and hosts what may end it
    kTheUsers  ///< it may not run at all: SubjectDoesNotRun
  };

  /// `command` is a program and its arguments; a name without a slash is looked up in PATH.
  ///
  /// Domain:     SIGPIPE is ignored, as a program may end before it has read all that it is asked.
  ProcessSubject(std::vector<std::string> command, SubjectInfo info, ProcessLimits limits = {},
                 Program program = Program::kOurs);
  ~ProcessSubject() override;

  const SubjectInfo& OwnInfo() const override;
  /// Sends all requests before it waits for the first answer.
  ///
  /// Returns:    if the child breaks down, each job that may be the cause is drawn alone on a fresh
  ///             child to find it; if none breaks it alone, the shortest run of jobs that does is
  ///             named in the end of its last one. kTooSlow also if the command was interrupted;
  ///             kNotDrawable also if the program can't be started.
  /// Error:      SubjectDoesNotRun if the user's program ends by itself before its first answer,
  ///             and again when it is asked for a single plain triangle.
  std::vector<DrawOutcome> DrawMany(std::span<const DrawJob> jobs) override;
  /// Times one request with repeats if the program takes them; else as many requests in one call,
  /// which includes reading and answering. The time is that of its whole process group.
  std::optional<DrawTime> TimeDraws(const DrawJob& job, int repeats) override;
  /// Error:      of its calls: SubjectStop; SubjectDoesNotRun.
  const EdgeEvaluator* Edges() const override;
  bool SharesCalls() const override { return true; }
  void SetDeadline(Clock::time_point deadline) override;
  /// The twin runs in its own process, with the same limits.
  Subject* Twin() override;

 private:
  class Child;
  class OutOfTime;
  struct Call;
  struct Wait;
  class Ended;
  class ShownEdges;
  std::unique_ptr<Child> TakeChild();
  void RequireThatItRuns();
  std::vector<std::vector<double>> AskValues(std::span<EdgeRequest> requests);
  double AskOpenValues(std::span<EdgeRequest> requests, const Wait& wait,
                       std::vector<std::vector<double>>& answers);
  std::string CallText(std::uint64_t first_id, std::span<const DrawJob> jobs) const;
  Call Ask(std::span<const DrawJob> jobs, const Wait& wait);
  Call AskOnce(std::span<const DrawJob> jobs, const Wait& wait);
  void AskNoting(Call& call, const std::function<void()>& ask);
  bool MayBeginAfresh(const Ended& ended, std::span<const DrawJob> jobs,
                      std::size_t answered) const;
  void BlameMemory(std::span<const DrawJob> jobs, Call& call);
  Wait LongestWait() const;
  std::vector<DrawOutcome> AskSome(std::span<const DrawJob> jobs);
  DrawOutcome AskAlone(const DrawJob& job);
  std::vector<DrawOutcome> AskInParts(std::span<const DrawJob> jobs, Call silent, const Wait& wait);
  DrawOutcome AskAgain(const DrawJob& job, const OutOfTime& slow, const Wait& wait);
  void TryAgain(const OutOfTime& slow, const Wait& wait,
                const std::function<void(const Wait&)>& ask);
  CallEnd EndOfSilence(const OutOfTime& slow, const Wait& wait, double in_parts,
                       std::size_t requests) const;
  bool BreaksDown(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);
  void Trace(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);
  void TraceAlone(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);
  void TraceRun(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes);

  std::vector<std::string> command_;
  SubjectInfo info_;
  ProcessLimits limits_;
  std::uint64_t next_id_ = 1;
  Clock::time_point deadline_ = Clock::time_point::max();
  int waits_left_;
  bool is_the_users_;
  bool may_not_run_;          ///< it has given no answer yet
  bool hangs_ = false;        ///< it was seen to hang
  bool is_in_parts_ = false;  ///< a batch without an answer is being asked for in parts
  double answered_seconds_ = 0;
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

/// Returns everything that a program prints: at most 1 MiB, within the limits but at least 10 s.
///
/// Error:      InputError that names `place` if it can't be started, does not end in time, or ends
///             with another status than 0; SubjectStop if the command was interrupted.
std::string OutputOf(const std::vector<std::string>& command, const std::string& place,
                     const ProcessLimits& limits = {});

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_PROCESS_H_
