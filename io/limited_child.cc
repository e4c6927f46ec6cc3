#include "io/limited_child.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <exception>
#include <fstream>
#include <functional>
#include <new>
#include <string>
#include <string_view>
#include <system_error>

#include "core/error.h"
#include "core/quoted.h"

namespace rasterproof::io {
namespace {

// The first byte of what a child says.
constexpr char kMade = 'M';
constexpr char kInputError = 'I';
constexpr char kOtherError = 'O';
constexpr char kNoMemory = 'N';

// With all that is mapped already, the shadow of sanitizers too.
std::uint64_t AddressSpace() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

void Limit(decltype(RLIMIT_AS) resource, std::uint64_t most) {
  rlimit limit{};
  getrlimit(resource, &limit);
  if (limit.rlim_max < most) return;
  limit = {most, most};
  setrlimit(resource, &limit);
}

void Write(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t n = write(file, text.data(), text.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return;
    text.remove_prefix(static_cast<std::size_t>(n));
  }
}

void Say(int file, char kind, std::string_view text) {
  Write(file, {&kind, 1});
  Write(file, text);
}

// The child's side. It leaves by _exit: what this process would do at its end is not the child's.
[[noreturn]] void Work(int file, pid_t parent, const ChildLimits& limits,
                       const std::function<std::string()>& make) {
  for (const int number : {SIGINT, SIGTERM, SIGHUP, SIGPIPE}) signal(number, SIG_DFL);
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere >= 0) dup2(nowhere, STDERR_FILENO);
  Limit(RLIMIT_CORE, 0);
  Limit(RLIMIT_CPU, limits.seconds);
  Limit(RLIMIT_AS, AddressSpace() + limits.bytes);
  try {
    Say(file, kMade, make());
  } catch (const InputError& error) {
    Say(file, kInputError, error.what());
  } catch (const std::bad_alloc&) {
    Say(file, kNoMemory, "");
  } catch (const std::exception& error) {
    Say(file, kOtherError, error.what());
  }
  _exit(0);
}

std::string ReadAll(int file) {
  std::string text;
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t n = read(file, block.data(), block.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return text;
    text.append(block.data(), static_cast<std::size_t>(n));
  }
}

InputError CannotFork(const std::string& place, int error) {
  return {place,
          "no process can be started to read it (" + std::generic_category().message(error) + ")",
          "end other programs"};
}

// The error again, of which a process can only tell the message: its parts, joined, are that.
InputError ErrorOf(const std::string& message) {
  const std::size_t reason = message.find(": ");
  const std::size_t remedy = message.rfind("; ");
  if (reason == message.npos || remedy == message.npos || remedy < reason) {
    return {message, "can't be read", "check that the file is complete"};
  }
  return {message.substr(0, reason), message.substr(reason + 2, remedy - reason - 2),
          message.substr(remedy + 2)};
}

constexpr const char* kRemedy = "check that the file is complete and well-formed";

std::string MebibytesText(std::uint64_t bytes) { return std::to_string(bytes >> 20) + " MiB"; }

// Why a child that did not say all it had to say ended.
std::string Reason(int status, const ChildLimits& limits) {
  if (!WIFSIGNALED(status)) return "its reader failed";
  const int number = WTERMSIG(status);
  if (number == SIGXCPU || number == SIGKILL) {
    return "reading it took more than " + std::to_string(limits.seconds) + " s of processor time";
  }
  return "the library that reads it crashed on it by signal " + std::to_string(number) + " (" +
         strsignal(number) + "): it is broken, or nested too deep";
}

}  // namespace

std::string MakeInChild(const ChildLimits& limits, const std::string& place,
                        const std::function<std::string()>& make) {
  std::array<int, 2> ends{};
  if (pipe2(ends.data(), O_CLOEXEC) != 0) throw CannotFork(place, errno);
  const pid_t parent = getpid();
  const pid_t child = fork();
  if (child == 0) Work(ends[1], parent, limits, make);
  const int error = errno;
  close(ends[1]);
  std::string said = child < 0 ? "" : ReadAll(ends[0]);
  close(ends[0]);
  if (child < 0) throw CannotFork(place, error);
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const bool ended_well = WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!ended_well || said.empty()) throw InputError(place, Reason(status, limits), kRemedy);
  const char kind = said.front();
  said.erase(0, 1);
  if (kind == kMade) return said;
  if (kind == kInputError) throw ErrorOf(said);
  if (kind == kNoMemory) {
    throw InputError(place, "reading it took more than " + MebibytesText(limits.bytes), kRemedy);
  }
  throw InputError(place, "can't be read (" + Printable(said) + ")", kRemedy);
}

}  // namespace rasterproof::io
