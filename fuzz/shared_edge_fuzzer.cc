// Shared edges: the exact methods count every sample as the model does, once on a shared edge.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/fuzz_target.h"

namespace {

using rasterproof::fuzz::Checked;

constexpr std::array kChecked{
    Checked{"spans-exact", "CoverageEqualsTheModel"},
    Checked{"spans-exact", "SharedEdgeSamplesAreCoveredOnce"},
    Checked{"filtered-exact", "CoverageEqualsTheModel"},
    Checked{"filtered-exact", "SignedCoverageEqualsTheWindingNumber"},
    Checked{"i64-snap8", "CoverageEqualsTheModel"},
    Checked{"i32-snap4", "SharedEdgeSamplesAreCoveredOnce"},
    Checked{"f32-direct:canonical", "DrawStaysInsideItsTarget"},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rasterproof::fuzz::PutToTheTest(kChecked, std::span(data, size));
  return 0;
}
