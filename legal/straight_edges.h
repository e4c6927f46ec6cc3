// Coverage next to a moved edge that no straight edge can produce.
#ifndef RASTERPROOF_LEGAL_STRAIGHT_EDGES_H_
#define RASTERPROOF_LEGAL_STRAIGHT_EDGES_H_

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "legal/clipped_triangle.h"
#include "legal/triangle_samples.h"

namespace rasterproof::legal {

/// Returns decisions of the triangle's open samples that exclude each other, because clipping
/// replaces each edge that leaves by one straight edge.
///
/// The moved edge passes within the reach of the old one at both ends, so along the old one its
/// offset is a linear function. By Helly's theorem in the plane of its two parameters, samples on
/// either side that no such function divides hold three that none does, counting the two ends: one
/// between two others, on the wrong side of the line through these.
///
/// Domain:     `facing` is the same in every legal model, +1 or -1; `open` the triangle's, by
///             sample.
/// Returns:    for an edge next to many samples, the exclusions of 24 of them: weaker, still true.
/// Source:     exact: exact::EdgeSign decides each line. The ends are taken a little wider than the
///             reach.
std::vector<Exclusion> ExclusionsOf(const ClippedTriangle& clipped, int facing,
                                    std::span<const OpenSample> open);

}  // namespace rasterproof::legal

#endif  // RASTERPROOF_LEGAL_STRAIGHT_EDGES_H_
