// Every property, in the order of the documentation.
#ifndef RASTERPROOF_PROPS_PROPERTIES_ALL_H_
#define RASTERPROOF_PROPS_PROPERTIES_ALL_H_

#include "props/property.h"

namespace rasterproof::props {

// A property is one file of the folder of its group, which defines it.
extern const Property kEdgeSignIsRightOutsideItsBand;
extern const Property kEdgeErrorStaysWithinItsBound;
extern const Property kReversedEdgeChangesSign;
extern const Property kCyclicRotationKeepsTheArea;
extern const Property kEdgeIsZeroAtItsEnds;
extern const Property kIntegerTranslationKeepsEdgeValues;
extern const Property kPowerOfTwoScalingScalesEdgeValues;
extern const Property kMirrorNegatesEdgeValues;
extern const Property kLiftedTrianglesCoverLikeProjectedOnes;
extern const Property kScalingClipVerticesKeepsCoverage;
extern const Property kSteppingStaysWithinItsBound;
extern const Property kSteppingEqualsDirectWhereExact;
extern const Property kLongSteppingStaysWithinItsBound;
extern const Property kTileSizeKeepsCoverage;
extern const Property kTargetWidthKeepsCoverage;
extern const Property kThreadCountKeepsCoverage;
extern const Property kBarycentricsStayWithinTheirBound;
extern const Property kBarycentricsSumToOne;
extern const Property kBarycentricIsOneAtItsVertexAndZeroOpposite;
extern const Property kBarycentricSignsAgreeWithTheEdges;
extern const Property kBarycentricsReproduceThePoint;
extern const Property kBarycentricsFollowTheirVertices;
extern const Property kInterpolatedValuesStayInTheHull;
extern const Property kInterpolationStaysWithinItsBound;
extern const Property kDepthByDeltasEqualsDepthByBarycentrics;
extern const Property kPerspectiveInterpolationStaysWithinItsBound;
extern const Property kCoverageEqualsTheModel;
extern const Property kClipSpaceCoverageEqualsTheModel;
extern const Property kEmbeddedMeshSamplesAreCoveredOnce;
extern const Property kSharedEdgeSamplesAreCoveredOnce;
extern const Property kSignedCoverageEqualsTheWindingNumber;
extern const Property kClosedMeshCancels;
extern const Property kClosedSurfaceAroundTheEyeIsSeenEquallyOften;
extern const Property kOneLegalModelExplainsTheMesh;
extern const Property kCoverageKeepsToItsSideOfTheModel;
extern const Property kSquaresThatMustBeAreCovered;
extern const Property kSquaresOutsideTheMayRegionStayFree;
extern const Property kMetSquaresIncludeCoveredCentres;
extern const Property kHeldSquaresHaveCoveredCentres;
extern const Property kSubdivisionLeavesNoSquareUntouched;
extern const Property kVertexRotationKeepsCoverage;
extern const Property kReversalSwapsFacing;
extern const Property kFacingIsOneAtAllSamples;
extern const Property kTriangleOrderKeepsCoverage;
extern const Property kDuplicatedVerticesKeepCoverage;
extern const Property kDegenerateTrianglesCoverNothing;
extern const Property kScissorOnlyCutsCoverage;
extern const Property kTilesDrawnApartEqualTheWhole;
extern const Property kNeighboursAreClippedAlike;
extern const Property kCullingRemovesOneFacing;
extern const Property kIntegerTranslationMovesCoverage;
extern const Property kBarycentricDistanceIsTheSmallestCoordinate;
extern const Property kDerivativeDistanceMeasuresInTheL1Norm;
extern const Property kHeightDistanceIsTheDistanceInPixels;
extern const Property kDrawStaysInsideItsTarget;
extern const Property kNonFiniteTrianglesCoverNothing;
extern const Property kBadTrianglesPoisonNoOthers;
extern const Property kEqualDrawsGiveEqualCounts;
extern const Property kFragmentBarycentricsSumToOne;
extern const Property kFragmentBarycentricsStayWithinTheirError;
extern const Property kFragmentDepthStaysInTheHull;
extern const Property kFragmentDepthFollowsItsBarycentrics;
extern const Property kCentroidsLieWhereStated;
extern const Property kOneCallDrawsLikeItsTriangles;
extern const Property kOpenTiesAreCoveredOnce;
extern const Property kPrimitiveIdFollowsTheStatedOrder;
extern const Property kBatchDrawsLikeSingleCalls;
extern const Property kTargetHeightKeepsCoverage;
extern const Property kNewVerticesGiveNewCoverage;
extern const Property kEarlierScenesLeaveNoTrace;

inline constexpr const Property* kAllProperties[] = {
    &kEdgeSignIsRightOutsideItsBand,
    &kEdgeErrorStaysWithinItsBound,
    &kReversedEdgeChangesSign,
    &kCyclicRotationKeepsTheArea,
    &kEdgeIsZeroAtItsEnds,
    &kIntegerTranslationKeepsEdgeValues,
    &kPowerOfTwoScalingScalesEdgeValues,
    &kMirrorNegatesEdgeValues,
    &kLiftedTrianglesCoverLikeProjectedOnes,
    &kScalingClipVerticesKeepsCoverage,
    &kSteppingStaysWithinItsBound,
    &kSteppingEqualsDirectWhereExact,
    &kLongSteppingStaysWithinItsBound,
    &kTileSizeKeepsCoverage,
    &kTargetWidthKeepsCoverage,
    &kThreadCountKeepsCoverage,
    &kBarycentricsStayWithinTheirBound,
    &kBarycentricsSumToOne,
    &kBarycentricIsOneAtItsVertexAndZeroOpposite,
    &kBarycentricSignsAgreeWithTheEdges,
    &kBarycentricsReproduceThePoint,
    &kBarycentricsFollowTheirVertices,
    &kInterpolatedValuesStayInTheHull,
    &kInterpolationStaysWithinItsBound,
    &kDepthByDeltasEqualsDepthByBarycentrics,
    &kPerspectiveInterpolationStaysWithinItsBound,
    &kCoverageEqualsTheModel,
    &kClipSpaceCoverageEqualsTheModel,
    &kEmbeddedMeshSamplesAreCoveredOnce,
    &kSharedEdgeSamplesAreCoveredOnce,
    &kSignedCoverageEqualsTheWindingNumber,
    &kClosedMeshCancels,
    &kClosedSurfaceAroundTheEyeIsSeenEquallyOften,
    &kOneLegalModelExplainsTheMesh,
    &kCoverageKeepsToItsSideOfTheModel,
    &kSquaresThatMustBeAreCovered,
    &kSquaresOutsideTheMayRegionStayFree,
    &kMetSquaresIncludeCoveredCentres,
    &kHeldSquaresHaveCoveredCentres,
    &kSubdivisionLeavesNoSquareUntouched,
    &kVertexRotationKeepsCoverage,
    &kReversalSwapsFacing,
    &kFacingIsOneAtAllSamples,
    &kTriangleOrderKeepsCoverage,
    &kDuplicatedVerticesKeepCoverage,
    &kDegenerateTrianglesCoverNothing,
    &kScissorOnlyCutsCoverage,
    &kTilesDrawnApartEqualTheWhole,
    &kNeighboursAreClippedAlike,
    &kCullingRemovesOneFacing,
    &kIntegerTranslationMovesCoverage,
    &kBarycentricDistanceIsTheSmallestCoordinate,
    &kDerivativeDistanceMeasuresInTheL1Norm,
    &kHeightDistanceIsTheDistanceInPixels,
    &kDrawStaysInsideItsTarget,
    &kNonFiniteTrianglesCoverNothing,
    &kBadTrianglesPoisonNoOthers,
    &kEqualDrawsGiveEqualCounts,
    &kFragmentBarycentricsSumToOne,
    &kFragmentBarycentricsStayWithinTheirError,
    &kFragmentDepthStaysInTheHull,
    &kFragmentDepthFollowsItsBarycentrics,
    &kCentroidsLieWhereStated,
    &kOneCallDrawsLikeItsTriangles,
    &kPrimitiveIdFollowsTheStatedOrder,
    &kBatchDrawsLikeSingleCalls,
    &kTargetHeightKeepsCoverage,
    &kOpenTiesAreCoveredOnce,
    &kNewVerticesGiveNewCoverage,
    &kEarlierScenesLeaveNoTrace,
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTIES_ALL_H_
