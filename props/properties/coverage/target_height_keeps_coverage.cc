// A higher target keeps the counts of the rows it shares with the lower one.
#include <algorithm>
#include <cstddef>
#include <string>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace target_height_keeps_coverage {

// The rows from y = 0 on; the top row is stored first.
CoverageCounts RowsFromZero(const CoverageCounts& high, int height, YAxis y_axis) {
  CoverageCounts part(high.width, height, high.samples);
  const int first = y_axis == YAxis::kDown ? 0 : high.height - height;
  const auto begin = static_cast<std::ptrdiff_t>(high.Index(0, first, 0));
  std::copy_n(high.front.begin() + begin, part.front.size(), part.front.begin());
  std::copy_n(high.back.begin() + begin, part.back.size(), part.back.begin());
  return part;
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  Checks asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, WholeTarget(c))));
  for (const int height : {c.scene.height + 1, 2 * c.scene.height + 7}) {
    if (!HasTheModelOf(c, c.scene.width, height)) continue;
    Scene higher = c.scene;
    higher.height = height;
    asked.checks.push_back(CheckAgainstBase(
        WholeCallOf(higher, c.profile, WholeTarget(c)),
        [&c, height](const CoverageCounts& observed, const CoverageCounts& base) {
          Verdict verdict = SameCounts(
              RowsFromZero(observed, c.scene.height, c.profile.y_axis), base, DecisionsOf(c),
              "the lower target's when " + std::to_string(height) + " pixels high");
          // Row 0 of the higher target lies above those that both have.
          const bool is_below = c.profile.y_axis == YAxis::kUp;
          if (verdict.witness && is_below) verdict.witness->y += height - c.scene.height;
          return verdict;
        }));
  }
  return asked;
}

}  // namespace target_height_keeps_coverage

extern constinit const Property kTargetHeightKeepsCoverage{
    .name = "TargetHeightKeepsCoverage",
    .group = "coverage",
    .clause = "A sample is covered alike whatever rows lie beyond it.",
    .tolerance = kExact,
    .domains = kCoverage,
    .gate = {.space = Space::kEither},
    .ask = target_height_keeps_coverage::Ask,
};

}  // namespace rasterproof::props
