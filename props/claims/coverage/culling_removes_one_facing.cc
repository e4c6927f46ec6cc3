// Culling a facing removes its counts and keeps the others.
#include <algorithm>

#include "core/coverage.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

Asked Ask(const Case& c, const Description& /*subject*/) {
  DrawOptions options = WholeTarget(c);
  Asked asked;
  asked.checks.push_back(BaseDraw(CountsOf(c.scene, c.profile, options)));
  for (const Cull cull : {Cull::kFront, Cull::kBack}) {
    options.cull = cull;
    asked.checks.push_back(CheckAgainstBase(
        CountsOf(c.scene, c.profile, options),
        [&c, cull](const CoverageCounts& observed, const CoverageCounts& whole) {
          const bool is_front = cull == Cull::kFront;
          CoverageCounts expected = whole;
          std::ranges::fill(is_front ? expected.front : expected.back, 0U);
          return SameCounts(observed, expected, DecisionsOf(c),
                            is_front ? "the back counts alone" : "the front counts alone");
        }));
  }
  return asked;
}

}  // namespace

constinit const Property kCullingRemovesOneFacing{
    .name = "CullingRemovesOneFacing",
    .group = "coverage",
    .clause =
        "Culling discards triangles of one facing (Vulkan 1.3, Basic Polygon Rasterization) "
        "and changes no other.",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .gate = {.space = Space::kEither, .shows = Shows::kCulling},
    .ask = Ask,
};

}  // namespace rasterproof::props
