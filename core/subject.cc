#include "core/subject.h"

#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/call_end.h"
#include "core/error.h"
#include "core/evaluators.h"
#include "core/float_mode.h"

namespace rasterproof {

std::vector<double> EdgeEvaluator::Values(std::span<const EdgeQuestion> questions) const {
  std::vector<double> values;
  for (const auto& [a, b, p] : questions) values.push_back(Value(a, b, p));
  return values;
}

std::vector<std::vector<double>> EdgeEvaluator::Steps(
    std::span<const StepsQuestion> questions) const {
  std::vector<std::vector<double>> values;
  for (const auto& [a, b, p, step, steps] : questions)
    values.push_back(Steps(a, b, p, step, steps));
  return values;
}

Drawing Subject::Show(const DrawJob& job) {
  Drawing drawing;
  drawing.counts = CoverageCounts(job.scene->width, job.scene->height, job.samples);
  if (job.triangles) {
    Draw(SceneOf(job), job.options, drawing.counts);
  } else {
    Draw(*job.scene, job.options, drawing.counts);
  }
  return drawing;
}

void Subject::Draw(const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
  counts += Show({scene, options, counts.samples}).counts;
}

std::vector<DrawOutcome> Subject::DrawMany(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes;
  for (const DrawJob& job : jobs) {
    DrawOutcome& outcome = outcomes.emplace_back();
    if (const std::optional<InputError> why = WhyNotDrawn(job)) {
      outcome.end = {Stop::kNotDrawable, why->what()};
      continue;
    }
    std::string complaint;
    outcome.end = EndOf([&] {
      const WithinFloatMode mode(job.options.float_mode);
      if (job.onto == nullptr) {
        outcome.drawing = Show(job);
      } else {
        outcome.drawing.counts = *job.onto;
        Draw(SceneOf(job), job.options, outcome.drawing.counts);
      }
      complaint = mode.Complaint();
    });
    if (!complaint.empty()) outcome.end = {Stop::kBrokeDown, complaint};
    if (EndsTheCall(outcome.end.stop)) break;
  }
  return outcomes;
}

Drawing DrawOne(Subject& subject, const DrawJob& job) {
  DrawOutcome outcome = std::move(subject.DrawMany({&job, 1}).front());
  outcome.Get();  // or it throws
  return std::move(outcome.drawing);
}

void DrawOnto(Subject& subject, const Scene& scene, const DrawOptions& options,
              CoverageCounts& counts) {
  counts += DrawOne(subject, {scene, options, counts.samples}).counts;
}

}  // namespace rasterproof
