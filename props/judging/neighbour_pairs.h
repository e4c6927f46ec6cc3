// Judging two neighbouring triangles at a time.
#ifndef RASTERPROOF_PROPS_JUDGING_NEIGHBOUR_PAIRS_H_
#define RASTERPROOF_PROPS_JUDGING_NEIGHBOUR_PAIRS_H_

#include <functional>

#include "core/case.h"
#include "props/judging/mesh_neighbours.h"
#include "props/property.h"

namespace rasterproof::props {

/// Asks for a few pairs of the case's neighbours, each pair alone and with a check of its own. A
/// check holds if every sample of their union within a pixel of the shared edge, and no nearer to
/// any other of their edges, is covered as CompareWithItsWinding says: exactly once. What lies
/// nearer to their outline is the business of EmbeddedMeshSamplesAreCoveredOnce and of the claims
/// about the model. A pair that folds or overlaps has no check.
///
/// `takes` chooses among the pairs. Either space; triangle and edge of the witness are those of the
/// case, and the edge is the one nearest to the witness's sample.
Asked CompareNeighbours(const Case& c, const Description& subject,
                        const std::function<bool(const Neighbours&)>& takes);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_NEIGHBOUR_PAIRS_H_
