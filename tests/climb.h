// A search for the inputs at which a bound is nearest to being broken.
#ifndef RASTERPROOF_TESTS_CLIMB_H_
#define RASTERPROOF_TESTS_CLIMB_H_

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/ulp.h"
#include "tests/reference/random_values.h"

namespace rasterproof {

/// What a climb costs and where it begins.
struct Climb {
  std::uint64_t seed;
  int evaluations;
  int restarts = 8;
};

/// The highest place of a climb.
template <std::size_t N>
struct Peak {
  double value = 0;
  std::array<double, N> at{};
};

/// Climbs on the bit patterns of N doubles towards the largest objective: each restart draws some
/// inputs, keeps the best and moves one of its numbers at a time by up to 2^48 ulps.
///
/// Returns:    the largest value seen, and where.
template <std::size_t N, class Draw, class Objective>
Peak<N> HighestPeak(const Climb& climb, const Draw& draw, const Objective& objective) {
  constexpr int kDrawn = 60;
  reference::RandomValues random(climb.seed);
  std::array<double, N> best{};
  double local = 0;
  Peak<N> worst;
  const int length = std::max(climb.evaluations / climb.restarts, 1);
  for (int n = 0; n < climb.evaluations; ++n) {
    if (n % length == 0) local = 0;
    std::array<double, N> c = best;
    if (n % length < kDrawn) {
      for (double& x : c) x = draw(random);
    } else {
      double& x = c[static_cast<std::size_t>(random.Integer(0, static_cast<int>(N) - 1))];
      const auto step = static_cast<std::int64_t>(random.Bits(random.Integer(1, 48)));
      x = MoveByUlps(x, random.Coin() ? step : -step);
    }
    const double value = objective(c);
    if (value >= local) {
      local = value;
      best = c;
    }
    if (value > worst.value) worst = {value, c};
  }
  return worst;
}

/// The value alone.
template <std::size_t N, class Draw, class Objective>
double Largest(const Climb& climb, const Draw& draw, const Objective& objective) {
  return HighestPeak<N>(climb, draw, objective).value;
}

}  // namespace rasterproof

#endif  // RASTERPROOF_TESTS_CLIMB_H_
