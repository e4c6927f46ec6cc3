// Every claim, in the order of the documentation.
#ifndef RASTERPROOF_PROPS_CLAIMS_ALL_H_
#define RASTERPROOF_PROPS_CLAIMS_ALL_H_

#include "props/property.h"

namespace rasterproof::props {

// A claim is one file of the folder of its group, which defines it.
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
extern const Property kWalkStaysWithinItsBound;
extern const Property kWalkEqualsDirectWhereExact;
extern const Property kLongWalkStaysWithinItsBound;
extern const Property kTileSizeKeepsCoverage;
extern const Property kTargetWidthKeepsCoverage;
extern const Property kThreadCountKeepsCoverage;
extern const Property kWeightsStayWithinTheirBound;
extern const Property kWeightsSumToOne;
extern const Property kWeightIsOneAtItsVertexAndZeroOpposite;
extern const Property kWeightSignsAgreeWithTheEdges;
extern const Property kWeightsReproduceThePoint;
extern const Property kWeightsFollowTheirVertices;
extern const Property kInterpolatedValuesStayInTheHull;
extern const Property kInterpolationStaysWithinItsBound;
extern const Property kDepthByDeltasEqualsDepthByWeights;
extern const Property kPerspectiveInterpolationStaysWithinItsBound;
extern const Property kCoverageEqualsTheModel;
extern const Property kClipSpaceCoverageEqualsTheModel;
extern const Property kEmbeddedMeshSamplesAreCoveredOnce;
extern const Property kSharedEdgeSamplesAreCoveredOnce;
extern const Property kSignedCoverageEqualsTheWindingNumber;
extern const Property kClosedMeshCancels;
extern const Property kClosedSurfaceAroundTheEyeIsSeenEquallyOften;
extern const Property kOneLegalModelExplainsTheMesh;
extern const Property kConservativeCoverageKeepsToItsSide;
extern const Property kVertexRotationKeepsCoverage;
extern const Property kReversalSwapsFacing;
extern const Property kTriangleOrderKeepsCoverage;
extern const Property kDuplicatedVerticesKeepCoverage;
extern const Property kDegenerateTrianglesCoverNothing;
extern const Property kScissorOnlyCutsCoverage;
extern const Property kNeighboursAreClippedAlike;
extern const Property kCullingRemovesOneFacing;
extern const Property kIntegerTranslationMovesCoverage;
extern const Property kWeightDistanceIsTheSmallestWeight;
extern const Property kDerivativeDistanceMeasuresInTheL1Norm;
extern const Property kHeightDistanceIsTheDistanceInPixels;
extern const Property kDrawStaysInsideItsTarget;
extern const Property kNonFiniteTrianglesCoverNothing;
extern const Property kBadTrianglesPoisonNoOthers;
extern const Property kEqualDrawsGiveEqualCounts;
extern const Property kFragmentWeightsSumToOne;
extern const Property kFragmentWeightsStayWithinTheirError;
extern const Property kFragmentDepthStaysInTheHull;
extern const Property kFragmentDepthFollowsItsWeights;
extern const Property kOneCallDrawsLikeItsTriangles;
extern const Property kWinnerFollowsTheDeclaredOrder;
extern const Property kBatchDrawsLikeSingleCalls;
extern const Property kTargetHeightKeepsCoverage;

inline constexpr const Property* kAllClaims[] = {
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
    &kWalkStaysWithinItsBound,
    &kWalkEqualsDirectWhereExact,
    &kLongWalkStaysWithinItsBound,
    &kTileSizeKeepsCoverage,
    &kTargetWidthKeepsCoverage,
    &kThreadCountKeepsCoverage,
    &kWeightsStayWithinTheirBound,
    &kWeightsSumToOne,
    &kWeightIsOneAtItsVertexAndZeroOpposite,
    &kWeightSignsAgreeWithTheEdges,
    &kWeightsReproduceThePoint,
    &kWeightsFollowTheirVertices,
    &kInterpolatedValuesStayInTheHull,
    &kInterpolationStaysWithinItsBound,
    &kDepthByDeltasEqualsDepthByWeights,
    &kPerspectiveInterpolationStaysWithinItsBound,
    &kCoverageEqualsTheModel,
    &kClipSpaceCoverageEqualsTheModel,
    &kEmbeddedMeshSamplesAreCoveredOnce,
    &kSharedEdgeSamplesAreCoveredOnce,
    &kSignedCoverageEqualsTheWindingNumber,
    &kClosedMeshCancels,
    &kClosedSurfaceAroundTheEyeIsSeenEquallyOften,
    &kOneLegalModelExplainsTheMesh,
    &kConservativeCoverageKeepsToItsSide,
    &kVertexRotationKeepsCoverage,
    &kReversalSwapsFacing,
    &kTriangleOrderKeepsCoverage,
    &kDuplicatedVerticesKeepCoverage,
    &kDegenerateTrianglesCoverNothing,
    &kScissorOnlyCutsCoverage,
    &kNeighboursAreClippedAlike,
    &kCullingRemovesOneFacing,
    &kIntegerTranslationMovesCoverage,
    &kWeightDistanceIsTheSmallestWeight,
    &kDerivativeDistanceMeasuresInTheL1Norm,
    &kHeightDistanceIsTheDistanceInPixels,
    &kDrawStaysInsideItsTarget,
    &kNonFiniteTrianglesCoverNothing,
    &kBadTrianglesPoisonNoOthers,
    &kEqualDrawsGiveEqualCounts,
    &kFragmentWeightsSumToOne,
    &kFragmentWeightsStayWithinTheirError,
    &kFragmentDepthStaysInTheHull,
    &kFragmentDepthFollowsItsWeights,
    &kOneCallDrawsLikeItsTriangles,
    &kWinnerFollowsTheDeclaredOrder,
    &kBatchDrawsLikeSingleCalls,
    &kTargetHeightKeepsCoverage,
};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_CLAIMS_ALL_H_
