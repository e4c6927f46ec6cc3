// Integers wide enough for every determinant of the fast path, on the stack.
#ifndef RASTERPROOF_EXACT_WIDE_INTEGER_H_
#define RASTERPROOF_EXACT_WIDE_INTEGER_H_

#include <array>
#include <cstdint>

namespace rasterproof::exact {

/// A finite double as sign * mantissa * 2^exponent with an odd mantissa (or 0).
struct Decoded {
  bool negative = false;
  std::uint64_t mantissa = 0;
  int exponent = 0;

  explicit Decoded(double x);
};

/// The largest exponent that divides all of `values` exactly: they are integers times 2^unit.
/// 0 if all are zero.
int CommonUnit(const std::array<double, 3>& values);

/// Sign and magnitude; only the limbs in use are touched.
///
/// Capacity: a double is below 2^1024 and a multiple of 2^-1074, hence below 2^2098 in that unit.
/// The largest value formed is a 3x3 determinant, a sum of six products of three: below
/// 6 * 2^6294 < 2^6297, which takes 99 limbs. A planar edge value takes 4199 bits.
/// Measured:   the largest determinant of entries below 2^1024 takes 99 limbs: MeasuredBounds,
///             2026-11-23.
class WideInteger {
 public:
  static constexpr int kLimbs = 99;

  WideInteger() = default;
  /// x / 2^unit, which must be an integer.
  WideInteger(double x, int unit);

  /// The limbs in use.
  int Limbs() const { return size_; }
  int Sign() const { return size_ == 0 ? 0 : (negative_ ? -1 : 1); }

  friend WideInteger operator-(const WideInteger& a, const WideInteger& b);
  friend WideInteger operator+(const WideInteger& a, const WideInteger& b);
  friend WideInteger operator*(const WideInteger& a, const WideInteger& b);
  /// The sign of a - b, without forming it.
  friend int Compare(const WideInteger& a, const WideInteger& b);

 private:
  // The limbs from size_ on are never read: 792 bytes that need no clearing.
  // NOLINTNEXTLINE(cppcoreguidelines-pro-type-member-init)
  std::array<std::uint64_t, kLimbs> limb_;
  int size_ = 0;  // no leading zero limb
  bool negative_ = false;

  void Trim() {
    while (size_ > 0 && limb_[static_cast<unsigned>(size_ - 1)] == 0) --size_;
  }
  static int CompareMagnitudes(const WideInteger& a, const WideInteger& b);
  static WideInteger AddSigned(const WideInteger& a, const WideInteger& b, bool b_negative);
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_WIDE_INTEGER_H_
