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

#include "core/call_end.h"
#include "core/error.h"
#include "subjects/process/groups.h"
#include "subjects/process/program_errors.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kChunk = 1 << 16;
// What a pipe holds, where the system allows it: so much goes over it in one turn.
constexpr int kPipeBytes = 1 << 20;
constexpr std::chrono::milliseconds kWatch{10};  // between two looks at its memory
constexpr int kMomentLooks = 50;                 // at whether it ended: about 200 ms
constexpr int kExitLooks = 2000;                 // about 10 s

std::string Reason(int error) { return std::generic_category().message(error); }

[[noreturn]] void CannotStart(const std::string& program, int error) {
  throw InputError(program, "can't be started: " + Reason(error),
                   "give the path of a program that this user may run");
}

struct Pipe {
  int read = -1;
  int write = -1;
};

Pipe MakePipe(const std::string& program) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) CannotStart(program, errno);
  return {AboveStandard(ends[0]), AboveStandard(ends[1])};
}

void LimitMemory(std::uint64_t bytes) {
  if (bytes == 0) return;
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

// The child's side of the fork: nothing here may allocate or throw.
[[noreturn]] void Become(char* const* argv, const Pipe& in, const Pipe& out, int report, int errors,
                         std::uint64_t most_bytes) {
  dup2(in.read, STDIN_FILENO);
  dup2(out.write, STDOUT_FILENO);
  if (errors >= 0) dup2(errors, STDERR_FILENO);
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  if (fcntl(STDERR_FILENO, F_GETFD) < 0) open("/dev/null", O_WRONLY);  // the one free number
  LimitMemory(most_bytes);
  execvp(argv[0], argv);
  const int error = errno;
  [[maybe_unused]] const ssize_t written = write(report, &error, sizeof error);
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::vector<std::string>& command, std::uint64_t most_bytes,
                           int errors) {
  if (Interrupted()) throw SubjectStop(Stop::kTooSlow, kInterruptedText);
  if (errors < 0) errors = ProgramErrors();
  const std::string& program = command.front();
  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  const Pipe in = MakePipe(program);
  const Pipe out = MakePipe(program);
  const Pipe report = MakePipe(program);  // closed by a good exec, else reports why it failed
  pid_ = ForkGroup();
  const int fork_error = errno;
  if (pid_ == 0) Become(argv.data(), in, out, report.write, errors, most_bytes);
  close(in.read);
  close(out.write);
  close(report.write);
  to_child_ = in.write;
  from_child_ = out.read;
  int error = fork_error;
  const ssize_t told = pid_ < 0 ? sizeof error : read(report.read, &error, sizeof error);
  close(report.read);
  if (told == static_cast<ssize_t>(sizeof error)) {
    End(0);
    CannotStart(program, error);
  }
  fcntl(to_child_, F_SETPIPE_SZ, kPipeBytes);
  fcntl(from_child_, F_SETPIPE_SZ, kPipeBytes);
  fcntl(to_child_, F_SETFL, O_NONBLOCK);
  fcntl(from_child_, F_SETFL, O_NONBLOCK);
}

// One that is in order sees that its input ends, and may end by itself.
ChildProcess::~ChildProcess() { End(lost_ || Interrupted() ? 0 : kMomentLooks); }

void ChildProcess::Close(int& file) {
  if (file >= 0) close(file);
  file = -1;
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
  if (said_ == to_say_.size()) Close(to_child_);
}

bool ChildProcess::WriteSome() {
  const ssize_t n = write(to_child_, to_say_.data() + said_, to_say_.size() - said_);
  if (n > 0) said_ += static_cast<std::size_t>(n);
  if (n < 0 && errno != EAGAIN) Close(to_child_);  // it reads no more; what it says may matter
  if (last_words_ && said_ == to_say_.size()) Close(to_child_);
  return n > 0;
}

PipeEnd ChildProcess::ReadSome(bool& moved) {
  if (heard_.size() < heard_to_ + kChunk) heard_.resize(2 * heard_.size() + kChunk);
  const ssize_t n = read(from_child_, heard_.data() + heard_to_, heard_.size() - heard_to_);
  heard_to_ += static_cast<std::size_t>(std::max<ssize_t>(n, 0));
  moved = moved || n > 0;
  return n == 0 || (n < 0 && errno != EAGAIN) ? PipeEnd::kClosed : PipeEnd::kOpen;
}

// Writes and reads what can be written and read now; waits until something can, or for the next
// look at the clocks.
PipeEnd ChildProcess::Exchange(Patience& patience) {
  if (Interrupted()) return PipeEnd::kInterrupted;
  const Clock::time_point now = Clock::now();
  const bool is_late = now >= patience.deadline;
  const bool is_over = patience.time.IsOver();
  Clock::duration wait = std::min(patience.time.UntilNextLook(), patience.deadline - now);
  if (most_resident_ != 0) wait = std::min<Clock::duration>(wait, kWatch);
  if (is_late || is_over) wait = {};
  const auto rounded_up = std::chrono::ceil<std::chrono::milliseconds>(wait).count();
  const bool has_words = to_child_ >= 0 && said_ < to_say_.size();
  std::array<pollfd, 3> ends{{{from_child_, POLLIN, 0},
                              {has_words ? to_child_ : -1, POLLOUT, 0},
                              {InterruptedFile(), POLLIN, 0}}};
  if (poll(ends.data(), ends.size(), static_cast<int>(rounded_up)) < 0) {
    return errno == EINTR ? PipeEnd::kOpen : PipeEnd::kClosed;
  }
  if (Interrupted()) return PipeEnd::kInterrupted;
  bool moved = false;
  if (ends[1].revents != 0) moved = WriteSome();
  if (ends[0].revents != 0) {
    const PipeEnd state = ReadSome(moved);
    if (state != PipeEnd::kOpen) return state;
  }
  // Output that came in the meantime counts, even if late.
  // Where both came first, the deadline says it: on a loaded machine it is a matter of chance
  // whether a limit is seen to be over at the deadline or behind it.
  if (!moved && is_late) return PipeEnd::kDeadline;
  if (!moved && is_over) return PipeEnd::kTimedOut;
  if (most_resident_ != 0 && MemoryOf(pid_).resident > most_resident_) return PipeEnd::kTooLarge;
  patience.time.Look(moved);
  return PipeEnd::kOpen;
}

PipeEnd ChildProcess::ReadLine(Patience& patience, std::size_t most_bytes, std::string_view& line) {
  std::size_t searched = 0;
  for (;;) {
    const std::string_view unread = Unread();
    const std::size_t end = unread.find('\n', searched);
    if (std::min(end, unread.size()) > most_bytes) {
      lost_ = true;
      return PipeEnd::kTooLong;
    }
    if (end != std::string_view::npos) {
      line = unread.substr(0, end);
      heard_from_ += end + 1;
      return PipeEnd::kOpen;
    }
    searched = unread.size();
    const PipeEnd state = ReadMore(patience);
    if (state != PipeEnd::kOpen) return state;
  }
}

PipeEnd ChildProcess::ReadBytes(Patience& patience, std::size_t count, std::string_view& bytes) {
  while (Unread().size() < count) {
    const PipeEnd state = ReadMore(patience);
    if (state != PipeEnd::kOpen) return state;
  }
  bytes = Unread().substr(0, count);
  heard_from_ += count;
  return PipeEnd::kOpen;
}

// Moves what is unread to the front and adds what comes.
PipeEnd ChildProcess::ReadMore(Patience& patience) {
  const std::string_view unread = Unread();
  if (heard_from_ != 0) std::copy(unread.begin(), unread.end(), heard_.begin());
  heard_from_ = 0;
  heard_to_ = unread.size();
  const PipeEnd state = Exchange(patience);
  if (state != PipeEnd::kOpen) lost_ = state != PipeEnd::kClosed;
  return state;
}

bool ChildProcess::HasUnread(std::string& first_line) {
  if (Unread().empty()) {
    bool moved = false;
    pollfd end{from_child_, POLLIN, 0};
    if (poll(&end, 1, 0) == 1) ReadSome(moved);
  }
  const std::string_view unread = Unread();
  if (unread.empty()) return false;
  lost_ = true;
  first_line = unread.substr(0, unread.find('\n'));
  return true;
}

bool ChildProcess::HasEnded() const {
  siginfo_t info{};
  return waitid(P_PID, static_cast<id_t>(pid_), &info, WEXITED | WNOWAIT | WNOHANG) == 0 &&
         info.si_pid == pid_;
}

std::string ChildProcess::Ending() { return End(kMomentLooks); }

std::string ChildProcess::End(int looks) {
  Close(to_child_);
  Close(from_child_);
  if (pid_ < 0) return "had ended";
  bool ended = HasEnded();
  // One that is on its way out is waited for, for how long: much memory takes its time to be freed.
  const int most = looks == 0 ? 0 : kExitLooks;
  for (int n = 0; !ended && (n < looks || (n < most && IsExiting(pid_))); ++n) {
    std::this_thread::sleep_for(std::chrono::milliseconds(n < 10 ? 1 : 5));
    ended = HasEnded();
  }
  int status = 0;
  EndGroup(std::exchange(pid_, -1), status);
  if (!ended) return kStillRan;
  if (WIFSIGNALED(status)) {
    return "was killed by signal " + std::to_string(WTERMSIG(status)) + " (" +
           strsignal(WTERMSIG(status)) + ")";
  }
  return kEnded + std::to_string(WEXITSTATUS(status));
}

}  // namespace rasterproof::subjects
