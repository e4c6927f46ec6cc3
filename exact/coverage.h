// Exact coverage: the count of every sample of a scene.
#ifndef RASTERPROOF_EXACT_COVERAGE_H_
#define RASTERPROOF_EXACT_COVERAGE_H_

#include <array>
#include <optional>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/error.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/placed_scene.h"

namespace rasterproof::exact {

/// Returns the counts of the profile's canonical model for the scene, under the options' culling
/// and scissor.
///
/// The model is the profile's for targets of the scene's size: coordinates wrap into its
/// fixed-point range and snap, and triangles beyond its largest extent are dropped. PrimitiveIds()
/// says which triangle stays on a sample that several cover.
/// Domain:     any scene; window space if the profile has fixed-point input or a largest extent.
///             Triangles with a non-finite x, y or w, or with zero area after snapping,
///             cover nothing. Clip space with a snapped profile: every w of a triangle must be
///             positive (snapping follows the division, and the profile does not define clipping),
///             and |x / w| and |y / w| below 2^(50 - bits). Rounded crossings and squares: window
///             space, and kFast, which alone decides them.
/// Squares:    the least coverage, as by SquareCoverage().
/// Error:      none; throws WhyNotDecided() outside the domain.
/// Cost:       kFast: spans, a guess in double per edge and row of samples, and exact signs by
///             bisection where the guess cannot tell. The other deciders: one sign per edge and
///             sample of the triangle's box, for cross-checking.
CoverageCounts Coverage(const PlacedScene& scene, const DrawOptions& options = {},
                        Decider decider = Decider::kFast);
inline CoverageCounts Coverage(const Scene& scene, const Profile& profile,
                               const DrawOptions& options = {}, Decider decider = Decider::kFast) {
  return Coverage(PlacedScene(scene, profile), options, decider);
}

/// Returns why the oracle can't decide the scene's counts under the profile: the scene is outside
/// Coverage()'s domain, or a sample location has too many fractional bits. Nothing if it can: then
/// neither Coverage() by kFast nor BoundaryWinding() throws.
std::optional<InputError> WhyNotDecided(const PlacedScene& scene);

/// Returns whether the triangle (window space, already snapped, finite) covers the point p under
/// the rule; either winding.
bool Covers(const std::array<Point2, 3>& v, Point2 p, const TieRule& rule,
            Decider decider = Decider::kFast);

/// Sign of E(v0, v1; v2): +1 front (counter-clockwise on screen), -1 back, 0 covers nothing.
int Facing(const std::array<Point2, 3>& v, Decider decider = Decider::kFast);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_COVERAGE_H_
