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
#include "subjects/process/conversation.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {

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
      waits_left_(limits.long_waits),
      is_the_users_(program == Program::kTheUsers),
      may_not_run_(is_the_users_) {
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
  if (jobs.size() == 1) {
    outcomes.push_back(AskAlone(jobs.front()));  // a braced list would copy it
    return outcomes;
  }
  const Wait wait = is_in_parts_ ? Wait{limits_.seconds, limits_.seconds} : LongestWait();
  Call call = Ask(jobs, wait);
  if (IsBreakdown(call.outcomes.back().end.stop)) {
    Trace(jobs, call.outcomes);
  } else if (call.slow && !info_.takes_batches) {
    // It is the one without an answer, or whose answer came late.
    call.outcomes.back() = AskAgain(jobs[call.outcomes.size() - 1], *call.slow, wait);
  } else if (call.slow) {
    // In a batch any job may be slow, or all of them a little: from now on they are fewer.
    constexpr std::size_t kPart = 8;
    most_in_a_batch_ = (jobs.size() + kPart - 1) / kPart;
    if (!call.slow->GaveAnswer()) return AskInParts(jobs, std::move(call), wait);
  }
  return std::move(call.outcomes);
}

const EdgeEvaluator* ProcessSubject::Edges() const { return edges_.get(); }

void ProcessSubject::SetDeadline(Clock::time_point deadline) {
  deadline_ = deadline;
  if (twin_ != nullptr) twin_->SetDeadline(deadline);
}

Subject* ProcessSubject::Twin() {
  if (twin_ == nullptr) {
    twin_ = std::make_unique<ProcessSubject>(command_, info_, limits_,
                                             is_the_users_ ? Program::kTheUsers : Program::kOurs);
    twin_->may_not_run_ = false;
    twin_->SetDeadline(deadline_);
  }
  return twin_.get();
}

// Asks all open requests in one write, and returns the own time that the answers took. Of several,
// a late one counts: a program may keep finished answers back while it works on later requests.
double ProcessSubject::AskOpenValues(std::span<EdgeRequest> requests, const Wait& wait,
                                     std::vector<std::vector<double>>& answers) {
  std::unique_ptr<Child> child = TakeChild();
  for (EdgeRequest& request : requests) request.id = next_id_++;
  child->Ask(RequestsText(requests));
  double counted = 0;
  for (const EdgeRequest& request : requests) {
    Patience patience = child->Wait(wait.most, deadline_);
    std::vector<double> values = ReadValues(
        request, info_.name, [&](std::size_t most) { return child->Line(patience, most); });
    child->TakeAnswer();
    may_not_run_ = false;
    const double seconds = patience.time.Counted();
    if (requests.size() == 1 && wait.IsLong() && seconds > wait.limit) throw OutOfTime(seconds);
    answers.push_back(std::move(values));
    counted += seconds;
  }
  child->RequireSilence();
  child_ = std::move(child);
  return counted;
}

// Which of several requests is slow is found only by asking each alone.
std::vector<std::vector<double>> ProcessSubject::AskValues(std::span<EdgeRequest> requests) {
  std::vector<std::vector<double>> answers;
  std::optional<OutOfTime> silence;
  Wait waited;
  double since = 0;  // own time of the answers since the silence
  for (std::size_t most = requests.size(); answers.size() < requests.size();) {
    const std::size_t count = std::min(most, requests.size() - answers.size());
    const std::span<EdgeRequest> open = requests.subspan(answers.size(), count);
    const Wait wait = LongestWait();
    try {
      since += AskOpenValues(open, wait, answers);
    } catch (const Ended& ended) {
      if (is_the_users_ && ended.how() == Ended::How::kCleanly) continue;
      if (ended.ByItself()) RequireThatItRuns();
      throw;
    } catch (const OutOfTime& slow) {
      most = 1;
      if (count == 1) {
        TryAgain(slow, wait, [&](const Wait& again) { AskOpenValues(open, again, answers); });
        continue;
      }
      silence = slow;
      waited = wait;
      if (wait.IsLong()) --waits_left_;
    }
  }
  if (silence) {
    const CallEnd end = EndOfSilence(*silence, waited, since, requests.size());
    if (end.stop != Stop::kNone) throw SubjectStop(end);
  }
  return answers;
}

// The child is in the hands of who asks it: whatever goes wrong, the next one starts a fresh one.
std::unique_ptr<ProcessSubject::Child> ProcessSubject::TakeChild() {
  if (Clock::now() >= deadline_)
    throw SubjectStop(Stop::kDeadline, "it ran out of time (--seconds)");
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

// A program of the user's that ends with status 0 between two answers begins afresh, as it may by
// design. A fresh one must answer before it may end.
bool ProcessSubject::MayBeginAfresh(const Ended& ended, std::span<const DrawJob> jobs,
                                    std::size_t answered) const {
  const bool is_in_a_batch = info_.takes_batches && jobs.size() > 1 && answered != 0;
  return is_the_users_ && ended.how() == Ended::How::kCleanly && !is_in_a_batch;
}

ProcessSubject::Call ProcessSubject::Ask(std::span<const DrawJob> jobs, const Wait& wait) {
  Call call = AskOnce(jobs, wait);
  if (call.ended && limits_.bytes != 0) BlameMemory(jobs, call);
  return call;
}

ProcessSubject::Call ProcessSubject::AskOnce(std::span<const DrawJob> jobs, const Wait& wait) {
  Call call;
  std::unique_ptr<Child> child;
  const std::uint64_t first_id = next_id_;
  next_id_ += jobs.size();
  const auto read = [&](std::size_t k, Drawing& drawing) {
    if (child == nullptr) {
      child = TakeChild();
      if (child->HasAnswered() && limits_.bytes != 0) call.bytes_before = child->Bytes();
      child->Ask(CallText(first_id + k, jobs.subspan(k)));
      if (limits_.bytes != 0) child->Remember(jobs.subspan(k));
    }
    Patience patience = child->Wait(wait.most, deadline_);
    drawing = ReadAnswer(
        first_id + k, jobs[k], info_, [&](std::size_t most) { return child->Line(patience, most); },
        [&](std::size_t count) { return child->Bytes(patience, count); });
    child->TakeAnswer();
    may_not_run_ = false;
    if (jobs[k].onto != nullptr) drawing.counts += *jobs[k].onto;
    call.counted = patience.time.Counted();
    answered_seconds_ += call.counted;
    if (wait.IsLong() && call.counted > wait.limit) call.slow.emplace(call.counted);
    if (k + 1 == jobs.size()) child->RequireSilence();
  };
  const auto ask = [&](std::size_t k, Drawing& drawing) {
    try {
      read(k, drawing);
    } catch (const Ended& ended) {
      if (!MayBeginAfresh(ended, jobs, k)) throw;
      child = nullptr;
      read(k, drawing);
    }
  };
  const bool goes_on = info_.takes_batches && jobs.size() > 1;
  for (std::size_t k = 0; k < jobs.size(); ++k) {
    auto& [drawing, end] = call.outcomes.emplace_back();
    Drawing& drawn = drawing;
    end = EndOf([&] { AskNoting(call, [&] { ask(k, drawn); }); });
    if (end.stop == Stop::kRefused) {
      may_not_run_ = false;
      child->TakeAnswer();
    }
    if (end.stop != Stop::kNone && end.stop != Stop::kRefused) {
      if (call.ended && child != nullptr) call.before = child->CallsBefore();
      return call;
    }
    if (call.slow && !goes_on) {
      if (k + 1 == jobs.size()) child_ = std::move(child);
      return call;
    }
  }
  child_ = std::move(child);
  return call;
}

// Notes in the call why it ended.
void ProcessSubject::AskNoting(Call& call, const std::function<void()>& ask) {
  try {
    ask();
  } catch (const Ended& ended) {
    call.ended = true;
    call.is_too_large = ended.how() == Ended::How::kTooLarge;
    if (ended.ByItself()) RequireThatItRuns();
    throw;
  } catch (const OutOfTime& slow) {
    call.slow = slow;
    throw;
  } catch (const SubjectStop& stop) {
    // The host of plugins tells so.
    call.ended = IsBreakdown(stop.stop()) && std::string_view(stop.what()).ends_with("bad_alloc");
    throw;
  }
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
  for (const DrawOutcome& outcome :
       Ask(jobs, {limits_.seconds * repeats, limits_.seconds * repeats}).outcomes)
    outcome.Get();
  if (!used || child_ == nullptr) return std::nullopt;
  const std::optional<double> used_now = child_->Used();
  if (!used_now) return std::nullopt;
  return DrawTime{.seconds = *used_now - *used, .wall_seconds = WallSeconds() - begun};
}

std::string ProcessSubject::CallText(std::uint64_t first_id, std::span<const DrawJob> jobs) const {
  std::string call = info_.takes_batches && jobs.size() > 1 ? BatchText(jobs.size()) : "";
  return call + RequestsText(first_id, jobs, info_);
}

}  // namespace rasterproof::subjects
