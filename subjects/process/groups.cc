#include "subjects/process/groups.h"

#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/eventfd.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kMostGroups = 1024;
constexpr pid_t kReserved = -1;

// In memory that the keeper shares. 0: a free place; kReserved: a child that is not there yet.
using Groups = std::array<std::atomic<pid_t>, kMostGroups>;
static_assert(std::atomic<pid_t>::is_always_lock_free);
static_assert(std::atomic<int>::is_always_lock_free);

std::atomic<bool> interrupted{false};
std::atomic<int> interrupted_file{-1};
std::atomic<Groups*> groups{nullptr};
// Held by this process alone, and by each child until its group is in the list: what the keeper
// reads of it ends when this process has ended.
std::atomic<int> lifeline{-1};
std::mutex forking;
pid_t keeper = -1;
pid_t owner = -1;  // the process that the keeper works for; a child that forks needs its own

void KillAll(Groups& all) noexcept {
  for (std::atomic<pid_t>& group : all) {
    if (const pid_t pid = group.load(); pid > 0) kill(-pid, SIGKILL);
  }
}

void CloseAllBut(int kept) {
  constexpr unsigned kLast = ~0U;
  const auto file = static_cast<unsigned>(kept);
  if (close_range(file + 1, kLast, 0) == 0) {
    close_range(0, file - 1, 0);
    return;
  }
  constexpr int kMostFiles = 1 << 16;
  for (int n = 0; n < kMostFiles; ++n) {
    if (n != kept) close(n);
  }
}

// Holds no file of this process's but its end of the lifeline, so that no reader of a pipe waits
// for the keeper. Nothing here may allocate.
[[noreturn]] void Keep(int life, Groups& all) {
  setpgid(0, 0);  // a signal to the command's group is not meant for it
  prctl(PR_SET_NAME, "rp-keeper");
  CloseAllBut(life);
  char byte = 0;
  while (read(life, &byte, 1) < 0 && errno == EINTR) {
  }
  KillAll(all);
  _exit(0);
}

void DismissKeeper() {
  if (owner != getpid()) return;
  if (Groups* const all = groups.load()) KillAll(*all);
  if (keeper < 0) return;
  kill(keeper, SIGKILL);
  waitpid(keeper, nullptr, 0);
}

// Nothing, or errno.
int StartKeeper() {
  void* const at =
      mmap(nullptr, sizeof(Groups), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (at == MAP_FAILED) return errno;
  auto* const all = new (at) Groups{};
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) return errno;
  const int read_end = AboveStandard(ends[0]);
  const int write_end = AboveStandard(ends[1]);
  const int wake = AboveStandard(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (read_end < 0 || write_end < 0 || wake < 0) return errno;
  keeper = fork();
  if (keeper == 0) {
    Keep(read_end, *all);
  }
  const int error = errno;
  close(read_end);
  if (keeper < 0) return error;
  groups = all;
  lifeline = write_end;
  interrupted_file = wake;
  if (owner < 0) std::atexit(DismissKeeper);
  owner = getpid();
  return 0;
}

std::atomic<pid_t>* ReservePlace() {
  for (std::atomic<pid_t>& group : *groups.load()) {
    pid_t free = 0;
    if (group.compare_exchange_strong(free, kReserved)) return &group;
  }
  return nullptr;
}

// The child's side. Nothing here may allocate: another thread may have held the heap's lock.
void BeginGroup(std::atomic<pid_t>& place) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGCHLD}) signal(number, SIG_DFL);
  setpgid(0, 0);
  place = getpid();
  close(lifeline.exchange(-1));
  owner = 0;  // none is mine
  groups = nullptr;
}

void NoticeChildren() {
  struct sigaction action{};
  if (sigaction(SIGCHLD, nullptr, &action) != 0) return;
  const bool noticed = action.sa_handler != SIG_IGN && (action.sa_flags & SA_NOCLDWAIT) == 0;
  if (!noticed) signal(SIGCHLD, SIG_DFL);
}

void FreePlaceOf(pid_t group) {
  Groups* const all = groups.load();
  if (all == nullptr) return;
  for (std::atomic<pid_t>& place : *all) {
    pid_t expected = group;
    if (place.compare_exchange_strong(expected, 0)) return;
  }
}

}  // namespace

pid_t ForkGroup() {
  const std::lock_guard lock(forking);
  NoticeChildren();
  if (owner != getpid()) {
    if (const int error = StartKeeper(); error != 0) {
      errno = error;
      return -1;
    }
  }
  std::atomic<pid_t>* const place = ReservePlace();
  if (place == nullptr) {
    errno = EAGAIN;
    return -1;
  }
  // No handler of this process's may run in the child.
  sigset_t all;
  sigset_t before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t pid = fork();
  const int error = errno;
  if (pid == 0) {
    BeginGroup(*place);
    sigemptyset(&all);
    pthread_sigmask(SIG_SETMASK, &all, nullptr);
    return 0;
  }
  if (pid > 0) setpgid(pid, pid);  // whoever is first, it is done before it is killed
  *place = pid > 0 ? pid : 0;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (pid > 0 && interrupted) kill(-pid, SIGKILL);  // a handler may have come before its place
  errno = error;
  return pid;
}

void EndGroup(pid_t group, int& status) {
  kill(-group, SIGKILL);
  kill(group, SIGKILL);
  FreePlaceOf(group);  // while the number is its own
  while (waitpid(group, &status, 0) < 0 && errno == EINTR) {
  }
}

void Interrupt() noexcept {
  const int error = errno;
  interrupted = true;
  if (Groups* const all = groups.load()) KillAll(*all);
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(interrupted_file.load(), &one, sizeof one);
  errno = error;
}

int AboveStandard(int file) {
  if (file < 0 || file > STDERR_FILENO) return file;
  const int above = fcntl(file, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  close(file);
  return above;
}

bool Interrupted() noexcept { return interrupted; }

int InterruptedFile() noexcept { return interrupted_file; }

}  // namespace rasterproof::subjects
