// Barycentrics: sums, barycentrics and what is interpolated stay within their proven bounds.
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "fuzz/fuzz_target.h"

namespace {

using rasterproof::fuzz::Checked;

constexpr std::array kChecked{
    Checked{"f32-direct", "BarycentricsSumToOne"},
    Checked{"f32-direct", "BarycentricsStayWithinTheirBound"},
    Checked{"f32-direct", "InterpolationStaysWithinItsBound"},
    Checked{"f64-direct", "BarycentricsSumToOne"},
    Checked{"f64-direct", "BarycentricIsOneAtItsVertexAndZeroOpposite"},
    Checked{"f64-direct", "DepthByDeltasEqualsDepthByBarycentrics"},
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  rasterproof::fuzz::PutToTheTest(kChecked, std::span(data, size));
  return 0;
}
