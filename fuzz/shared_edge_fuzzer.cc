// Shared edges: the exact methods count every sample as the model does, once on a shared edge.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/fuzz_target.h"

namespace {

using rasterproof::fuzz::Claim;

constexpr std::array kClaims{
    Claim{"spans-exact", "CoverageEqualsTheModel"},
    Claim{"spans-exact", "SharedEdgeSamplesAreCoveredOnce"},
    Claim{"filtered-exact", "CoverageEqualsTheModel"},
    Claim{"filtered-exact", "SignedCoverageEqualsTheWindingNumber"},
    Claim{"i64-snap8", "CoverageEqualsTheModel"},
    Claim{"i32-snap4", "SharedEdgeSamplesAreCoveredOnce"},
    Claim{"f32-direct:canonical", "DrawStaysInsideItsTarget"},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rasterproof::fuzz::PutToTheTest(kClaims, std::span(data, size));
  return 0;
}
