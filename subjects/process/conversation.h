// What ProcessSubject's parts share: a running program, and how a call to it ended.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_CONVERSATION_H_
#define RASTERPROOF_SUBJECTS_PROCESS_CONVERSATION_H_

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "core/quoted.h"
#include "subjects/process/child.h"
#include "subjects/process/process.h"

namespace rasterproof::subjects {

/// How long an answer is waited for, in the program's own time.
struct ProcessSubject::Wait {
  double limit = 0;  ///< what it may take
  double most = 0;   ///< when it counts as hanging, if that is more

  bool IsLong() const { return most > limit; }
};

/// It took longer than its limit. What is thrown to callers says what that means.
class ProcessSubject::OutOfTime : public SubjectStop {
 public:
  /// It gave no answer at all.
  explicit OutOfTime(const OwnTime& time)
      : SubjectStop(Stop::kTooSlow, time.Text() + " and gave no answer"),
        starved_(time.WasStarved()) {}
  /// It answered, but late.
  explicit OutOfTime(double seconds)
      : SubjectStop(Stop::kTooSlow, "it answered after " + SecondsText(seconds)),
        gave_answer_(true) {}

  bool GaveAnswer() const { return gave_answer_; }
  /// Whether there was no answer because the machine gave it too little time.
  bool WasStarved() const { return starved_; }

 private:
  bool gave_answer_ = false;
  bool starved_ = false;
};

/// The process was gone before its answer was whole.
class ProcessSubject::Ended : public SubjectStop {
 public:
  enum class How : std::uint8_t {
    kByItself,
    kCleanly,  ///< by itself, between two answers, with status 0
    kBySignal,
    kTooLarge,  ///< its memory was watched
  };
  Ended(const std::string& what, How how) : SubjectStop(Stop::kBrokeDown, what), how_(how) {}

  How how() const { return how_; }
  bool ByItself() const { return how_ == How::kByItself || how_ == How::kCleanly; }

 private:
  How how_;
};

/// What came of one call.
struct ProcessSubject::Call {
  std::vector<DrawOutcome> outcomes;         ///< up to the one that ended it
  double counted = 0;                        ///< own time that the last answer took
  std::optional<OutOfTime> slow;             ///< the last wait that took longer than its limit
  bool ended = false;                        ///< the process did, or it was out of memory
  bool is_too_large = false;                 ///< it was ended where its memory was watched
  std::uint64_t bytes_before = 0;            ///< the process's address space when it was asked
  std::vector<std::vector<DrawJob>> before;  ///< the calls to that process before
};

/// The running child, and reading its answers.
class ProcessSubject::Child {
 public:
  Child(const std::vector<std::string>& command, const ProcessLimits& limits)
      : process_(command, limits.bytes) {}
  /// One without a limit on its address space, which is ended once it holds so many bytes, and
  /// says nothing.
  Child(const std::vector<std::string>& command, std::uint64_t most_resident, int errors)
      : process_(command, 0, errors) {
    process_.WatchMemory(most_resident);
  }

  void Ask(std::string request) { process_.Say(std::move(request)); }
  std::optional<double> Used() const { return process_.Used(); }
  std::uint64_t Bytes() const { return process_.Bytes(); }
  std::uint64_t MostBytes() const { return process_.MostBytes(); }
  bool HasAnswered() const { return answers_ != 0; }

  /// The calls before the last one, in order; none if they were too many or large to be kept.
  std::vector<std::vector<DrawJob>> CallsBefore() {
    if (!calls_.empty()) calls_.pop_back();
    return std::move(calls_);
  }
  void Remember(std::span<const DrawJob> jobs) {
    constexpr std::size_t kMost = std::size_t{1} << 20;
    for (const DrawJob& job : jobs) {
      kept_ += 1 + job.scene->vertices.size() + job.Triangles().size();
    }
    if (kept_ > kMost) return calls_.clear();
    calls_.emplace_back(jobs.begin(), jobs.end());
  }

  /// Before each answer.
  Patience Wait(double seconds, ChildProcess::Clock::time_point deadline) {
    has_begun_ = false;
    return process_.Wait(seconds, deadline);
  }
  /// Behind each answer.
  void TakeAnswer() { ++answers_; }

  std::string_view Line(Patience& patience, std::size_t most_bytes) {
    std::string_view line;
    const PipeEnd end = process_.ReadLine(patience, most_bytes, line);
    RequireOpen(end, patience, most_bytes);
    has_begun_ = true;
    return line;
  }
  std::string_view Bytes(Patience& patience, std::size_t count) {
    std::string_view bytes;
    const PipeEnd end = process_.ReadBytes(patience, count, bytes);
    RequireOpen(end, patience, count);
    has_begun_ = true;
    return bytes;
  }

  /// Extra output would be taken for the answer to the next request.
  void RequireSilence() {
    std::string more;
    if (!process_.HasUnread(more)) return;
    if (!process_.WasTold()) {
      const std::string why = "it printed before it was asked: " + Quoted(more, 60);
      if (more.find('\n') == std::string::npos) BreakDown(why);
      throw SubjectDoesNotRun(
          "the program", why,
          "write only answers to standard output; greetings and logs go to standard error");
    }
    BreakDown("it printed more than its answer: " + Quoted(more, 60) +
              "; rows of back faces need `coverage facing-counts`");
  }

 private:
  void RequireOpen(PipeEnd end, const Patience& patience, std::size_t most_bytes) {
    switch (end) {
      case PipeEnd::kOpen:
        return;
      case PipeEnd::kTimedOut:
        if (process_.ReadsNoMore()) BreakDown("it closed its input without an answer");
        throw OutOfTime(patience.time);
      case PipeEnd::kDeadline:
        throw SubjectStop(Stop::kDeadline, "it ran out of time before it answered (--seconds)");
      case PipeEnd::kInterrupted:
        throw SubjectStop(Stop::kTooSlow, kInterruptedText);
      case PipeEnd::kTooLong:
        BreakDown("a line of its answer is longer than " + std::to_string(most_bytes) +
                  " bytes, the most that a correct answer to this scene needs");
      case PipeEnd::kTooLarge:
        throw Ended("it took more memory than its limit", Ended::How::kTooLarge);
      case PipeEnd::kClosed:
        break;
    }
    std::string part;
    has_begun_ = process_.HasUnread(part) || has_begun_;
    const std::string ending = process_.Ending();
    const std::string what = "it " + (ending == kStillRan ? "closed its output" : ending) +
                             " before its answer was whole";
    if (ending == kStillRan) BreakDown(what);
    if (!ending.starts_with(kEnded)) throw Ended(what, Ended::How::kBySignal);
    const bool is_clean = ending == kEndedWell && HasAnswered() && !has_begun_;
    throw Ended(what, is_clean ? Ended::How::kCleanly : Ended::How::kByItself);
  }

  std::vector<std::vector<DrawJob>> calls_;
  std::size_t kept_ = 0;
  std::uint64_t answers_ = 0;
  bool has_begun_ = false;  ///< the answer that is waited for
  ChildProcess process_;
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_CONVERSATION_H_
