// A scissor keeps the counts inside it and leaves none outside.
#include <array>

#include "core/coverage.h"
#include "core/scene.h"
#include "props/judging/open_by_call.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace scissor_only_cuts_coverage {

// The inner half, the left half and the bottom row: cuts on every side.
std::array<PixelRect, 3> Scissors(const Scene& scene) {
  const int w = scene.width;
  const int h = scene.height;
  return {PixelRect{w / 4, h / 4, w - w / 4, h - h / 4}, PixelRect{0, 0, w / 2, h},
          PixelRect{0, h - 1, w, h}};
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  const auto open = WhereCallsMayDiffer(c, MayChooseByCall(c.profile));
  if (!open) return NotExercised(kPlacesNotKnown);
  DrawOptions options = WholeTarget(c);
  Checks asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, options)));
  for (const PixelRect& rect : Scissors(c.scene)) {
    options.scissor = rect;
    asked.checks.push_back(CheckAgainstBase(
        WholeCallOf(c.scene, c.profile, options),
        [&c, rect, open](const CoverageCounts& observed, const CoverageCounts& whole) {
          return SameCounts(observed, CutTo(rect, open->Expected(observed, whole)),
                            open->Judged(DecisionsOf(c)), "the scissored part of the whole");
        }));
  }
  return asked;
}

}  // namespace scissor_only_cuts_coverage

extern constinit const Property kScissorOnlyCutsCoverage{
    .name = "ScissorOnlyCutsCoverage",
    .group = "coverage",
    .clause =
        "The scissor test discards samples outside its rectangle and changes nothing else "
        "(Vulkan 1.3, Scissor Test).",
    .required_by = kScissorClauses,
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .gate = {.space = Space::kEither,
             .shows = Shows::kScissor,
             .any_model = true,
             .judges_clipped = true},
    .ask = scissor_only_cuts_coverage::Ask,
};

}  // namespace rasterproof::props
