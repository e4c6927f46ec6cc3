#include "props/shrink/cost.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "core/case.h"

namespace rasterproof::props {
namespace {

// A significant bit is worth four binades: 0.75 is simpler than 16, 2^40 than a full mantissa.
constexpr std::uint64_t kCostPerBit = 4;
constexpr std::uint64_t kInfinityCost = 5000;  // above 53 bits and 1074 binades
constexpr std::uint64_t kNanCost = 6000;

std::uint64_t SignificantBits(double x) {
  int exponent = 0;
  const auto bits = static_cast<std::uint64_t>(std::ldexp(std::frexp(std::fabs(x), &exponent), 53));
  return 53 - static_cast<std::uint64_t>(std::countr_zero(bits));
}

std::uint64_t OptionsCost(const DrawOptions& options) {
  std::uint64_t cost = 0;
  if (options.cull != Cull::kNone) ++cost;
  if (options.scissor) ++cost;
  if (options.tile != 0) ++cost;
  if (options.threads != 1) ++cost;
  return cost;
}

}  // namespace

std::uint64_t CoordinateCost(double x) {
  if (std::isnan(x)) return kNanCost;
  const std::uint64_t negative = std::signbit(x) ? 1 : 0;
  if (std::isinf(x)) return kInfinityCost + negative;
  if (x == 0) return negative;
  return 1 + kCostPerBit * SignificantBits(x) +
         static_cast<std::uint64_t>(std::abs(std::ilogb(x))) + negative;
}

Cost CostOf(const Case& c) {
  std::uint64_t coordinates = c.scene.clip_space ? 1 : 0;
  for (const Vertex& v : c.scene.vertices) {
    // w is simplest at 1: that is where its own distance is 0.
    coordinates += CoordinateCost(v.x) + CoordinateCost(v.y) + CoordinateCost(v.z) +
                   (v.w == 1 ? 0 : 1 + CoordinateCost(v.w));
  }
  return {c.scene.triangles.size(), c.scene.vertices.size(),
          static_cast<std::uint64_t>(c.scene.width) * static_cast<std::uint64_t>(c.scene.height),
          OptionsCost(c.options), coordinates};
}

}  // namespace rasterproof::props
