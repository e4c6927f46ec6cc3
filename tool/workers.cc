#include "tool/workers.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace rasterproof::tool {
namespace {

class Queue {
 public:
  Queue(std::size_t count, const std::function<void(std::size_t, std::size_t)>& work)
      : count_(count), work_(work) {}

  void Serve(std::size_t worker) {
    for (std::size_t i = Next(); i < count_; i = Next()) {
      try {
        work_(worker, i);
      } catch (...) {
        Failed(i, std::current_exception());
      }
    }
  }

  void Rethrow() const {
    if (error_ != nullptr) std::rethrow_exception(error_);
  }

 private:
  std::size_t Next() {
    const std::lock_guard lock(mutex_);
    return error_ == nullptr && next_ < count_ ? next_++ : count_;
  }

  void Failed(std::size_t i, std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (error_ != nullptr && failed_ < i) return;
    failed_ = i;
    error_ = std::move(error);
  }

  const std::size_t count_;
  const std::function<void(std::size_t, std::size_t)>& work_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::size_t failed_ = 0;
  std::exception_ptr error_;
};

}  // namespace

int DefaultJobs() { return std::max(1, static_cast<int>(std::thread::hardware_concurrency())); }

void ShareWork(int jobs, std::size_t count,
               const std::function<void(std::size_t worker, std::size_t i)>& work) {
  Queue queue(count, work);
  const std::size_t workers = std::min(static_cast<std::size_t>(jobs), count);
  {
    std::vector<std::jthread> threads;
    for (std::size_t w = 1; w < workers; ++w) {
      threads.emplace_back([&queue, w] { queue.Serve(w); });
    }
    queue.Serve(0);
  }
  queue.Rethrow();
}

}  // namespace rasterproof::tool
