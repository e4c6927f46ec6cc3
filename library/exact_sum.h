// Exact tier: sums of products of any finite doubles, in integers.
#ifndef RASTERPROOF_LIBRARY_EXACT_SUM_H_
#define RASTERPROOF_LIBRARY_EXACT_SUM_H_

#include <array>
#include <cstddef>
#include <cstdint>

namespace rasterproof::library {

/// An accumulator that loses nothing: positive and negative products apart, in units of 2^-2148.
///
/// A double is m 2^e with |m| < 2^53 and -1074 <= e <= 971, so a product of two is an integer below
/// 2^106 times 2^(e1 + e2), e1 + e2 >= -2148: in these units it ends below bit 2148 + 1942 + 106 =
/// 4196. 66 words of 64 bits hold 4224 bits, room for 2^28 products. Floating point over- or
/// underflow plays no part: nothing is computed in it.
class ExactSum {
 public:
  /// Adds x y, or subtracts it.
  ///
  /// Domain:     finite.
  void Add(double x, double y) { AddSigned(x, y, false); }
  void Subtract(double x, double y) { AddSigned(x, y, true); }

  /// -1, 0 or +1.
  int Sign() const;
  /// The nearest double, ties to even; infinity beyond the largest.
  double ToDouble() const;

 private:
  static constexpr std::size_t kWords = 66;
  using Words = std::array<std::uint64_t, kWords>;

  void AddSigned(double x, double y, bool negate);
  static int Compare(const Words& a, const Words& b);

  Words positive_{};
  Words negative_{};
};

}  // namespace rasterproof::library

#endif  // RASTERPROOF_LIBRARY_EXACT_SUM_H_
