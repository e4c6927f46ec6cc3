#include "tool/workers.h"

#include <sched.h>

#include <algorithm>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

namespace rasterproof::tool {
namespace {

class Queue {
 public:
  Queue(std::span<const std::size_t> order,
        const std::function<void(std::size_t, std::size_t)>& work)
      : order_(order), work_(work) {}

  void Serve(std::size_t worker) {
    while (const std::optional<std::size_t> i = Next()) {
      try {
        work_(worker, *i);
      } catch (...) {  // whatever it is, it is thrown again below
        Failed(*i, std::current_exception());
      }
    }
  }

  void Rethrow() const {
    if (error_ != nullptr) std::rethrow_exception(error_);
  }

 private:
  std::optional<std::size_t> Next() {
    const std::lock_guard lock(mutex_);
    while (next_ < order_.size()) {
      const std::size_t i = order_[next_++];
      if (error_ == nullptr || i < failed_) return i;
    }
    return std::nullopt;
  }

  void Failed(std::size_t i, std::exception_ptr error) {
    const std::lock_guard lock(mutex_);
    if (error_ != nullptr && failed_ < i) return;
    failed_ = i;
    error_ = std::move(error);
  }

  const std::span<const std::size_t> order_;
  const std::function<void(std::size_t, std::size_t)>& work_;
  std::mutex mutex_;
  std::size_t next_ = 0;
  std::size_t failed_ = 0;
  std::exception_ptr error_;
};

// Keeps the calling thread to one core while it lives: the `worker`-th allowed one from `first` on.
// A process that the worker starts runs there too: they take turns, and what wakes on one core
// while the other sleeps on a second one costs a fifth more. A worker that finds no free core runs
// where the system puts it.
class OnOneCore {
 public:
  OnOneCore(int first, std::size_t worker) {
    if (first < 0 || sched_getaffinity(0, sizeof before_, &before_) != 0) return;
    if (worker >= static_cast<std::size_t>(CPU_COUNT(&before_))) return;
    int core = first;
    for (std::size_t n = 0; n < worker; ++n) {
      do {
        core = (core + 1) % CPU_SETSIZE;
      } while (!CPU_ISSET(core, &before_));
    }
    cpu_set_t one;
    CPU_ZERO(&one);
    CPU_SET(core, &one);
    is_kept_ = sched_setaffinity(0, sizeof one, &one) == 0;
  }
  OnOneCore(const OnOneCore&) = delete;
  OnOneCore& operator=(const OnOneCore&) = delete;
  ~OnOneCore() {
    if (is_kept_) sched_setaffinity(0, sizeof before_, &before_);
  }

 private:
  cpu_set_t before_{};
  bool is_kept_ = false;
};

}  // namespace

int DefaultJobs() {
  return static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1U, unsigned{kMostJobs}));
}

std::vector<std::size_t> OrderOfWork(int jobs, std::size_t count,
                                     const std::function<bool(std::size_t)>& takes_long) {
  std::vector<std::size_t> order;
  for (const bool is_long : {true, false}) {
    for (std::size_t i = 0; i < count; ++i) {
      if ((jobs > 1 && takes_long(i)) == is_long) order.push_back(i);
    }
  }
  return order;
}

void ShareWork(int jobs, std::span<const std::size_t> order,
               const std::function<void(std::size_t worker, std::size_t i)>& work) {
  Queue queue(order, work);
  const std::size_t workers = std::min(static_cast<std::size_t>(jobs), order.size());
  const int first = sched_getcpu();
  {
    std::vector<std::jthread> threads;
    for (std::size_t w = 1; w < workers; ++w) {
      try {
        threads.emplace_back([&queue, first, w] {
          const OnOneCore core(first, w);
          queue.Serve(w);
        });
      } catch (const std::system_error&) {
        break;  // the machine gives no more: fewer do the same
      }
    }
    const OnOneCore core(threads.empty() ? -1 : first, 0);
    queue.Serve(0);
  }
  queue.Rethrow();
}

Subject& Crew::Of(std::size_t worker, std::size_t subject) {
  Member& member = members_[worker];
  if (member.subject == nullptr || member.number != subject) {
    member.subject = nullptr;  // its process ends before the next one begins
    member.subject = make_(subject);
    member.number = subject;
  }
  return *member.subject;
}

}  // namespace rasterproof::tool
