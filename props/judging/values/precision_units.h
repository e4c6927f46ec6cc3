// The units of bounds on rounding errors, by precision.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_PRECISION_UNITS_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_PRECISION_UNITS_H_

#include "core/scene.h"

namespace rasterproof::props {

/// u: half the distance from 1 to the next larger number, 2^-24 or 2^-53.
constexpr double UnitRoundoff(Precision precision) {
  return precision == Precision::kFloat32 ? 0x1p-24 : 0x1p-53;
}

/// eta: the smallest subnormal number, 2^-149 or 2^-1074.
constexpr double SmallestSubnormal(Precision precision) {
  return precision == Precision::kFloat32 ? 0x1p-149 : 0x1p-1074;
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_PRECISION_UNITS_H_
