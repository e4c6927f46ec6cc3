// Coverage one sample at a time: slow, and too simple to be wrong where the spans might be.
#ifndef RASTERPROOF_EXACT_SAMPLE_SCAN_H_
#define RASTERPROOF_EXACT_SAMPLE_SCAN_H_

#include <array>

#include "core/coverage.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/sample_frame.h"

namespace rasterproof::exact {

/// Adds one to every sample of the clip rectangle that the triangle (screen axes, finite) covers.
///
/// Cost:       three signs per sample of the triangle's box (clip space: of the clip rectangle).
void ScanSamples(const std::array<Vertex, 3>& v, bool clip_space, int facing,
                 const SampleFrame& frame, Decider decider, CoverageCounts& counts);

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_SAMPLE_SCAN_H_
