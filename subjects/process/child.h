// A child process with a pipe in each direction and limits on time, memory and lines.
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
  kTooLong,      ///< a line has more bytes than allowed
  kTimedOut,     ///< the limit on its own time came first
  kDeadline,     ///< the deadline came first
  kTooLarge,     ///< it holds more memory than it may (WatchMemory)
  kInterrupted,  ///< the command is to end (groups.h)
};

/// The message of kTooSlow if PipeEnd::kInterrupted ended an exchange.
inline constexpr const char* kInterruptedText = "the command was interrupted before it answered";

/// The text of Ending() for a child that had to be killed.
inline constexpr const char* kStillRan = "still ran";
/// How Ending() begins for a child that ended by itself.
inline constexpr const char* kEnded = "ended with status ";
/// The text of Ending() for a child that ended by itself and reports no failure.
inline constexpr const char* kEndedWell = "ended with status 0";

/// The limits on a child's time: on its own time (own_time.h), and a deadline.
struct Patience {
  using Clock = OwnTime::Clock;
  OwnTime time;
  Clock::time_point deadline = Clock::time_point::max();
};

/// Owns the child: the destructor kills it with its process group and waits for it.
class ChildProcess {
 public:
  using Clock = OwnTime::Clock;

  /// `errors`: the file for its standard error; -1: ProgramErrors().
  ///
  /// Error:      InputError if the program can't be started; SubjectStop if the command was
  ///             interrupted.
  ChildProcess(const std::vector<std::string>& command, std::uint64_t most_bytes, int errors = -1);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Sets the limits on its time from now on.
  Patience Wait(double seconds, Clock::time_point deadline = Clock::time_point::max()) const {
    return {OwnTime(pid_, seconds), deadline};
  }
  /// Processor time of it and its group since they began. Nothing if the system does not report it.
  std::optional<double> Used() const { return ProcessorSeconds(pid_); }
  /// From now on an exchange ends once the group holds so many bytes of memory.
  void WatchMemory(std::uint64_t most_resident) { most_resident_ = most_resident; }
  /// The address space of the child now; 0 if the system does not report it.
  std::uint64_t Bytes() const { return AddressSpace(pid_); }
  /// The most address space that a process of the group has taken so far.
  std::uint64_t MostBytes() const { return MemoryOf(pid_).most_address_space; }
  /// Queues text for the child. It is written while answers are read, so that neither side waits
  /// for the other's full pipe.
  void Say(std::string text);
  bool WasTold() const { return !to_say_.empty(); }
  /// Closes the child's input once all queued text is written.
  void SayNoMore();
  /// Whether the child closed its input before it had read all queued text.
  bool ReadsNoMore() const { return said_ < to_say_.size() && to_child_ < 0; }
  /// Reads a line of at most this many bytes, without its newline. kOpen: `line` holds it, valid
  /// until the next call.
  PipeEnd ReadLine(Patience& patience, std::size_t most_bytes, std::string_view& line);
  /// Reads exactly so many bytes. kOpen: `bytes` holds them, valid until the next call.
  PipeEnd ReadBytes(Patience& patience, std::size_t count, std::string_view& bytes);

  /// Returns the output received after the lines that were read, up to the next newline, without
  /// waiting. Nothing if there is none.
  bool HasUnread(std::string& first_line);

  /// Kills it if it still runs, and returns how it ended: "ended with status 3", "was killed by
  /// signal 11 (Segmentation fault)", "still ran". A child that closed its output has a moment to
  /// end by itself.
  std::string Ending();

 private:
  PipeEnd Exchange(Patience& patience);
  PipeEnd ReadMore(Patience& patience);
  bool WriteSome();
  PipeEnd ReadSome(bool& moved);
  bool HasEnded() const;
  void Close(int& file);
  std::string End(int looks);

  pid_t pid_ = -1;
  std::uint64_t most_resident_ = 0;
  int to_child_ = -1;
  int from_child_ = -1;
  std::string to_say_;
  std::size_t said_ = 0;
  bool last_words_ = false;
  bool lost_ = false;  ///< it did not answer as it should: do not wait for it
  std::string_view Unread() const { return {heard_.data() + heard_from_, heard_to_ - heard_from_}; }

  std::vector<char> heard_;
  std::size_t heard_from_ = 0;  ///< bytes before were read by callers
  std::size_t heard_to_ = 0;    ///< bytes after are free
};

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_CHILD_H_
