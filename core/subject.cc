#include "core/subject.h"

#include <exception>
#include <span>
#include <vector>

#include "core/evaluators.h"

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

std::vector<DrawOutcome> Subject::DrawMany(std::span<const DrawJob> jobs) {
  std::vector<DrawOutcome> outcomes;
  for (const DrawJob& job : jobs) {
    DrawOutcome& outcome = outcomes.emplace_back();
    try {
      outcome.drawing = Show(job);
    } catch (...) {
      outcome.error = std::current_exception();
      if (outcome.BrokeDown()) break;
    }
  }
  return outcomes;
}

}  // namespace rasterproof
