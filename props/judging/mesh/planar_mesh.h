// Judging a mesh that lies flat: every sample inside once, none outside.
#ifndef RASTERPROOF_PROPS_JUDGING_MESH_PLANAR_MESH_H_
#define RASTERPROOF_PROPS_JUDGING_MESH_PLANAR_MESH_H_

#include <array>

#include "props/judging/gate.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// Asks for the case's mesh, culling and scissor off, and compares every count with the mesh's
/// winding number. Window space, or clip space: a mesh in front of the eye, or one that lies around
/// it.
///
/// Precondition (else nothing is asked): no triangle is folded against the others, in any legal
/// model, and no winding number exceeds 1 in size. Then all areas have one sign, so the count *is*
/// the size of the signed coverage, and that is the winding number.
///
/// Shared ties: where the profile lets every triangle have the samples on its edges (edge_samples
/// may be shared, the inclusive tie rule), a sample inside must be covered at least once, and away
/// from edges once.
///
/// A watertight subject states where its meshes have no gap, not where their outline lies: for it
/// samples near the outline (a T-junction is one) are not judged. So with a mesh that the subject
/// clips (the profile's guard_band), and one whose grid points it may choose. If a legal choice can
/// turn over or flatten a triangle, the samples that it can cover are counted as not judged. The
/// triangles on all other samples have one facing in every legal model, so that the argument above
/// holds.
///
/// Samples that the mesh itself leaves uncovered inside, in cracks (T-junctions that the snap
/// opens, vertices that should be one) and holes, are counted in Verdict::in_gaps.
///
/// A mesh that is judged as it is shown (judging/as_shown.h) can fail, by a gap or by what is
/// covered outside, but never holds: how often a sample is covered does not show.
Checks CompareWithItsWinding(const PlacedCase& c, const Description& subject);

/// The requirement on the profile: meshes cover each sample inside.
inline constexpr std::array kPlanarMeshRules{kClosesEdges};

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_MESH_PLANAR_MESH_H_
