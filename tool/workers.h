// Work shared among threads, its results in their order.
#ifndef RASTERPROOF_TOOL_WORKERS_H_
#define RASTERPROOF_TOOL_WORKERS_H_

#include <cstddef>
#include <functional>

namespace rasterproof::tool {

/// As many as the machine has cores; at least 1.
int DefaultJobs();

/// Calls work(worker, i) once for each i in [0, count), in ascending order of starting, from
/// min(jobs, count) threads; `worker` says which of them, from 0. One job: from the caller's.
///
/// Domain:     jobs >= 1.
/// Error:      what the call with the lowest i threw, after all that had begun have ended; none
///             begins behind it.
void ShareWork(int jobs, std::size_t count,
               const std::function<void(std::size_t worker, std::size_t i)>& work);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_WORKERS_H_
