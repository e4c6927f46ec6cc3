// What SharedEdgeSamplesAreCoveredOnce asks of one pair, for a property that asks it of others too.
#ifndef RASTERPROOF_PROPS_PROPERTIES_COVERAGE_SHARED_EDGE_SAMPLES_ARE_COVERED_ONCE_H_
#define RASTERPROOF_PROPS_PROPERTIES_COVERAGE_SHARED_EDGE_SAMPLES_ARE_COVERED_ONCE_H_

#include <cstdint>
#include <functional>

#include "props/judging/mesh/mesh_neighbours.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// How the two triangles of an edge that leaves the guard band clip it.
enum class Clipped : std::uint8_t {
  kMayDiffer,  ///< the clauses do not say alike: the samples that this decides are left out
  kAlike
};

/// Asks for a few pairs of the case's neighbours, those that `takes` chooses, each pair drawn
/// alone. Holds if every sample beside their common edge, and away from their outline, is covered
/// once.
Checks CoverSharedEdgesOnce(const PlacedCase& c, const Description& subject, Clipped clipped,
                            const std::function<bool(const Neighbours&)>& takes);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_PROPERTIES_COVERAGE_SHARED_EDGE_SAMPLES_ARE_COVERED_ONCE_H_
