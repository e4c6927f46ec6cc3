#include "subjects/process/process.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <iterator>
#include <string_view>
#include <utility>

#include "core/call_end.h"
#include "core/evaluators.h"
#include "core/quoted.h"
#include "core/stated_edges.h"
#include "core/subject_info.h"
#include "core/target_size.h"
#include "subjects/process/child.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {

// Its own time was over. What is thrown to callers says what that means.
class ProcessSubject::OutOfTime : public SubjectStop {
 public:
  explicit OutOfTime(const OwnTime& time)
      : SubjectStop(Stop::kTooSlow, time.Text()), starved_(time.WasStarved()) {}
  bool WasStarved() const { return starved_; }

 private:
  bool starved_;
};

// What came of one call.
struct ProcessSubject::Call {
  std::vector<DrawOutcome> outcomes;  ///< up to the one that ended it
  double counted = 0;                 ///< own time that the last answer took
  std::optional<OutOfTime> slow;      ///< if that ended it
};

namespace {

// The program ended by itself before its answer was whole.
class EndedByItself : public SubjectStop {
 public:
  explicit EndedByItself(const std::string& how) : SubjectStop(Stop::kBrokeDown, how) {}
};

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

// How many times the limit a draw gets that is to show whether it hangs.
constexpr double kHangFactor = 10;
// How often in a subject's life that is tried.
constexpr int kMostTries = 3;

}  // namespace

// The running child, and reading its answers.
class ProcessSubject::Child {
 public:
  Child(const std::vector<std::string>& command, const ProcessLimits& limits)
      : process_(command, limits.bytes) {}

  void Ask(std::string request) { process_.Say(std::move(request)); }
  std::optional<double> Used() const { return process_.Used(); }

  Patience Wait(double seconds, ChildProcess::Clock::time_point deadline) const {
    return process_.Wait(seconds, deadline);
  }

  std::string_view Line(Patience& patience, std::size_t most_bytes) {
    std::string_view line;
    const PipeEnd end = process_.ReadLine(patience, most_bytes, line);
    RequireOpen(end, patience, most_bytes);
    return line;
  }
  std::string_view Bytes(Patience& patience, std::size_t count) {
    std::string_view bytes;
    const PipeEnd end = process_.ReadBytes(patience, count, bytes);
    RequireOpen(end, patience, count);
    return bytes;
  }

  // Whoever says more than it was asked would be taken for an answer to what comes next.
  void RequireSilence() {
    std::string more;
    if (!process_.HasUnread(more)) return;
    if (!process_.WasTold()) BreakDown("it spoke before it was asked: " + Quoted(more, 60));
    BreakDown("it said more than its answer: " + Quoted(more, 60) +
              "; rows of back faces want `coverage facing-counts`");
  }

 private:
  void RequireOpen(PipeEnd end, const Patience& patience, std::size_t most_bytes) {
    switch (end) {
      case PipeEnd::kOpen:
        return;
      case PipeEnd::kTimedOut:
        if (process_.ReadsNoMore()) BreakDown("it closed its input and gave no answer");
        throw OutOfTime(patience.time);
      case PipeEnd::kDeadline:
        throw SubjectStop(Stop::kDeadline, "its time was up before it answered (--seconds)");
      case PipeEnd::kInterrupted:
        throw SubjectStop(Stop::kTooSlow, kInterruptedText);
      case PipeEnd::kTooLong:
        BreakDown("a line of its answer is longer than " + std::to_string(most_bytes) +
                  " bytes, the most that a correct answer to this scene needs");
      case PipeEnd::kClosed:
        break;
    }
    const std::string ending = process_.Ending();
    const std::string what = "it " + (ending == kStillRan ? "closed its output" : ending) +
                             " before its answer was whole";
    if (ending.starts_with(kEnded)) throw EndedByItself(what);
    BreakDown(what);
  }

  ChildProcess process_;
};

// The child's edge values. A repeated question is sent again.
class ProcessSubject::ShownEdges final : public StatedEdges {
 public:
  explicit ShownEdges(ProcessSubject& subject)
      : StatedEdges(subject.info_.edges, subject.info_.input), subject_(subject) {}
  double Value(Point2 a, Point2 b, Point2 p) const override {
    return Values(std::array{EdgeQuestion{a, b, p}}).front();
  }
  std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
    return Steps(std::array{StepsQuestion{a, b, p, step, steps}}).front();
  }
  std::vector<double> Values(std::span<const EdgeQuestion> questions) const override {
    std::vector<EdgeRequest> requests;
    for (const auto& [a, b, p] : questions) requests.push_back({0, a, b, p, std::nullopt, 0});
    std::vector<double> values;
    for (const auto& answer : subject_.AskValues(requests)) values.push_back(answer.front());
    return values;
  }
  std::vector<std::vector<double>> Steps(std::span<const StepsQuestion> questions) const override {
    std::vector<EdgeRequest> requests;
    for (const auto& [a, b, p, step, steps] : questions) {
      requests.push_back({0, a, b, p, step, steps});
    }
    return subject_.AskValues(requests);
  }

 private:
  ProcessSubject& subject_;
};

ProcessSubject::ProcessSubject(std::vector<std::string> command, SubjectInfo info,
                               ProcessLimits limits, Program program)
    : command_(std::move(command)),
      info_(std::move(info)),
      limits_(limits),
      tries_left_(kMostTries),
      may_not_run_(program == Program::kTheUsers) {
  if (info_.edges.shows_values) edges_ = std::make_unique<ShownEdges>(*this);
}

ProcessSubject::~ProcessSubject() = default;

const SubjectInfo& ProcessSubject::OwnInfo() const { return info_; }

std::vector<DrawOutcome> ProcessSubject::DrawMany(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes;
  while (outcomes.size() < jobs.size()) {
    const std::size_t at_hand = jobs.size() - outcomes.size();
    std::vector<DrawOutcome> drawn =
        AskSome(jobs.subspan(outcomes.size(), std::min(at_hand, most_in_a_batch_)));
    std::ranges::move(drawn, std::back_inserter(outcomes));
    if (!outcomes.empty() && EndsTheCall(outcomes.back().end.stop)) break;
  }
  return outcomes;
}

// The outcomes of the first of the jobs, up to a breakdown; the rest must be asked again.
std::vector<DrawOutcome> ProcessSubject::AskSome(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes;
  const DrawJob& first = jobs.front();
  const auto fits = [](const DrawJob& job) {
    return IsTargetSize(job.scene->width, job.scene->height, job.samples);
  };
  jobs = jobs.first(static_cast<std::size_t>(
      std::ranges::distance(jobs.begin(), std::ranges::find_if_not(jobs, fits))));
  if (jobs.empty()) {
    outcomes.emplace_back().end = EndOf([&] {
      RequireTargetSize("subject " + info_.name, first.scene->width, first.scene->height,
                        first.samples);
    });
    return outcomes;
  }
  if (jobs.size() == 1) return {AskAlone(jobs.front())};
  Call call = Ask(jobs, limits_.seconds);
  outcomes = std::move(call.outcomes);
  if (!call.slow) {
    if (IsBreakdown(outcomes.back().end.stop)) Trace(jobs, outcomes);
    return outcomes;
  }
  // In a batch any job may be slow, or all of them a little: parts of it are asked for. Else it is
  // the one without an answer.
  if (info_.takes_batches) {
    constexpr std::size_t kPart = 8;
    most_in_a_batch_ = (jobs.size() + kPart - 1) / kPart;
    outcomes.pop_back();
  } else {
    outcomes.back() = AskAgain(jobs[outcomes.size() - 1], *call.slow);
  }
  return outcomes;
}

const EdgeEvaluator* ProcessSubject::Edges() const { return edges_.get(); }

void ProcessSubject::SetDeadline(Clock::time_point deadline) {
  deadline_ = deadline;
  if (twin_ != nullptr) twin_->SetDeadline(deadline);
}

Subject* ProcessSubject::Twin() {
  if (twin_ == nullptr) {
    twin_ = std::make_unique<ProcessSubject>(command_, info_, limits_);
    twin_->SetDeadline(deadline_);
  }
  return twin_.get();
}

// Asks all open requests in one write. The program may keep finished answers back while it works on
// later requests, so a slow request is found only by asking each alone.
std::vector<std::vector<double>> ProcessSubject::AskValues(std::span<EdgeRequest> requests) {
  std::vector<std::vector<double>> answers;
  const auto ask = [&](std::size_t count, double seconds) {
    std::unique_ptr<Child> child = TakeChild();
    const std::span<EdgeRequest> open = requests.subspan(answers.size(), count);
    for (EdgeRequest& request : open) request.id = next_id_++;
    child->Ask(RequestsText(open));
    double counted = 0;
    for (const EdgeRequest& request : open) {
      Patience patience = child->Wait(seconds, deadline_);
      answers.push_back(ReadValues(request, info_.name,
                                   [&](std::size_t most) { return child->Line(patience, most); }));
      may_not_run_ = false;
      counted = patience.time.Counted();
    }
    child->RequireSilence();
    child_ = std::move(child);
    return counted;
  };
  for (std::size_t most = requests.size(); answers.size() < requests.size();) {
    const std::size_t count = std::min(most, requests.size() - answers.size());
    try {
      ask(count, limits_.seconds);
    } catch (const EndedByItself&) {
      RequireThatItRuns();
      throw;
    } catch (const OutOfTime& slow) {
      most = 1;
      if (count == 1) TryLonger(slow, [&](double seconds) { return ask(1, seconds); });
    }
  }
  return answers;
}

// The child is in the hands of who asks it: whatever goes wrong, the next one starts a fresh one.
std::unique_ptr<ProcessSubject::Child> ProcessSubject::TakeChild() {
  if (Clock::now() >= deadline_) throw SubjectStop(Stop::kDeadline, "its time was up (--seconds)");
  if (child_ == nullptr) child_ = std::make_unique<Child>(command_, limits_);
  std::unique_ptr<Child> child = std::move(child_);
  child->RequireSilence();
  return child;
}

// It ended by itself. If it never answered, it may be no program that runs: a module is missing, or
// an argument. Or it ended over this scene, which is a finding.
void ProcessSubject::RequireThatItRuns() {
  if (std::exchange(may_not_run_, false)) RequireThatItAnswers(command_, info_, limits_);
}

ProcessSubject::Call ProcessSubject::Ask(std::span<const DrawJob> jobs, double seconds) {
  Call call;
  std::unique_ptr<Child> child;
  const std::uint64_t first_id = next_id_;
  next_id_ += jobs.size();
  const auto ask = [&](std::size_t k, Drawing& drawing) {
    if (child == nullptr) {
      child = TakeChild();
      child->Ask(CallText(first_id, jobs));
    }
    Patience patience = child->Wait(seconds, deadline_);
    drawing = ReadAnswer(
        first_id + k, jobs[k], info_, [&](std::size_t most) { return child->Line(patience, most); },
        [&](std::size_t count) { return child->Bytes(patience, count); });
    may_not_run_ = false;
    if (jobs[k].onto != nullptr) drawing.counts += *jobs[k].onto;
    call.counted = patience.time.Counted();
    if (k + 1 == jobs.size()) child->RequireSilence();
  };
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    auto& [drawing, end] = call.outcomes.emplace_back();
    Drawing& drawn = drawing;
    end = EndOf([&] {
      try {
        ask(k, drawn);
      } catch (const EndedByItself&) {
        RequireThatItRuns();
        throw;
      } catch (const OutOfTime& slow) {
        call.slow = slow;
        throw;
      }
    });
    if (end.stop == Stop::kRefused) may_not_run_ = false;
    if (end.stop != Stop::kNone && end.stop != Stop::kRefused) return call;
  }
  child_ = std::move(child);
  return call;
}

std::optional<DrawTime> ProcessSubject::TimeDraws(const DrawJob& job, int repeats) {
  std::vector<DrawJob> jobs{job};
  if (info_.takes_repeats) {
    jobs.front().repeats = repeats;
  } else {
    jobs.resize(static_cast<std::size_t>(repeats), job);
  }
  RequireTargetSize("subject " + info_.name, job.scene->width, job.scene->height, job.samples);
  child_ = TakeChild();
  const std::optional<double> used = child_->Used();
  const double begun = WallSeconds();
  for (const DrawOutcome& outcome : Ask(jobs, limits_.seconds * repeats).outcomes) outcome.Get();
  if (!used || child_ == nullptr) return std::nullopt;
  const std::optional<double> used_now = child_->Used();
  if (!used_now) return std::nullopt;
  return DrawTime{.seconds = *used_now - *used, .wall_seconds = WallSeconds() - begun};
}

std::string ProcessSubject::CallText(std::uint64_t first_id, std::span<const DrawJob> jobs) const {
  std::string call = info_.takes_batches && jobs.size() > 1 ? BatchText(jobs.size()) : "";
  return call + RequestsText(first_id, jobs, info_);
}

DrawOutcome ProcessSubject::AskAlone(const DrawJob& job) {
  Call call = Ask({&job, 1}, limits_.seconds);
  return call.slow ? AskAgain(job, *call.slow) : std::move(call.outcomes.front());
}

DrawOutcome ProcessSubject::AskAgain(const DrawJob& job, const OutOfTime& slow) {
  DrawOutcome outcome;
  CallEnd end = EndOf([&] {
    TryLonger(slow, [&](double seconds) {
      Call again = Ask({&job, 1}, seconds);
      if (again.slow) throw *again.slow;
      outcome = std::move(again.outcomes.front());
      return again.counted;
    });
  });
  if (end.stop != Stop::kNone) outcome.end = std::move(end);
  return outcome;
}

// Repeats a draw that took too long, alone on a fresh process with a much longer limit. It then
// hangs, or its time is known; or it was slow only once, and the answer counts.
void ProcessSubject::TryLonger(const OutOfTime& slow, const std::function<double(double)>& ask) {
  const std::string limit = SecondsText(limits_.seconds);
  const std::string said = std::string(slow.what()) + " and gave no answer";
  if (hangs_) {
    throw SubjectStop(Stop::kHung, "it hangs: " + said + ", as before with 10 times as much");
  }
  const std::string advice = said + "; raise --time-limit (now " + limit + ") if it needs more";
  if (slow.WasStarved()) throw SubjectStop(Stop::kTooSlow, advice);
  const auto longer = std::chrono::duration<double>(kHangFactor * limits_.seconds);
  if (tries_left_ == 0 || deadline_ - Clock::now() < longer)
    throw SubjectStop(Stop::kTooSlow, advice);
  --tries_left_;
  child_.reset();
  double counted = 0;
  try {
    counted = ask(longer.count());
  } catch (const OutOfTime& again) {
    if (again.WasStarved()) throw SubjectStop(Stop::kTooSlow, advice);
    hangs_ = true;
    throw SubjectStop(Stop::kHung, "it hangs: alone, on a fresh process, " +
                                       std::string(again.what()) +
                                       " and gave no answer, 10 times its limit of " + limit);
  }
  if (counted <= limits_.seconds) return;
  throw SubjectStop(Stop::kTooSlow, "alone, on a fresh process, it answered after " +
                                        SecondsText(counted) +
                                        "; give a --time-limit above that (now " + limit + ")");
}

// Asks a fresh child. Error: SubjectStop if it can't be found out.
bool ProcessSubject::BreaksDown(std::span<const DrawJob> jobs, std::vector<DrawOutcome>& outcomes) {
  constexpr double kPatience = 4;  // a batch may be slow without being at fault
  child_.reset();
  outcomes = Ask(jobs, jobs.size() > 1 ? kPatience * limits_.seconds : limits_.seconds).outcomes;
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
    if (!info_.takes_batches) {
      outcomes.back().end.stop = Stop::kBrokeDown;
      outcomes.back().end.why += "; the same calls on a fresh process do not do it again";
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
    outcomes.push_back(AskAlone(jobs[outcomes.size()]));
    if (EndsTheCall(outcomes.back().end.stop)) return;
  }
  outcomes.emplace_back().end = {Stop::kBrokeDown,
                                 seen.back().end.why + "; not alone, but after the " +
                                     std::to_string(run - 1) + " draws before it" +
                                     (info_.takes_batches ? " in the same call" : "")};
}

}  // namespace rasterproof::subjects
