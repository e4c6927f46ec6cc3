// Random numbers for the tests of bounds and plans: fixed seeds, shapes that reach the hard places.
#ifndef RASTERPROOF_TESTS_REFERENCE_RANDOM_VALUES_H_
#define RASTERPROOF_TESTS_REFERENCE_RANDOM_VALUES_H_

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "core/ulp.h"

namespace rasterproof::reference {

/// A seeded source. std::mt19937_64 is the same on every machine; the standard's distributions are
/// not, so none is used.
class RandomValues {
 public:
  explicit RandomValues(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t Bits(int count) { return count == 0 ? 0 : engine_() >> (64 - count); }
  /// An integer in [low, high].
  int Integer(int low, int high) {
    const auto range = static_cast<std::uint64_t>(high - low) + 1;
    return low + static_cast<int>(engine_() % range);
  }
  bool Coin() { return Bits(1) != 0; }
  /// Uniform over [low, high), 53 bits.
  double Uniform(double low, double high) {
    return low + (high - low) * std::ldexp(static_cast<double>(Bits(53)), -53);
  }
  /// Log-uniform magnitude 2^[low, high) with a full significand and either sign, a value of T.
  template <class T>
  T LogUniform(int low, int high) {
    const double m = 1 + std::ldexp(static_cast<double>(Bits(52)), -52);
    const double x = std::ldexp(m, Integer(low, high - 1));
    return static_cast<T>(Coin() ? x : -x);
  }
  /// Any finite value of T, every bit pattern alike.
  template <class T>
  T AnyFinite() {
    for (;;) {
      const T x = std::bit_cast<T>(static_cast<BitsOf<T>>(engine_()));
      if (std::isfinite(x)) return x;
    }
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_TESTS_REFERENCE_RANDOM_VALUES_H_
