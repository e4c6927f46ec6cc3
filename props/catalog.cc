#include <array>
#include <span>
#include <string_view>
#include <vector>

#include "props/catalog/clip_coverage.h"
#include "props/catalog/clip_scaling.h"
#include "props/catalog/clipped_neighbours.h"
#include "props/catalog/closed_around_eye.h"
#include "props/catalog/closed_mesh.h"
#include "props/catalog/conservative.h"
#include "props/catalog/coverage_translation.h"
#include "props/catalog/culling.h"
#include "props/catalog/degenerate.h"
#include "props/catalog/domain_lists.h"
#include "props/catalog/duplicated_vertices.h"
#include "props/catalog/edge_antisymmetry.h"
#include "props/catalog/edge_ends.h"
#include "props/catalog/edge_error.h"
#include "props/catalog/edge_mirror.h"
#include "props/catalog/edge_rotation.h"
#include "props/catalog/edge_scaling.h"
#include "props/catalog/edge_sign.h"
#include "props/catalog/edge_translation.h"
#include "props/catalog/embedded_mesh.h"
#include "props/catalog/interpolation_deltas.h"
#include "props/catalog/interpolation_error.h"
#include "props/catalog/interpolation_hull.h"
#include "props/catalog/interpolation_perspective.h"
#include "props/catalog/joint_legality.h"
#include "props/catalog/lifted_triangles.h"
#include "props/catalog/model_coverage.h"
#include "props/catalog/non_finite.h"
#include "props/catalog/outputs.h"
#include "props/catalog/poison.h"
#include "props/catalog/row_words.h"
#include "props/catalog/scissor.h"
#include "props/catalog/shared_edge.h"
#include "props/catalog/target_guard.h"
#include "props/catalog/target_width.h"
#include "props/catalog/thread_count.h"
#include "props/catalog/tile_size.h"
#include "props/catalog/triangle_order.h"
#include "props/catalog/vertex_reversal.h"
#include "props/catalog/vertex_rotation.h"
#include "props/catalog/walk_error.h"
#include "props/catalog/walk_exact.h"
#include "props/catalog/walk_long.h"
#include "props/catalog/weight_corners.h"
#include "props/catalog/weight_error.h"
#include "props/catalog/weight_permutation.h"
#include "props/catalog/weight_point.h"
#include "props/catalog/weight_sign.h"
#include "props/catalog/weight_sum.h"
#include "props/catalog/winding_number.h"
#include "props/catalog/wireframe_derivative.h"
#include "props/catalog/wireframe_height.h"
#include "props/catalog/wireframe_weight.h"
#include "props/property.h"

namespace rasterproof::props {
namespace {

constexpr auto kProperties = std::to_array<Property>({
    {.name = "EdgeSignIsRightOutsideItsBand",
     .group = "edge",
     .clause = "The sign of the edge function says on which side of an edge a sample lies (Pineda, "
               "SIGGRAPH 1988, section 3).",
     .precondition = kEdgeValues,
     .tolerance = kOwnBound,
     .domains = kNearEdges,
     .check = EdgeSignIsRightOutsideItsBand},
    {.name = "EdgeErrorStaysWithinItsBound",
     .group = "edge",
     .clause = "An edge value is (p.x - a.x)(b.y - a.y) - (p.y - a.y)(b.x - a.x), up to a proven "
               "rounding error (Shewchuk 1997; Ozaki et al., BIT 2016).",
     .precondition = kEdgeValues,
     .tolerance = "the subject's proven ErrorBound",
     .domains = kMagnitudes,
     .check = EdgeErrorStaysWithinItsBound},
    {.name = "ReversedEdgeChangesSign",
     .group = "edge",
     .clause =
         "E(b, a; p) = -E(a, b; p): the determinant changes sign with the exchange of its ends.",
     .precondition = kEdgeValues,
     .tolerance = "the sum of both proven ErrorBounds; where both are 0, none: exact",
     .domains = kNearEdges,
     .check = ReversedEdgeChangesSign},
    {.name = "CyclicRotationKeepsTheArea",
     .group = "edge",
     .clause = "Twice the signed area is E(v0, v1; v2) from whichever vertex it is told.",
     .precondition = kEdgeValues,
     .tolerance = kBothBounds,
     .domains = kMagnitudes,
     .check = CyclicRotationKeepsTheArea},
    {.name = "EdgeIsZeroAtItsEnds",
     .group = "edge",
     .clause = "An edge line passes through its ends: E(a, b; a) = E(a, b; b) = 0.",
     .precondition = kEdgeValues,
     .tolerance = kOwnBound,
     .domains = kMagnitudes,
     .check = EdgeIsZeroAtItsEnds},
    {.name = "IntegerTranslationKeepsEdgeValues",
     .group = "edge",
     .clause = "E depends on differences of positions only.",
     .precondition = "the subject shows edge values and claims a finite bound there; window space "
                     "within the limits; the moved coordinates are exact, of the input format, on "
                     "the subpixel grid and within the limit",
     .tolerance = kBothBounds,
     .domains = kOnTheLattice,
     .check = IntegerTranslationKeepsEdgeValues},
    {.name = "PowerOfTwoScalingScalesEdgeValues",
     .group = "edge",
     .clause = "E is homogeneous of degree two in the positions.",
     .precondition = "the subject shows edge values and claims a finite bound there; window space "
                     "within the limits; the scaled coordinates are exact, of the input format, on "
                     "the subpixel grid and within the limit",
     .tolerance = "the sum of both proven ErrorBounds, scaled",
     .domains = kOnTheLattice,
     .check = PowerOfTwoScalingScalesEdgeValues},
    {.name = "MirrorNegatesEdgeValues",
     .group = "edge",
     .clause = "A mirror reverses orientation: E changes sign when an axis is turned over or the "
               "axes are exchanged.",
     .precondition = "the subject shows edge values and claims a finite bound there; window space "
                     "within the limits; the mirrored coordinates are of the input format, on the "
                     "subpixel grid and within the limit",
     .tolerance = kBothBounds,
     .domains = kOnTheLattice,
     .check = MirrorNegatesEdgeValues},
    {.name = "LiftedTrianglesCoverLikeProjectedOnes",
     .group = "edge",
     .clause = "N_ij . (p, 1) with N_ij = V_j x V_i is w_i w_j E of the projected edge (Olano and "
               "Greer, Graphics Hardware 1997).",
     .precondition = "contract sample-exact; coordinates within the limit; the subject takes clip "
                     "space; the lifted coordinates are exact",
     .tolerance = kExact,
     .domains = kClipSpace,
     .check = LiftedTrianglesCoverLikeProjectedOnes},
    {.name = "ScalingClipVerticesKeepsCoverage",
     .group = "edge",
     .clause = "A homogeneous edge needs no division: multiplying a clip-space vertex by a "
               "positive number changes no sign (McCool, Wales and Moule, Graphics Hardware 2001).",
     .precondition = "contract sample-exact; coordinates within the limit; the subject takes clip "
                     "space; the scaled coordinates are exact",
     .tolerance = kExact,
     .domains = kClipSpace,
     .check = ScalingClipVerticesKeepsCoverage},
    {.name = "WalkStaysWithinItsBound",
     .group = "incremental",
     .clause = "E(x + L, y) = E + L dY, E(x, y + L) = E - L dX and their opposites (Pineda, "
               "SIGGRAPH 1988, section 3.2): each step adds its rounding.",
     .precondition = kEdgeValues,
     .tolerance = kWalkBounds,
     .domains = kMagnitudes,
     .check = WalkStaysWithinItsBound},
    {.name = "WalkEqualsDirectWhereExact",
     .group = "incremental",
     .clause = "Incremental equals direct evaluation wherever the arithmetic is exact (Pineda, "
               "SIGGRAPH 1988, section 3.2).",
     .precondition = "the subject shows edge values and claims a finite bound there; window space "
                     "within the limits; both claimed bounds are 0",
     .tolerance = kExact,
     .domains = kOnTheLattice,
     .check = WalkEqualsDirectWhereExact},
    {.name = "LongWalkStaysWithinItsBound",
     .group = "incremental",
     .clause = "A walk over 16384 samples, the largest target of current APIs, drifts by a proven "
               "bound at most.",
     .precondition = kEdgeValues,
     .tolerance = kWalkBounds,
     .domains = kLongWalks,
     .check = LongWalkStaysWithinItsBound},
    {.name = "TileSizeKeepsCoverage",
     .group = "incremental",
     .clause = "How a rasterizer walks its target is not observable: D3D11.3 functional "
               "specification 3.4.2.1 (top-left rule) decides by the sample's position alone.",
     .precondition = kSampleExactOnly,
     .tolerance = kExact,
     .domains = kCoverage,
     .check = TileSizeKeepsCoverage},
    {.name = "TargetWidthKeepsCoverage",
     .group = "incremental",
     .clause = "Coverage depends on the sample and the triangle, not on the size of the target.",
     .precondition = kSampleExactOnly,
     .tolerance = kExact,
     .domains = kCoverage,
     .check = TargetWidthKeepsCoverage},
    {.name = "ThreadCountKeepsCoverage",
     .group = "incremental",
     .clause = "Sharing the work among threads is not observable.",
     .precondition = "contract sample-exact; coordinates within the limit; the subject takes a "
                     "number of threads",
     .tolerance = kExact,
     .domains = kCoverage,
     .check = ThreadCountKeepsCoverage},
    {.name = "WeightsStayWithinTheirBound",
     .group = "barycentric",
     .clause = "lambda_i is the signed area of the part opposite vertex i over that of the whole "
               "(OpenGL 4.6 section 14.6.1, the weights a, b, c).",
     .precondition = "the subject shows weights and claims a finite bound there; window space "
                     "within the limits, area not zero; unsigned areas: closed triangle only",
     .tolerance = kWeightBounds,
     .domains = kWeights,
     .check = WeightsStayWithinTheirBound},
    {.name = "WeightsSumToOne",
     .group = "barycentric",
     .clause =
         "a + b + c = 1 (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
     .precondition = kWeightValues,
     .tolerance = "the subject's proven SumErrorBound",
     .domains = kWeights,
     .check = WeightsSumToOne},
    {.name = "WeightIsOneAtItsVertexAndZeroOpposite",
     .group = "barycentric",
     .clause = "lambda_i is 1 at vertex i and 0 on the opposite edge.",
     .precondition =
         "the subject shows weights and claims a finite bound there; window space within the "
         "limits, area not zero; at vertices and at samples exactly on an edge line",
     .tolerance = kWeightBounds,
     .domains = kWeights,
     .check = WeightIsOneAtItsVertexAndZeroOpposite},
    {.name = "WeightSignsAgreeWithTheEdges",
     .group = "barycentric",
     .clause = "a, b, c lie in [0, 1] inside the triangle (OpenGL 4.6 section 14.6.1 and Vulkan "
               "1.3, Basic Polygon Rasterization), and one of them is negative outside.",
     .precondition = kWeightValues,
     .tolerance = "the subject's proven WeightErrorBounds; where they are 0, none: exact",
     .domains = kWeights,
     .check = WeightSignsAgreeWithTheEdges},
    {.name = "WeightsReproduceThePoint",
     .group = "barycentric",
     .clause = "p = a p_a + b p_b + c p_c (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon "
               "Rasterization).",
     .precondition = kWeightValues,
     .tolerance = "sum of bound_i |v_i|",
     .domains = kWeights,
     .check = WeightsReproduceThePoint},
    {.name = "WeightsFollowTheirVertices",
     .group = "barycentric",
     .clause = "A weight belongs to its vertex, in whatever order the vertices are told.",
     .precondition = kWeightValues,
     .tolerance = "the sum of both proven WeightErrorBounds",
     .domains = kWeights,
     .check = WeightsFollowTheirVertices},
    {.name = "InterpolatedValuesStayInTheHull",
     .group = "barycentric",
     .clause = "Inside, an interpolated value is a convex combination of the vertices' values.",
     .precondition =
         "the subject shows weights and claims a finite bound there; window space within the "
         "limits, area not zero; sample in the closed triangle; every w positive",
     .tolerance = kInterpolationBound,
     .domains = kWeights,
     .check = InterpolatedValuesStayInTheHull},
    {.name = "InterpolationStaysWithinItsBound",
     .group = "barycentric",
     .clause = "z = a z_a + b z_b + c z_c for depth and other affine quantities (OpenGL 4.6 "
               "section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization).",
     .precondition = kWeightValues,
     .tolerance = kInterpolationBound,
     .domains = kWeights,
     .check = InterpolationStaysWithinItsBound},
    {.name = "DepthByDeltasEqualsDepthByWeights",
     .group = "barycentric",
     .clause = "z0 + l1 (z1 - z0) + l2 (z2 - z0) is l0 z0 + l1 z1 + l2 z2 because the weights sum "
               "to one.",
     .precondition = kWeightValues,
     .tolerance = "the sum of both proven InterpolationErrorBounds",
     .domains = kWeights,
     .check = DepthByDeltasEqualsDepthByWeights},
    {.name = "PerspectiveInterpolationStaysWithinItsBound",
     .group = "barycentric",
     .clause = "f = (sum a f_a / w_a) / (sum a / w_a) (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, "
               "Basic Polygon Rasterization; Heckbert and Moreton 1991).",
     .precondition = "the subject shows weights and claims a finite bound there; window space "
                     "within the limits, area not zero; every w positive",
     .tolerance = kInterpolationBound,
     .domains = kWeights,
     .check = PerspectiveInterpolationStaysWithinItsBound},
    {.name = "CoverageEqualsTheModel",
     .group = "coverage",
     .clause = "A sample is covered if it is inside, or on a top or left edge (D3D11.3 functional "
               "specification 3.4.2.1 (top-left rule); the profile names the rule).",
     .precondition = "contract sample-exact; coordinates within the limit; window space",
     .tolerance = kExact,
     .domains = kModelCoverage,
     .check = CoverageEqualsTheModel},
    {.name = "ClipSpaceCoverageEqualsTheModel",
     .group = "coverage",
     .clause = "A clip-space triangle covers what the ray through the sample meets in front of the "
               "eye (Olano and Greer 1997).",
     .precondition =
         "contract sample-exact; coordinates within the limit; clip space; no near clipping",
     .tolerance = kExact,
     .domains = kClipSpace,
     .check = ClipSpaceCoverageEqualsTheModel},
    {.name = "EmbeddedMeshSamplesAreCoveredOnce",
     .group = "coverage",
     .clause = "Polygons on either side of a common edge produce exactly one fragment for a sample "
               "on it (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon Rasterization); at "
               "a shared vertex D3D11.3 functional specification 3.4.2.1 (top-left rule).",
     .precondition = kEmbeddedMeshes,
     .tolerance = kExact,
     .domains = kMeshesAnySpace,
     .check = EmbeddedMeshSamplesAreCoveredOnce},
    {.name = "SharedEdgeSamplesAreCoveredOnce",
     .group = "coverage",
     .clause = "Exactly one of two polygons on either side of a common edge with identical "
               "endpoints owns a sample on it (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic "
               "Polygon Rasterization).",
     .precondition = kSharedEdges,
     .tolerance = kExact,
     .domains = kMeshesAnySpace,
     .check = SharedEdgeSamplesAreCoveredOnce},
    {.name = "SignedCoverageEqualsTheWindingNumber",
     .group = "coverage",
     .clause = "Front minus back is the winding number of the boundary: every interior edge is "
               "walked once each way, and its two triangles decide it alike.",
     .precondition = "contract sample-exact; coordinates within the limit; a consistent fill rule",
     .tolerance = kExact,
     .domains = kAnyMesh,
     .check = SignedCoverageEqualsTheWindingNumber},
    {.name = "ClosedMeshCancels",
     .group = "coverage",
     .clause = "A closed surface has no boundary: what it shows of its front it shows of its back.",
     .precondition =
         "contract sample-exact or closed; coordinates within the limit; every edge is walked as "
         "often each way; in clip space in front of the eye; facings told, or no legal "
         "choice turns a triangle there",
     .tolerance = kExact,
     .domains = kClosed,
     .check = ClosedMeshCancels},
    {.name = "ClosedSurfaceAroundTheEyeIsSeenEquallyOften",
     .group = "coverage",
     .clause = "A closed surface winds equally often around the eye in every direction.",
     .precondition = "contract sample-exact or closed; coordinates within the limit; clip space "
                     "without snapping; "
                     "a closed surface that does not pass through the eye",
     .tolerance = kExact,
     .domains = kClosedClip,
     .check = ClosedSurfaceAroundTheEyeIsSeenEquallyOften},
    {.name = "OneLegalModelExplainsTheMesh",
     .group = "coverage",
     .clause = "A vertex has one position for all triangles that use it, and a sample on an edge "
               "one owner: D3D11.3 functional specification 3.4.1 (snapping within 0.6 ulp) and "
               "3.4.2.1.",
     .precondition = "contract sample-exact; the profile leaves grid points or the tie rule free; "
                     "window space; coordinates within the limit",
     .tolerance = "the profile's own freedom, jointly for all triangles",
     .domains = kFreeSnaps,
     .check = OneLegalModelExplainsTheMesh},
    {.name = "ConservativeCoverageKeepsToItsSide",
     .group = "coverage",
     .clause = "Conservative coverage strays to one side only: an overestimate leaves no covered "
               "sample out, an underestimate adds none.",
     .precondition = "contract conservative over or under; coordinates within the limit",
     .tolerance = kExact,
     .domains = kCoverageAnySpace,
     .check = ConservativeCoverageKeepsToItsSide},
    {.name = "VertexRotationKeepsCoverage",
     .group = "coverage",
     .clause = "A triangle is the same from whichever vertex it is told.",
     .precondition = kSampleExactOnly,
     .tolerance = kExact,
     .domains = kCoverageAnySpace,
     .check = VertexRotationKeepsCoverage},
    {.name = "ReversalSwapsFacing",
     .group = "coverage",
     .clause = "Winding decides facing, never coverage.",
     .precondition = kSampleExactOnly,
     .tolerance = kExact,
     .domains = kCoverageAnySpace,
     .check = ReversalSwapsFacing},
    {.name = "TriangleOrderKeepsCoverage",
     .group = "coverage",
     .clause = "Coverage of a triangle depends on no other triangle.",
     .precondition = "contract sample-exact; coordinates within the limit; two triangles or more",
     .tolerance = kExact,
     .domains = kMeshes,
     .check = TriangleOrderKeepsCoverage},
    {.name = "DuplicatedVerticesKeepCoverage",
     .group = "coverage",
     .clause = "Vertices are positions: equal bits cover alike, shared by an index or not.",
     .precondition = kSampleExactOnly,
     .tolerance = kExact,
     .domains = kMeshes,
     .check = DuplicatedVerticesKeepCoverage},
    {.name = "DegenerateTrianglesCoverNothing",
     .group = "coverage",
     .clause = "A triangle of zero area after snapping produces nothing (D3D11.3 functional "
               "specification, rasterizer; the profile says so).",
     .precondition = "contract sample-exact; coordinates within the limit; triangles of zero area",
     .tolerance = kExact,
     .domains = kDegenerate,
     .check = DegenerateTrianglesCoverNothing},
    {.name = "ScissorOnlyCutsCoverage",
     .group = "coverage",
     .clause = "The scissor test discards samples outside its rectangle and changes nothing else "
               "(Vulkan 1.3, Scissor Test).",
     .precondition = kSampleExactOnly,
     .tolerance = kExact,
     .domains = kCoverageAnySpace,
     .check = ScissorOnlyCutsCoverage},
    {.name = "NeighboursAreClippedAlike",
     .group = "coverage",
     .clause = "A shared edge is clipped alike for both of its triangles: no gap opens and nothing "
               "doubles where they leave the target.",
     .precondition = kClippedNeighbours,
     .tolerance = kExact,
     .domains = kClipped,
     .check = NeighboursAreClippedAlike},
    {.name = "CullingRemovesOneFacing",
     .group = "coverage",
     .clause = "Culling discards triangles of one facing (Vulkan 1.3, Basic Polygon Rasterization) "
               "and changes no other.",
     .precondition = kSampleExactOnly,
     .tolerance = kExact,
     .domains = kCoverageAnySpace,
     .check = CullingRemovesOneFacing},
    {.name = "IntegerTranslationMovesCoverage",
     .group = "coverage",
     .clause = "Moving a scene by whole pixels moves its image (OpenGL 4.6 section 14.2, "
               "Invariance; Vulkan does not promise it by itself, a sample-exact model does).",
     .precondition = "contract sample-exact; coordinates within the limit; window space; the moved "
                     "coordinates are exact, of the input format and within the limit",
     .tolerance = kExact,
     .domains = kOnTheLattice,
     .check = IntegerTranslationMovesCoverage},
    {.name = "WeightDistanceIsTheSmallestWeight",
     .group = "wireframe",
     .clause = "The weight-space test lambda_i <= W draws lines of W heights, not of W pixels.",
     .precondition = kInTheTriangle,
     .tolerance = kWireframeBound,
     .domains = kWeights,
     .check = WeightDistanceIsTheSmallestWeight},
    {.name = "DerivativeDistanceMeasuresInTheL1Norm",
     .group = "wireframe",
     .clause = "lambda_i / fwidth(lambda_i) with fwidth = |d/dx| + |d/dy| (GLSL 4.60 section "
               "8.14.1) is |E_i| / (|dX| + |dY|).",
     .precondition = kInTheTriangle,
     .tolerance = kWireframeBound,
     .domains = kWeights,
     .check = DerivativeDistanceMeasuresInTheL1Norm},
    {.name = "HeightDistanceIsTheDistanceInPixels",
     .group = "wireframe",
     .clause = "lambda_i times the height over edge i is the distance to edge i.",
     .precondition = kInTheTriangle,
     .tolerance = kWireframeBound,
     .domains = kWeights,
     .check = HeightDistanceIsTheDistanceInPixels},
    {.name = "DrawStaysInsideItsTarget",
     .group = "extremes",
     .clause = "Writes outside the scissor and the target never happen, and a draw comes back, "
               "whatever the input.",
     .precondition = "the subject takes the scene",
     .tolerance = kExact,
     .domains = kExtremes,
     .check = DrawStaysInsideItsTarget},
    {.name = "NonFiniteTrianglesCoverNothing",
     .group = "extremes",
     .clause = "A triangle with NaN or infinity in x, y or w covers nothing (the profile says so; "
               "D3D11.3 drops NaN).",
     .precondition = "contract sample-exact; a vertex that is NaN, or infinite where the profile "
                     "says what it covers",
     .tolerance = kExact,
     .domains = kNonFinite,
     .check = NonFiniteTrianglesCoverNothing},
    {.name = "BadTrianglesPoisonNoOthers",
     .group = "extremes",
     .clause = "A triangle that covers nothing leaves the coverage of the others alone.",
     .precondition = "contract sample-exact; the other triangles finite and within the limit",
     .tolerance = kExact,
     .domains = kExtremes,
     .check = BadTrianglesPoisonNoOthers},
});

}  // namespace

std::span<const Property> Catalog() {
  static const std::vector<Property> all = [] {
    std::vector<Property> joined(kProperties.begin(), kProperties.end());
    const std::span<const Property> more = OutputProperties();
    joined.insert(joined.end(), more.begin(), more.end());
    return joined;
  }();
  return all;
}

const Property* FindProperty(std::string_view name) {
  for (const Property& property : Catalog()) {
    if (property.name == name) return &property;
  }
  return nullptr;
}

}  // namespace rasterproof::props
