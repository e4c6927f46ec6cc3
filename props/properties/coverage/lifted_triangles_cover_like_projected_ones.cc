// A window-space triangle lifted to clip space covers what the window-space triangle covers.
//
// Each vertex becomes (x w, y w, w), with its own positive power of two w.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "props/judging/as_shown.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace lifted_triangles_cover_like_projected_ones {

constexpr std::array<double, 5> kDepths{1, 0.25, 8, 2, 0x1p-4};

double Rounded(double x, Precision precision) {
  return precision == Precision::kFloat32 ? static_cast<double>(static_cast<float>(x)) : x;
}

// A window-space scene near the one that the case projects to. Its rounded positions are the exact
// ones of the property, so what the division lost does not matter. A vertex at w = 0 becomes
// infinite or NaN, and the case is then not judged.
Scene ProjectedScene(const Scene& clip) {
  Scene window = clip;
  window.clip_space = false;
  for (Vertex& v : window.vertices) {
    v = {Rounded(v.x / v.w, clip.precision), Rounded(v.y / v.w, clip.precision), 0, 1};
  }
  return window;
}

// Nothing if a product is not exact.
std::optional<Scene> Lifted(const Scene& window) {
  Scene clip = window;
  clip.clip_space = true;
  for (std::size_t i = 0; i < clip.vertices.size(); ++i) {
    Vertex& v = clip.vertices[i];
    const double w = kDepths[i % kDepths.size()];
    const Vertex lifted{Rounded(v.x * w, clip.precision), Rounded(v.y * w, clip.precision), v.z, w};
    if (lifted.x / w != v.x || lifted.y / w != v.y) return std::nullopt;
    v = lifted;
  }
  return clip;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  PlacedCase projected = c.With(ProjectedScene(c.scene));
  const std::optional<Scene> lifted = Lifted(projected.scene);
  if (!WithinLimits(projected.scene, c.profile) || !lifted || !WithinLimits(*lifted, c.profile)) {
    return NotExercised("the projected scene is beyond the limits");
  }
  if (const auto why = exact::WhyNotDecided(projected)) {
    return NotDecided(why->what());
  }
  Questions questions;
  questions.draws.push_back(CountsOf(*lifted, c.profile, WholeTarget(c)));
  const bool as_shown = IsJudgedAsShown(subject.info, c.scene);
  return OneCheck(std::move(questions),
                  [projected = std::move(projected), as_shown](const Answers& answers) {
                    CoverageCounts expected = exact::Coverage(projected, WholeTarget(projected));
                    if (as_shown) expected = AsShown(std::move(expected));
                    return SameCounts(answers.draws[0]->counts, expected, DecisionsOf(projected),
                                      "that of the projected triangles");
                  });
}

}  // namespace lifted_triangles_cover_like_projected_ones

extern constinit const Property kLiftedTrianglesCoverLikeProjectedOnes{
    .name = "LiftedTrianglesCoverLikeProjectedOnes",
    .group = "coverage",
    .clause =
        "N_ij . (p, 1) with N_ij = V_j x V_i is w_i w_j E of the projected edge (Olano and "
        "Greer, Graphics Hardware 1997).",
    .tolerance = kExact,
    .domains = kClipSpace,
    .gate = {.space = Space::kClip, .where = "the lifted coordinates are exact"},
    .ask = lifted_triangles_cover_like_projected_ones::Ask,
};

}  // namespace rasterproof::props
