// A floating-point number that knows which roundings made it: the polynomial in their errors.
#ifndef RASTERPROOF_TESTS_REFERENCE_PERTURBED_H_
#define RASTERPROOF_TESTS_REFERENCE_PERTURBED_H_

#include <array>
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

/// The roundings of the expression that runs: kMost at most. The same operation on the same numbers
/// rounds alike: it is one rounding.
class Roundings {
 public:
  static constexpr std::size_t kMost = 32;
  /// An operation and its operands.
  using Key = std::tuple<char, double, double, double>;

  /// How an operation's error is stated.
  enum class Form : std::uint8_t {
    kRelative,  ///< fl(z) = z (1 + d), |d| <= u: what the proofs start from
    kHalfUlp,   ///< fl(z) = z + e, |e| <= half an ulp of z, and 0 where z is a float
    kOfResult   ///< z = fl(z) (1 + d), |d| <= u: polynomials are of exact values, their constants
                ///< what is computed. No quotients.
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
    if (all_.size() == kMost) throw std::length_error("An expression rounds too often.");
    if (rounding.actual.Abs() > rounding.most) throw std::logic_error("A rounding errs too much.");
    all_.push_back(rounding);
    return place->second;
  }

 private:
  inline static std::vector<Rounding> all_;
  inline static std::map<Key, std::size_t> numbers_;
  inline static Form form_ = Form::kRelative;
};

/// A polynomial in the errors of the roundings.
class Polynomial {
 public:
  Polynomial(const exact::Rational& constant) {  // NOLINT(google-explicit-constructor)
    Add({}, constant);
  }
  static Polynomial OfError(std::size_t n) {
    Polynomial error(0);
    Powers once{};
    once[n] = 1;
    error.Add(once, 1);
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
        Powers powers = powers_a;
        for (std::size_t n = 0; n < powers.size(); ++n) {
          powers[n] = static_cast<std::uint8_t>(powers[n] + powers_b[n]);
        }
        product.Add(powers, factor_a * factor_b);
      }
    }
    return product;
  }
  friend Polynomial operator-(const Polynomial& a, const Polynomial& b) {
    return a + b * Polynomial(-1);
  }

  bool IsZero() const { return terms_.empty(); }
  /// What the expression is where nothing rounds.
  exact::Rational Exact() const {
    const auto constant = terms_.find(Powers{});
    return constant == terms_.end() ? exact::Rational(0) : constant->second;
  }
  /// The most that roundings can make of it: the sum of the other terms' largest magnitudes.
  exact::Rational Deviation() const {
    exact::Rational sum;
    for (const auto& [powers, factor] : terms_) {
      if (powers != Powers{}) sum += factor.Abs() * Product(powers, &Rounding::most);
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
  using Powers = std::array<std::uint8_t, Roundings::kMost>;  ///< of each error

  void Add(const Powers& powers, const exact::Rational& factor) {
    exact::Rational& sum = terms_[powers];
    sum += factor;
    if (sum.Sign() == 0) terms_.erase(powers);
  }
  static exact::Rational Product(const Powers& powers, exact::Rational Rounding::* size) {
    exact::Rational product(1);
    for (std::size_t n = 0; n < Roundings::Count(); ++n) {
      for (int k = 0; k < powers[n]; ++k) product *= Roundings::At(n).*size;
    }
    return product;
  }

  std::map<Powers, exact::Rational> terms_;
};

/// A number of F beside the polynomial that it is: a template of a number type, run with this one,
/// writes down what its own operations round.
///
/// Domain:     no operation overflows; Roundings::Clear() comes before an expression. A product
///             that underflows errs by half of the smallest subnormal eta, whatever its size, and a
///             sum by nothing: of them, and with half ulps, the first is refused.
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
    if (a.terms_.IsZero()) return b;  // 0 + b is never rounded
    return Rounded(a.value_ + b.value_, Rational(a.value_) + b.value_, a.terms_ + b.terms_,
                   {'+', a.value_, b.value_, 0});
  }
  friend Perturbed operator-(const Perturbed& a, const Perturbed& b) { return a + -b; }
  friend Perturbed operator*(const Perturbed& a, const Perturbed& b) {
    return Rounded(a.value_ * b.value_, Rational(a.value_) * b.value_, a.terms_ * b.terms_,
                   {'*', a.value_, b.value_, 0});
  }
  friend Perturbed operator/(const Perturbed& a, const Perturbed& b) {
    if (Roundings::HowStated() == Roundings::Form::kOfResult) throw std::logic_error("A quotient.");
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
  // NOLINTNEXTLINE(readability-identifier-naming): found in place of std::fabs
  friend Perturbed fabs(const Perturbed& a) { return a.value_ < 0 ? -a : a; }
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
    const bool is_of_result = Roundings::HowStated() == Roundings::Form::kOfResult;
    // fl(z) - error is z, of which `before` is the polynomial.
    const Polynomial start = is_of_result ? before + Polynomial(error) : before;
    if (exact.Sign() != 0 && exact.Abs() < std::numeric_limits<F>::min()) {
      if (std::get<char>(key) == '+') return {value, start};
      const Rational half_eta = Rational(std::numeric_limits<F>::denorm_min()) / 2;
      const std::size_t n = Roundings::Find(key, {half_eta, is_of_result ? -error : error});
      return {value, start + Polynomial::OfError(n)};
    }
    const Rational u(rounding_epsilon<F>());
    if (is_of_result) {
      const Rational relative = value == 0 ? Rational(0) : -error / value;
      return {value,
              start + Polynomial(value) * Polynomial::OfError(Roundings::Find(key, {u, relative}))};
    }
    const Rational relative = exact.Sign() == 0 ? Rational(0) : error / exact;
    return {value, start + start * Polynomial::OfError(Roundings::Find(key, {u, relative}))};
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
