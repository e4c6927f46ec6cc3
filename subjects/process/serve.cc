#include "subjects/process/serve.h"

#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <istream>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kMostKeptBack{10};
constexpr std::size_t kMostSaidAtOnce = 1 << 20;  // characters; one answer may have more

std::string OneLine(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

// A drawing of another shape than its target's can't be sent.
void RequireShape(const Drawing& drawing, const DrawJob& job, CoverageKind kind) {
  const Outputs answered = Answered(kind, job.wants);
  const Scene& target = *job.scene;
  const std::size_t size = CoverageCounts::Size(target.width, target.height, job.samples);
  const std::size_t values = size * target.channels.size();
  const CoverageCounts& counts = drawing.counts;
  const bool fits = counts.width == target.width && counts.height == target.height &&
                    counts.samples == job.samples && counts.front.size() == size &&
                    counts.back.size() == size &&
                    (!answered.primitive_ids || drawing.primitive_ids.size() == size) &&
                    (!answered.barycentrics || drawing.barycentrics.size() == size) &&
                    (!answered.depths || drawing.depths.size() == size) &&
                    (!answered.centroids || drawing.centroids.size() == size) &&
                    (!answered.values || drawing.values.size() == values) &&
                    (!answered.derivatives || drawing.derivatives.size() == values);
  if (!fits) BreakDown("its drawing has not the shape of the target, or lacks a part");
}

// This process may have no more memory, be it for the target, for the answer or for the subject.
std::string OutOfMemoryText() {
  rlimit limit{};
  getrlimit(RLIMIT_AS, &limit);
  std::string most = "all that the machine gives";
  if (limit.rlim_cur != RLIM_INFINITY) {
    most = std::to_string(limit.rlim_cur >> 20) + " MiB (--memory-limit)";
  }
  return "its process has used up its memory, " + most +
         ", of which rasterproof takes a part for target and answer; raise --memory-limit, or "
         "give it smaller targets";
}

// Does what EndOf does. Whose memory ran out is not known: that is no finding.
CallEnd EndHere(const std::function<void()>& call) {
  try {
    return EndOf(call);
  } catch (const std::bad_alloc&) {
    return {Stop::kOutOfMemory, OutOfMemoryText()};
  } catch (const std::exception& error) {
    return {Stop::kBrokeDown, error.what()};
  }
}

std::string_view EndWord(Stop stop) {
  switch (stop) {
    case Stop::kRefused:
    case Stop::kNotDrawable:
      return "refused ";
    case Stop::kOutOfMemory:
      return "no-memory ";
    case Stop::kNone:
    case Stop::kBrokeDown:
    case Stop::kHung:
    case Stop::kTooSlow:
    case Stop::kDeadline:
      break;
  }
  return "fault ";
}

std::string EndText(std::uint64_t id, const CallEnd& end) {
  return std::string(EndWord(end.stop)) + std::to_string(id) + " " + OneLine(end.why) + "\n";
}

// The result of `answer`, or how it ended.
std::string AnswerOrEnd(std::uint64_t id, const std::function<std::string()>& answer) {
  std::string text;
  const CallEnd end = EndHere([&] { text = answer(); });
  if (end.stop != Stop::kNone) return EndText(id, end);
  return text;  // moved: of a large target there is no room for a second one
}

std::string Answer(const DrawRequest& request, const DrawOutcome& outcome, CoverageKind kind) {
  return AnswerOrEnd(request.id, [&] {
    RequireShape(outcome.Get(), request.job, kind);
    return AnswerText(request.id, outcome.drawing, kind, request.job.wants);
  });
}

// All repeats of the job but the last. Their failures occur in the last one too.
void DrawForTheClock(Subject& subject, const DrawJob& job) {
  if (job.repeats == 1) return;
  try {
    if (!subject.TimeDraws(job, job.repeats - 1)) {
      for (int k = 1; k < job.repeats; ++k) DrawOne(subject, job);
    }
  } catch (const std::exception&) {
    return;
  }
}

std::string ValuesOf(const Subject& subject, const EdgeRequest& request) {
  const EdgeEvaluator* const edges = subject.Edges();
  if (edges == nullptr) throw InputError("subject", "it shows no edge values", "ask for none");
  const auto& [id, a, b, p, step, steps] = request;
  if (!step) {
    const double value = edges->Value(a, b, p);
    return ValuesText(id, {&value, 1});
  }
  return ValuesText(id, edges->Steps(a, b, p, *step, steps));
}

}  // namespace

void Serve(Subject& subject, std::istream& in, const std::function<void(const std::string&)>& say) {
  RequestReader requests(in);
  std::string values;  // that were not said yet
  Clock::time_point said = Clock::now();
  for (;;) {
    if (const std::optional<EdgeRequest> request = requests.NextEdgeRequest()) {
      values += AnswerOrEnd(request->id, [&] { return ValuesOf(subject, *request); });
      // If more requests are waiting, answers are collected and written about every 10 ms, after
      // the answer in progress at that time. If that one hangs, those before it are never written.
      if (requests.HasMore() && Clock::now() - said < kMostKeptBack) continue;
      say(std::exchange(values, {}));
      said = Clock::now();
      continue;
    }
    if (!values.empty()) say(std::exchange(values, {}));
    const std::vector<DrawRequest> call = requests.NextCall();
    if (call.empty()) return;
    std::vector<DrawJob> jobs;
    for (const DrawRequest& request : call) jobs.push_back(request.job);
    for (const DrawJob& job : jobs) DrawForTheClock(subject, job);
    std::vector<DrawOutcome> outcomes;
    CallEnd end = EndHere([&] { outcomes = subject.DrawMany(jobs); });
    if (end.stop != Stop::kNone) outcomes = {{{}, std::move(end)}};
    std::string answers;
    for (std::size_t k = 0; k < call.size() && k < outcomes.size(); ++k) {
      std::string answer = Answer(call[k], outcomes[k], subject.Info().coverage);
      outcomes[k].drawing = {};  // a large one takes much memory
      if (!answers.empty() && answers.size() + answer.size() > kMostSaidAtOnce)
        say(std::exchange(answers, {}));
      if (answers.empty()) {
        answers = std::move(answer);
      } else {
        answers += answer;
      }
    }
    if (outcomes.size() < call.size() &&
        (outcomes.empty() || !EndsTheCall(outcomes.back().end.stop))) {
      answers += "fault " + std::to_string(call[outcomes.size()].id) + " it left out a scene\n";
    }
    say(answers);
  }
}

}  // namespace rasterproof::subjects
