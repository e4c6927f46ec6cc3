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

double FixedInput::Wrapped(double x) const {
  if (!wraps || !std::isfinite(x)) return x;
  // fmod is exact, and so is one span more or less: both are multiples of 2^-m below 2^n in size.
  const double rest = std::fmod(x, Span());
  if (rest < Least()) return rest + Span();
  return rest < Least() + Span() ? rest : rest - Span();
}

std::int64_t FixedInput::Raw(double x) const {
  return static_cast<std::int64_t>(std::ldexp(x, fraction_bits));
}

}  // namespace rasterproof
