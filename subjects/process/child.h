// A child process with a pipe either way and a limit on everything.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_CHILD_H_
#define RASTERPROOF_SUBJECTS_PROCESS_CHILD_H_

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "subjects/process/own_time.h"

namespace rasterproof::subjects {

/// How an exchange with a child ended.
enum class PipeEnd : std::uint8_t {
  kOpen,         ///< the child goes on
  kClosed,       ///< the child closed its output: it ended, or is about to
  kTooLong,      ///< a line has more bytes than it may
  kTimedOut,     ///< its own time was over first
  kDeadline,     ///< the deadline came first
  kInterrupted,  ///< the command is to end (groups.h)
};

/// What kTooSlow says where PipeEnd::kInterrupted ended an exchange.
inline constexpr const char* kInterruptedText = "the command was interrupted before it answered";

/// What Ending() says of a child that had to be killed.
inline constexpr const char* kStillRan = "still ran";
/// How it begins of one that ended by itself.
inline constexpr const char* kEnded = "ended with status ";

/// How long a child may take: of its own time, and until when.
struct Patience {
  using Clock = OwnTime::Clock;
  OwnTime time;
  Clock::time_point deadline = Clock::time_point::max();
};

/// Owns the child: it is killed, with its process group, and waited for when this goes.
class ChildProcess {
 public:
  using Clock = OwnTime::Clock;

  /// `errors`: the file that it has for its standard error; -1: this program's own.
  ///
  /// Error:      InputError if the program can't be started; SubjectStop if the command was
  ///             interrupted.
  ChildProcess(const std::vector<std::string>& command, std::uint64_t most_bytes, int errors = -1);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The time that it takes from here on.
  Patience Wait(double seconds, Clock::time_point deadline = Clock::time_point::max()) const {
    return {OwnTime(pid_, seconds), deadline};
  }
  /// Processor time of it and its group since they began. Nothing: the system does not tell.
  std::optional<double> Used() const { return ProcessorSeconds(pid_); }
  /// What the child is told next; it leaves while answers are read, so that neither side waits for
  /// the other's full pipe.
  void Say(std::string text);
  bool WasTold() const { return !to_say_.empty(); }
  /// Closes the child's input once all was said.
  void SayNoMore();
  /// Whether the child closed its input before it had read all that it was told.
  bool ReadsNoMore() const { return said_ < to_say_.size() && to_child_ < 0; }
  /// Reads a line of at most so many bytes, without its end. kOpen: `line` is it, until the next
  /// call.
  PipeEnd ReadLine(Patience& patience, std::size_t most_bytes, std::string_view& line);

  /// What it has said by now beyond the lines that were read, up to its first line's end; does not
  /// wait. Nothing: it has said no more.
  bool HasUnread(std::string& first_line);

  /// Kills what still runs, and says how it ended: "ended with status 3", "was killed by signal 11
  /// (Segmentation fault)", "still ran". A child that closed its output is given a moment to end.
  std::string Ending();

 private:
  PipeEnd Exchange(Patience& patience);
  bool WriteSome();
  PipeEnd ReadSome(bool& moved);
  bool HasEnded() const;
  void Close(int& file);
  std::string End(int looks);

  pid_t pid_ = -1;
  int to_child_ = -1;
  int from_child_ = -1;
  std::string to_say_;
  std::size_t said_ = 0;
  bool last_words_ = false;
  bool lost_ = false;  ///< it did not answer as it should: nothing is worth waiting for
  std::string_view Unread() const { return {heard_.data() + heard_from_, heard_to_ - heard_from_}; }

  std::vector<char> heard_;
  std::size_t heard_from_ = 0;  ///< what lies before was given out
  std::size_t heard_to_ = 0;    ///< what lies behind is room
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_CHILD_H_
