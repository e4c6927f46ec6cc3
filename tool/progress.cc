#include "tool/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdint>
#include <mutex>
#include <string>

#include "fmt/format.h"

namespace rasterproof::tool {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto kBarInterval = std::chrono::milliseconds(200);
constexpr auto kLineInterval = std::chrono::seconds(5);  // "no silence over 10 s", with room

}  // namespace

void Tell(const std::string& text) noexcept {
  for (std::size_t told = 0; told < text.size();) {
    const ssize_t n = write(STDERR_FILENO, text.data() + told, text.size() - told);
    if (n <= 0 && errno != EINTR) return;
    told += static_cast<std::size_t>(std::max<ssize_t>(n, 0));
  }
}

Progress::Progress()
    : terminal_(isatty(STDERR_FILENO) == 1), began_(Clock::now()), thread_([this] { Loop(); }) {}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
  Show(/*final=*/true);
}

void Progress::Stage(const std::string& name, std::uint64_t total) {
  const std::lock_guard lock(mutex_);
  Show(/*final=*/true);
  stage_ = name;
  total_ = total;
  done_ = 0;
  began_ = Clock::now();
}

void Progress::Done(std::uint64_t steps) {
  const std::lock_guard lock(mutex_);
  done_ = steps;
}

void Progress::Say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  Show(/*final=*/true);
  Tell(line + "\n");
}

void Progress::Loop() {
  std::unique_lock lock(mutex_);
  while (!stop_) {
    if (terminal_) {
      wake_.wait_for(lock, kBarInterval);
    } else {
      wake_.wait_for(lock, kLineInterval);
    }
    if (!stop_ && !stage_.empty()) Show(/*final=*/false);
  }
}

// On a terminal the bar is redrawn in place and wiped at the end; elsewhere only what lasts is
// printed.
void Progress::Show(bool final) {
  if (final) {
    if (terminal_ && !stage_.empty()) Tell("\r\033[K");
    return;
  }
  const double seconds = std::chrono::duration<double>(Clock::now() - began_).count();
  if (!terminal_) {
    Tell(fmt::format("  {}: {}{} after {:.0f} s\n", stage_, done_,
                     total_ != 0 ? fmt::format(" of {}", total_) : "", seconds));
    return;
  }
  constexpr std::uint64_t kWidth = 30;
  const std::uint64_t filled = total_ == 0 ? 0 : std::min(kWidth, kWidth * done_ / total_);
  Tell(fmt::format("\r\033[K{} [{}{}] {}{}", stage_, std::string(filled, '#'),
                   std::string(kWidth - filled, '.'), done_,
                   total_ != 0 ? fmt::format("/{}", total_) : ""));
}

}  // namespace rasterproof::tool
