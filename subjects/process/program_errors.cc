#include "subjects/process/program_errors.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <thread>

#include "subjects/process/groups.h"

namespace rasterproof::subjects {
namespace {

constexpr std::uint64_t kMostErrorLines = 20;
constexpr std::size_t kLongestErrorLine = 400;  // bytes; the rest of a line is left out

void WriteError(std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(STDERR_FILENO, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return;  // nobody reads it
    text.remove_prefix(static_cast<std::size_t>(written));
  }
}

// Reads the pipe in a thread of its own, so that no program waits for a full one.
class ErrorLines {
 public:
  ErrorLines() {
    if (!Open(lines_) || !Open(end_)) return;
    fcntl(lines_[0], F_SETFL, O_NONBLOCK);
    reader_ = std::thread([this] { ReadUntilEnd(); });
  }
  ErrorLines(const ErrorLines&) = delete;
  ErrorLines& operator=(const ErrorLines&) = delete;
  // A program that left its group may hold the pipe: the end is told by another one.
  ~ErrorLines() {
    if (!reader_.joinable()) return;
    close(end_[1]);
    reader_.join();
    if (!line_.empty()) EndLine();
    if (left_out_ != 0) {
      WriteError("program: ... " + std::to_string(left_out_) +
                 (left_out_ == 1 ? " more line\n" : " more lines\n"));
    }
  }
  int file() const { return reader_.joinable() ? lines_[1] : -1; }

 private:
  static bool Open(std::array<int, 2>& ends) {
    if (pipe2(ends.data(), O_CLOEXEC) != 0) return false;
    for (int& end : ends) end = AboveStandard(end);
    return true;
  }
  void ReadUntilEnd() {
    for (;;) {
      std::array<pollfd, 2> files{pollfd{lines_[0], POLLIN, 0}, pollfd{end_[0], POLLIN, 0}};
      if (poll(files.data(), files.size(), -1) < 0 && errno != EINTR) return;
      const bool is_end = files[1].revents != 0;
      ReadAll();
      if (is_end) return;
    }
  }
  void ReadAll() {
    std::array<char, 4096> bytes{};
    for (;;) {
      const ssize_t n = read(lines_[0], bytes.data(), bytes.size());
      if (n <= 0) return;
      for (const char c : std::string_view(bytes.data(), static_cast<std::size_t>(n))) Add(c);
    }
  }
  void Add(char c) {
    if (c == '\n') {
      EndLine();
    } else if (line_.size() < kLongestErrorLine) {
      line_ += c;
    }
  }
  void EndLine() {
    if (shown_ < kMostErrorLines) {
      ++shown_;
      WriteError("program: " + line_ + "\n");
    } else {
      ++left_out_;
    }
    line_.clear();
  }

  std::array<int, 2> lines_{-1, -1};
  std::array<int, 2> end_{-1, -1};
  std::string line_;
  std::uint64_t shown_ = 0;
  std::uint64_t left_out_ = 0;
  std::thread reader_;
};

}  // namespace

int ProgramErrors() {
  static const ErrorLines lines;
  return lines.file();
}

}  // namespace rasterproof::subjects
