// An integer that stands for all values that it can take: for showing that code cannot overflow.
#ifndef RASTERPROOF_TESTS_REFERENCE_RANGED_H_
#define RASTERPROOF_TESTS_REFERENCE_RANGED_H_

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <vector>

namespace rasterproof::reference::testing {

__extension__ using Int128 = __int128;

/// A polynomial in variables of given ranges, of first degree in each: so its least and largest
/// values lie at corners of the ranges, and are taken there. A template of an integer type, run
/// with this one, says whether any of its operations leaves `kBits` bits, for all inputs at once.
///
/// Domain:     Begin() comes before an expression. A product of first degree no longer is refused.
///             Polynomials of less than 2^127.
template <int kBits>
class Ranged {
 public:
  /// Forgets all variables, and what overflowed.
  static void Begin() {
    ranges_.clear();
    has_overflowed_ = false;
  }
  static Ranged Variable(std::int64_t least, std::int64_t most) {
    ranges_.push_back({least, most});
    Ranged x(0);
    x.terms_[std::size_t{1} << (ranges_.size() - 1)] = 1;
    return x;
  }
  static bool HasOverflowed() { return has_overflowed_; }

  Ranged(std::int64_t constant) {  // NOLINT(google-explicit-constructor): as an integer is
    if (constant != 0) terms_[0] = constant;
  }

  Ranged operator-() const { return Ranged(0) - *this; }
  friend Ranged operator+(const Ranged& a, const Ranged& b) { return a.Plus(b, 1); }
  friend Ranged operator-(const Ranged& a, const Ranged& b) { return a.Plus(b, -1); }
  friend Ranged operator*(const Ranged& a, const Ranged& b) {
    Ranged product(0);
    for (const auto& [in_a, factor_a] : a.terms_) {
      for (const auto& [in_b, factor_b] : b.terms_) {
        if ((in_a & in_b) != 0) throw std::domain_error("Extremes need not lie at corners.");
        product.Add(in_a | in_b, factor_a * factor_b);
      }
    }
    return product.Checked();
  }
  /// The same polynomial.
  friend bool operator==(const Ranged&, const Ranged&) = default;

 private:
  struct Range {
    Int128 least, most;
  };

  Ranged Plus(const Ranged& other, int sign) const {
    Ranged sum = *this;
    for (const auto& [variables, factor] : other.terms_) sum.Add(variables, sign * factor);
    return sum.Checked();
  }
  void Add(std::size_t variables, Int128 factor) {
    Int128& sum = terms_[variables];
    sum += factor;
    if (sum == 0) terms_.erase(variables);
  }
  Ranged Checked() const {
    for (std::size_t corner = 0; corner < std::size_t{1} << ranges_.size(); ++corner) {
      const Int128 value = At(corner);
      const Int128 limit = Int128{1} << (kBits - 1);
      if (value < -limit || value >= limit) has_overflowed_ = true;
    }
    return *this;
  }
  /// Bit n of the corner: whether variable n is at its most.
  Int128 At(std::size_t corner) const {
    Int128 value = 0;
    for (const auto& [variables, factor] : terms_) {
      Int128 term = factor;
      for (std::size_t n = 0; n < ranges_.size(); ++n) {
        if (((variables >> n) & 1) == 0) continue;
        term *= ((corner >> n) & 1) != 0 ? ranges_[n].most : ranges_[n].least;
      }
      value += term;
    }
    return value;
  }

  inline static std::vector<Range> ranges_;
  inline static bool has_overflowed_ = false;

  std::map<std::size_t, Int128> terms_;  ///< factors, by the set of variables as bits
};

}  // namespace rasterproof::reference::testing

#endif  // RASTERPROOF_TESTS_REFERENCE_RANGED_H_
