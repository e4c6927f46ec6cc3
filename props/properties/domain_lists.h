// Which domains put a property to the test.
#ifndef RASTERPROOF_PROPS_PROPERTIES_DOMAIN_LISTS_H_
#define RASTERPROOF_PROPS_PROPERTIES_DOMAIN_LISTS_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace rasterproof::props {

// The first list, then the second.
template <std::size_t m, std::size_t n>
constexpr std::array<std::string_view, m + n> Both(const std::array<std::string_view, m>& first,
                                                   const std::array<std::string_view, n>& second) {
  std::array<std::string_view, m + n> both;
  std::ranges::copy(second, std::ranges::copy(first, both.begin()).out);
  return both;
}

// Names of domains, by what they are good for. A name that no domain has would be found by the
// tests, which look every one of them up.

// Samples on an edge or a few lattice steps from it.
inline constexpr auto kNearEdges = std::to_array<std::string_view>(
    {"near-edge", "edges-through-samples", "hardest-sample", "hardest-vertex", "ulp-extremes",
     "vertices-on-samples", "caps", "needles", "far-slivers", "axis-aligned", "rounded-differences",
     "sub-pixel-triangles"});

// Every order of magnitude, and the near-edge ones that make errors largest.
inline constexpr auto kMagnitudes = std::to_array<std::string_view>(
    {"near-edge", "hardest-vertex", "uniform-subpixel", "offset-cancellation", "mixed-magnitude",
     "subnormal", "product-overflow", "largest-and-smallest", "coordinate-limits", "needles",
     "signed-zeros", "snap-ties"});

// Coordinates on a coarse lattice, so that moved and scaled ones are exact.
inline constexpr auto kOnTheLattice = std::to_array<std::string_view>(
    {"uniform-subpixel", "vertices-on-samples", "axis-aligned", "edges-through-samples",
     "near-edge", "vertex-orders", "fans"});

// The same, and what is off the subpixel grid before it is moved and after.
inline constexpr auto kMoved =
    Both(kOnTheLattice, std::to_array<std::string_view>({"off-grid-moves"}));

// Long targets.
inline constexpr auto kLongRows =
    std::to_array<std::string_view>({"long-rows", "target-sizes", "near-edge"});

// Ordinary, thin and far triangles.
inline constexpr auto kBarycentrics = std::to_array<std::string_view>(
    {"uniform-subpixel", "vertices-on-samples", "edges-through-samples", "axis-aligned",
     "near-edge", "caps", "needles", "offset-cancellation", "mixed-magnitude", "vertex-orders",
     "grids"});

// The same, corners between grid points, small areas and more vertices.
inline constexpr auto kFragments =
    Both(kBarycentrics, std::to_array<std::string_view>(
                            {"off-grid-fragments", "sub-pixel-triangles", "fans", "every-size"}));

// Barycentrics, and fragments of few samples.
inline constexpr auto kCentroids =
    Both(kBarycentrics,
         std::to_array<std::string_view>({"sub-pixel-triangles", "rows-and-columns", "fans"}));

// Clip space as values see it: in front of the eye, beside it, and around it.
inline constexpr auto kClipValues = std::to_array<std::string_view>(
    {"perspective", "perspective-meshes", "cameras", "mixed-w", "one-vertex-behind",
     "meshes-around-eye", "w-ratios", "clip-slivers"});

// What interpolation can get wrong, in window and clip space.
inline constexpr auto kValueDomains = Both(kFragments, kClipValues);

// Samples at vertices, and on edges.
inline constexpr auto kVertexValueDomains = std::to_array<std::string_view>(
    {"vertices-on-samples", "fans", "grids", "axis-aligned", "perspective-meshes", "perspective"});
inline constexpr auto kEdgeValueDomains = std::to_array<std::string_view>(
    {"edges-through-samples", "axis-aligned", "vertices-on-samples", "shared-edge", "grids",
     "rows-and-columns", "perspective-meshes"});

// Everything in window space that a single draw can get wrong.
inline constexpr auto kCoverage = std::to_array<std::string_view>({"near-edge",
                                                                   "edges-through-samples",
                                                                   "hardest-sample",
                                                                   "hardest-vertex",
                                                                   "ulp-extremes",
                                                                   "vertices-on-samples",
                                                                   "axis-aligned",
                                                                   "caps",
                                                                   "needles",
                                                                   "uniform-subpixel",
                                                                   "snap-ties",
                                                                   "coordinate-limits",
                                                                   "mixed-magnitude",
                                                                   "offset-cancellation",
                                                                   "subnormal",
                                                                   "far-slivers",
                                                                   "product-overflow",
                                                                   "largest-and-smallest",
                                                                   "signed-zeros",
                                                                   "vertex-orders",
                                                                   "degenerate",
                                                                   "long-rows",
                                                                   "target-sizes",
                                                                   "t-junctions",
                                                                   "range-ends",
                                                                   "rounded-differences",
                                                                   "sub-pixel-triangles",
                                                                   "far-negative-corners",
                                                                   "least-areas",
                                                                   "rows-and-columns",
                                                                   "far-sides"});

// The same, and edges on the borders of tiles.
inline constexpr auto kAcrossTiles =
    Both(kCoverage, std::to_array<std::string_view>({"tile-borders"}));

// What a single draw can get wrong, what only the model can tell, and enough samples to find what
// goes wrong once in a million.
inline constexpr auto kModelCoverage = Both(
    kCoverage, std::to_array<std::string_view>({"deciding-snap-ties",   "full-coverage",
                                                "wrapped-coordinates",  "primitive-extent-ends",
                                                "target-size-ends",     "guard-band-ends",
                                                "near-repeats",         "sparse-indices",
                                                "many-triangles",       "crowds",
                                                "accumulator-ends",     "underflowing-products",
                                                "near-rectangles",      "non-finite-depths",
                                                "every-size",           "tilted-grids",
                                                "diagonal-needles",     "tile-borders",
                                                "rounded-arrangements", "equal-after-snap",
                                                "earcut-meshes",        "scaled-viewports",
                                                "tessellation-cracks",  "soups",
                                                "coplanar-depths",      "every-lane",
                                                "far-tile-corners",     "pattern-lines",
                                                "turned-by-snap",       "far-corners",
                                                "aliased-indices"}));

// Where a single draw can show the wrong side.
inline constexpr auto kFacings =
    Both(kCoverage, std::to_array<std::string_view>({"turned-by-snap"}));

// The hard places of window space, and clip space.
inline constexpr auto kCoverageAnySpace = std::to_array<std::string_view>(
    {"near-edge", "edges-through-samples", "hardest-vertex", "vertices-on-samples", "axis-aligned",
     "caps", "needles", "vertex-orders", "grids", "mixed-magnitude", "product-overflow",
     "perspective", "mixed-w"});

// The same, what only the snap gives its side, and triangles small enough to be left out.
inline constexpr auto kFacingsAnySpace = Both(
    kCoverageAnySpace, std::to_array<std::string_view>({"turned-by-snap", "sub-pixel-triangles"}));

// Planar subdivisions.
inline constexpr auto kMeshes = std::to_array<std::string_view>(
    {"shared-edge", "fans", "strips", "grids", "triangulations", "subdivisions", "covering-fans",
     "guard-band-ends", "folds", "near-rectangles", "every-size", "scaled-viewports",
     "frame-sweeps", "pattern-lines"});

// Calls of several triangles, and of many kinds of them.
inline constexpr auto kCalls =
    Both(kMeshes, std::to_array<std::string_view>({"crowds", "every-lane", "aliased-indices"}));

// The same, meshes in clip space, and on targets that reach beyond the stated range.
inline constexpr auto kMeshesAnySpace =
    Both(kMeshes, std::to_array<std::string_view>({"perspective-meshes", "meshes-around-eye",
                                                   "far-sides", "tilted-grids", "earcut-meshes",
                                                   "cameras", "far-corners", "near-beside-far"}));

// Meshes of a few triangles and of many, in window and clip space.
inline constexpr auto kLists = std::to_array<std::string_view>(
    {"shared-edge", "fans", "grids", "every-size", "perspective-meshes", "cameras"});

// Planar or not, open or closed, conforming or not.
inline constexpr auto kAnyMesh = std::to_array<std::string_view>({"shared-edge",
                                                                  "fans",
                                                                  "grids",
                                                                  "triangulations",
                                                                  "subdivisions",
                                                                  "t-junctions",
                                                                  "closed-mesh",
                                                                  "strips",
                                                                  "vertex-orders",
                                                                  "degenerate",
                                                                  "near-edge",
                                                                  "covering-fans",
                                                                  "wrapped-coordinates",
                                                                  "guard-band-ends",
                                                                  "near-repeats",
                                                                  "sparse-indices",
                                                                  "perspective-meshes",
                                                                  "meshes-around-eye",
                                                                  "closed-around-eye",
                                                                  "many-triangles",
                                                                  "crowds",
                                                                  "far-sides",
                                                                  "every-size",
                                                                  "rounded-arrangements",
                                                                  "equal-after-snap",
                                                                  "earcut-meshes",
                                                                  "cameras",
                                                                  "tessellation-cracks",
                                                                  "soups",
                                                                  "coplanar-depths"});

// The same, and what the snap turns over.
inline constexpr auto kAnyMeshAndTurned =
    Both(kAnyMesh, std::to_array<std::string_view>({"turned-by-snap"}));

// Closed surfaces.
inline constexpr auto kClosed =
    std::to_array<std::string_view>({"closed-mesh", "closed-folds", "rounded-arrangements"});

// Closed surfaces around the eye or beside it.
inline constexpr auto kClosedClip =
    std::to_array<std::string_view>({"closed-around-eye", "meshes-around-eye"});

// Clip space, and window-space places lifted to it for a subject that takes nothing else.
inline constexpr auto kClipSpace = std::to_array<std::string_view>(
    {"perspective", "mixed-w", "one-vertex-behind", "hardest-rays", "closed-around-eye",
     "near-edge", "edges-through-samples", "hardest-vertex", "vertices-on-samples", "axis-aligned",
     "needles", "grids", "mixed-magnitude", "cameras", "least-w", "eye-planes"});

// Meshes that leave the target or pass behind the eye.
inline constexpr auto kClipped = std::to_array<std::string_view>(
    {"fans", "grids", "triangulations", "shared-edge", "strips", "closed-around-eye",
     "covering-fans", "every-size", "guard-band-ends", "folds", "perspective-meshes",
     "meshes-around-eye", "cameras"});

// Vertices that a tolerance lets snap either way, meshes first, and triangles that it flattens.
inline constexpr auto kFreeSnaps = std::to_array<std::string_view>(
    {"shared-snap-ties", "snap-ties", "shared-edge", "fans", "folds", "far-corners",
     "near-beside-far", "aliased-indices", "degenerate", "least-areas"});

// Triangles of zero area.
inline constexpr auto kDegenerate = std::to_array<std::string_view>({"degenerate", "signed-zeros"});

// NaN and infinity.
inline constexpr auto kNonFinite = std::to_array<std::string_view>({"non-finite"});

// Whatever input there is.
inline constexpr auto kExtremes = std::to_array<std::string_view>(
    {"non-finite", "product-overflow", "largest-and-smallest", "coordinate-limits", "subnormal",
     "far-slivers", "degenerate", "mixed-magnitude", "target-sizes", "near-edge", "mixed-w",
     "wrapped-coordinates", "target-size-ends"});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTIES_DOMAIN_LISTS_H_
