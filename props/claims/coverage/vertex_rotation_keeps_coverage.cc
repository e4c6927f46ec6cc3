// Rotating a triangle's vertex list changes no count.
#include <string>

#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Asked Ask(const Case& c, const Description& /*subject*/) {
  Asked asked;
  Case rotated = c;
  for (int turn = 1; turn < 3; ++turn) {
    for (Triangle& t : rotated.scene.triangles) t = {t[1], t[2], t[0]};
    asked.checks.push_back(VariationCheck(
        c, rotated, "the unrotated triangles' after " + std::to_string(turn) + " rotation(s)"));
  }
  return asked;
}

}  // namespace

constinit const Property kVertexRotationKeepsCoverage{
    .name = "VertexRotationKeepsCoverage",
    .group = "coverage",
    .clause = "A triangle is the same from whichever vertex it is told.",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .gate = {.space = Space::kEither},
    .ask = Ask,
};

}  // namespace rasterproof::props
