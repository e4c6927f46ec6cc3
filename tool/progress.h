// Progress on standard error: a bar on a terminal, lines elsewhere, never silent for long.
#ifndef RASTERPROOF_TOOL_PROGRESS_H_
#define RASTERPROOF_TOOL_PROGRESS_H_

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

namespace rasterproof::tool {

/// Writes to standard error; what can't be written there is lost, and nothing else.
void Tell(const std::string& text) noexcept;

/// Prints the current step. Its own thread repeats it, so that a long step is never silent. It
/// shows the worker whose stage began first, and how many others there are.
class Progress {
 public:
  explicit Progress(std::size_t workers = 1);
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// The worker begins a stage of `total` steps (0: unknown); without a name it does nothing.
  void Stage(const std::string& name, std::uint64_t total = 0, std::size_t worker = 0);
  void Done(std::uint64_t steps, std::size_t worker = 0);
  /// Prints a separate line.
  void Say(const std::string& line);

 private:
  struct Work {
    std::string stage;
    std::uint64_t total = 0;
    std::uint64_t done = 0;
    std::chrono::steady_clock::time_point began;
  };

  void Loop();
  void Show();
  void Wipe();

  const bool terminal_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false;
  std::vector<Work> workers_;
  std::thread thread_;
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PROGRESS_H_
