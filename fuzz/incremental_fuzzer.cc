// Incremental evaluation: walks equal direct evaluation where exact, and keep their drift bound
// elsewhere.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/fuzz_target.h"

namespace {

using rasterproof::fuzz::Claim;

constexpr std::array kClaims{
    Claim{"f32-incremental", "WalkStaysWithinItsBound"},
    Claim{"f32-incremental-row", "WalkStaysWithinItsBound"},
    Claim{"f32-incremental-compensated", "WalkStaysWithinItsBound"},
    Claim{"f64-incremental", "WalkStaysWithinItsBound"},
    Claim{"i64-snap8", "WalkEqualsDirectWhereExact"},
    Claim{"f32-index-fma", "WalkStaysWithinItsBound"},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rasterproof::fuzz::PutToTheTest(kClaims, std::span(data, size));
  return 0;
}
