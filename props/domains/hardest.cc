#include "props/domains/hardest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

namespace rasterproof::props {
namespace {

constexpr Int128 kMostSteps = Int128{1} << 53;
constexpr int kMostBits = 72;

Int128 Magnitude(Int128 x) { return x < 0 ? -x : x; }

bool Fits(Int128 x) { return Magnitude(x) < Int128{1} << kMostBits; }

// The exponent of the lowest bit that is set in x.
int LowestExponent(double x) {
  if (x == 0) return 0;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);  // x = mantissa 2^exponent
  const auto bits = static_cast<std::uint64_t>(std::fabs(std::ldexp(mantissa, 53)));
  return exponent - 53 + static_cast<int>(std::countr_zero(bits));
}

// x in units of 2^unit, if that is an integer of few enough bits to multiply with another.
std::optional<Int128> InUnits(double x, int unit) {
  const double scaled = std::ldexp(x, -unit);
  if (std::fabs(scaled) >= 0x1p61) return std::nullopt;
  return static_cast<Int128>(static_cast<std::int64_t>(scaled));
}

// Steps from x away from zero to the end of its binade.
double StepsToEndOfBinade(double x, double step) {
  return std::ldexp(1.0, std::ilogb(x) + 1) / step - std::fabs(x) / step;
}

double StepsToStartOfBinade(double x, double step) {
  return std::fabs(x) / step - std::ldexp(1.0, std::ilogb(x)) / step;
}

}  // namespace

Int128 FirstInRange(Int128 a, Int128 m, Int128 low, Int128 high) {
  if (low == 0) return 0;
  if (a == 0) return -1;
  const Int128 first = (low + a - 1) / a;
  if (first * a <= high) return first < kMostSteps ? first : -1;
  // No multiple of a is in range, so a i = m k + r, r of [low, high], needs some k >= 1: then
  // (m k) mod a lies in [-high, -low] modulo a, the same question about smaller numbers.
  const Int128 wraps = FirstInRange(m % a, a, Modulo(-high, a), Modulo(-low, a));
  // i >= k at every level, so a k past the cap, or an overflow (m < 2^72), is an i past the cap.
  if (wraps < 0 || wraps >= kMostSteps) return -1;
  const Int128 i = (m * wraps + low + a - 1) / a;
  return i < kMostSteps ? i : -1;
}

Int128 ArgMinModulo(Int128 a, Int128 c, Int128 m, Int128 n) {
  a = Modulo(a, m);
  c = Modulo(c, m);
  const Int128 start =
      c == 0 ? 0 : m - c;  // (a i + c) mod m <= r  iff  (a i) mod m in start + [0, r]
  Int128 best = 0;
  Int128 low = 0;
  Int128 high = c;  // i = 0 reaches this
  while (low < high) {
    const Int128 middle = low + (high - low) / 2;
    const bool wraps = start + middle >= m;  // then the range contains 0, which i = 0 reaches
    const Int128 i = wraps ? 0 : FirstInRange(a, m, start, start + middle);
    if (i >= 0 && i < n) {
      best = i;
      high = Modulo(a * i + c, m);
    } else {
      low = middle + 1;
    }
  }
  return best;
}

namespace {

struct Steps {
  Int128 i = 0;
  Int128 j = 0;
};

// The steps (i, j), 0 <= i < n and j any, for which sign * (value + a i + b j) is smallest but
// positive: over i steps the best number j leaves (value + a i) mod b, and Euclid's algorithm finds
// the least of these without trying them. Residue 0 is moved to the far end by taking one off.
Steps SmallestPositive(Int128 value, Int128 a, Int128 b, Int128 n, int sign) {
  const Int128 m = Magnitude(b);
  const Int128 i = ArgMinModulo(sign * a, sign * value - 1, m, n);
  const Int128 least = sign * (Modulo(sign * (value + a * i) - 1, m) + 1);
  return {i, (least - value - a * i) / b};
}

struct IntegerPoint {
  Int128 x = 0;
  Int128 y = 0;
};

std::optional<IntegerPoint> InUnits(Point2 p, int unit) {
  const std::optional<Int128> x = InUnits(p.x, unit);
  const std::optional<Int128> y = InUnits(p.y, unit);
  if (!x || !y) return std::nullopt;
  return IntegerPoint{*x, *y};
}

Int128 EdgeValueInUnits(const IntegerPoint& a, const IntegerPoint& b, const IntegerPoint& p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

Point2 Transposed(Point2 p) { return {p.y, p.x}; }

// How many of v's places in x, from v on and away from zero, have their best place in y within v's
// binade. 0 if none, or if only v itself.
Int128 LengthOfRun(Point2 v, double ux, double uy, double off_line, double slope) {
  const double room =
      std::min(StepsToEndOfBinade(v.y, uy), StepsToStartOfBinade(v.y, uy)) - 2 - off_line;
  if (room < 1) return 0;
  const double run = slope > 0 ? room / slope : 0x1p52;
  return static_cast<Int128>(
      static_cast<std::int64_t>(std::min({StepsToEndOfBinade(v.x, ux), run, 0x1p52})));
}

// HardestVertex for a line that moves less than a step in y per step in x.
std::optional<Point2> HardestAlongX(Point2 v, Point2 q, Point2 p, double ux, double uy, int sign) {
  const int unit = std::min({LowestExponent(q.x), LowestExponent(q.y), LowestExponent(p.x),
                             LowestExponent(p.y), std::ilogb(ux), std::ilogb(uy)});
  const auto vi = InUnits(v, unit);
  const auto qi = InUnits(q, unit);
  const auto pi = InUnits(p, unit);
  const auto step = InUnits({std::copysign(ux, v.x), uy}, unit);
  if (!vi || !qi || !pi || !step) return std::nullopt;
  // E(v, q; p) is affine in v: a step in x adds (p.y - q.y) ux, a step in y adds (q.x - p.x) uy.
  if (!Fits((pi->y - qi->y)) || Magnitude(step->x) >> 40 != 0 || step->y >> 40 != 0) {
    return std::nullopt;
  }
  const Int128 a = (pi->y - qi->y) * step->x;
  const Int128 b = (qi->x - pi->x) * step->y;
  if (!Fits(a) || !Fits(b) || b == 0) return std::nullopt;
  const Int128 value = EdgeValueInUnits(*vi, *qi, *pi);
  const double per_step = 1 / std::fabs(static_cast<double>(b));
  const Int128 n = LengthOfRun(v, ux, uy, std::fabs(static_cast<double>(value)) * per_step,
                               std::fabs(static_cast<double>(a)) * per_step);
  if (n == 0) return std::nullopt;
  const Steps best = SmallestPositive(value, a, b, n, sign);
  return Point2{v.x + std::copysign(ux, v.x) * static_cast<double>(best.i),
                v.y + uy * static_cast<double>(best.j)};
}

}  // namespace

std::optional<Point2> HardestVertex(Point2 v, Point2 q, Point2 p, const InputLattice& lattice,
                                    int sign) {
  if (v.x == 0 || v.y == 0) return std::nullopt;
  const double ux = lattice.Step(v.x);
  const double uy = lattice.Step(v.y);
  if (std::fabs((p.y - q.y) * ux) <= std::fabs((q.x - p.x) * uy)) {
    return HardestAlongX(v, q, p, ux, uy, sign);
  }
  // E changes its sign when x and y change places.
  const auto best = HardestAlongX(Transposed(v), Transposed(q), Transposed(p), uy, ux, -sign);
  if (!best) return std::nullopt;
  return Transposed(*best);
}

std::optional<HardPixel> HardestPixel(Point2 a, Point2 b, Point2 location, int sign) {
  if (std::fabs(b.y - a.y) > std::fabs(b.x - a.x)) {
    const auto best = HardestPixel(Transposed(a), Transposed(b), Transposed(location), -sign);
    if (!best) return std::nullopt;
    return HardPixel{best->j, best->i};
  }
  constexpr int kUnit = -24;
  constexpr Int128 kPixel = Int128{1} << 24;
  const auto ai = InUnits(a, kUnit);
  const auto bi = InUnits(b, kUnit);
  const auto first = static_cast<std::int64_t>(std::ceil(std::min(a.x, b.x) - location.x));
  const auto last = static_cast<std::int64_t>(std::floor(std::max(a.x, b.x) - location.x));
  const auto pi = InUnits({static_cast<double>(first) + location.x, location.y}, kUnit);
  if (!ai || !bi || !pi || ai->x == bi->x || last < first) return std::nullopt;
  // A pixel to the right adds dY, a pixel down takes dX away.
  const Steps best = SmallestPositive(EdgeValueInUnits(*ai, *bi, *pi), (bi->y - ai->y) * kPixel,
                                      -(bi->x - ai->x) * kPixel, Int128{last - first + 1}, sign);
  return HardPixel{first + static_cast<std::int64_t>(best.i), static_cast<std::int64_t>(best.j)};
}

}  // namespace rasterproof::props
