#include "tool/survey/isolated.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>

#include "subjects/process/groups.h"

namespace rasterproof::tool {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kThrew = 1;
constexpr auto kLook = std::chrono::milliseconds(20);

[[noreturn]] void RunAsChild(const std::function<void()>& work) {
  try {
    work();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    _exit(kThrew);
  }
  // Neither destructors nor atexit: a library's own clean-up is not what is surveyed.
  _exit(0);
}

std::string End(int status) {
  if (WIFSIGNALED(status)) return "killed by signal " + std::to_string(WTERMSIG(status));
  if (WEXITSTATUS(status) != 0) return "ended with status " + std::to_string(WEXITSTATUS(status));
  return "";
}

// Not yet waited for: its number stays its own until its group is ended.
bool HasEnded(pid_t child) {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT | WNOHANG) == 0 &&
         info.si_pid == child;
}

}  // namespace

std::string RunIsolated(const std::function<void()>& work,
                        const std::atomic<std::uint64_t>& progress, double stall_seconds) {
  const pid_t child = subjects::ForkGroup();
  if (child < 0) return "no process could be made";
  if (child == 0) RunAsChild(work);
  std::uint64_t seen = progress;
  Clock::time_point since = Clock::now();
  while (true) {
    int status = 0;
    if (HasEnded(child)) {
      subjects::EndGroup(child, status);
      return End(status);
    }
    std::this_thread::sleep_for(kLook);
    if (progress != seen) {
      seen = progress;
      since = Clock::now();
    } else if (Clock::now() - since > std::chrono::duration<double>(stall_seconds)) {
      subjects::EndGroup(child, status);
      return "no answer for " + std::to_string(static_cast<int>(stall_seconds)) + " s";
    }
  }
}

}  // namespace rasterproof::tool
