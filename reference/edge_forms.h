// Edge evaluation: the ways to compute E(a, b; p) afresh at a point.
//
// A form is built once per edge and holds what does not depend on p. `reversed` negates the edge
// without swapping its ends: rounding to nearest is symmetric, so every form gives exactly the
// negative of its unreversed value, which is what canonical edges rest on.
//
// fma is called by its bare name: a number type other than float and double brings its own.
#ifndef RASTERPROOF_REFERENCE_EDGE_FORMS_H_
#define RASTERPROOF_REFERENCE_EDGE_FORMS_H_

#include <cmath>
#include <concepts>

#include "core/vertex.h"

namespace rasterproof::reference {

/// An edge form: built once an edge, evaluated at any point.
///
/// Domain:     Convert takes what the form's header allows; Centre(n), n < 2^16, is exact.
/// Properties: Form(b, a, true) is E(a, b; .) evaluated from b: its values are exactly the
/// negatives
///             of those of Form(b, a, false).
template <class F>
concept EdgeForm = std::constructible_from<F, typename F::Point, typename F::Point, bool> &&
                   requires(const F& form, typename F::Scalar x, Point2 p, int n) {
                     { F::Convert(p) } -> std::same_as<typename F::Point>;
                     { F::Centre(n) } -> std::same_as<typename F::Scalar>;
                     { form.At(x, x) } -> std::same_as<typename F::Scalar>;
                   };

/// A form that can also be stepped: E(x + 1, y) - E(x, y) and E(x, y + 1) - E(x, y).
template <class F>
concept SteppedForm = EdgeForm<F> && requires(const F& form) {
  { form.StepX() } -> std::same_as<typename F::Scalar>;
  { form.StepY() } -> std::same_as<typename F::Scalar>;
};

/// A point in the number format of a kernel.
template <class T>
struct PointOf {
  T x;
  T y;
};

/// What all floating-point forms share: the anchor a and the direction (dX, dY) = +-(b - a).
///
/// Source:     Pineda, A Parallel Algorithm for Polygon Rasterization, SIGGRAPH 1988.
template <class T>
class FloatForm {
 public:
  using Scalar = T;
  using Point = PointOf<T>;

  FloatForm(Point a, Point b, bool reversed)
      : x_(a.x),
        y_(a.y),
        dx_(reversed ? a.x - b.x : b.x - a.x),
        dy_(reversed ? a.y - b.y : b.y - a.y) {}

  static Point Convert(Point2 p) { return {static_cast<T>(p.x), static_cast<T>(p.y)}; }
  /// The centre of column or row n. Exact: n < 2^16.
  static T Centre(int n) { return static_cast<T>(n) + T{0.5}; }
  /// E(x + 1, y) - E(x, y) and E(x, y + 1) - E(x, y), as rounded once each.
  T StepX() const { return dy_; }
  T StepY() const { return -dx_; }

 protected:
  T x_, y_, dx_, dy_;
};

/// Five operations: two differences of the sample, two products, one difference.
template <class T>
class DirectForm : public FloatForm<T> {
 public:
  using FloatForm<T>::FloatForm;
  T At(T x, T y) const { return (x - this->x_) * this->dy_ - (y - this->y_) * this->dx_; }
};

/// The direct form as compilers contract it: the second product is never rounded.
template <class T>
class DirectFmaForm : public FloatForm<T> {
 public:
  using FloatForm<T>::FloatForm;
  T At(T x, T y) const {
    using std::fma;
    return fma(-(y - this->y_), this->dx_, (x - this->x_) * this->dy_);
  }
};

/// Kahan's difference of products: its sign is right wherever the four differences are exact.
///
/// Source:     Jeannerod, Louvet, Muller, Further analysis of Kahan's algorithm, Math. Comp. 2013.
template <class T>
class KahanForm : public FloatForm<T> {
 public:
  using FloatForm<T>::FloatForm;
  T At(T x, T y) const {
    using std::fma;
    const T product = (y - this->y_) * this->dx_;
    const T product_error = fma(-(y - this->y_), this->dx_, product);
    return fma(x - this->x_, this->dy_, -product) + product_error;
  }
};

/// A x + B y + C with A = dY, B = -dX, C = bx ay - ax by: cheap, and inaccurate far from the
/// origin.
template <class T>
class AffineForm : public FloatForm<T> {
 public:
  using Point = typename FloatForm<T>::Point;
  AffineForm(Point a, Point b, bool reversed)
      : FloatForm<T>(a, b, reversed), c_(Negated(b.x * a.y - a.x * b.y, reversed)) {}
  T At(T x, T y) const { return (this->dy_ * x - this->dx_ * y) + c_; }

 protected:
  AffineForm(Point a, Point b, bool reversed, T c)
      : FloatForm<T>(a, b, reversed), c_(Negated(c, reversed)) {}
  static T Negated(T value, bool negate) { return negate ? -value : value; }
  T c_;
};

/// The affine form with every product fused into the sum that follows it.
template <class T>
class AffineFmaForm : public AffineForm<T> {
 public:
  using Point = typename FloatForm<T>::Point;
  AffineFmaForm(Point a, Point b, bool reversed) : AffineForm<T>(a, b, reversed, Constant(a, b)) {}
  T At(T x, T y) const {
    using std::fma;
    return fma(this->dy_, x, fma(-this->dx_, y, this->c_));
  }

 private:
  static T Constant(Point a, Point b) {
    using std::fma;
    return fma(b.x, a.y, -(a.x * b.y));
  }
};

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_EDGE_FORMS_H_
