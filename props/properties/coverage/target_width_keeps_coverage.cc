// A larger target keeps the counts of the samples it shares with the smaller one.
#include <string>

#include "core/coverage.h"
#include "core/scene.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace target_width_keeps_coverage {

CoverageCounts LeftPart(const CoverageCounts& wide, int width) {
  CoverageCounts part(width, wide.height, wide.samples);
  for (int row = 0; row < wide.height; ++row) {
    for (int x = 0; x < width; ++x) {
      for (int s = 0; s < wide.samples; ++s) {
        part.front[part.Index(x, row, s)] = wide.front[wide.Index(x, row, s)];
        part.back[part.Index(x, row, s)] = wide.back[wide.Index(x, row, s)];
      }
    }
  }
  return part;
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  Checks asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, WholeTarget(c))));
  for (const int width : {c.scene.width + 1, 2 * c.scene.width + 7}) {
    if (!HasTheModelOf(c, width, c.scene.height)) continue;
    Scene wider = c.scene;
    wider.width = width;
    asked.checks.push_back(CheckAgainstBase(
        WholeCallOf(wider, c.profile, WholeTarget(c)),
        [&c, width](const CoverageCounts& observed, const CoverageCounts& base) {
          return SameCounts(LeftPart(observed, c.scene.width), base, DecisionsOf(c),
                            "the narrower target's when " + std::to_string(width) + " pixels wide");
        }));
  }
  return asked;
}

}  // namespace target_width_keeps_coverage

extern constinit const Property kTargetWidthKeepsCoverage{
    .name = "TargetWidthKeepsCoverage",
    .group = "coverage",
    .clause = "Coverage depends on the sample and the triangle, not on the size of the target.",
    .tolerance = kExact,
    .domains = kCoverage,
    .gate = {.space = Space::kEither},
    .ask = target_width_keeps_coverage::Ask,
};

}  // namespace rasterproof::props
