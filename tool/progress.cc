#include "tool/progress.h"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <mutex>
#include <string>
#include <utility>

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

Progress::Progress(std::size_t workers)
    : terminal_(isatty(STDERR_FILENO) == 1), workers_(workers), thread_([this] { Loop(); }) {}

Progress::~Progress() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  wake_.notify_all();
  thread_.join();
  Wipe();
}

void Progress::Stage(const std::string& name, std::uint64_t total, std::size_t worker) {
  const std::lock_guard lock(mutex_);
  Wipe();
  workers_[worker] = {name, total, 0, Clock::now()};
}

void Progress::Done(std::uint64_t steps, std::size_t worker) {
  const std::lock_guard lock(mutex_);
  workers_[worker].done = steps;
}

void Progress::Say(const std::string& line) {
  const std::lock_guard lock(mutex_);
  Wipe();
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
    if (!stop_) Show();
  }
}

// On a terminal the bar is redrawn in place and wiped at the end; elsewhere only what lasts is
// printed.
void Progress::Wipe() {
  if (terminal_) Tell("\r\033[K");
}

void Progress::Show() {
  const auto is_idle = [](const Work& work) { return work.stage.empty(); };
  const auto idle = std::ranges::count_if(workers_, is_idle);
  const auto others = std::ssize(workers_) - idle - 1;
  if (others < 0) return;
  const Work& work = *std::ranges::min_element(
      workers_, {}, [&](const Work& each) { return std::pair(is_idle(each), each.began); });
  const std::string more = others == 0 ? "" : fmt::format("; {} more at work", others);
  const std::string total = work.total == 0 ? "" : std::to_string(work.total);
  if (!terminal_) {
    const double seconds = std::chrono::duration<double>(Clock::now() - work.began).count();
    // Nothing is counted where nothing is known of how much there is.
    const bool counts = work.done != 0 || work.total != 0;
    const std::string done =
        counts ? fmt::format("{}{} after", work.done, total.empty() ? "" : " of " + total)
               : "at work for";
    Tell(fmt::format("  {}: {} {:.0f} s{}\n", work.stage, done, seconds, more));
    return;
  }
  constexpr std::uint64_t kWidth = 30;
  const std::uint64_t filled =
      work.total == 0 ? 0 : std::min(kWidth, kWidth * work.done / work.total);
  Tell(fmt::format("\r\033[K{} [{}{}] {}{}{}", work.stage, std::string(filled, '#'),
                   std::string(kWidth - filled, '.'), work.done, total.empty() ? "" : "/" + total,
                   more));
}

}  // namespace rasterproof::tool
