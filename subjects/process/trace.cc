// Whose breakdown it is, of several draws at once.
#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "subjects/process/conversation.h"
#include "subjects/process/process.h"

namespace rasterproof::subjects {
namespace {

// The least n of [low, high] that does it, if all above do as well: high is known to.
std::size_t LeastThat(std::size_t low, std::size_t high,
                      const std::function<bool(std::size_t)>& does) {
  while (low < high) {
    const std::size_t middle = low + (high - low) / 2;
    if (does(middle)) {
      high = middle;
    } else {
      low = middle + 1;
    }
  }
  return high;
}

}  // namespace

// Asks a fresh child. Error: SubjectStop if it can't be found out.
bool ProcessSubject::BreaksDown(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes) {
  constexpr double kPatience = 4;  // a batch may be slow without being at fault
  child_.reset();
  const double most = jobs.size() > 1 ? kPatience * limits_.seconds : limits_.seconds;
  outcomes = Ask(jobs, {most, most}).outcomes;
  const CallEnd& end = outcomes.back().end;
  if (EndsTheCall(end.stop) && !IsBreakdown(end.stop)) throw SubjectStop(end);
  return IsBreakdown(end.stop);
}

// A breakdown over several draws at once: finds out whose it is. `outcomes` ends with it.
void ProcessSubject::Trace(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes) {
  const std::vector<DrawOutcome> known = outcomes;
  try {
    TraceAlone(jobs, outcomes);
  } catch (const SubjectStop& slow) {
    outcomes = known;
    outcomes.back().end.why += "; which of " + std::to_string(jobs.size()) +
                               " draws does it was not found out: " + slow.what();
  }
}

// Finds the draw that is to blame by asking each alone. A program answers in order, so no draw
// before the missing answer is to blame. In a batch it may also be any later one, for the program
// may draw them all before it says anything.
void ProcessSubject::TraceAlone(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes) {
  const std::size_t first = outcomes.size() - 1;
  const std::size_t last = info_.takes_batches ? jobs.size() - 1 : first;
  const DrawOutcome fault = outcomes.back();
  outcomes.pop_back();
  for (std::size_t k = first; k <= last; ++k) {
    std::vector<DrawOutcome> alone;
    const bool breaks_down = BreaksDown(jobs.subspan(k, 1), alone);
    outcomes.push_back(alone.front());
    if (breaks_down) return;
  }
  outcomes.resize(first);
  outcomes.push_back(fault);
  TraceRun(jobs.first(last + 1), outcomes);
}

// None of the jobs does it alone. Finds the first run from the beginning that does, then the
// shortest one with the same end. `outcomes` ends with the fault.
void ProcessSubject::TraceRun(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes) {
  std::vector<DrawOutcome> seen;
  if (!BreaksDown(jobs, seen)) {
    outcomes.back().end.stop = Stop::kBrokeDown;
    outcomes.back().end.why += "; the same calls on a fresh process do not do it again";
    return;
  }
  const std::size_t end = LeastThat(seen.size(), jobs.size(),
                                    [&](std::size_t n) { return BreaksDown(jobs.first(n), seen); });
  const std::size_t run =
      LeastThat(2, end, [&](std::size_t n) { return BreaksDown(jobs.subspan(end - n, n), seen); });
  BreaksDown(jobs.subspan(end - run, run), seen);
  outcomes.resize(std::min(outcomes.size() - 1, end - 1));
  while (outcomes.size() + 1 < end) {
    outcomes.push_back(AskAlone(jobs[outcomes.size()]));
    if (EndsTheCall(outcomes.back().end.stop)) return;
  }
  outcomes.emplace_back().end = {Stop::kBrokeDown,
                                 seen.back().end.why + "; not alone, but after the " +
                                     std::to_string(run - 1) + " draws before it" +
                                     (info_.takes_batches ? " in the same call" : "")};
}

}  // namespace rasterproof::subjects
