#include "props/catalog/triangle_order.h"

#include <algorithm>
#include <cstddef>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict TriangleOrderKeepsCoverage(Subject& subject, const Case& c) {
  const Need need{.space = Space::kEither, .any_model_suffices = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (c.scene.triangles.size() < 2) {
    return {Outcome::kNotExercised, 0, 0, "one triangle has one order", std::nullopt};
  }
  Case reordered = c;
  std::ranges::reverse(reordered.scene.triangles);
  Verdict reversed = SameAsUnvaried(subject, c, reordered, "that in the order given");
  if (reversed.outcome == Outcome::kViolated) return reversed;
  // A rotation by half, too: a subject that looks at its neighbour in the list sees another one.
  const auto half = static_cast<std::ptrdiff_t>(reordered.scene.triangles.size() / 2);
  std::ranges::rotate(reordered.scene.triangles, reordered.scene.triangles.begin() + half);
  Verdict rotated = SameAsUnvaried(subject, c, reordered, "that in the order given");
  rotated.exercised += reversed.exercised;
  return rotated;
}

}  // namespace rasterproof::props
