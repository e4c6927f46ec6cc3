// The order of the triangles changes no count.
#include <algorithm>
#include <cstddef>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Verdict Judge(Subject& subject, const Case& c) {
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

}  // namespace

constinit const Property kTriangleOrderKeepsCoverage{
    .name = "TriangleOrderKeepsCoverage",
    .group = "coverage",
    .clause = "Coverage of a triangle depends on no other triangle.",
    .precondition = "contract sample-exact; coordinates within the limit; two triangles or more",
    .tolerance = kExact,
    .domains = kMeshes,
    .check = Judge,
};

}  // namespace rasterproof::props
