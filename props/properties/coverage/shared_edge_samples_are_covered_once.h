// What SharedEdgeSamplesAreCoveredOnce asks of one pair, for a property that asks it of others too.
#ifndef RASTERPROOF_PROPS_PROPERTIES_COVERAGE_SHARED_EDGE_SAMPLES_ARE_COVERED_ONCE_H_
#define RASTERPROOF_PROPS_PROPERTIES_COVERAGE_SHARED_EDGE_SAMPLES_ARE_COVERED_ONCE_H_

#include <functional>

#include "core/case.h"
#include "props/judging/mesh_neighbours.h"
#include "props/property.h"

namespace rasterproof::props {

/// Asks for a few pairs of the case's neighbours, those that `takes` chooses, each pair drawn
/// alone. Holds if every sample beside their common edge, and away from their outline, is covered
/// once.
Asked CoverSharedEdgesOnce(const Case& c, const Description& subject,
                           const std::function<bool(const Neighbours&)>& takes);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTIES_COVERAGE_SHARED_EDGE_SAMPLES_ARE_COVERED_ONCE_H_
