// Progress on standard error: a bar on a terminal, lines elsewhere, never silent for long.
#ifndef RASTERPROOF_TOOL_PROGRESS_H_
#define RASTERPROOF_TOOL_PROGRESS_H_

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <string>
#include <thread>

namespace rasterproof::tool {

/// Writes to standard error; what can't be written there is lost, and nothing else.
void Tell(const std::string& text) noexcept;

/// Says what is being done. A thread of its own repeats it, so that a long step is never silent.
class Progress {
 public:
  Progress();
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Begins a stage of `total` steps (0: unknown).
  void Stage(const std::string& name, std::uint64_t total = 0);
  void Done(std::uint64_t steps);
  /// Prints a line of its own.
  void Say(const std::string& line);

 private:
  void Loop();
  void Show(bool final);

  const bool terminal_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool stop_ = false;
  std::string stage_;
  std::uint64_t total_ = 0;
  std::uint64_t done_ = 0;
  std::chrono::steady_clock::time_point began_;
  std::thread thread_;
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_PROGRESS_H_
