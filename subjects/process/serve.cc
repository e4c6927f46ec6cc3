#include "subjects/process/serve.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/subject_errors.h"
#include "subjects/process/protocol.h"

namespace rasterproof::subjects {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kMostKeptBack{10};

std::string OneLine(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  return text;
}

// A drawing of another shape than its target's can't be told.
void RequireShape(const Drawing& drawing, const DrawJob& job, CoverageKind kind) {
  const Outputs answered = Answered(kind, job.wants);
  const CoverageCounts target(job.scene->width, job.scene->height, job.samples);
  const CoverageCounts& counts = drawing.counts;
  const bool fits = counts.width == target.width && counts.height == target.height &&
                    counts.samples == target.samples && counts.front.size() == target.size() &&
                    counts.back.size() == target.size() &&
                    (!answered.primitive_ids || drawing.primitive_ids.size() == target.size()) &&
                    (!answered.barycentrics || drawing.barycentrics.size() == target.size()) &&
                    (!answered.depths || drawing.depths.size() == target.size()) &&
                    (!answered.centroids || drawing.centroids.size() == target.size());
  if (!fits) throw SubjectFault("its drawing has not the shape of the target, or lacks a part");
}

// What `answer` gives, or what it throws as an answer.
std::string AnswerOrFault(std::uint64_t number, const std::function<std::string()>& answer) {
  const std::string id = std::to_string(number);
  try {
    return answer();
  } catch (const InputError& error) {
    return "refused " + id + " " + OneLine(error.what()) + "\n";
  } catch (const std::exception& error) {
    return "fault " + id + " " + OneLine(error.what()) + "\n";
  } catch (...) {
    return "fault " + id + " it threw something that is no std::exception\n";
  }
}

std::string Answer(const DrawRequest& request, const DrawOutcome& outcome, CoverageKind kind) {
  return AnswerOrFault(request.id, [&] {
    if (outcome.error == nullptr) RequireShape(outcome.drawing, request.job, kind);
    return AnswerText(request.id, outcome.Get(), kind, request.job.wants);
  });
}

// All repeats of the job but the last. What goes wrong in them goes wrong in that one, too.
void DrawForTheClock(Subject& subject, const DrawJob& job) {
  if (job.repeats == 1) return;
  try {
    if (!subject.TimeDraws(job, job.repeats - 1)) {
      for (int k = 1; k < job.repeats; ++k) subject.Show(job);
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
      values += AnswerOrFault(request->id, [&] { return ValuesOf(subject, *request); });
      // Where more is asked already the answers go in one write, about every 10 ms: behind the one
      // that is worked on by then. If that one hangs those before it are never said.
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
    const std::vector<DrawOutcome> outcomes = subject.DrawMany(jobs);
    std::string answers;
    for (std::size_t k = 0; k < call.size() && k < outcomes.size(); ++k) {
      answers += Answer(call[k], outcomes[k], subject.Info().coverage);
    }
    if (outcomes.size() < call.size() && !(!outcomes.empty() && outcomes.back().BrokeDown())) {
      answers += "fault " + std::to_string(call[outcomes.size()].id) + " it left out a scene\n";
    }
    say(answers);
  }
}

}  // namespace rasterproof::subjects
