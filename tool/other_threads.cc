#include "tool/other_threads.h"

#include "core/float_environment.h"
#include "core/float_mode.h"

#if defined(__x86_64__) && defined(__linux__)
#include <sys/syscall.h>
#include <ucontext.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <string>
#include <thread>
#endif

namespace rasterproof::tool {

#if defined(__x86_64__) && defined(__linux__)
namespace {

std::atomic<std::uint32_t> wanted = 0;
std::atomic<int> handled = 0;

void SetMode(int /*signal*/, siginfo_t* /*info*/, void* context) {
  auto* const machine = &static_cast<ucontext_t*>(context)->uc_mcontext;
  std::uint32_t& bits = machine->fpregs->mxcsr;
  bits = (bits & ~FloatEnvironment::kMode) | wanted.load();
  handled.fetch_add(1);
}

}  // namespace

bool CanSetOtherThreads() { return true; }

void SetModeOfOtherThreads(FloatMode mode) {
  const int number = SIGRTMAX - 2;
  struct sigaction action = {};
  action.sa_sigaction = SetMode;
  action.sa_flags = SA_SIGINFO | SA_RESTART;
  sigaction(number, &action, nullptr);
  wanted = ControlBits(mode);
  handled = 0;
  int asked = 0;
  const auto self = syscall(SYS_gettid);
  for (const auto& entry : std::filesystem::directory_iterator("/proc/self/task")) {
    const long thread = std::stol(entry.path().filename().string());
    if (thread != self && syscall(SYS_tgkill, getpid(), thread, number) == 0) ++asked;
  }
  // A thread that sleeps runs its handler at once; one that blocks the signal never does.
  for (int k = 0; k < 1000 && handled < asked; ++k) {
    std::this_thread::sleep_for(std::chrono::microseconds(20));
  }
}
#else
bool CanSetOtherThreads() { return false; }

void SetModeOfOtherThreads(FloatMode /*mode*/) {}
#endif

}  // namespace rasterproof::tool
