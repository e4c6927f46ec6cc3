#include "core/subject.h"

#include <exception>

namespace rasterproof {

Drawing Subject::Show(const DrawJob& job) {
  Drawing drawing;
  drawing.counts = CoverageCounts(job.scene.width, job.scene.height, job.samples);
  Draw(job.scene, job.options, drawing.counts);
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
