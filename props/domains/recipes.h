// The recipes of the table of domains. Each is total: every bit string gives a valid case, the same
// under every compiler: no two draws occur in the arguments of one call or on both sides of an
// operator, whose order C++ leaves open.
#ifndef RASTERPROOF_PROPS_DOMAINS_RECIPES_H_
#define RASTERPROOF_PROPS_DOMAINS_RECIPES_H_

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"

namespace rasterproof::props {

// recipes_ordinary.cc
Case UniformSubpixel(BitSource& bits, const SubjectInfo& info);
Case VerticesOnSamples(BitSource& bits, const SubjectInfo& info);
Case AxisAligned(BitSource& bits, const SubjectInfo& info);
Case VertexOrders(BitSource& bits, const SubjectInfo& info);
Case TargetSizes(BitSource& bits, const SubjectInfo& info);

// recipes_near_edge.cc
Case EdgesThroughSamples(BitSource& bits, const SubjectInfo& info);
Case NearEdge(BitSource& bits, const SubjectInfo& info);
Case PatternLines(BitSource& bits, const SubjectInfo& info);
Case HardestSamples(BitSource& bits, const SubjectInfo& info);
Case HardestVertices(BitSource& bits, const SubjectInfo& info);
Case UlpExtremes(BitSource& bits, const SubjectInfo& info);
Case Caps(BitSource& bits, const SubjectInfo& info);
Case LongRows(BitSource& bits, const SubjectInfo& info);

// recipes_magnitudes.cc
Case Needles(BitSource& bits, const SubjectInfo& info);
Case FarSlivers(BitSource& bits, const SubjectInfo& info);
Case OffsetCancellation(BitSource& bits, const SubjectInfo& info);
Case Subnormal(BitSource& bits, const SubjectInfo& info);
Case ProductOverflow(BitSource& bits, const SubjectInfo& info);
Case LargestAndSmallest(BitSource& bits, const SubjectInfo& info);
Case MixedMagnitude(BitSource& bits, const SubjectInfo& info);
Case CoordinateLimits(BitSource& bits, const SubjectInfo& info);

// recipes_range.cc
Case LeastAreas(BitSource& bits, const SubjectInfo& info);
Case RowsAndColumns(BitSource& bits, const SubjectInfo& info);
Case RangeEnds(BitSource& bits, const SubjectInfo& info);
Case FarNegativeCorners(BitSource& bits, const SubjectInfo& info);
Case RoundedDifferences(BitSource& bits, const SubjectInfo& info);
Case SubPixelTriangles(BitSource& bits, const SubjectInfo& info);
Case DecidingSnapTies(BitSource& bits, const SubjectInfo& info);
Case FullCoverage(BitSource& bits, const SubjectInfo& info);
/// Triangles in which the snapping of one vertex decides a sample.
void AddDecidingTies(CaseBuilder& builder);

// recipes_least_w.cc
Case LeastW(BitSource& bits, const SubjectInfo& info);

// recipes_eye_planes.cc
Case EyePlanes(BitSource& bits, const SubjectInfo& info);

// recipes_far_corners.cc
Case FarCorners(BitSource& bits, const SubjectInfo& info);
Case NearBesideFar(BitSource& bits, const SubjectInfo& info);

// recipes_far_sides.cc
Case FarSides(BitSource& bits, const SubjectInfo& info);

// recipes_folds.cc: what a legal choice of grid points turns over.
Case Folds(BitSource& bits, const SubjectInfo& info);
Case ClosedFolds(BitSource& bits, const SubjectInfo& info);

// recipes_turned.cc: what the stated snap turns over.
Case TurnedBySnap(BitSource& bits, const SubjectInfo& info);

// recipes_lists.cc
Case NearRepeats(BitSource& bits, const SubjectInfo& info);
Case SparseIndices(BitSource& bits, const SubjectInfo& info);
Case AliasedIndices(BitSource& bits, const SubjectInfo& info);

// recipes_crowds.cc: what only many triangles show.
Case LongLists(BitSource& bits, const SubjectInfo& info);
Case Crowds(BitSource& bits, const SubjectInfo& info);
Case EveryLane(BitSource& bits, const SubjectInfo& info);

// recipes_ends.cc
Case AccumulatorEnds(BitSource& bits, const SubjectInfo& info);
Case UnderflowingProducts(BitSource& bits, const SubjectInfo& info);
Case NearRectangles(BitSource& bits, const SubjectInfo& info);

// recipes_profile_keys.cc: what is next to what only some profiles make.
Case WrappedCoordinates(BitSource& bits, const SubjectInfo& info);
Case PrimitiveExtentEnds(BitSource& bits, const SubjectInfo& info);
Case GuardBandEnds(BitSource& bits, const SubjectInfo& info);
Case OffGridMoves(BitSource& bits, const SubjectInfo& info);
Case OffGridFragments(BitSource& bits, const SubjectInfo& info);
Case TargetSizeEnds(BitSource& bits, const SubjectInfo& info);

// recipes_degenerate.cc
Case SnapTies(BitSource& bits, const SubjectInfo& info);
Case Degenerate(BitSource& bits, const SubjectInfo& info);
Case SignedZeros(BitSource& bits, const SubjectInfo& info);
Case NonFinite(BitSource& bits, const SubjectInfo& info);
Case NonFiniteDepths(BitSource& bits, const SubjectInfo& info);

// recipes_meshes.cc
Case SharedEdge(BitSource& bits, const SubjectInfo& info);
Case Fans(BitSource& bits, const SubjectInfo& info);
Case Strips(BitSource& bits, const SubjectInfo& info);
Case Grids(BitSource& bits, const SubjectInfo& info);
Case PerspectiveMeshes(BitSource& bits, const SubjectInfo& info);
Case EverySize(BitSource& bits, const SubjectInfo& info);
Case SharedSnapTies(BitSource& bits, const SubjectInfo& info);

// recipes_squares.cc: next to the sides and corners of pixels.
Case SquareGridLines(BitSource& bits, const SubjectInfo& info);
Case SquareCrossings(BitSource& bits, const SubjectInfo& info);
Case SquareInteriors(BitSource& bits, const SubjectInfo& info);

// recipes_subdivisions.cc
Case Triangulations(BitSource& bits, const SubjectInfo& info);
Case Subdivisions(BitSource& bits, const SubjectInfo& info);
Case TJunctions(BitSource& bits, const SubjectInfo& info);
Case FineMeshes(BitSource& bits, const SubjectInfo& info);
Case CoveringFans(BitSource& bits, const SubjectInfo& info);

// recipes_closed.cc
Case ClosedMesh(BitSource& bits, const SubjectInfo& info);
Case MeshesAroundEye(BitSource& bits, const SubjectInfo& info);
Case ClosedAroundEye(BitSource& bits, const SubjectInfo& info);
Case Perspective(BitSource& bits, const SubjectInfo& info);
Case MixedW(BitSource& bits, const SubjectInfo& info);
Case OneVertexBehind(BitSource& bits, const SubjectInfo& info);
Case HardestRays(BitSource& bits, const SubjectInfo& info);

// recipes_tilted.cc
Case TiltedGrids(BitSource& bits, const SubjectInfo& info);
Case DiagonalNeedles(BitSource& bits, const SubjectInfo& info);

// recipes_tiles.cc
Case TileBorders(BitSource& bits, const SubjectInfo& info);
Case FarTileCorners(BitSource& bits, const SubjectInfo& info);

// recipes_constructed.cc: meshes as other programs make them.
Case RoundedArrangements(BitSource& bits, const SubjectInfo& info);
Case EqualAfterSnap(BitSource& bits, const SubjectInfo& info);
Case EarcutMeshes(BitSource& bits, const SubjectInfo& info);

// recipes_engines.cc
Case Cameras(BitSource& bits, const SubjectInfo& info);
Case ScaledViewports(BitSource& bits, const SubjectInfo& info);
Case FrameSweeps(BitSource& bits, const SubjectInfo& info);

// recipes_soups.cc
Case TessellationCracks(BitSource& bits, const SubjectInfo& info);
Case Soups(BitSource& bits, const SubjectInfo& info);
Case CoplanarDepths(BitSource& bits, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_RECIPES_H_
