#include "subjects/process/process.h"

#include <algorithm>
#include <cstddef>
#include <exception>
#include <functional>
#include <utility>

#include "core/edge_claims.h"
#include "core/error.h"
#include "subjects/process/child.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

ChildProcess::Clock::time_point After(double seconds) {
  return ChildProcess::Clock::now() + std::chrono::duration_cast<ChildProcess::Clock::duration>(
                                          std::chrono::duration<double>(seconds));
}

std::string SecondsText(double seconds) {
  std::string text = std::to_string(seconds);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text + " s";
}

std::string FaultText(const DrawOutcome& outcome) {
  try {
    outcome.Get();
    return "";
  } catch (const std::exception& error) {
    return error.what();
  }
}

// The job without the wishes that the subject does not take.
DrawJob Taken(const DrawJob& job, const SubjectInfo& info) {
  DrawJob taken = job;
  if (!info.takes_tiles) taken.options.tile = 0;
  if (!info.takes_threads) taken.options.threads = 1;
  return taken;
}

// The least n of [low, high] that does it, if it is so for all above as well; high is known to.
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

// The running child, and reading its answers.
class ProcessSubject::Child {
 public:
  Child(const std::vector<std::string>& command, const ProcessLimits& limits)
      : process_(command, limits.bytes), limits_(limits) {}

  void Ask(std::string request) { process_.Say(std::move(request)); }

  std::string Line(ChildProcess::Clock::time_point deadline) {
    std::string line;
    switch (process_.ReadLine(deadline, limits_.answer_bytes, line)) {
      case PipeEnd::kOpen:
        return line;
      case PipeEnd::kTimedOut:
        throw SubjectFault("it gave no answer within " + SecondsText(limits_.seconds));
      case PipeEnd::kInterrupted:
        throw SubjectTooSlow(kInterruptedText);
      case PipeEnd::kClosed:
        break;
    }
    throw SubjectFault("it " + process_.Ending() + " before its answer was whole");
  }

  // Whoever says more than it was asked would be taken for an answer to what comes next.
  void RequireSilence() {
    const std::string more = process_.Unread();
    if (more.empty()) return;
    throw SubjectFault("it said more than its answer: \"" + more.substr(0, 60) +
                       "\"; rows of back faces want `coverage facing-counts`");
  }

 private:
  ChildProcess process_;
  ProcessLimits limits_;
};

// The child's edge values. A question that is put again gets the answer afresh.
class ProcessSubject::ShownEdges final : public ClaimedEdges {
 public:
  explicit ShownEdges(ProcessSubject& subject)
      : ClaimedEdges(subject.info_.edges, subject.info_.input), subject_(subject) {}
  double Value(Point2 a, Point2 b, Point2 p) const override {
    return subject_.AskValues(a, b, p, std::nullopt, 0).front();
  }
  std::vector<double> Walk(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
    return subject_.AskValues(a, b, p, step, steps);
  }

 private:
  ProcessSubject& subject_;
};

ProcessSubject::ProcessSubject(std::vector<std::string> command, SubjectInfo info,
                               ProcessLimits limits)
    : command_(std::move(command)), info_(std::move(info)), limits_(limits) {
  if (info_.edges.shows_values) edges_ = std::make_unique<ShownEdges>(*this);
}

ProcessSubject::~ProcessSubject() = default;

const SubjectInfo& ProcessSubject::Info() const { return info_; }

void ProcessSubject::Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  counts += Show({scene, options, counts.samples}).counts;
}

Drawing ProcessSubject::Show(const DrawJob& job) {
  DrawOutcome outcome = std::move(Ask({&job, 1}, limits_.seconds).front());
  outcome.Get();  // or it throws
  return std::move(outcome.drawing);
}

std::vector<DrawOutcome> ProcessSubject::DrawMany(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes = Ask(jobs, limits_.seconds);
  if (jobs.size() > 1 && outcomes.back().BrokeDown()) Trace(jobs, outcomes);
  return outcomes;
}

const EdgeEvaluator* ProcessSubject::Edges() const { return edges_.get(); }

std::vector<double> ProcessSubject::AskValues(Point2 a, Point2 b, Point2 p,
                                              std::optional<Step> step, int steps) {
  if (child_ == nullptr) child_ = std::make_unique<Child>(command_, limits_);
  std::unique_ptr<Child> child = std::move(child_);
  const EdgeRequest request{next_id_++, a, b, p, step, steps};
  child->Ask(RequestText(request));
  const auto deadline = After(limits_.seconds);
  std::vector<double> values =
      ReadValues(request, info_.name, [&] { return child->Line(deadline); });
  child_ = std::move(child);
  return values;
}

// One call. Whatever goes wrong in it, the next one starts a fresh child.
std::vector<DrawOutcome> ProcessSubject::Ask(std::span<const DrawJob> jobs, double seconds) {
  if (child_ == nullptr) child_ = std::make_unique<Child>(command_, limits_);
  std::unique_ptr<Child> child = std::move(child_);
  const std::uint64_t first_id = next_id_;
  next_id_ += jobs.size();
  std::string call = info_.takes_batches && jobs.size() > 1 ? BatchText(jobs.size()) : "";
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    call += RequestText(first_id + k, Taken(jobs[k], info_));
  }
  child->Ask(std::move(call));
  std::vector<DrawOutcome> outcomes;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    const auto deadline = After(seconds);
    DrawOutcome& outcome = outcomes.emplace_back();
    try {
      outcome.drawing =
          ReadAnswer(first_id + k, jobs[k], info_, [&] { return child->Line(deadline); });
      if (k + 1 == jobs.size()) child->RequireSilence();
    } catch (const InputError&) {
      outcome.error = std::current_exception();
    } catch (const SubjectFault&) {
      outcome.error = std::current_exception();
      return outcomes;
    } catch (const SubjectTooSlow&) {
      outcome.error = std::current_exception();
      return outcomes;
    }
  }
  child_ = std::move(child);
  return outcomes;
}

// Asks a fresh child, and gives it more time: a batch may be slow without being at fault.
bool ProcessSubject::BreaksDown(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes) {
  constexpr double kPatience = 4;
  child_.reset();
  outcomes = Ask(jobs, jobs.size() > 1 ? kPatience * limits_.seconds : limits_.seconds);
  return outcomes.back().BrokeDown();
}

// A program answers in order: before the answer that is missing none is to blame. In a batch it may
// be any of those behind it as well, for it may draw them all before it says anything.
void ProcessSubject::Trace(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes) {
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
  const std::string what = FaultText(outcomes.back());
  std::vector<DrawOutcome> seen;
  if (!BreaksDown(jobs, seen)) {
    if (!info_.takes_batches) {
      outcomes.back().error = std::make_exception_ptr(
          SubjectFault(what + "; the same calls on a fresh process do not do it again"));
    } else {
      outcomes = seen;  // it was slow as a whole, and nothing more
    }
    return;
  }
  const std::size_t end = LeastThat(seen.size(), jobs.size(),
                                    [&](std::size_t n) { return BreaksDown(jobs.first(n), seen); });
  const std::size_t run =
      LeastThat(2, end, [&](std::size_t n) { return BreaksDown(jobs.subspan(end - n, n), seen); });
  BreaksDown(jobs.subspan(end - run, run), seen);
  outcomes.resize(std::min(outcomes.size() - 1, end - 1));
  while (outcomes.size() + 1 < end) {
    outcomes.push_back(Ask(jobs.subspan(outcomes.size(), 1), limits_.seconds).front());
    if (outcomes.back().BrokeDown()) return;
  }
  outcomes.emplace_back().error = std::make_exception_ptr(SubjectFault(
      FaultText(seen.back()) + "; not alone, but after the " + std::to_string(run - 1) +
      " draws before it" + (info_.takes_batches ? " in the same call" : "")));
}

std::string OutputOf(const std::vector<std::string>& command, const std::string& place,
                     const ProcessLimits& limits) {
  ChildProcess process(command, limits.bytes);
  process.SayNoMore();
  const auto deadline = After(limits.seconds);
  std::string output;
  for (;;) {
    std::string line;
    const PipeEnd end = process.ReadLine(deadline, limits.answer_bytes, line);
    if (end == PipeEnd::kOpen) {
      output += line + '\n';
      continue;
    }
    if (end == PipeEnd::kTimedOut) {
      throw InputError(place, "it did not end within " + SecondsText(limits.seconds),
                       "mend the program");
    }
    if (end == PipeEnd::kInterrupted) throw SubjectTooSlow(kInterruptedText);
    const std::string ending = process.Ending();
    if (ending == "ended with status 0") return output;
    throw InputError(place, "it " + ending, "mend the program, or give another");
  }
}

}  // namespace rasterproof::subjects
