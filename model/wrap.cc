#include "model/wrap.h"

#include <cmath>

namespace rasterproof {

double Wrapped(double x, const FixedInput& fixed) {
  if (!fixed.wraps || !std::isfinite(x)) return x;
  // fmod is exact, and so is adding or subtracting a span: multiples of 2^-m below 2^n in size.
  const double rest = std::fmod(x, fixed.Span());
  if (rest < fixed.Least()) return rest + fixed.Span();
  return rest < fixed.Least() + fixed.Span() ? rest : rest - fixed.Span();
}

}  // namespace rasterproof
