// How long a child takes by its own clock: what a loaded machine keeps from it does not count.
#ifndef RASTERPROOF_SUBJECTS_PROCESS_OWN_TIME_H_
#define RASTERPROOF_SUBJECTS_PROCESS_OWN_TIME_H_

#include <sys/types.h>

#include <chrono>
#include <optional>
#include <string>

namespace rasterproof::subjects {

/// Counts processor time of a process group where it computes, and wall clock where it sleeps.
///
/// Time in which it wants a processor and gets none, or waits for a disk, counts as neither, and
/// processor time of many threads no more than wall clock: what is counted is never more than wall
/// clock. So that a wait ends even where a machine gives nothing, kMostWaiting times the limit of
/// wall clock end it too.
///
/// Measured:   in ticks of 10 ms, by /proc; without /proc wall clock counts.
class OwnTime {
 public:
  using Clock = std::chrono::steady_clock;
  static constexpr double kMostWaiting = 20;

  OwnTime(pid_t group, double limit);

  /// How long to wait before the next look.
  Clock::duration UntilNextLook() const;
  /// Takes the time since the last look into account, if there is enough of it. `moved`: something
  /// went over the pipes since, so that nobody slept over it.
  void Look(bool moved);

  bool IsOver() const;
  /// Whether it is over because the machine gave the group too little of its time.
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

/// Processor time of the group's processes by their own clocks, in all threads; that of their ended
/// children in ticks of 10 ms. Nothing if /proc shows no process of the group.
std::optional<double> ProcessorSeconds(pid_t group);

/// Whether the process is past its last instruction, though it may still be there.
bool IsExiting(pid_t process);

/// "0.05 s", "10 s".
std::string SecondsText(double seconds);

}  // namespace rasterproof::subjects

#endif  // RASTERPROOF_SUBJECTS_PROCESS_OWN_TIME_H_
