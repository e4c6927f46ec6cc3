// How long a child takes by its own clock: time lost to the machine's load does not count.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_OWN_TIME_H_
#define RASTERPROOF_SUBJECTS_PROCESS_OWN_TIME_H_

#include <sys/types.h>

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace rasterproof::subjects {

/// Counts processor time of a process group where it computes, and wall clock where it sleeps.
///
/// Waiting for a processor or for a disk is not counted, nor is sleep that nobody looked at because
/// this process waited for a processor; processor time of many threads counts
/// as at most the wall clock: the sum never exceeds wall clock. So that a wait ends even if the
/// machine gives the group no time, kMostWaiting times the limit in wall clock ends it too.
///
/// Measured:   in ticks of 10 ms, by /proc; without /proc wall clock counts.
class OwnTime {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr double kMostWaiting = 20;

  OwnTime(pid_t group, double limit);

  /// How long to wait before the next look.
  Clock::duration UntilNextLook() const;
  /// Counts the time since the last look, if there is enough of it. `moved`: bytes went over the
  /// pipes since, so that the time is not counted as sleep.
  void Look(bool moved);

  bool IsOver() const;
  /// Whether the limit was reached because the machine gave the group too little time.
  bool WasStarved() const { return Counted() < limit_; }
  /// "it used 10 s of processor time", "it slept for 10 s", or both.
  std::string Text() const;
  double Counted() const;

 private:
  double Elapsed() const { return std::chrono::duration<double>(seen_ - began_).count(); }

  pid_t group_;
  double limit_;
  Clock::duration tick_;
  Clock::time_point began_;
  Clock::time_point seen_;
  double asleep_ = 0;
  double used_ = 0;               ///< of a processor
  std::optional<double> before_;  ///< the group's processor time at the last look
};

/// Returns the processor time of the group's processes in all threads, by their own clocks; for
/// ended children in ticks of 10 ms. Nothing if /proc shows no process of the group.
std::optional<double> ProcessorSeconds(pid_t group);

/// What the processes of a group take of memory, in bytes. 0 where the system does not report it.
struct GroupMemory {
  std::uint64_t resident = 0;            ///< all of them together
  std::uint64_t most_address_space = 0;  ///< the most that one has taken so far
};
GroupMemory MemoryOf(pid_t group);
/// The address space of one process now.
std::uint64_t AddressSpace(pid_t process);

/// Whether the process is past its last instruction, though it may still be there.
bool IsExiting(pid_t process);

/// "0.05 s", "10 s".
std::string SecondsText(double seconds);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_OWN_TIME_H_
