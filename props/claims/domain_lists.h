// Which domains put a claim to the test.
#ifndef RASTERPROOF_PROPS_CLAIMS_DOMAIN_LISTS_H_
#define RASTERPROOF_PROPS_CLAIMS_DOMAIN_LISTS_H_

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
    {"near-edge", "edges-through-centres", "hardest-pixel", "hardest-vertex", "f64-killer",
     "centres", "caps", "needles", "sliver-1e30", "axis-aligned", "tiny-ends", "sub-pixel"});

// Every order of magnitude, and the near-edge ones that make errors largest.
inline constexpr auto kMagnitudes = std::to_array<std::string_view>(
    {"near-edge", "hardest-vertex", "uniform-subpixel", "offset-cancellation", "mixed-magnitude",
     "subnormal", "overflow-products", "both-ends", "guard-band", "needles", "signed-zeros",
     "snap-ties"});

// Coordinates on a coarse lattice, so that moved and scaled ones are exact.
inline constexpr auto kOnTheLattice =
    std::to_array<std::string_view>({"uniform-subpixel", "centres", "axis-aligned",
                                     "edges-through-centres", "near-edge", "windings", "fans"});

// Long targets.
inline constexpr auto kLongWalks =
    std::to_array<std::string_view>({"long-walk", "size-ladder", "near-edge"});

// Ordinary, thin and far triangles.
inline constexpr auto kWeights = std::to_array<std::string_view>(
    {"uniform-subpixel", "centres", "edges-through-centres", "axis-aligned", "near-edge", "caps",
     "needles", "offset-cancellation", "mixed-magnitude", "windings", "grids"});

// Everything in window space that a single draw can get wrong.
inline constexpr auto kCoverage =
    std::to_array<std::string_view>({"near-edge",         "edges-through-centres",
                                     "hardest-pixel",     "hardest-vertex",
                                     "f64-killer",        "centres",
                                     "axis-aligned",      "caps",
                                     "needles",           "uniform-subpixel",
                                     "snap-ties",         "guard-band",
                                     "mixed-magnitude",   "offset-cancellation",
                                     "subnormal",         "sliver-1e30",
                                     "overflow-products", "both-ends",
                                     "signed-zeros",      "windings",
                                     "degenerate",        "long-walk",
                                     "size-ladder",       "t-junctions",
                                     "range-ends",        "tiny-ends",
                                     "sub-pixel",         "far-negative-corners",
                                     "least-areas",       "rows-and-columns"});

// The same, what only the model can tell, and enough samples to find what goes wrong once in a
// million.
inline constexpr auto kModelCoverage =
    Both(kCoverage, std::to_array<std::string_view>(
                        {"deciding-ties", "full-targets", "wrapped-coordinates", "extent-ends",
                         "target-ends", "no-clip-ends", "near-repeats", "sparse-indices"}));

// The hard places of window space, and clip space.
inline constexpr auto kCoverageAnySpace = std::to_array<std::string_view>(
    {"near-edge", "edges-through-centres", "hardest-vertex", "centres", "axis-aligned", "caps",
     "needles", "windings", "grids", "mixed-magnitude", "overflow-products", "perspective",
     "w-mixed"});

// Planar subdivisions.
inline constexpr auto kMeshes =
    std::to_array<std::string_view>({"shared-edge", "fans", "strips", "grids", "triangulations",
                                     "subdivisions", "covering-fans", "no-clip-ends", "folds"});

// The same, and meshes in clip space.
inline constexpr auto kMeshesAnySpace =
    Both(kMeshes, std::to_array<std::string_view>({"perspective-meshes", "meshes-around-eye"}));

// Planar or not, open or closed, conforming or not.
inline constexpr auto kAnyMesh = std::to_array<std::string_view>(
    {"shared-edge", "fans", "grids", "triangulations", "subdivisions", "t-junctions", "closed-mesh",
     "strips", "windings", "degenerate", "near-edge", "covering-fans", "wrapped-coordinates",
     "no-clip-ends", "near-repeats", "sparse-indices", "perspective-meshes", "meshes-around-eye",
     "closed-around-eye"});

// Closed surfaces.
inline constexpr auto kClosed = std::to_array<std::string_view>({"closed-mesh", "closed-folds"});

// Closed surfaces around the eye or beside it.
inline constexpr auto kClosedClip =
    std::to_array<std::string_view>({"closed-around-eye", "meshes-around-eye"});

// Clip space, and window-space places lifted to it for a subject that takes nothing else.
inline constexpr auto kClipSpace = std::to_array<std::string_view>(
    {"perspective", "w-mixed", "closed-around-eye", "near-edge", "edges-through-centres",
     "hardest-vertex", "centres", "axis-aligned", "needles", "grids", "mixed-magnitude"});

// Meshes that leave the target or pass behind the eye.
inline constexpr auto kClipped = std::to_array<std::string_view>(
    {"fans", "grids", "triangulations", "shared-edge", "strips", "closed-around-eye",
     "covering-fans", "no-clip-ends", "folds", "perspective-meshes", "meshes-around-eye"});

// Vertices that a tolerance lets snap either way, meshes first.
inline constexpr auto kFreeSnaps = std::to_array<std::string_view>(
    {"shared-snap-ties", "snap-ties", "shared-edge", "fans", "folds"});

// Triangles of zero area.
inline constexpr auto kDegenerate = std::to_array<std::string_view>({"degenerate", "signed-zeros"});

// NaN and infinity.
inline constexpr auto kNonFinite = std::to_array<std::string_view>({"non-finite"});

// Whatever input there is.
inline constexpr auto kExtremes = std::to_array<std::string_view>(
    {"non-finite", "overflow-products", "both-ends", "guard-band", "subnormal", "sliver-1e30",
     "degenerate", "mixed-magnitude", "size-ladder", "near-edge", "w-mixed", "wrapped-coordinates",
     "target-ends"});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CLAIMS_DOMAIN_LISTS_H_
