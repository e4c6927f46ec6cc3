#include "io/output.h"

#include <fcntl.h>
#include <poll.h>
#include <pthread.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <iostream>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.h"

namespace rasterproof::io {
namespace {

namespace fs = std::filesystem;

// No scene of ours comes near this; /dev/zero would.
constexpr std::size_t kMaxFileBytes = std::size_t{1} << 30;

std::string ReasonOf(int error) { return std::generic_category().message(error); }

InputError CannotRead(const std::string& name, int error) {
  return {name, "can't be read (" + ReasonOf(error) + ")", "give a readable file"};
}

InputError CannotWrite(const std::string& name, int error) {
  return {name, "can't be written (" + ReasonOf(error) + ")",
          "make room there or choose another place"};
}

InputError TooLarge(const std::string& name) {
  return {name, "is larger than 1 GiB", "give a smaller file"};
}

// Owns a file descriptor.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() { Close(); }
  int get() const { return fd_; }
  // Some file systems report a failed write only here.
  int Close() { return fd_ < 0 || ::close(std::exchange(fd_, -1)) == 0 ? 0 : errno; }

 private:
  int fd_;
};

// While it lives, writing to a closed pipe is an error of write(), not the end of the process.
class BrokenPipeIsAnError {
 public:
  BrokenPipeIsAnError() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    sigset_t pending;
    sigpending(&pending);
    was_pending_ = sigismember(&pending, SIGPIPE) == 1;
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  BrokenPipeIsAnError(const BrokenPipeIsAnError&) = delete;
  BrokenPipeIsAnError& operator=(const BrokenPipeIsAnError&) = delete;
  ~BrokenPipeIsAnError() {
    // Takes back the signal that a failed write left, before it can be delivered.
    const timespec now{};
    if (!was_pending_) sigtimedwait(&pipe_, nullptr, &now);
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t pipe_;
  sigset_t before_;
  bool was_pending_ = false;
};

// Writes all of it; returns 0 or the error.
int WriteAll(int fd, std::string_view content) {
  const BrokenPipeIsAnError guard;
  while (!content.empty()) {
    const ssize_t n = ::write(fd, content.data(), content.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) return errno;
    content.remove_prefix(static_cast<std::size_t>(n));
  }
  return 0;
}

void WriteDirectly(const std::string& path, std::string_view content) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
  if (file.get() < 0) throw CannotWrite(path, errno);
  int error = WriteAll(file.get(), content);
  if (const int closed = file.Close(); error == 0) error = closed;
  if (error != 0) throw CannotWrite(path, error);
}

// Creates a file that was not there, in the folder of `path`. The process id and a counter keep the
// names of processes and threads apart; open() sees to the rest, and to the umask.
std::pair<std::string, int> CreateBeside(const fs::path& path) {
  static std::atomic<unsigned> counter{0};
  for (;;) {
    const std::string file =
        ".rasterproof-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".part";
    const std::string name = (path.parent_path() / file).string();
    const int fd = ::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return {name, fd};
  }
}

// The new name is on the disk only when its folder is. Not all file systems can say so.
void SyncFolder(const fs::path& path) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  const Descriptor descriptor(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (descriptor.get() >= 0) ::fsync(descriptor.get());
}

// How long a pipe may be open at one end alone: 5 s at least.
constexpr int kMostLooks = 500;
constexpr int kMillisecondsALook = 10;

// Waits until somebody writes into a pipe that was opened without waiting; gives its first byte, if
// there is one by then.
std::string AwaitWriter(int pipe, const std::string& name) {
  for (int look = 0; look < kMostLooks; ++look) {
    char byte = 0;
    const ssize_t n = ::read(pipe, &byte, 1);
    if (n == 1) return {byte};
    if (n < 0) return "";  // it is open at the other end, too
    pollfd end{pipe, POLLIN, 0};
    if (::poll(&end, 1, kMillisecondsALook) > 0 && (end.revents & POLLHUP) != 0) return "";
  }
  throw InputError(name, "is a pipe that nobody writes into", "start its writer, or give a file");
}

// Requires a regular file, or a pipe that somebody writes into, or what is standard input anyway.
// Returns what was read of it.
std::string BeginToRead(int file, const std::string& name) {
  struct stat status{};
  if (::fstat(file, &status) != 0) throw CannotRead(name, errno);
  struct stat input{};
  const bool is_input = ::fstat(STDIN_FILENO, &input) == 0 && input.st_dev == status.st_dev &&
                        input.st_ino == status.st_ino;
  if ((S_ISCHR(status.st_mode) || S_ISBLK(status.st_mode)) && !is_input) {
    throw InputError(name, "is a device", "give a file");
  }
  std::string first = S_ISFIFO(status.st_mode) ? AwaitWriter(file, name) : "";
  ::fcntl(file, F_SETFL, ::fcntl(file, F_GETFL) & ~O_NONBLOCK);
  return first;
}

}  // namespace

bool IsThere(const std::string& path) {
  std::error_code unknown;
  return fs::exists(path, unknown);
}

std::string ReadFile(const std::string& path) {
  const bool standard = path == "-";
  const std::string name = standard ? "standard input" : path;
  // O_NONBLOCK: opening a pipe must not wait for somebody to write.
  Descriptor file(standard ? ::dup(STDIN_FILENO)
                           : ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
  if (file.get() < 0) throw CannotRead(name, errno);
  std::string content = standard ? "" : BeginToRead(file.get(), name);
  // A regular file tells its size at once; anything else is read to its end.
  struct stat status{};
  const bool sized = ::fstat(file.get(), &status) == 0 && S_ISREG(status.st_mode);
  const std::size_t size = sized ? static_cast<std::size_t>(status.st_size) : 0;
  if (size > kMaxFileBytes) throw TooLarge(name);
  content.reserve(size);
  std::array<char, 1 << 16> block;
  for (;;) {
    const ssize_t n = ::read(file.get(), block.data(), block.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw CannotRead(name, errno);
    if (n == 0) return content;
    content.append(block.data(), static_cast<std::size_t>(n));
    if (content.size() > kMaxFileBytes) throw TooLarge(name);
  }
}

void WriteFile(const std::string& path, std::string_view content) {
  struct stat before{};
  const bool exists = ::stat(path.c_str(), &before) == 0;
  if (!exists && errno != ENOENT) throw CannotWrite(path, errno);
  if (exists && S_ISDIR(before.st_mode)) throw CannotWrite(path, EISDIR);
  if (exists && !S_ISREG(before.st_mode)) return WriteDirectly(path, content);
  // The rename below would replace a file that may not be written, and a link instead of its file.
  if (exists && ::access(path.c_str(), W_OK) != 0) throw CannotWrite(path, errno);
  std::error_code unresolved;
  const fs::path file = exists ? fs::canonical(path, unresolved) : fs::path(path);
  if (unresolved) throw CannotWrite(path, unresolved.value());

  const auto [name, fd] = CreateBeside(file);
  Descriptor part(fd);
  if (fd < 0) throw CannotWrite(path, errno);
  int error = WriteAll(fd, content);
  if (error == 0 && exists && ::fchmod(fd, before.st_mode & 07777) != 0) error = errno;
  if (error == 0 && ::fsync(fd) != 0) error = errno;
  if (const int closed = part.Close(); error == 0) error = closed;
  if (error == 0 && ::rename(name.c_str(), file.c_str()) != 0) error = errno;
  if (error != 0) {
    ::unlink(name.c_str());
    throw CannotWrite(path, error);
  }
  SyncFolder(file);
}

void WriteStandardOutput(std::string_view content) {
  // What was written through the streams comes first.
  errno = 0;
  const bool flushed = std::cout.flush() && std::fflush(stdout) == 0;
  int error = flushed ? 0 : (errno != 0 ? errno : EIO);
  if (error == 0) error = WriteAll(STDOUT_FILENO, content);
  // A reader that has seen enough, as `head`, has closed its end.
  if (error != 0 && error != EPIPE) throw CannotWrite("standard output", error);
}

void MakeFolder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (!error && !fs::is_directory(path, error))
    error = std::make_error_code(std::errc::not_a_directory);
  if (error) {
    throw InputError(path, "can't be made a folder (" + error.message() + ")",
                     "choose another place");
  }
}

void RequireFolderCanBe(const std::string& path) {
  std::error_code error;
  std::vector<fs::path> made;  // what is not there yet, the innermost first
  for (fs::path at = fs::absolute(path, error).lexically_normal();
       !fs::exists(at, error) && at != at.parent_path(); at = at.parent_path()) {
    made.push_back(at);
  }
  MakeFolder(path);
  const bool is_ours = access(path.c_str(), W_OK | X_OK) == 0;
  for (const fs::path& folder : made) fs::remove(folder, error);  // none that others filled since
  if (is_ours) return;
  throw InputError(path, "is a folder into which this user may not write", "choose another place");
}

void RequireFileCanBe(const std::string& path) {
  if (path.empty() || path == "-") return;
  std::error_code none;
  const fs::file_status status = fs::status(path, none);
  if (fs::is_directory(status)) throw CannotWrite(path, EISDIR);
  if (fs::exists(status) && !fs::is_regular_file(status)) return;  // a device or a pipe
  const fs::path folder = fs::path(path).parent_path();
  const std::string name = folder.empty() ? "." : folder.string();
  if (::access(name.c_str(), W_OK | X_OK) != 0) throw CannotWrite(path, errno);
}

void WriteOutput(const std::string& path, std::string_view content) {
  if (path == "-") {
    WriteStandardOutput(content);
  } else {
    WriteFile(path, content);
  }
}

}  // namespace rasterproof::io
