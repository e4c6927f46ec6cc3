// An exact rational number. Only its backend includes a Boost header.
#ifndef RASTERPROOF_EXACT_RATIONAL_H_
#define RASTERPROOF_EXACT_RATIONAL_H_

#include <compare>
#include <memory>
#include <string>

namespace rasterproof::exact {

/// A rational number of unbounded size.
///
/// Cost:       allocates; for verdicts and explanations, not for inner loops.
class Rational {
 public:
  Rational();
  /// Domain:     finite. The value is taken exactly.
  Rational(double value);  // NOLINT(google-explicit-constructor): a double *is* a rational
  Rational(const Rational& other);
  Rational(Rational&& other) noexcept;
  Rational& operator=(const Rational& other);
  Rational& operator=(Rational&& other) noexcept;
  ~Rational();

  Rational operator-() const;
  Rational& operator+=(const Rational& other);
  Rational& operator-=(const Rational& other);
  Rational& operator*=(const Rational& other);
  /// Domain:     other != 0.
  Rational& operator/=(const Rational& other);
  friend Rational operator+(Rational a, const Rational& b) { return a += b; }
  friend Rational operator-(Rational a, const Rational& b) { return a -= b; }
  friend Rational operator*(Rational a, const Rational& b) { return a *= b; }
  friend Rational operator/(Rational a, const Rational& b) { return a /= b; }

  /// -1, 0 or +1.
  int Sign() const;
  Rational Abs() const;
  friend bool operator==(const Rational& a, const Rational& b) { return Compare(a, b) == 0; }
  friend std::strong_ordering operator<=>(const Rational& a, const Rational& b) {
    return Compare(a, b) <=> 0;
  }

  /// The nearest double / float, ties to even; overflow gives infinity, subnormals are rounded
  /// once.
  double ToDouble() const;
  float ToFloat() const;
  /// The smallest double that is not below the value.
  double ToDoubleUp() const;
  /// "3", "-7/2".
  std::string ToString() const;

 private:
  static int Compare(const Rational& a, const Rational& b);
  struct Storage;
  std::unique_ptr<Storage> storage_;
};

}  // namespace rasterproof::exact

#endif  // RASTERPROOF_EXACT_RATIONAL_H_
