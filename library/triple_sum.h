// Exact sums of products of three doubles, in integers: the last tier of homogeneous edges.
#ifndef RASTERPROOF_LIBRARY_TRIPLE_SUM_H_
#define RASTERPROOF_LIBRARY_TRIPLE_SUM_H_

#include <array>
#include <cstddef>
#include <cstdint>

namespace rasterproof::library {

/// An accumulator of products of three doubles that loses nothing, in units of 2^-3222.
///
/// A double is m 2^e with |m| < 2^53 and -1074 <= e <= 971: a product of three is an integer below
/// 2^159 in units of 2^(3 * -1074), and ends below bit 3 (1074 + 971) + 159 = 6294. 200 limbs of 32
/// bits hold 6400 bits. Each limb is kept in 64 bits, so that 2^28 products can be added before
/// any carry has to move.
class TripleSum {
 public:
  /// Adds x y z.
  ///
  /// Domain:     finite.
  void Add(double x, double y, double z);
  /// Subtracts x y z.
  void Subtract(double x, double y, double z) { Add(-x, y, z); }

  /// -1, 0 or +1.
  int Sign() const;

 private:
  static constexpr std::size_t kLimbs = 200;
  std::array<std::int64_t, kLimbs> limbs_{};
};

}  // namespace rasterproof::library

#endif  // RASTERPROOF_LIBRARY_TRIPLE_SUM_H_
