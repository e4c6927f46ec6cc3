// Published conformance checks, re-expressed from a description of what they draw and let pass: a
// baseline that the catalogue is compared with.
#ifndef RASTERPROOF_TESTS_SUBJECTS_CONFORMANCE_BASELINE_H_
#define RASTERPROOF_TESTS_SUBJECTS_CONFORMANCE_BASELINE_H_

#include <cstdint>

#include "core/subject.h"

namespace rasterproof {

enum class Baseline : std::uint8_t {
  kPasses,
  kFails,
  kSkips  ///< the check does not know the convention that it meets
};

/// After the Khronos CTS: nine triangles in a small target, where samples within three subpixels of
/// an edge don't matter, and meshes of rotated quads, which must cover no sample twice and no inner
/// one never. Some wrong pixels are allowed where there are several samples.
Baseline CtsLike(Subject& subject);

/// After Piglit: finds the convention out with a few probes, skips if it is none that it knows, and
/// compares triangles at ordinary places with it.
Baseline PiglitLike(Subject& subject);

}  // namespace rasterproof

#endif  // RASTERPROOF_TESTS_SUBJECTS_CONFORMANCE_BASELINE_H_
