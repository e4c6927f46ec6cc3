#include "props/catalog/planar_mesh.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "core/scene.h"
#include "exact/winding.h"
#include "props/catalog/free_choices.h"
#include "props/catalog/outline.h"
#include "props/catalog/precondition.h"
#include "props/catalog/redraw.h"
#include "props/catalog/witness.h"

namespace rasterproof::props {
namespace {

Verdict NotExercised(const char* why) { return {Outcome::kNotExercised, 0, 0, why, std::nullopt}; }

}  // namespace

std::optional<Verdict> OwnsNoEdges(const Profile& profile) {
  if (profile.fill_rule.IsConsistent()) return std::nullopt;
  return Verdict::NotApplicable(profile.fill_rule.inclusive
                                    ? "an inclusive fill rule covers shared edges twice"
                                    : "an exclusive fill rule covers shared edges never");
}

Verdict JudgePlanarMesh(Subject& subject, const Case& c, const MeshView& view) {
  const bool watertight_only = !HasOneModel(c.profile) || !IsUnclipped(c.scene, c.profile);
  const OpenTriangles open = watertight_only ? OpenTriangles(c) : OpenTriangles();
  if (watertight_only ? open.RestIsFolded() : exact::ShapeOf(c.scene, c.profile).folded) {
    return NotExercised("the snapped mesh is folded");
  }
  const std::vector<std::int64_t> winding = exact::BoundaryWinding(c.scene, c.profile);
  if (std::ranges::any_of(winding, [](std::int64_t w) { return std::abs(w) > 1; })) {
    return NotExercised("the mesh overlaps itself");
  }
  const Outline outline = watertight_only       ? Outline::OfMoved(c, open.MostMoved())
                          : view.spares_outline ? Outline(c)
                                                : Outline();
  const auto is_judged = [&](const SamplePlace& place) {
    return (!view.looks_at || view.looks_at(place)) && !outline.IsNear(place.at);
  };
  const CoverageCounts counts = Drawn(subject, c.scene, c.profile, WholeTarget(c));
  std::uint64_t exercised = 0;
  std::uint64_t not_judged = 0;
  for (int row = 0; row < counts.height; ++row) {
    for (int x = 0; x < counts.width; ++x) {
      for (int s = 0; s < counts.samples; ++s) {
        const std::size_t k = counts.Index(x, row, s);
        const auto expected = static_cast<std::uint32_t>(std::abs(winding[k]));
        const bool is_right = counts.Count(k) == expected ||
                              (c.profile.overdraw && expected == 1 && counts.Count(k) > 1);
        if (is_right && expected == 0) continue;  // outside and left alone: not worth counting
        const SamplePlace place = PlaceOf(c, x, row, s);
        if (!is_judged(place)) continue;
        if (open.CanCover(place.at)) {
          ++not_judged;
          continue;
        }
        ++exercised;
        if (is_right) continue;
        Witness witness =
            WitnessAt(-1, -1, place, "covered " + std::to_string(counts.Count(k)) + " times",
                      expected == 0        ? "outside: never"
                      : c.profile.overdraw ? "at least once"
                                           : "exactly once");
        return Verdict::Violated(
            exercised,
            counts.Count(k) < expected ? "a gap in the mesh" : "a sample covered too often",
            witness);
      }
    }
  }
  Verdict verdict = Verdict::Held(exercised);
  verdict.not_judged = not_judged;
  return verdict;
}

}  // namespace rasterproof::props
