// Work shared among threads, its results in their order.
#ifndef RASTERPROOF_TOOL_WORKERS_H_
#define RASTERPROOF_TOOL_WORKERS_H_

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "core/subject.h"

namespace rasterproof::tool {

/// A subject outside takes up to two processes a worker, and this process knows 1024 of them.
inline constexpr int kMostJobs = 256;

/// As many as the machine has cores for this process; at least 1, at most kMostJobs.
int DefaultJobs();

/// 0, 1, ... count - 1; where several workers share them, those that take long before the others.
std::vector<std::size_t> OrderOfWork(int jobs, std::size_t count,
                                     const std::function<bool(std::size_t)>& takes_long);

/// Calls work(worker, i) once for each i of the order, begun in that order, from as many threads as
/// there are jobs, but no more than calls; `worker` says which of them, from 0. One job: from the
/// caller's.
///
/// Domain:     jobs >= 1; each i once.
/// Error:      what the call with the lowest i threw; all with lower i were made, and those that
///             had begun have ended.
void ShareWork(int jobs, std::span<const std::size_t> order,
               const std::function<void(std::size_t worker, std::size_t i)>& work);

/// A subject for each worker, made when it is first wanted: no two share one.
class Crew {
 public:
  using Make = std::function<std::unique_ptr<Subject>(std::size_t subject)>;

  /// `make` is called by several workers at once.
  Crew(int jobs, Make make) : make_(std::move(make)), members_(static_cast<std::size_t>(jobs)) {}

  std::size_t size() const { return members_.size(); }
  /// The first worker takes one that is there already.
  void Give(std::unique_ptr<Subject> first) { members_.front() = {std::move(first), 0}; }
  /// The worker's own. A worker has one subject at a time: the last one goes.
  Subject& Of(std::size_t worker, std::size_t subject = 0);

 private:
  struct Member {
    std::unique_ptr<Subject> subject;
    std::size_t number = 0;
  };

  Make make_;
  std::vector<Member> members_;
};

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_WORKERS_H_
