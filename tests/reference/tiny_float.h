// Floating-point numbers of so few bits that a formula can be tried on all of them.
#ifndef RASTERPROOF_TESTS_REFERENCE_TINY_FLOAT_H_
#define RASTERPROOF_TESTS_REFERENCE_TINY_FLOAT_H_

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace rasterproof::reference::testing {

/// A binary floating-point number of p bits, without least or greatest exponent; rounds to nearest,
/// ties to even.
///
/// Domain:     p <= 12 and values within 2^+-400: sums, products and fused operations are exact in
///             double before they are rounded, and a quotient that double rounds is rounded right
///             (53 >= 2 p + 2).
template <int p>
class TinyFloat {
 public:
  static_assert(p >= 2 && p <= 12);

  constexpr TinyFloat() = default;
  constexpr explicit TinyFloat(double x) : value_(Rounded(x)) {}
  constexpr operator double() const {
    return value_;
  }  // NOLINT(google-explicit-constructor): exact

  constexpr TinyFloat operator-() const { return Exactly(-value_); }
  friend constexpr TinyFloat operator+(TinyFloat a, TinyFloat b) {
    return TinyFloat(a.value_ + b.value_);
  }
  friend constexpr TinyFloat operator-(TinyFloat a, TinyFloat b) {
    return TinyFloat(a.value_ - b.value_);
  }
  friend constexpr TinyFloat operator*(TinyFloat a, TinyFloat b) {
    return TinyFloat(a.value_ * b.value_);
  }
  friend constexpr TinyFloat operator/(TinyFloat a, TinyFloat b) {
    return TinyFloat(a.value_ / b.value_);
  }
  // NOLINTNEXTLINE(readability-identifier-naming): found in place of std::fma
  friend constexpr TinyFloat fma(TinyFloat a, TinyFloat b, TinyFloat c) {
    return TinyFloat(a.value_ * b.value_ + c.value_);
  }

  /// Zero, and both signs of every number of `binades` binades from [1, 2) up.
  static std::vector<TinyFloat> All(int binades) {
    std::vector<TinyFloat> all = NotNegative(binades);
    const std::size_t half = all.size();
    for (std::size_t k = 1; k < half; ++k) all.push_back(-all[k]);
    return all;
  }
  static std::vector<TinyFloat> NotNegative(int binades) {
    std::vector<TinyFloat> all{TinyFloat()};
    for (int binade = 0; binade < binades; ++binade) {
      for (int k = 0; k < 1 << (p - 1); ++k) {
        all.push_back(Exactly(std::ldexp(1 + std::ldexp(k, 1 - p), binade)));
      }
    }
    return all;
  }

 private:
  static constexpr TinyFloat Exactly(double x) {
    TinyFloat exact;
    exact.value_ = x;
    return exact;
  }
  // Adds half of the last place kept, or just less where that is even already, and cuts.
  static constexpr double Rounded(double x) {
    constexpr int kCut = 53 - p;
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t odd = (bits >> kCut) & 1;
    const std::uint64_t up = bits + (std::uint64_t{1} << (kCut - 1)) - 1 + odd;
    return std::bit_cast<double>(up >> kCut << kCut);
  }

  double value_ = 0;
};

}  // namespace rasterproof::reference::testing

template <int p>
struct std::numeric_limits<rasterproof::reference::testing::TinyFloat<p>> {
  static constexpr rasterproof::reference::testing::TinyFloat<p> epsilon() {
    return rasterproof::reference::testing::TinyFloat<p>(
        std::bit_cast<double>(static_cast<std::uint64_t>(1023 + 1 - p) << 52));
  }
};

#endif  // RASTERPROOF_TESTS_REFERENCE_TINY_FLOAT_H_
