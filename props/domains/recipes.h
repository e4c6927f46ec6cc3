// The recipes behind the table of domains. Each is total: every bit string gives a valid case, and
// the same one under every compiler: two draws never stand in one call's arguments or on both sides
// of an operator, whose order C++ leaves open.
#ifndef RASTERPROOF_PROPS_DOMAINS_RECIPES_H_
#define RASTERPROOF_PROPS_DOMAINS_RECIPES_H_

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/sketch.h"

namespace rasterproof::props {

// recipes_ordinary.cc
Case UniformSubpixel(BitSource& bits, const SubjectInfo& info);
Case Centres(BitSource& bits, const SubjectInfo& info);
Case AxisAligned(BitSource& bits, const SubjectInfo& info);
Case Windings(BitSource& bits, const SubjectInfo& info);
Case SizeLadder(BitSource& bits, const SubjectInfo& info);

// recipes_near_edge.cc
Case EdgesThroughCentres(BitSource& bits, const SubjectInfo& info);
Case NearEdge(BitSource& bits, const SubjectInfo& info);
Case HardestPixels(BitSource& bits, const SubjectInfo& info);
Case HardestVertices(BitSource& bits, const SubjectInfo& info);
Case F64Killer(BitSource& bits, const SubjectInfo& info);
Case Caps(BitSource& bits, const SubjectInfo& info);
Case LongWalk(BitSource& bits, const SubjectInfo& info);

// recipes_magnitudes.cc
Case Needles(BitSource& bits, const SubjectInfo& info);
Case Sliver1e30(BitSource& bits, const SubjectInfo& info);
Case OffsetCancellation(BitSource& bits, const SubjectInfo& info);
Case Subnormal(BitSource& bits, const SubjectInfo& info);
Case OverflowProducts(BitSource& bits, const SubjectInfo& info);
Case BothEnds(BitSource& bits, const SubjectInfo& info);
Case MixedMagnitude(BitSource& bits, const SubjectInfo& info);
Case GuardBand(BitSource& bits, const SubjectInfo& info);

// recipes_range.cc
Case LeastAreas(BitSource& bits, const SubjectInfo& info);
Case RowsAndColumns(BitSource& bits, const SubjectInfo& info);
Case RangeEnds(BitSource& bits, const SubjectInfo& info);
Case FarNegativeCorners(BitSource& bits, const SubjectInfo& info);
Case TinyEnds(BitSource& bits, const SubjectInfo& info);
Case SubPixel(BitSource& bits, const SubjectInfo& info);
Case DecidingTies(BitSource& bits, const SubjectInfo& info);
Case FullTargets(BitSource& bits, const SubjectInfo& info);
/// Triangles one vertex of which decides a sample by how it is snapped.
void AddDecidingTies(Sketch& sketch);

// recipes_folds.cc: what a legal choice of grid points turns over.
Case Folds(BitSource& bits, const SubjectInfo& info);
Case ClosedFolds(BitSource& bits, const SubjectInfo& info);

// recipes_lists.cc
Case NearRepeats(BitSource& bits, const SubjectInfo& info);
Case SparseIndices(BitSource& bits, const SubjectInfo& info);

// recipes_promises.cc: what is next to a promise that only some profiles make.
Case WrappedCoordinates(BitSource& bits, const SubjectInfo& info);
Case ExtentEnds(BitSource& bits, const SubjectInfo& info);
Case NoClipEnds(BitSource& bits, const SubjectInfo& info);
Case TargetEnds(BitSource& bits, const SubjectInfo& info);

// recipes_degenerate.cc
Case SnapTies(BitSource& bits, const SubjectInfo& info);
Case Degenerate(BitSource& bits, const SubjectInfo& info);
Case SignedZeros(BitSource& bits, const SubjectInfo& info);
Case NonFinite(BitSource& bits, const SubjectInfo& info);

// recipes_meshes.cc
Case SharedEdge(BitSource& bits, const SubjectInfo& info);
Case Fans(BitSource& bits, const SubjectInfo& info);
Case Strips(BitSource& bits, const SubjectInfo& info);
Case Grids(BitSource& bits, const SubjectInfo& info);
Case PerspectiveMeshes(BitSource& bits, const SubjectInfo& info);
Case SharedSnapTies(BitSource& bits, const SubjectInfo& info);

// recipes_subdivisions.cc
Case Triangulations(BitSource& bits, const SubjectInfo& info);
Case Subdivisions(BitSource& bits, const SubjectInfo& info);
Case TJunctions(BitSource& bits, const SubjectInfo& info);
Case CoveringFans(BitSource& bits, const SubjectInfo& info);

// recipes_closed.cc
Case ClosedMesh(BitSource& bits, const SubjectInfo& info);
Case MeshesAroundEye(BitSource& bits, const SubjectInfo& info);
Case ClosedAroundEye(BitSource& bits, const SubjectInfo& info);
Case Perspective(BitSource& bits, const SubjectInfo& info);
Case MixedW(BitSource& bits, const SubjectInfo& info);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_DOMAINS_RECIPES_H_
