#include "subjects/process/own_time.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <system_error>

#include "core/clock.h"

namespace rasterproof::subjects {
namespace {

namespace fs = std::filesystem;

// The fields read from a line of /proc/.../stat (proc(5)).
struct Stat {
  char state = 0;
  pid_t group = 0;
  unsigned flags = 0;
  double seconds = 0;           // of a processor, that of ended children included
  double children_seconds = 0;  // of ended children alone
  long threads = 0;
};

std::optional<Stat> ReadStat(const fs::path& path) {
  std::ifstream in(path);
  std::string line;
  if (!std::getline(in, line)) return std::nullopt;
  // The name before it is in brackets and may hold anything.
  const std::size_t end = line.rfind(')');
  if (end == std::string::npos) return std::nullopt;
  std::istringstream fields(line.substr(end + 1));
  Stat stat;
  std::string skipped;
  fields >> stat.state >> skipped >> stat.group;
  for (int n = 6; n <= 8; ++n) fields >> skipped;
  fields >> stat.flags;
  for (int n = 10; n <= 13; ++n) fields >> skipped;
  std::array<double, 4> ticks{};  // fields 14 to 17: its own, its ended children's
  for (double& part : ticks) fields >> part;
  fields >> skipped >> skipped >> stat.threads;
  if (!fields) return std::nullopt;
  const auto a_second = static_cast<double>(sysconf(_SC_CLK_TCK));
  stat.children_seconds = (ticks[2] + ticks[3]) / a_second;
  stat.seconds = (ticks[0] + ticks[1]) / a_second + stat.children_seconds;
  return stat;
}

// Runs, wants to run, or waits for a disk.
bool IsBusy(char state) { return state == 'R' || state == 'D'; }

bool HasBusyThread(const fs::path& process) {
  std::error_code gone;
  for (const auto& thread : fs::directory_iterator(process / "task", gone)) {
    const std::optional<Stat> stat = ReadStat(thread.path() / "stat");
    if (stat && IsBusy(stat->state)) return true;
  }
  return false;
}

// Of a time between two looks, so many ticks at most count as sleep.
constexpr double kMostTicksSeen = 2;

struct GroupState {
  double seconds = 0;
  bool busy = false;
};

// Calls `look` with the number, the stat and the folder of every process of the group.
template <class Look>
void LookAtGroup(pid_t group, const Look& look) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator("/proc", none)) {
    const std::string name = entry.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    const std::optional<Stat> stat = ReadStat(entry.path() / "stat");
    if (stat && stat->group == group) look(std::stoi(name), *stat, entry.path());
  }
}

// Nothing if /proc shows no process of the group.
std::optional<GroupState> StateOf(pid_t group) {
  std::optional<GroupState> state;
  LookAtGroup(group, [&](pid_t, const Stat& stat, const fs::path& process) {
    if (!state) state.emplace();
    state->seconds += stat.seconds;
    state->busy = state->busy || IsBusy(stat.state) || (stat.threads > 1 && HasBusyThread(process));
  });
  return state;
}

OwnTime::Clock::duration Duration(double seconds) {
  return std::chrono::duration_cast<OwnTime::Clock::duration>(
      std::chrono::duration<double>(seconds));
}

}  // namespace

OwnTime::OwnTime(pid_t group, double limit)
    : group_(group),
      limit_(limit),
      tick_(Duration(std::clamp(limit / 20, 0.01, 0.25))),
      began_(Clock::now()),
      seen_(began_) {}

OwnTime::Clock::duration OwnTime::UntilNextLook() const {
  return std::max(seen_ + tick_ - Clock::now(), Clock::duration::zero());
}

void OwnTime::Look(bool moved) {
  const Clock::time_point now = Clock::now();
  if (now - seen_ < tick_) return;
  const double passed = std::chrono::duration<double>(now - seen_).count();
  seen_ = now;
  const std::optional<GroupState> state = StateOf(group_);
  if (!state) {
    asleep_ += moved ? 0 : passed;
    return;
  }
  // Its time before the first look is unknown and counts as none.
  const double used = std::max(state->seconds - before_.value_or(state->seconds), 0.0);
  const bool is_first = !before_;
  before_ = state->seconds;
  used_ += used;
  if (moved || state->busy || is_first) return;
  // A look that comes late, because this process had to wait itself, does not see what the group
  // did meanwhile: it may have waited for a processor, too.
  const double seen =
      std::min(passed, kMostTicksSeen * std::chrono::duration<double>(tick_).count());
  asleep_ += std::max(seen - used, 0.0);
}

double OwnTime::Counted() const { return std::min(used_ + asleep_, Elapsed()); }

bool OwnTime::IsOver() const { return Counted() >= limit_ || Elapsed() >= kMostWaiting * limit_; }

std::string OwnTime::Text() const {
  const double used = std::min(used_, Elapsed() - asleep_);
  const auto rounded = [](double seconds) { return SecondsText(std::max(seconds, 0.0)); };
  if (WasStarved()) {
    return "in " + rounded(Elapsed()) + " it got " + rounded(used) +
           " of processor time from a loaded machine, and slept for " + rounded(asleep_);
  }
  constexpr double kSmallShare = 0.05;
  if (asleep_ < kSmallShare * limit_) return "it used " + rounded(used) + " of processor time";
  if (used < kSmallShare * limit_) return "it slept for " + rounded(asleep_);
  return "it used " + rounded(used) + " of processor time and slept for " + rounded(asleep_);
}

std::optional<double> ProcessorSeconds(pid_t group) {
  std::optional<double> sum;
  LookAtGroup(group, [&](pid_t process, const Stat& stat, const fs::path&) {
    clockid_t clock{};
    const bool has_clock = clock_getcpuclockid(process, &clock) == 0;
    const double own = stat.seconds - stat.children_seconds;
    sum = sum.value_or(0) + stat.children_seconds + (has_clock ? SecondsOf(clock) : own);
  });
  return sum;
}

GroupMemory MemoryOf(pid_t group) {
  GroupMemory memory;
  LookAtGroup(group, [&](pid_t, const Stat&, const fs::path& process) {
    std::ifstream in(process / "status");
    for (std::string line; std::getline(in, line);) {
      const std::size_t value = line.find(':') + 1;
      const auto bytes = [&] { return 1024 * std::strtoull(line.c_str() + value, nullptr, 10); };
      if (line.starts_with("VmRSS:")) memory.resident += bytes();
      if (line.starts_with("VmPeak:"))
        memory.most_address_space = std::max<std::uint64_t>(memory.most_address_space, bytes());
    }
  });
  return memory;
}

std::uint64_t AddressSpace(pid_t process) {
  std::ifstream in("/proc/" + std::to_string(process) + "/statm");
  std::uint64_t pages = 0;
  in >> pages;
  return in ? pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE)) : 0;
}

bool IsExiting(pid_t process) {
  constexpr unsigned kExiting = 0x4;  // PF_EXITING of the kernel
  const std::optional<Stat> stat = ReadStat("/proc/" + std::to_string(process) + "/stat");
  return stat && (stat->flags & kExiting) != 0;
}

std::string SecondsText(double seconds) {
  std::array<char, 32> digits{};
  std::snprintf(digits.data(), digits.size(), "%.3g s", seconds);
  return digits.data();
}

}  // namespace rasterproof::subjects
