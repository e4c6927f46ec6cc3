// The well-founded order in which shrinking goes down.
#ifndef RASTERPROOF_PROPS_SHRINK_COST_H_
#define RASTERPROOF_PROPS_SHRINK_COST_H_

#include <array>
#include <cstdint>

#include "core/case.h"

namespace rasterproof::props {

/// What is simple, dearest first: triangles, vertices, samples of the target, options that are not
/// the default, and the coordinates' own costs. Compared lexicographically.
using Cost = std::array<std::uint64_t, 5>;

/// Returns the cost of a case. Two cases of equal cost are equally simple, not equal.
Cost CostOf(const Case& c);

/// Returns the cost of one coordinate: 0 for +0, then by significant bits, by the distance of the
/// exponent from 0 and by the sign; infinities cost more than any number, and NaN most.
std::uint64_t CoordinateCost(double x);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_SHRINK_COST_H_
