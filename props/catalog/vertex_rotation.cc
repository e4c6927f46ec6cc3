#include "props/catalog/vertex_rotation.h"

#include <cstdint>
#include <string>

#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"

namespace rasterproof::props {

Verdict VertexRotationKeepsCoverage(Subject& subject, const Case& c) {
  if (auto refusal = CannotJudgeCoverage(subject, c, {.space = Space::kEither})) return *refusal;
  std::uint64_t exercised = 0;
  Case rotated = c;
  for (int turn = 1; turn < 3; ++turn) {
    for (Triangle& t : rotated.scene.triangles) t = {t[1], t[2], t[0]};
    const Verdict verdict =
        SameAsUnvaried(subject, c, rotated,
                       "the unrotated triangles' after " + std::to_string(turn) + " rotation(s)");
    exercised += verdict.exercised;
    if (verdict.outcome == Outcome::kViolated) return verdict;
  }
  return Verdict::Held(exercised);
}

}  // namespace rasterproof::props
