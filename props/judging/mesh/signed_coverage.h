// Front counts minus back counts.
#ifndef RASTERPROOF_PROPS_JUDGING_MESH_SIGNED_COVERAGE_H_
#define RASTERPROOF_PROPS_JUDGING_MESH_SIGNED_COVERAGE_H_

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "props/judging/freedom/free_choices.h"
#include "props/judging/freedom/outline.h"
#include "props/judging/gate.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// Where front minus back is stated, each sample of an edge is given to one side, once.
inline constexpr std::array kSignedCoverageRules{kCountsTies, kOwnsEdges};

/// The samples that are not judged: next to an outline, where a triangle can lie whose facing or
/// extent the subject may choose, and where clipping may decide.
struct Spared {
  Outline outline;
  OpenTriangles open;
  ClippedEdges clipped;
};

/// Asks for the case, culling and scissor off. Holds if front minus back is `expected`, in words
/// `what`, at every sample that is not `spared`. Samples spared for open triangles are counted as
/// not judged.
///
/// Domain:     a case that outlives what is returned.
/// Shape:      expected: as CoverageCounts.
Checks CompareSignedCoverage(const PlacedCase& c, std::vector<std::int64_t> expected,
                             std::string what, Spared spared = {});

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_MESH_SIGNED_COVERAGE_H_
