// The units of bounds on rounding errors, by precision.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_PRECISION_UNITS_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_PRECISION_UNITS_H_

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene.h"
#include "core/value_rule.h"

namespace rasterproof::props {

/// u: half the distance from 1 to the next larger number, 2^-24 or 2^-53.
constexpr double UnitRoundoff(Precision precision) {
  return precision == Precision::kFloat32 ? 0x1p-24 : 0x1p-53;
}

/// eta: the smallest subnormal number, 2^-149 or 2^-1074.
constexpr double SmallestSubnormal(Precision precision) {
  return precision == Precision::kFloat32 ? 0x1p-149 : 0x1p-1074;
}

/// The smallest and the largest number of the format with all its bits.
constexpr double LeastNormal(Precision precision) {
  return precision == Precision::kFloat32 ? 0x1p-126 : std::numeric_limits<double>::min();
}
constexpr double LargestNumber(Precision precision) {
  return precision == Precision::kFloat32 ? double{std::numeric_limits<float>::max()}
                                          : std::numeric_limits<double>::max();
}

/// The ulp of a number in the format.
inline double UlpOf(double value, Precision precision) {
  const bool is_float = precision == Precision::kFloat32;
  int exponent = 0;
  static_cast<void>(std::frexp(value, &exponent));
  return std::ldexp(1.0, std::max(exponent - (is_float ? 24 : 53), is_float ? -149 : -1074));
}

/// Whether a depth is a number of the format. A program shows the code of a normalized one as a
/// double: code / (2^bits - 1), rounded once, or in float32.
inline bool IsOfDepthFormat(double x, DepthFormat format) {
  const double step = DepthStep(format);
  if (step == 0) {
    return format == DepthFormat::kFloat64 || x == static_cast<double>(static_cast<float>(x));
  }
  const double most = std::nearbyint(1 / step);
  const double code = std::nearbyint(x * most);
  if (!(code >= 0 && code <= most)) return false;
  const double value = code / most;
  return x == value || x == static_cast<double>(static_cast<float>(value));
}

/// What a depth may be off by the rounding to its format: one step of it, or half; and what float32
/// rounds if that is what it is shown in.
inline double DepthRoundingOf(const ValueRule& rule, double x) {
  const double share = rule.depth_rounding == DepthRounding::kNearest ? 0.5 : 1;
  const double step = DepthStep(rule.depth);
  const double shown = std::ldexp(std::fabs(x), rule.depth == DepthFormat::kFloat64 ? -52 : -24);
  return step != 0 ? share * step + shown : 2 * share * shown;
}

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_PRECISION_UNITS_H_
