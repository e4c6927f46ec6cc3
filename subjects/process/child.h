// A child process with a pipe either way and a deadline on everything.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_CHILD_H_
#define RASTERPROOF_SUBJECTS_PROCESS_CHILD_H_

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace rasterproof::subjects {

/// How an exchange with a child ended.
enum class PipeEnd : std::uint8_t {
  kOpen,        ///< the child goes on
  kClosed,      ///< the child closed its output: it ended, or is about to
  kTimedOut,    ///< the deadline came first
  kInterrupted  ///< the command is to end (groups.h)
};

/// What SubjectTooSlow says where PipeEnd::kInterrupted ended an exchange.
inline constexpr const char* kInterruptedText = "the command was interrupted before it answered";

/// Owns the child: it is killed, with its process group, and waited for when this goes.
class ChildProcess {
 public:
  using Clock = std::chrono::steady_clock;

  /// Error:      InputError if the program can't be started; SubjectTooSlow if the command was
  ///             interrupted.
  ChildProcess(const std::vector<std::string>& command, std::uint64_t most_bytes);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// What the child is told next; it leaves while answers are read, so that neither side waits for
  /// the other's full pipe.
  void Say(std::string text);
  /// Closes the child's input once all was said.
  void SayNoMore();
  /// Reads a line, without its end. kOpen: `line` holds it.
  PipeEnd ReadLine(Clock::time_point deadline, std::size_t most_bytes, std::string& line);

  /// What it has said by now beyond the lines that were read; does not wait. Its first line.
  std::string Unread();

  /// Kills what still runs, and says how it ended: "ended with status 3", "was killed by signal 11
  /// (Segmentation fault)", "still ran".
  std::string Ending();

 private:
  PipeEnd Exchange(Clock::time_point deadline);
  void CloseInput();

  pid_t pid_ = -1;
  int to_child_ = -1;
  int from_child_ = -1;
  std::string to_say_;
  std::size_t said_ = 0;
  bool last_words_ = false;
  std::string heard_;
  std::size_t heard_from_ = 0;  ///< what lies before was given out
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_CHILD_H_
