// Whatever the input, a draw writes nothing outside the scissor and keeps the counts' shape.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "core/coverage.h"
#include "core/scene.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace draw_stays_inside_its_target {

// Any value will do that a subject would not write by itself and that leaves room to count up.
constexpr std::uint32_t kGuard = 0x5a5a0000;
constexpr int kGuardColumns = 8;
constexpr int kGuardRows = 3;

bool Holds(const PixelRect& rect, int x, int row) {
  return x >= rect.x0 && x < rect.x1 && row >= rect.y0 && row < rect.y1;
}

bool KeptItsShape(const CoverageCounts& counts, const CoverageCounts& before) {
  return counts.width == before.width && counts.height == before.height &&
         counts.samples == before.samples && counts.front.size() == before.front.size() &&
         counts.back.size() == before.back.size();
}

// A look at what surrounds the rectangle that was drawn into.
Verdict LookAround(const CoverageCounts& counts, const CoverageCounts& before,
                   const PixelRect& rect) {
  if (!KeptItsShape(counts, before)) {
    return Verdict::Violated(1, "the draw changed the shape of its target",
                             {.observed = {std::ssize(counts.front), " samples"},
                              .expected = {std::ssize(before.front)}});
  }
  std::uint64_t guarded = 0;
  for (int row = 0; row < counts.height; ++row) {
    for (int x = 0; x < counts.width; ++x) {
      for (int s = 0; s < counts.samples; ++s) {
        const std::size_t k = counts.Index(x, row, s);
        const bool inside = Holds(rect, x, row);
        if (!inside) ++guarded;
        const bool untouched = counts.front[k] == kGuard && counts.back[k] == kGuard;
        const bool only_added = counts.front[k] >= kGuard && counts.back[k] >= kGuard;
        if (inside ? only_added : untouched) continue;
        Witness witness = WitnessOfCounts(counts, before, k);
        return Verdict::Violated(std::max<std::uint64_t>(guarded, 1),
                                 inside ? "counts were overwritten, not added to"
                                        : "a sample outside the scissor was written",
                                 witness);
      }
    }
  }
  // With nothing around the rectangle the draw itself was the test: it came back.
  return Verdict::Held(std::max<std::uint64_t>(guarded, 1));
}

// A draw into a rectangle of a guarded target.
Check GuardedDraw(const PlacedCase& c, const Scene& scene, const PixelRect& rect) {
  DrawOptions options = WholeTarget(c);
  const PixelRect whole{0, 0, scene.width, scene.height};
  if (rect != whole) options.scissor = rect;
  Check check;
  check.questions.draws.push_back(WholeCallOf(scene, c.profile, options));
  check.questions.draws.back().fill = kGuard;
  check.judge = [&c, whole, rect](const Answers& answers) {
    CoverageCounts before(whole.x1, whole.y1, c.profile.pattern.samples());
    std::ranges::fill(before.front, kGuard);
    std::ranges::fill(before.back, kGuard);
    return OfDraw(0, LookAround(answers.draws[0]->counts, before, rect));
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  const int w = c.scene.width;
  const int h = c.scene.height;
  Checks asked;
  asked.checks.push_back(GuardedDraw(c, c.scene, {0, 0, w, h}));
  if (!subject.info.takes_scissor) return asked;
  // The case's own target as part of a larger one: what runs over its right end or wraps to the
  // previous row, and what runs over its bottom, lands in guarded samples of the same buffer.
  Scene framed = c.scene;
  const LargestTarget& most = c.profile.max_target;
  framed.width = std::max(w, std::min(w + kGuardColumns, most.width));
  framed.height = std::max(h, std::min(h + kGuardRows, most.height));
  asked.checks.push_back(GuardedDraw(c, framed, {0, 0, w, h}));
  asked.checks.push_back(GuardedDraw(c, c.scene, {w / 4, h / 4, w - w / 4, h - h / 4}));
  return asked;
}

}  // namespace draw_stays_inside_its_target

extern constinit const Property kDrawStaysInsideItsTarget{
    .name = "DrawStaysInsideItsTarget",
    .group = "extremes",
    .clause =
        "Writes outside the scissor and the target never happen, and a draw comes back, "
        "whatever the input.",
    .required_by = kInsideTheTargetClauses,
    .tolerance = kExact,
    .domains = kExtremes,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kNone,
             .judges_degenerates = true,
             .bound_by = BoundBy::kNothing},
    .ask = draw_stays_inside_its_target::Ask,
};

}  // namespace rasterproof::props
