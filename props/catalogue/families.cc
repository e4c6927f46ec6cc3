// The rows of the catalogue: every domain and every world, by what they are hard for.
#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "props/catalogue/catalogue.h"

namespace rasterproof::props {
namespace {

struct Group {
  Theme theme;
  std::span<const std::string_view> domains;
};

constexpr auto kOrdinary = std::to_array<std::string_view>(
    {"uniform-subpixel", "full-coverage", "every-size", "sub-pixel-triangles", "vertex-orders"});
constexpr auto kNearEdges = std::to_array<std::string_view>(
    {"vertices-on-samples", "axis-aligned", "edges-through-samples", "near-edge", "hardest-sample",
     "hardest-vertex", "ulp-extremes", "rounded-differences", "least-areas", "rows-and-columns",
     "long-rows", "pattern-lines"});
constexpr auto kThin =
    std::to_array<std::string_view>({"needles", "caps", "far-slivers", "diagonal-needles"});
constexpr auto kMagnitudes = std::to_array<std::string_view>(
    {"offset-cancellation", "subnormal", "product-overflow", "underflowing-products",
     "largest-and-smallest", "mixed-magnitude", "coordinate-limits", "range-ends", "far-sides",
     "far-corners", "near-beside-far", "far-negative-corners", "wrapped-coordinates",
     "primitive-extent-ends", "guard-band-ends", "accumulator-ends"});
constexpr auto kSnapping = std::to_array<std::string_view>(
    {"snap-ties", "deciding-snap-ties", "shared-snap-ties", "off-grid-moves", "off-grid-fragments",
     "folds", "closed-folds", "equal-after-snap", "scaled-viewports", "turned-by-snap"});
constexpr auto kNothing = std::to_array<std::string_view>(
    {"degenerate", "signed-zeros", "non-finite", "non-finite-depths"});
constexpr auto kMeshes = std::to_array<std::string_view>(
    {"shared-edge", "fans", "strips", "grids", "triangulations", "covering-fans", "subdivisions",
     "t-junctions", "closed-mesh", "near-rectangles", "tilted-grids", "rounded-arrangements",
     "earcut-meshes", "frame-sweeps", "tessellation-cracks", "soups", "fine-meshes"});
constexpr auto kCalls = std::to_array<std::string_view>(
    {"target-sizes", "target-size-ends", "near-repeats", "sparse-indices", "aliased-indices",
     "many-triangles", "crowds", "every-lane", "tile-borders", "far-tile-corners",
     "coplanar-depths"});
constexpr auto kPixelSides =
    std::to_array<std::string_view>({"square-grid-lines", "square-crossings", "square-interiors"});
constexpr auto kClip = std::to_array<std::string_view>(
    {"perspective", "mixed-w", "closed-around-eye", "one-vertex-behind", "hardest-rays",
     "perspective-meshes", "meshes-around-eye", "cameras", "least-w", "eye-planes"});

constexpr auto kGroups = std::to_array<Group>({
    {{"ordinary", "It covers the samples that exact geometry covers."}, kOrdinary},
    {{"near edges",
      "Every sample gets the sign that exact arithmetic gives it, zero included; the tie rule "
      "decides on the edge alone."},
     kNearEdges},
    {{"long and thin",
      "A sliver covers the samples that exact geometry covers, often none, and none next to its "
      "line."},
     kThin},
    {{"magnitudes",
      "Products that overflow, underflow or cancel decide nothing: the sign is that of the exact "
      "value, up to the stated limit."},
     kMagnitudes},
    {{"snapping",
      "Every vertex goes to the grid point that the profile names, ties included, and neighbours "
      "agree on it."},
     kSnapping},
    {{"no area, not finite",
      "A triangle without area or with a vertex that is not finite covers nothing; its neighbours "
      "are drawn as without it."},
     kNothing},
    {{"meshes",
      "Every sample inside is covered exactly once, at hubs too; what is closed cancels. Where "
      "triangles are inverted, front minus back does so."},
     kMeshes},
    {{"calls and targets",
      "What a triangle covers depends neither on its neighbours in the call nor on the target's "
      "size or tiles."},
     kCalls},
    {{"pixel sides", "Corners and edges on the sides of pixels decide no sample but their own."},
     kPixelSides},
    {{"clip space",
      "The part in front of the eye is covered, and no vertex with w <= 0 is projected."},
     kClip},
});
constexpr Theme kWorlds{"small worlds",
                        "Every case of the world is covered as exact geometry says."};

}  // namespace

std::vector<Family> Catalogue() {
  std::vector<Family> families;
  for (const Group& group : kGroups) {
    for (const std::string_view name : group.domains) {
      const Domain& domain = *FindDomain(name);
      families.push_back({name, domain.summary, &group.theme, &domain, nullptr});
    }
  }
  for (const World& world : Worlds()) {
    families.push_back({world.name, world.summary, &kWorlds, nullptr, &world});
  }
  return families;
}

}  // namespace rasterproof::props
