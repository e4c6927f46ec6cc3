// Samples on common edges with one triangle on each side.
#ifndef RASTERPROOF_LEGAL_EDGE_OWNERS_H_
#define RASTERPROOF_LEGAL_EDGE_OWNERS_H_

#include <cstddef>
#include <vector>

#include "legal/model_clauses.h"
#include "legal/triangle_samples.h"

namespace rasterproof::legal {

/// Returns every sample that some choice of places puts on an edge between exactly two triangles,
/// one on each side of it in some legal model. If more triangles share an edge, no specification
/// states an owner, nor in a legal model that turns or flattens one of them. Left out are two that
/// may turn whose corners have more than 4096 choices of places.
///
/// Domain:     `open` by triangle: [first_open[t], first_open[t + 1]) are triangle t's, in
///             ascending order of their samples.
std::vector<CommonEdgeSample> CommonEdgeSamplesOf(const FamilyView& view,
                                                  const std::vector<OpenSample>& open,
                                                  const std::vector<std::size_t>& first_open,
                                                  const std::vector<int>& facing);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_EDGE_OWNERS_H_
