// Work in a child process, so that what it breaks is only itself.
#ifndef RASTERPROOF_TOOL_SURVEY_ISOLATED_H_
#define RASTERPROOF_TOOL_SURVEY_ISOLATED_H_

#include <sys/mman.h>

#include <atomic>
#include <cstdint>
#include <functional>
#include <new>
#include <string>
#include <type_traits>

namespace rasterproof::tool {

/// A value that this process and its children see alike.
template <class T>
class Shared {
  static_assert(std::is_trivially_destructible_v<T>);

 public:
  Shared() {
    void* const at =
        mmap(nullptr, sizeof(T), PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (at == MAP_FAILED) throw std::bad_alloc();
    value_ = new (at) T();
  }
  ~Shared() { munmap(value_, sizeof(T)); }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  T* operator->() const { return value_; }
  T& operator*() const { return *value_; }

 private:
  T* value_;
};

/// Runs the work in a child of this process until it returns, dies, or does not change `progress`
/// for so long.
///
/// Returns:    nothing if it returned; else how it ended, in words: "killed by signal 11",
///             "no answer for 10 s".
std::string RunIsolated(const std::function<void()>& work,
                        const std::atomic<std::uint64_t>& progress, double stall_seconds);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_SURVEY_ISOLATED_H_
