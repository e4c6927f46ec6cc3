// Whatever the input, samples outside the scissor keep their values, and the counts keep their shape.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/target_size.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

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

// Draws into a rectangle of a guarded target and looks at what surrounds it.
Verdict DrawGuarded(Subject& subject, const Scene& scene, const Profile& profile,
                    DrawOptions options, const PixelRect& rect) {
  const bool is_whole = rect == PixelRect{0, 0, scene.width, scene.height};
  if (!is_whole) options.scissor = rect;
  RequireTargetSize("scene", scene.width, scene.height, profile.lattice.samples());
  CoverageCounts counts(scene.width, scene.height, profile.lattice.samples());
  std::ranges::fill(counts.front, kGuard);
  std::ranges::fill(counts.back, kGuard);
  const CoverageCounts before = counts;
  subject.Draw(scene, options, counts);
  if (!KeptItsShape(counts, before)) {
    return Verdict::Violated(1, "the draw changed the shape of its target",
                             {.observed = std::to_string(counts.front.size()) + " samples",
                              .expected = std::to_string(before.front.size())});
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

Verdict Judge(Subject& subject, const Case& c) {
  if (auto refusal = CannotDraw(subject, c, Space::kEither)) return *refusal;
  const int w = c.scene.width;
  const int h = c.scene.height;
  // The case's own target as part of a larger one: what runs over its right end or wraps to the
  // previous row, and what runs over its bottom, lands in guarded samples of the same buffer.
  Scene framed = c.scene;
  framed.width = std::min(w + kGuardColumns, kMaxTargetSide);
  framed.height = std::min(h + kGuardRows, kMaxTargetSide);
  std::vector<std::pair<const Scene*, PixelRect>> draws{{&c.scene, {0, 0, w, h}}};
  if (subject.Info().takes_scissor) {
    draws.push_back({&framed, {0, 0, w, h}});
    draws.push_back({&c.scene, {w / 4, h / 4, w - w / 4, h - h / 4}});
  }
  std::uint64_t exercised = 0;
  for (const auto& [scene, rect] : draws) {
    Verdict verdict = DrawGuarded(subject, *scene, c.profile, WholeTarget(c), rect);
    exercised += verdict.exercised;
    if (verdict.outcome == Outcome::kViolated) {
      verdict.exercised = exercised;
      return verdict;
    }
  }
  return Verdict::Held(exercised);
}

}  // namespace

constinit const Property kDrawStaysInsideItsTarget{
    .name = "DrawStaysInsideItsTarget",
    .group = "extremes",
    .clause =
        "Writes outside the scissor and the target never happen, and a draw comes back, "
        "whatever the input.",
    .precondition = "the subject takes the scene",
    .tolerance = kExact,
    .domains = kExtremes,
    .check = Judge,
};

}  // namespace rasterproof::props
