// Checks of many samples of a case at the price of one property: a subject is asked once, and the
// target's bound properties judge only the differences.
#ifndef RASTERPROOF_FUZZ_SCREENS_H_
#define RASTERPROOF_FUZZ_SCREENS_H_

#include <cstdint>
#include <span>

#include "fuzz/fuzz_target.h"

namespace rasterproof::fuzz {

/// Each edge value has the sign of E at the samples on either side of the edge, unless |E| is
/// within the bound that the subject states: EdgeSignIsRightOutsideItsBand, at other samples. The
/// bound and E itself are asked for only where signs differ.
///
/// Domain:     subjects that show edge values.
int ScreenEdgeSigns(const Bound& bound, std::span<const std::uint8_t> bytes);

/// Each subject's counts equal its profile's model, which is computed once a group. Where they
/// don't, the bound properties judge.
int ScreenCoverage(const Bound& bound, std::span<const std::uint8_t> bytes);

/// Front minus back is the winding number of the mesh's boundary. Where it is not, the bound
/// properties judge.
int ScreenWinding(const Bound& bound, std::span<const std::uint8_t> bytes);

}  // namespace rasterproof::fuzz

#endif  // RASTERPROOF_FUZZ_SCREENS_H_
