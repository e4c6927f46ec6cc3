#include "props/catalog/edge_scaling.h"

#include <array>

#include "props/catalog/edge_queries.h"

namespace rasterproof::props {
namespace {

// Upwards only: the way down is the same claim read backwards, and could meet subnormals.
constexpr std::array<EdgeMap, 3> kScalings{{
    {.sx = 2, .sy = 2, .factor = 4},
    {.sx = 32, .sy = 32, .factor = 0x1p10},
    {.sx = 0x1p20, .sy = 0x1p20, .factor = 0x1p40},
}};

}  // namespace

Verdict PowerOfTwoScalingScalesEdgeValues(Subject& subject, const Case& c) {
  return EdgeValuesFollow(subject, c, kScalings, "edge value does not scale by 4^k");
}

}  // namespace rasterproof::props
