#include "core/fixed_input.h"

#include <cmath>
#include <cstdint>

namespace rasterproof {

double FixedInput::Span() const { return std::ldexp(1.0, integer_bits); }

double FixedInput::Step() const { return std::ldexp(1.0, -fraction_bits); }

bool FixedInput::IsGiven(double x) const {
  if (!std::isfinite(x) || (!wraps && !InRange(x))) return false;
  const double units = std::ldexp(x, fraction_bits);
  return units == std::floor(units);
}

std::int64_t FixedInput::Raw(double x) const {
  return static_cast<std::int64_t>(std::ldexp(x, fraction_bits));
}

}  // namespace rasterproof
