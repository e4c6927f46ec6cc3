// Coordinates that come as integers: n.m fixed point, signed or not, wrapping or not.
#ifndef RASTERPROOF_CORE_FIXED_INPUT_H_
#define RASTERPROOF_CORE_FIXED_INPUT_H_

#include <cstdint>

namespace rasterproof {

/// The number format of a rasterizer that takes integers in units of 2^-m pixel.
///
/// The range is [-2^(n-1), 2^(n-1)) if signed, else [0, 2^n): n counts the sign.
/// Domain:     1 <= integer_bits <= kMaxIntegerBits; 0 <= fraction_bits <= kMaxSubpixelBits, so
///             that 64 of the ranges side by side are still exact in double.
struct FixedInput {
  int integer_bits = 12;
  int fraction_bits = 4;
  bool is_signed = true;
  /// Coordinates beyond the range are given too and taken modulo 2^n. Otherwise none is given.
  bool wraps = false;

  /// The number of pixels in the range, 2^n.
  double Span() const;
  /// Least coordinate of the range.
  double Least() const { return is_signed ? -Span() / 2 : 0; }
  /// Largest coordinate of the range: 2^-m short of its end.
  double Largest() const { return Least() + Span() - Step(); }
  /// 2^-m.
  double Step() const;
  bool InRange(double x) const { return x >= Least() && x <= Largest(); }
  /// Whether x can be given: a finite multiple of 2^-m, in range unless the format wraps.
  bool IsGiven(double x) const;
  /// x in units of 2^-m, not wrapped.
  ///
  /// Domain:     IsGiven(x), |x| < 2^(62 - fraction_bits).
  std::int64_t Raw(double x) const;

  friend bool operator==(const FixedInput&, const FixedInput&) = default;
};

inline constexpr int kMaxIntegerBits = 31;

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_FIXED_INPUT_H_
