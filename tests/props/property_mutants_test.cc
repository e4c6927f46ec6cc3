// Every property finds a bug by itself: a mutant for each, by its own verdict.
//
// `rasterproof selftest` asks the other way round: whether any property finds the mutant.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string_view>

#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/mutants/mutants.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

struct Row {
  std::string_view property;
  std::string_view mutant;
};

// A property with several branches has a mutant for each.
constexpr Row kRows[] = {
    {"CyclicRotationKeepsTheArea", "mutant:edge-from-one-end"},
    {"EdgeErrorStaysWithinItsBound", "mutant:edge-half-float"},
    {"EdgeErrorStaysWithinItsBound", "mutant:edge-bound-too-small"},
    {"EdgeIsZeroAtItsEnds", "mutant:edge-from-one-end"},
    {"EdgeSignIsRightOutsideItsBand", "mutant:edge-absolute"},
    {"IntegerTranslationKeepsEdgeValues", "mutant:edge-from-one-end"},
    {"MirrorNegatesEdgeValues", "mutant:edge-biased"},
    {"PowerOfTwoScalingScalesEdgeValues", "mutant:edge-from-one-end"},
    {"ReversedEdgeChangesSign", "mutant:edge-biased"},
    {"LongSteppingStaysWithinItsBound", "mutant:stepping-loses-after-8192"},
    {"SteppingEqualsDirectWhereExact", "mutant:stepping-of-16"},
    {"SteppingStaysWithinItsBound", "mutant:stepping-wrong-way"},
    {"SteppingStaysWithinItsBound", "mutant:stepping-back-wrong"},
    {"SteppingStaysWithinItsBound", "mutant:stepping-last-lost"},
    {"BarycentricIsOneAtItsVertexAndZeroOpposite", "mutant:barycentrics-rotated"},
    {"BarycentricSignsAgreeWithTheEdges", "mutant:barycentrics-unsigned"},
    {"BarycentricsFollowTheirVertices", "mutant:barycentrics-exchanged-back"},
    {"BarycentricsReproduceThePoint", "mutant:barycentrics-rotated"},
    {"BarycentricsStayWithinTheirBound", "mutant:barycentrics-reciprocal"},
    {"BarycentricsSumToOne", "mutant:barycentrics-one-minus"},
    {"CentroidsLieWhereStated", "mutant:centroid-centre-always"},
    {"CentroidsLieWhereStated", "mutant:centroid-beside-the-only-sample"},
    {"DepthByDeltasEqualsDepthByBarycentrics", "mutant:depth-of-wrong-vertex"},
    {"FragmentBarycentricsStayWithinTheirError", "mutant:fragments-of-given"},
    {"FragmentBarycentricsSumToOne", "mutant:vulkan-fragments-sum-off"},
    {"FragmentDepthFollowsItsBarycentrics", "mutant:fragments-depth-alone-flat"},
    {"FragmentDepthStaysInTheHull", "mutant:vulkan-depth-off"},
    {"InterpolatedValuesStayInTheHull", "mutant:hull-left"},
    {"InterpolationStaysWithinItsBound", "mutant:depth-16-bits"},
    {"PerspectiveInterpolationStaysWithinItsBound", "mutant:perspective-affine"},
    {"ClipSpaceCoverageEqualsTheModel", "mutant:clip-drops-behind"},
    {"ClosedMeshCancels", "mutant:ties-inclusive"},
    {"ClosedSurfaceAroundTheEyeIsSeenEquallyOften", "mutant:clip-drops-behind"},
    {"CoverageEqualsTheModel", "mutant:ties-inclusive"},
    {"CoverageEqualsTheModel", "mutant:sample-1-right"},
    {"CoverageEqualsTheModel", "mutant:samples-exchanged"},
    {"CoverageKeepsToItsSideOfTheModel", "mutant:at-least-model-ties-lost"},
    {"CoverageKeepsToItsSideOfTheModel", "mutant:at-most-model-ties-twice"},
    {"CullingRemovesOneFacing", "mutant:cull-exchanged"},
    {"CullingRemovesOneFacing", "mutant:culls-of-input"},
    {"CullingRemovesOneFacing", "mutant:d3d11-culls-of-input"},
    {"CoverageEqualsTheModel", "mutant:facing-of-input"},
    {"CoverageEqualsTheModel", "mutant:flat-of-input"},
    {"DegenerateTrianglesCoverNothing", "mutant:degenerate-line"},
    {"DuplicatedVerticesKeepCoverage", "mutant:leak-cached-vertex"},
    {"EmbeddedMeshSamplesAreCoveredOnce", "mutant:ties-inclusive"},
    {"FacingIsOneAtAllSamples", "mutant:facing-by-sample"},
    {"FacingIsOneAtAllSamples", "mutant:facing-by-sample-where-open"},
    {"FacingIsOneAtAllSamples", "mutant:facing-of-input"},
    {"FacingIsOneAtAllSamples", "mutant:d3d11-facing-of-input"},
    {"IntegerTranslationMovesCoverage", "mutant:drop-left-of-target"},
    {"IntegerTranslationMovesCoverage", "mutant:samples-vary-where-fixed"},
    {"LiftedTrianglesCoverLikeProjectedOnes", "mutant:clip-w-ignored"},
    {"LargeTargetIsCoveredLikeASmallOne", "mutant:target-index-in-float"},
    {"LargeTargetIsCoveredLikeASmallOne", "mutant:target-bins-of-8-bits"},
    {"LongListDrawsLikeItsEnd", "mutant:list-ids-of-16-bits"},
    {"LongListDrawsLikeItsEnd", "mutant:list-ids-in-a-float"},
    {"LongListDrawsLikeItsEnd", "mutant:list-ids-in-a-colour"},
    {"LongListDrawsLikeItsEnd", "mutant:list-ids-by-batches"},
    {"LongListDrawsLikeItsEnd", "mutant:list-count-of-16-bits"},
    {"LongListDrawsLikeItsEnd", "mutant:list-offsets-of-19-bits"},
    {"NeighboursAreClippedAlike", "mutant:drop-left-of-target"},
    {"NeighboursAreClippedAlike", "mutant:clip-drops-by-first"},
    {"OneCallDrawsLikeItsTriangles", "mutant:many-lost"},
    {"OneCallDrawsLikeItsTriangles", "mutant:ids-from-the-end"},
    {"OneGridExplainsEveryCall", "mutant:vulkan-grid-by-list"},
    {"OneLegalModelExplainsTheMesh", "mutant:free-two-places"},
    {"OneLegalModelExplainsTheMesh", "mutant:free-rules-mixed"},
    {"OneLegalModelExplainsTheMesh", "mutant:samples-one-reused"},
    {"OneLegalModelExplainsTheMesh", "mutant:samples-centre-for-all"},
    {"OneLegalModelExplainsTheMesh", "mutant:samples-exchanged-under-vulkan"},
    {"OneLegalModelExplainsTheMesh", "mutant:samples-vary"},
    {"OneLegalModelExplainsTheMesh", "mutant:vulkan-vertices-by-16-bits"},
    {"OneLegalModelExplainsTheMesh", "mutant:gl-vertices-by-8-bits-and-x"},
    {"SharedEdgeSamplesAreCoveredOnce", "mutant:vulkan-far-box-of-32-bits"},
    {"SharedEdgeSamplesAreCoveredOnce", "mutant:gl-far-values-of-64-bits"},
    {"ClipSpaceCoverageEqualsTheModel", "mutant:clip-reciprocal-overflows"},
    {"OpenTiesAreCoveredOnce", "mutant:vulkan-two-owners"},
    {"PrimitiveIdFollowsTheStatedOrder", "mutant:ids-of-a-byte"},
    {"ReversalSwapsFacing", "mutant:facing-back-lost"},
    {"ScalingClipVerticesKeepsCoverage", "mutant:clip-w-clamped"},
    {"ScissorOnlyCutsCoverage", "mutant:scissor-right-inclusive"},
    {"SamplesLieInTheirPixel", "mutant:samples-outside-where-open"},
    {"SamplesLieInTheirPixel", "mutant:samples-one-outside-where-open"},
    {"SamplesLieInTheirPixel", "mutant:small-triangles-lost-where-open"},
    {"SamplesLieInTheirPixel", "mutant:samples-vary-where-fixed"},
    {"SharedEdgeSamplesAreCoveredOnce", "mutant:ties-inclusive"},
    {"SharedEdgeSamplesAreCoveredOnce", "mutant:samples-by-triangle"},
    {"SignedCoverageEqualsTheWindingNumber", "mutant:ties-inclusive"},
    {"SignedCoverageEqualsTheWindingNumber", "mutant:facing-of-input"},
    {"EnvironmentKeepsCoverage", "mutant:mode-magic-snap"},
    {"EnvironmentKeepsCoverage", "mutant:mode-needs-subnormals"},
    {"TargetHeightKeepsCoverage", "mutant:target-last-row"},
    {"TargetWidthKeepsCoverage", "mutant:target-odd-width"},
    {"ThreadCountKeepsCoverage", "mutant:threads-last-row"},
    {"TileSizeKeepsCoverage", "mutant:tile-size-matters"},
    {"TilesDrawnApartEqualTheWhole", "mutant:map-tile-origin"},
    {"TriangleOrderKeepsCoverage", "mutant:box-limited-by-last"},
    {"VertexRotationKeepsCoverage", "mutant:ties-first-edge"},
    {"HeldSquaresHaveCoveredCentres", "mutant:squares-inner-by-three-corners"},
    {"MetSquaresIncludeCoveredCentres", "mutant:squares-by-corners"},
    {"SquaresOutsideTheMayRegionStayFree", "mutant:squares-epsilon-outside"},
    {"SquaresThatMustBeAreCovered", "mutant:squares-epsilon-inside"},
    {"SubdivisionLeavesNoSquareUntouched", "mutant:squares-by-corners"},
    {"BarycentricDistanceIsTheSmallestCoordinate", "mutant:distance-of-barycentric-exchanged"},
    {"DerivativeDistanceMeasuresInTheL1Norm", "mutant:distance-in-l2"},
    {"HeightDistanceIsTheDistanceInPixels", "mutant:distance-of-next-edge"},
    {"BadTrianglesPoisonNoOthers", "mutant:nan-poisons"},
    {"BatchDrawsLikeSingleCalls", "mutant:batch-last-lost"},
    {"BatchDrawsLikeSingleCalls", "mutant:batch-leaks"},
    {"DrawStaysInsideItsTarget", "mutant:scissor-right-inclusive"},
    {"DrawStaysInsideItsTarget", "mutant:target-overwritten"},
    {"EarlierScenesLeaveNoTrace", "mutant:vulkan-kept-by-sixteenths"},
    {"EqualDrawsGiveEqualCounts", "mutant:target-every-third-draw"},
    {"NewVerticesGiveNewCoverage", "mutant:vulkan-kept-by-pixels"},
    {"NewVerticesGiveNewCoverage", "mutant:vulkan-kept-by-first"},
    {"NewVerticesGiveNewCoverage", "mutant:gl-kept-by-first"},
    {"EarlierScenesLeaveNoTrace", "mutant:vulkan-kept-by-first"},
    {"PredecessorsKeepCoverage", "mutant:vulkan-trace-of-non-finite"},
    {"PredecessorsKeepCoverage", "mutant:gl-trace-of-refusal"},
    {"PredecessorsKeepCoverage", "mutant:vulkan-trace-of-flat"},
    {"PredecessorsKeepCoverage", "mutant:d3d11-trace-of-far"},
    {"PredecessorsKeepCoverage", "mutant:gl-trace-of-many"},
    {"NonFiniteTrianglesCoverNothing", "mutant:nan-as-zero"},
};

TEST(PropertyMutants, ThereIsOneForEveryProperty) {
  std::set<std::string_view> properties;
  for (const Row& row : kRows) properties.insert(row.property);
  for (const Property& property : Catalog()) {
    EXPECT_TRUE(properties.contains(property.name))
        << property.name << " has no row in kRows: name a mutant that it finds";
  }
}

TEST(PropertyMutants, EachIsFoundByItsPropertyAloneWithAWitness) {
  constexpr std::uint64_t kSeed = 1;
  constexpr std::uint64_t kCases = 400;
  std::size_t row = 0;
  for (const auto& [name, mutant] : kRows) {
    if (row++ % (kOneCaseIn > 1 ? 4 : 1) != 0) continue;
    const Property* property = FindProperty(name);
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(mutant);
    ASSERT_TRUE(property != nullptr && subject != nullptr) << name << ", " << mutant;
    Verdict verdict;
    for (std::uint64_t i = 0; i < kCases && verdict.outcome != Outcome::kViolated; ++i) {
      verdict = RunCase(*subject, *property, DrawCase(subject->Info(), *property, kSeed, i));
    }
    EXPECT_EQ(verdict.outcome, Outcome::kViolated) << name << " lets " << mutant << " through";
    if (verdict.outcome != Outcome::kViolated) continue;
    EXPECT_FALSE(verdict.message.empty()) << name;
    EXPECT_GT(verdict.exercised, 0U) << name;
    ASSERT_TRUE(verdict.witness.has_value()) << name;
    EXPECT_FALSE(verdict.witness->observed.empty()) << name;
    EXPECT_FALSE(verdict.witness->expected.empty()) << name;
  }
}

}  // namespace
}  // namespace rasterproof::props
