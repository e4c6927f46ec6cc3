// How near to edges the samples of a case lie: the evidence that a domain is not dead.
#ifndef RASTERPROOF_PROPS_RUN_NEAR_EDGE_H_
#define RASTERPROOF_PROPS_RUN_NEAR_EDGE_H_

#include "core/case.h"
#include "core/result.h"

namespace rasterproof::props {

/// Counts, for every edge and every line of samples that crosses it, the sample before and the
/// sample after the crossing: no other sample of that line is nearer.
///
/// The distance is taken along the line of samples (a row for a steep edge, a column for a flat
/// one) and in steps of the input lattice at the sample: ulps of its coordinate in the scene's
/// precision, or subpixels of the profile; rounded to whole steps. "On" is exact; the other classes
/// are counted from an estimate, long double where a double leaves doubt, within its error bound.
/// Domain:     any case. Vertices are snapped by the profile first; triangles that are not finite,
///             or clip space with a w that is not positive, are left out, as are triangles after
///             the first 64.
/// Cost:       some operations in double for each edge and line of samples, in long double where a
///             double leaves doubt, and an exact sign for a sample within the estimate's error.
NearEdgeCounts CountNearEdges(const Case& c);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_RUN_NEAR_EDGE_H_
