#include "io/renamed.h"

#include <array>
#include <utility>

namespace rasterproof::io {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;

// Old, new. Reasons: docs/decisions/layers-and-build.md, "One word for one thing".
constexpr auto kRenamed = std::to_array<Pair>({
    // Keys of profiles and their values.
    {"any_tie_rule", "tie_ownership (stated, axis-aligned, per-edge, open)"},
    {"conservative-over", "at-least-model"},
    {"conservative-under", "at-most-model"},
    {"crossing", "scanline_rounding"},
    {"fill_rule", "tie_rule"},
    {"max_extent", "max_primitive_extent"},
    {"no_clip", "guard_band"},
    {"overdraw", "edge_samples (owned, may-be-shared)"},
    {"targets", "by_target_size"},
    {"zero_area", "degenerate_triangles"},
    // Descriptions of subjects and the protocol.
    {"ids", "primitive-ids"},
    {"walk", "steps"},
    {"walk-error", "stepping-error"},
    {"walks", "steps"},
    {"weight-error", "barycentric-error"},
    {"weights-of", "barycentrics-of"},
    {"winning-id", "primitive-id"},
    {"wins", "visible"},
    // Domains.
    {"both-ends", "largest-and-smallest"},
    {"centres", "vertices-on-samples"},
    {"deciding-ties", "deciding-snap-ties"},
    {"edges-through-centres", "edges-through-samples"},
    {"extent-ends", "primitive-extent-ends"},
    {"f64-killer", "ulp-extremes"},
    {"full-targets", "full-coverage"},
    {"guard-band", "coordinate-limits"},
    {"hardest-pixel", "hardest-sample"},
    {"long-walk", "long-rows"},
    {"no-clip-ends", "guard-band-ends"},
    {"overflow-products", "product-overflow"},
    {"size-ladder", "target-sizes"},
    {"sliver-1e30", "far-slivers"},
    {"sub-pixel", "sub-pixel-triangles"},
    {"target-ends", "target-size-ends"},
    {"tiny-ends", "rounded-differences"},
    {"w-mixed", "mixed-w"},
    {"windings", "vertex-orders"},
    // Properties.
    {"ConservativeCoverageKeepsToItsSide", "CoverageKeepsToItsSideOfTheModel"},
    {"DepthByDeltasEqualsDepthByWeights", "DepthByDeltasEqualsDepthByBarycentrics"},
    {"FragmentDepthFollowsItsWeights", "FragmentDepthFollowsItsBarycentrics"},
    {"FragmentWeightsStayWithinTheirError", "FragmentBarycentricsStayWithinTheirError"},
    {"FragmentWeightsSumToOne", "FragmentBarycentricsSumToOne"},
    {"LongWalkStaysWithinItsBound", "LongSteppingStaysWithinItsBound"},
    {"WalkEqualsDirectWhereExact", "SteppingEqualsDirectWhereExact"},
    {"WalkStaysWithinItsBound", "SteppingStaysWithinItsBound"},
    {"WeightDistanceIsTheSmallestWeight", "BarycentricDistanceIsTheSmallestCoordinate"},
    {"WeightIsOneAtItsVertexAndZeroOpposite", "BarycentricIsOneAtItsVertexAndZeroOpposite"},
    {"WeightSignsAgreeWithTheEdges", "BarycentricSignsAgreeWithTheEdges"},
    {"WeightsFollowTheirVertices", "BarycentricsFollowTheirVertices"},
    {"WeightsReproduceThePoint", "BarycentricsReproduceThePoint"},
    {"WeightsStayWithinTheirBound", "BarycentricsStayWithinTheirBound"},
    {"WeightsSumToOne", "BarycentricsSumToOne"},
    {"WinnerFollowsTheDeclaredOrder", "PrimitiveIdFollowsTheStatedOrder"},
});

}  // namespace

std::string RenamedText(std::string_view word) {
  for (const auto& [before, now] : kRenamed) {
    if (before == word) return ", which is " + std::string(now) + " now";
  }
  return "";
}

}  // namespace rasterproof::io
