#include "subjects/process/child.h"

#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <thread>
#include <utility>

#include "core/error.h"
#include "core/subject.h"
#include "subjects/process/groups.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kChunk = 1 << 16;

std::string Reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void CannotStart(const std::string& program, int error) {
  throw InputError(program, "can't be started: " + Reason(error),
                   "give a program that this user may run, with its path");
}

struct Pipe {
  int read = -1;
  int write = -1;
};

Pipe MakePipe(const std::string& program) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) CannotStart(program, errno);
  return {ends[0], ends[1]};
}

void LimitMemory(std::uint64_t bytes) {
  if (bytes == 0) return;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

// The child's side of the fork: nothing here may allocate or throw.
[[noreturn]] void Become(char* const* argv, const Pipe& in, const Pipe& out, int report,
                         std::uint64_t most_bytes) {
  dup2(in.read, STDIN_FILENO);
  dup2(out.write, STDOUT_FILENO);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  LimitMemory(most_bytes);
  execvp(argv[0], argv);
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(report, &error, sizeof error);
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, std::uint64_t most_bytes) {
  if (Interrupted()) throw SubjectTooSlow(kInterruptedText);
  const std::string& program = command.front();
  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const Pipe in = MakePipe(program);
  const Pipe out = MakePipe(program);
  const Pipe report = MakePipe(program);  // closed by a good exec, else tells why it failed
  pid_ = ForkGroup();
  if (pid_ < 0) CannotStart(program, errno);
  if (pid_ == 0) Become(argv.data(), in, out, report.write, most_bytes);
  close(in.read);
  close(out.write);
  close(report.write);
  to_child_ = in.write;
  from_child_ = out.read;
  int error = 0;
  const ssize_t told = read(report.read, &error, sizeof error);
  close(report.read);
  if (told == static_cast<ssize_t>(sizeof error)) {
    Ending();
    CannotStart(program, error);
  }
  fcntl(to_child_, F_SETFL, O_NONBLOCK);
  fcntl(from_child_, F_SETFL, O_NONBLOCK);
}

ChildProcess::~ChildProcess() { Ending(); }

void ChildProcess::CloseInput() {
  if (to_child_ >= 0) close(to_child_);
  to_child_ = -1;
}

void ChildProcess::Say(std::string text) {
  if (said_ == to_say_.size()) {
    to_say_ = std::move(text);
    said_ = 0;
  } else {
    to_say_ += text;
  }
}

void ChildProcess::SayNoMore() {
  last_words_ = true;
  if (said_ == to_say_.size()) CloseInput();
}

// Writes and reads what can be written and read now; waits until something can, or the deadline.
PipeEnd ChildProcess::Exchange(Clock::time_point deadline) {
  if (Interrupted()) return PipeEnd::kInterrupted;
  const auto left =
      std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
  if (left <= 0) return PipeEnd::kTimedOut;
  const bool has_words = to_child_ >= 0 && said_ < to_say_.size();
  std::array<pollfd, 3> ends{{{from_child_, POLLIN, 0},
                              {has_words ? to_child_ : -1, POLLOUT, 0},
                              {InterruptedFile(), POLLIN, 0}}};
  if (poll(ends.data(), ends.size(), static_cast<int>(std::min<long long>(left, 1000))) < 0) {
    return errno == EINTR ? PipeEnd::kOpen : PipeEnd::kClosed;
  }
  if (Interrupted()) return PipeEnd::kInterrupted;
  if (ends[1].revents != 0) {
    const ssize_t n = write(to_child_, to_say_.data() + said_, to_say_.size() - said_);
    if (n > 0) said_ += static_cast<std::size_t>(n);
    if (n < 0 && errno != EAGAIN) CloseInput();  // it reads no more; what it still says may matter
    if (last_words_ && said_ == to_say_.size()) CloseInput();
  }
  if (ends[0].revents != 0) {
    const std::size_t length = heard_.size();
    heard_.resize(length + kChunk);
    const ssize_t n = read(from_child_, heard_.data() + length, kChunk);
    heard_.resize(length + static_cast<std::size_t>(std::max<ssize_t>(n, 0)));
    if (n == 0 || (n < 0 && errno != EAGAIN)) return PipeEnd::kClosed;
  }
  return PipeEnd::kOpen;
}

PipeEnd ChildProcess::ReadLine(Clock::time_point deadline, std::size_t most_bytes,
                               std::string& line) {
  std::size_t searched = heard_from_;
  for (;;) {
    const std::size_t end = heard_.find('\n', searched);
    if (end != std::string::npos) {
      line.assign(heard_, heard_from_, end - heard_from_);
      heard_from_ = end + 1;
      return PipeEnd::kOpen;
    }
    heard_.erase(0, heard_from_);
    heard_from_ = 0;
    searched = heard_.size();
    if (searched > most_bytes) return PipeEnd::kClosed;
    const PipeEnd state = Exchange(deadline);
    if (state != PipeEnd::kOpen) return state;
  }
}

std::string ChildProcess::Unread() {
  pollfd end{from_child_, POLLIN, 0};
  if (heard_from_ == heard_.size() && poll(&end, 1, 0) == 1) {
    Exchange(Clock::now() + std::chrono::milliseconds(1));
  }
  const std::string unread = heard_.substr(heard_from_);
  return unread.substr(0, unread.find('\n'));
}

std::string ChildProcess::Ending() {
  CloseInput();
  if (from_child_ >= 0) close(from_child_);
  from_child_ = -1;
  if (pid_ < 0) return "had ended";
  int status = 0;
  bool ended = false;
  // A child that closed its output is on its way out: give it a moment to say with what.
  for (int n = 0; n < 50 && !ended; ++n) {
    siginfo_t info{};
    ended = waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOWAIT | WNOHANG) == 0 &&
            info.si_pid == pid_;
    if (!ended) std::this_thread::sleep_for(std::chrono::milliseconds(n < 10 ? 1 : 5));
  }
  EndGroup(std::exchange(pid_, -1), status);
  if (!ended) return "still ran";
  if (WIFSIGNALED(status)) {
    return "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  }
  return "ended with status " + std::to_string(WEXITSTATUS(status));
}

}  // namespace rasterproof::subjects
