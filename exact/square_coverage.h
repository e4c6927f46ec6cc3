// What a profile's square rule says of a scene: the squares that must be covered, and may be.
#ifndef RASTERPROOF_EXACT_SQUARE_COVERAGE_H_
#define RASTERPROOF_EXACT_SQUARE_COVERAGE_H_

#include <cstddef>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "exact/placed_scene.h"

namespace rasterproof::exact {

/// Returns how many triangles must at least cover each sample, and how many may at most: every
/// sample of a pixel that the triangle's must region, or may region, has.
///
/// Where the profile leaves open where vertices are placed, by up to t on each axis, these are
/// bounds that hold whatever is chosen: a region of placed vertices is that of the given ones with
/// the pixel's square shrunk (must) or grown (may) by t. A triangle that some choice makes flat
/// must cover nothing but what flat ones must.
/// Facings:    as placed; flat triangles are back ones.
/// Domain:     window space; profile.squares states the region; IsDecidable.
///             Triangles with a non-finite x, y or w cover nothing.
/// Cost:       of point coverage of the same triangles, 1.5 to 2.8 times for 8 pixels, 1.12 to 1.26
///             for 64, 1.06 to 1.08 for 1024, over all presets (bench/square_ratio.cc, 2026-11-23).
/// Source:     the bounds: docs/decisions/profiles.md.
CoverageCounts MustCover(const PlacedScene& scene, const DrawOptions& options = {});
CoverageCounts MayCover(const PlacedScene& scene, const DrawOptions& options = {});

/// How far, in pixels on each axis, a legal place of a vertex may be from the given one, rounded up
/// to a multiple of kSquareStep; 0 where the profile names one place. A rounding that is not stated
/// moves by a step of the coarsest legal grid at most, as does a stated one on a grid that is not.
double PlacingReach(const Snap& snap, const Freedom& freedom);

/// Returns whether triangle t has no area where the profile places it, or may have none.
bool MayBeFlat(const PlacedScene& scene, std::size_t t);

/// The least that a subject of the profile covers: MustCover, or MayCover where nothing must be.
///
/// Domain:     profile.squares.
CoverageCounts SquareCoverage(const PlacedScene& scene, const DrawOptions& options = {});

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_SQUARE_COVERAGE_H_
