// Moving the scene by whole pixels moves the counts, where the moved vertices are exact.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/ulp.h"
#include "model/snap_scene.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace integer_translation_moves_coverage {

constexpr std::array<std::pair<int, int>, 3> kShifts{{{1, 0}, {-3, 2}, {5, -4}}};

// x + shift if that is exact and of the scene's precision.
std::optional<double> ExactSum(double x, double shift, Precision precision) {
  const double sum = x + shift;
  if (!std::isfinite(sum) || sum - x != shift || sum - shift != x) return std::nullopt;
  if (precision == Precision::kFloat32 && !IsFloat32(sum)) return std::nullopt;
  return sum;
}

std::optional<Scene> Moved(const PlacedCase& c, int dx, int dy) {
  Scene moved = c.scene;
  for (Vertex& v : moved.vertices) {
    const std::optional<double> x = ExactSum(v.x, dx, c.scene.precision);
    const std::optional<double> y = ExactSum(v.y, dy, c.scene.precision);
    if (!x || !y) return std::nullopt;
    v.x = *x;
    v.y = *y;
  }
  const bool is_judged = WithinLimits(moved, c.profile) && IsUnwrapped(moved, c.profile) &&
                         IsUnclipped(moved, c.profile);
  return is_judged ? std::optional(moved) : std::nullopt;
}

// What a target of the same size shows of `counts` when they are moved by (dx, dy) pixels: samples
// that come from outside are left at zero.
CoverageCounts MovedCounts(const CoverageCounts& counts, int dx, int dy) {
  CoverageCounts moved(counts.width, counts.height, counts.samples);
  for (int row = std::max(0, dy); row < counts.height + std::min(0, dy); ++row) {
    for (int x = std::max(0, dx); x < counts.width + std::min(0, dx); ++x) {
      for (int s = 0; s < counts.samples; ++s) {
        const std::size_t from = counts.Index(x - dx, row - dy, s);
        moved.front[counts.Index(x, row, s)] = counts.front[from];
        moved.back[counts.Index(x, row, s)] = counts.back[from];
      }
    }
  }
  return moved;
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  Checks asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, WholeTarget(c))));
  for (const auto& [dx, dy] : kShifts) {
    const std::optional<Scene> moved = Moved(c, dx, dy);
    if (!moved) continue;
    asked.checks.push_back(CheckAgainstBase(
        WholeCallOf(*moved, c.profile, WholeTarget(c)),
        [&c, x = dx, y = dy](const CoverageCounts& observed, const CoverageCounts& still) {
          const int rows = c.profile.y_axis == YAxis::kDown ? y : -y;
          // There and back: the samples that the target shows both before and after the move.
          return SameCounts(MovedCounts(MovedCounts(observed, -x, -rows), x, rows),
                            MovedCounts(still, x, rows), DecisionsOf(c),
                            "the unmoved scene's, moved by (" + std::to_string(x) + ", " +
                                std::to_string(y) + "),");
        }));
  }
  return asked;
}

constexpr std::array kRules{kCountsTies, kFixesSamplePositions};

// What leaves grid points or owners free may choose others a pixel further: then it is users who
// want it.
bool StatesTranslation(const Profile& profile) {
  return profile.translation_invariant || profile.freedom.IsNone();
}

}  // namespace integer_translation_moves_coverage

extern constinit const Property kIntegerTranslationMovesCoverage{
    .name = "IntegerTranslationMovesCoverage",
    .group = "coverage",
    .clause =
        "Moving a scene by whole pixels moves its image (OpenGL 4.6 section 14.2, "
        "Invariance; Vulkan does not state it by itself, a sample-exact model does).",
    .required_by = kTranslationClauses,
    .stated_by = integer_translation_moves_coverage::StatesTranslation,
    .tolerance = kExact,
    .domains = kMoved,
    .gate = {.any_model = true,
             .unwrapped = true,
             .rules = integer_translation_moves_coverage::kRules,
             .where =
                 "the moved coordinates are exact, of the input format and within the limit, and "
                 "nothing is clipped before or after"},
    .ask = integer_translation_moves_coverage::Ask,
};

}  // namespace rasterproof::props
