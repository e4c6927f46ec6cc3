// Barycentrics: sums, weights and what is interpolated stay within their proven bounds.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/fuzz_target.h"

namespace {

using rasterproof::fuzz::Claim;

constexpr std::array kClaims{
    Claim{"f32-direct", "WeightsSumToOne"},
    Claim{"f32-direct", "WeightsStayWithinTheirBound"},
    Claim{"f32-direct", "InterpolationStaysWithinItsBound"},
    Claim{"f64-direct", "WeightsSumToOne"},
    Claim{"f64-direct", "WeightIsOneAtItsVertexAndZeroOpposite"},
    Claim{"f64-direct", "DepthByDeltasEqualsDepthByWeights"},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rasterproof::fuzz::PutToTheTest(kClaims, std::span(data, size));
  return 0;
}
