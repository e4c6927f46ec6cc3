// Incremental evaluation: steppings equal direct evaluation where exact, and keep their drift bound
// elsewhere.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/fuzz_target.h"

namespace {

using rasterproof::fuzz::Checked;

constexpr std::array kChecked{
    Checked{"f32-incremental", "SteppingStaysWithinItsBound"},
    Checked{"f32-incremental-row", "SteppingStaysWithinItsBound"},
    Checked{"f32-incremental-compensated", "SteppingStaysWithinItsBound"},
    Checked{"f64-incremental", "SteppingStaysWithinItsBound"},
    Checked{"i64-snap8", "SteppingEqualsDirectWhereExact"},
    Checked{"f32-index-fma", "SteppingStaysWithinItsBound"},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rasterproof::fuzz::PutToTheTest(kChecked, std::span(data, size));
  return 0;
}
