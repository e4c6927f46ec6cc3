// A floating-point number that knows which roundings made it: the polynomial in their errors.
#ifndef RASTERPROOF_TESTS_REFERENCE_PERTURBED_H_
#define RASTERPROOF_TESTS_REFERENCE_PERTURBED_H_

#include <cmath>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <tuple>
#include <utility>
#include <vector>

#include "core/ulp.h"
#include "exact/rational.h"

namespace rasterproof::reference::testing {

/// What is known of one rounding's error.
struct Rounding {
  exact::Rational most;    ///< it is at most this in size, whatever the operands
  exact::Rational actual;  ///< it is this here
};

/// The roundings of the expression that runs: 16 at most. The same operation on the same numbers
/// rounds alike: it is one rounding.
class Roundings {
 public:
  /// An operation and its operands.
  using Key = std::tuple<char, double, double, double>;

  /// How an operation's error is stated.
  enum class Form : std::uint8_t {
    kRelative,  ///< fl(z) = z (1 + d), |d| <= u: what the proofs start from
    kHalfUlp    ///< fl(z) = z + e, |e| <= half an ulp of z, and 0 where z is a float
  };

  static void Clear(Form form) {
    all_.clear();
    numbers_.clear();
    form_ = form;
  }
  static Form HowStated() { return form_; }
  static const Rounding& At(std::size_t n) { return all_[n]; }
  static std::size_t Count() { return all_.size(); }

  static std::size_t Find(const Key& key, const Rounding& rounding) {
    const auto [place, is_new] = numbers_.emplace(key, all_.size());
    if (!is_new) return place->second;
    if (all_.size() == 16) throw std::length_error("An expression rounds more than 16 times.");
    if (rounding.actual.Abs() > rounding.most) throw std::logic_error("A rounding errs too much.");
    all_.push_back(rounding);
    return place->second;
  }

 private:
  inline static std::vector<Rounding> all_;
  inline static std::map<Key, std::size_t> numbers_;
  inline static Form form_ = Form::kRelative;
};

/// A polynomial in the errors of the roundings: the exponent of the n-th is digit n, base 16.
class Polynomial {
 public:
  Polynomial(const exact::Rational& constant) {  // NOLINT(google-explicit-constructor)
    Add(0, constant);
  }
  static Polynomial OfError(std::size_t n) {
    Polynomial error(0);
    error.Add(std::uint64_t{1} << (4 * n), 1);
    return error;
  }

  friend Polynomial operator+(Polynomial a, const Polynomial& b) {
    for (const auto& [powers, factor] : b.terms_) a.Add(powers, factor);
    return a;
  }
  friend Polynomial operator*(const Polynomial& a, const Polynomial& b) {
    Polynomial product(0);
    for (const auto& [powers_a, factor_a] : a.terms_) {
      for (const auto& [powers_b, factor_b] : b.terms_) {
        product.Add(powers_a + powers_b, factor_a * factor_b);
      }
    }
    return product;
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return a + b * Polynomial(-1);
  }

  /// What the expression is where nothing rounds.
  exact::Rational Exact() const {
    const auto constant = terms_.find(0);
    return constant == terms_.end() ? exact::Rational(0) : constant->second;
  }
  /// The most that roundings can make of it: the sum of the other terms' largest magnitudes.
  exact::Rational Deviation() const {
    exact::Rational sum;
    for (const auto& [powers, factor] : terms_) {
      if (powers != 0) sum += factor.Abs() * Product(powers, &Rounding::most);
    }
    return sum;
  }
  /// Its value with the errors that the roundings have here.
  exact::Rational Here() const {
    exact::Rational sum;
    for (const auto& [powers, factor] : terms_) sum += factor * Product(powers, &Rounding::actual);
    return sum;
  }

 private:
  void Add(std::uint64_t powers, const exact::Rational& factor) {
    exact::Rational& sum = terms_[powers];
    sum += factor;
    if (sum.Sign() == 0) terms_.erase(powers);
  }
  static exact::Rational Product(std::uint64_t powers, exact::Rational Rounding::* size) {
    exact::Rational product(1);
    for (std::size_t n = 0; powers != 0; ++n, powers >>= 4) {
      for (std::uint64_t k = 0; k < (powers & 15); ++k) product *= Roundings::At(n).*size;
    }
    return product;
  }

  std::map<std::uint64_t, exact::Rational> terms_;
};

/// A number of F beside the polynomial that it is: a template of a number type, run with this one,
/// writes down what its own operations round.
///
/// Domain:     no operation over- or underflows; Roundings::Clear() comes before an expression.
template <class F>
class Perturbed {
 public:
  Perturbed() : Perturbed(0.0) {}
  Perturbed(double exact)  // NOLINT(google-explicit-constructor): as a literal of F
      : value_(static_cast<F>(exact)), terms_(exact::Rational(value_)) {
    if (static_cast<double>(value_) != exact) throw std::invalid_argument("Not a number of F.");
  }

  F Value() const { return value_; }
  const Polynomial& Terms() const { return terms_; }

  Perturbed operator-() const { return {-value_, terms_ * Polynomial(-1)}; }
  friend Perturbed operator+(const Perturbed& a, const Perturbed& b) {
    return Rounded(a.value_ + b.value_, Rational(a.value_) + b.value_, a.terms_ + b.terms_,
                   {'+', a.value_, b.value_, 0});
  }
  friend Perturbed operator-(const Perturbed& a, const Perturbed& b) { return a + -b; }
  friend Perturbed operator*(const Perturbed& a, const Perturbed& b) {
    return Rounded(a.value_ * b.value_, Rational(a.value_) * b.value_, a.terms_ * b.terms_,
                   {'*', a.value_, b.value_, 0});
  }
  friend Perturbed operator/(const Perturbed& a, const Perturbed& b) {
    return Rounded(a.value_ / b.value_, Rational(a.value_) / b.value_, a.terms_ * b.Inverse(),
                   {'/', a.value_, b.value_, 0});
  }
  // NOLINTNEXTLINE(readability-identifier-naming): found in place of std::fma
  friend Perturbed fma(const Perturbed& a, const Perturbed& b, const Perturbed& c) {
    const Polynomial terms = a.terms_ * b.terms_ + c.terms_;
    const F value = std::fma(a.value_, b.value_, c.value_);
    // What a product's rounding leaves is a float.
    if (c.value_ == -(a.value_ * b.value_)) return {value, terms};
    return Rounded(value, Rational(a.value_) * b.value_ + c.value_, terms,
                   {'f', a.value_, b.value_, c.value_});
  }
  friend bool operator==(const Perturbed& a, const Perturbed& b) { return a.value_ == b.value_; }
  friend std::partial_ordering operator<=>(const Perturbed& a, const Perturbed& b) {
    return a.value_ <=> b.value_;
  }

 private:
  using Rational = exact::Rational;

  Perturbed(F value, Polynomial terms) : value_(value), terms_(std::move(terms)) {}

  static Perturbed Rounded(F value, const Rational& exact, const Polynomial& before,
                           const Roundings::Key& key) {
    const Rational error = Rational(value) - exact;
    if (Roundings::HowStated() == Roundings::Form::kHalfUlp) {
      if (error.Sign() == 0) return {value, before};
      return {value, before + Polynomial::OfError(Roundings::Find(key, {HalfUlp(exact), error}))};
    }
    const Rational relative = exact.Sign() == 0 ? Rational(0) : error / exact;
    const std::size_t n = Roundings::Find(key, {Rational(rounding_epsilon<F>()), relative});
    return {value, before + before * Polynomial::OfError(n)};
  }
  /// Half an ulp of z, from which floats are half an ulp of z or less apart.
  static Rational HalfUlp(const Rational& z) {
    int exponent = std::ilogb(z.ToDouble());
    while (Rational(std::ldexp(1.0, exponent)) > z.Abs()) --exponent;
    return {std::ldexp(1.0, exponent - std::numeric_limits<F>::digits)};
  }
  /// 1 / b = (1 + t) / b_0, |t| <= h / (1 - h) where b is within h |b_0| of b_0.
  Polynomial Inverse() const {
    const Rational exact = terms_.Exact();
    const Rational h = terms_.Deviation() / exact.Abs();
    const Polynomial inverse(Rational(1) / exact);
    if (h.Sign() == 0) return inverse;
    const Rounding rounding{h / (Rational(1) - h), exact / value_ - 1};
    return inverse + inverse * Polynomial::OfError(Roundings::Find({'i', value_, 0, 0}, rounding));
  }

  F value_;
  Polynomial terms_;
};

}  // namespace rasterproof::reference::testing

#endif  // RASTERPROOF_TESTS_REFERENCE_PERTURBED_H_
