// The pixels of a scene that a profile's square rule says must be covered, or may be.
#ifndef RASTERPROOF_EXACT_SQUARE_COVERAGE_H_
#define RASTERPROOF_EXACT_SQUARE_COVERAGE_H_

#include <cstddef>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "exact/placed_scene.h"

namespace rasterproof::exact {

/// Returns how many triangles must at least cover each sample, and how many may at most. A region
/// covers every sample of its pixels.
///
/// If the profile lets vertices move by up to t on each axis, the bounds hold for every choice: the
/// region of placed vertices becomes the region of the given ones with the pixel's square shrunk
/// (must) or grown (may) by t. A triangle that some choice makes flat must cover only what flat
/// triangles must.
/// Facings:    as placed; flat triangles count as back-facing.
/// Domain:     window space; profile.squares states the region; IsDecidable.
///             Triangles with a non-finite x, y or w cover nothing.
/// Cost:       of point coverage of the same triangles, 1.5 to 2.8 times for 8 pixels, 1.12 to 1.26
///             for 64, 1.06 to 1.08 for 1024, over all presets (bench/square_ratio.cc, 2026-11-23).
/// Source:     the bounds: docs/decisions/profiles.md.
CoverageCounts MustCover(const PlacedScene& scene, const DrawOptions& options = {});
CoverageCounts MayCover(const PlacedScene& scene, const DrawOptions& options = {});

/// How far, in pixels on each axis, a legal place of a vertex may be from the given one, rounded up
/// to a multiple of kSquareStep; 0 if the profile names one place. If the rounding or the grid is
/// not stated, it is at most a step of the coarsest legal grid.
double PlacingReach(const Snap& snap, const Freedom& freedom);

/// Returns whether triangle t has no area where the profile places it, or may have none.
bool MayBeFlat(const PlacedScene& scene, std::size_t t);

/// Returns the least coverage of a subject of the profile: MustCover, or MayCover if no region must
/// be covered.
///
/// Domain:     profile.squares.
CoverageCounts SquareCoverage(const PlacedScene& scene, const DrawOptions& options = {});

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_SQUARE_COVERAGE_H_
