// Edge evaluation along rows: what a kernel does between one sample and the next.
//
// A walk is built from a form and the corner of the triangle's box. RowStart(j), with j never
// decreasing, gives a cursor at the box's first column of row j; Value(i) is E at column i, which
// is where Next and Skip have brought the cursor. Where a walk starts depends on the triangle and
// the target only, never on tile, scissor or thread: so neither does what it rounds to.
//
// Values(form, x, y, step, steps) is the same walk from any point in any of the eight directions.
#ifndef RASTERPROOF_REFERENCE_EDGE_WALKS_H_
#define RASTERPROOF_REFERENCE_EDGE_WALKS_H_

#include <cmath>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/evaluators.h"
#include "reference/bounds.h"
#include "reference/edge_forms.h"

namespace rasterproof::reference {

/// A running sum of steps: each Add adds one.
template <class S, class T>
concept StepSum = std::constructible_from<S, T> && requires(S sum, const S& said, T step) {
  sum.Add(step);
  { said.Rounded() } -> std::same_as<T>;
};

/// A way along the rows of a box.
///
/// Domain:     RowStart(j) for rows j that never decrease, from the row that the walk was built at.
/// Returns:    a cursor at the box's first column; Value(i) is E at column i, which is where Next
///             (one column) and Skip (n columns) have brought it.
template <class W>
concept RowWalking =
    EdgeForm<typename W::Form> && std::constructible_from<W, const typename W::Form&, int, int> &&
    requires(W walk, typename W::Cursor cursor, const typename W::Cursor& at, int n) {
      { walk.RowStart(n) } -> std::same_as<typename W::Cursor>;
      { at.Value(n) } -> std::same_as<typename W::T>;
      cursor.Next();
      cursor.Skip(n);
    };

/// Rounds each addition.
template <class T>
struct PlainSum {
  T sum;
  PlainSum(T start) : sum(start) {}  // NOLINT(google-explicit-constructor)
  void Add(T step) { sum = sum + step; }
  T Rounded() const { return sum; }
};

/// Keeps what each addition rounds away in a second word (Knuth's TwoSum), which is itself rounded
/// but never renormalised.
template <class T>
struct CompensatedSum {
  T sum;
  T lost = 0;
  CompensatedSum(T start) : sum(start) {}  // NOLINT(google-explicit-constructor)
  void Add(T step) {
    const T next = sum + step;
    const T part = next - sum;
    lost = lost + ((sum - (next - part)) + (step - part));
    sum = next;
  }
  T Rounded() const { return sum + lost; }
};

/// Signed distance in pixels of n steps.
template <class T>
T StepsInPixels(const Step& step, int n) {
  return static_cast<T>(std::int64_t{step.sign} * step.length * n);
}

/// What one step adds: +-L dY or -+L dX, the product rounded once.
template <SteppedForm Form>
typename Form::Scalar StepValue(const Form& form, const Step& step) {
  using T = typename Form::Scalar;
  return StepsInPixels<T>(step, 1) * (step.along_y ? form.StepY() : form.StepX());
}

/// E evaluated afresh at the n-th point of a walk.
template <EdgeForm Form>
typename Form::Scalar FreshValue(const Form& form, typename Form::Scalar x, typename Form::Scalar y,
                                 const Step& step, int n) {
  const auto moved = StepsInPixels<typename Form::Scalar>(step, n);
  return step.along_y ? form.At(x, y + moved) : form.At(x + moved, y);
}

/// E evaluated afresh at every sample.
template <EdgeForm F>
class FreshWalk {
 public:
  using Form = F;
  using T = typename F::Scalar;
  struct Cursor {
    F form;
    T y;
    T Value(int i) const { return form.At(F::Centre(i), y); }
    void Next() {}
    void Skip(int) {}
  };

  FreshWalk(const F& form, int, int) : form_(form) {}
  Cursor RowStart(int j) const { return {form_, F::Centre(j)}; }

  static std::vector<double> Values(const F& form, T x, T y, const Step& step, int steps) {
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(steps) + 1);
    for (int n = 0; n <= steps; ++n) values.push_back(FreshValue(form, x, y, step, n));
    return values;
  }

 private:
  F form_;
};

/// Pineda's increments: E once at the box's corner, additions from there on, down and across.
template <SteppedForm F, template <class> class Sum = PlainSum>
  requires StepSum<Sum<typename F::Scalar>, typename F::Scalar>
class CornerWalk {
 public:
  using Form = F;
  using T = typename F::Scalar;
  struct Cursor {
    Sum<T> e;
    T step;
    T Value(int) const { return e.Rounded(); }
    void Next() { e.Add(step); }
    void Skip(int n) {
      while (n-- > 0) Next();
    }
  };

  CornerWalk(const F& form, int x0, int y0)
      : row_(y0),
        start_(form.At(F::Centre(x0), F::Centre(y0))),
        step_x_(form.StepX()),
        step_y_(form.StepY()) {}
  Cursor RowStart(int j) {
    for (; row_ < j; ++row_) start_.Add(step_y_);
    return {start_, step_x_};
  }

  static std::vector<double> Values(const F& form, T x, T y, const Step& step, int steps) {
    const T add = StepValue(form, step);
    Sum<T> e(form.At(x, y));
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(steps) + 1);
    for (int n = 0; n <= steps; ++n, e.Add(add)) values.push_back(e.Rounded());
    return values;
  }

 private:
  int row_;
  Sum<T> start_;
  T step_x_, step_y_;
};

template <SteppedForm F>
using CompensatedWalk = CornerWalk<F, CompensatedSum>;

template <class Walk>
inline constexpr bool kStepsFromCorner = false;
template <class F, template <class> class Sum>
inline constexpr bool kStepsFromCorner<CornerWalk<F, Sum>> = true;

/// E afresh at the first column of each row, additions across.
template <SteppedForm F>
class RowWalk {
 public:
  using Form = F;
  using T = typename F::Scalar;
  using Cursor = typename CornerWalk<F>::Cursor;

  RowWalk(const F& form, int x0, int) : form_(form), x0_(x0) {}
  Cursor RowStart(int j) const { return {form_.At(F::Centre(x0_), F::Centre(j)), form_.StepX()}; }

  static std::vector<double> Values(const F& form, T x, T y, const Step& step, int steps) {
    return step.along_y ? FreshWalk<F>::Values(form, x, y, step, steps)
                        : CornerWalk<F>::Values(form, x, y, step, steps);
  }

 private:
  F form_;
  int x0_;
};

/// E afresh at every column that is a multiple of 16, additions between. The anchors belong to the
/// target, not to the triangle: with canonical edges both triangles of a shared edge see one
/// number.
template <SteppedForm F>
class AnchoredWalk {
 public:
  using Form = F;
  using T = typename F::Scalar;
  struct Cursor {
    F form;
    T y;
    int column;
    T e;
    Cursor(const F& f, T row, int i) : form(f), y(row), column(i) { Anchor(); }
    T Value(int) const { return e; }
    void Next() {
      ++column;
      e = column % kReanchorSteps == 0 ? form.At(F::Centre(column), y) : e + form.StepX();
    }
    void Skip(int n) {
      column += n;
      Anchor();
    }
    void Anchor() {
      const int anchor = column - column % kReanchorSteps;
      e = form.At(F::Centre(anchor), y);
      for (int i = anchor; i < column; ++i) e = e + form.StepX();
    }
  };

  AnchoredWalk(const F& form, int x0, int) : form_(form), x0_(x0) {}
  Cursor RowStart(int j) const { return {form_, F::Centre(j), x0_}; }

  /// From any point every 16th step starts afresh.
  static std::vector<double> Values(const F& form, T x, T y, const Step& step, int steps) {
    const T add = StepValue(form, step);
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(steps) + 1);
    T e = 0;
    for (int n = 0; n <= steps; ++n) {
      e = n % kReanchorSteps == 0 ? FreshValue(form, x, y, step, n) : e + add;
      values.push_back(e);
    }
    return values;
  }

 private:
  F form_;
  int x0_;
};

template <class T>
struct ProductThenSum {
  static T Apply(T n, T step, T start) { return start + n * step; }
};
template <class T>
struct FusedSum {
  static T Apply(T n, T step, T start) { return std::fma(n, step, start); }
};

/// E at the row's first column plus the column's index times dY: no step depends on the one before.
template <SteppedForm F, template <class> class Sum>
class IndexWalk {
 public:
  using Form = F;
  using T = typename F::Scalar;
  struct Cursor {
    T start;
    T step;
    int x0;
    T Value(int i) const { return Sum<T>::Apply(static_cast<T>(i - x0), step, start); }
    void Next() {}
    void Skip(int) {}
  };

  IndexWalk(const F& form, int x0, int) : form_(form), x0_(x0) {}
  Cursor RowStart(int j) const {
    return {form_.At(F::Centre(x0_), F::Centre(j)), form_.StepX(), x0_};
  }

  static std::vector<double> Values(const F& form, T x, T y, const Step& step, int steps) {
    const T start = form.At(x, y);
    const T one_pixel = step.along_y ? form.StepY() : form.StepX();
    std::vector<double> values;
    values.reserve(static_cast<std::size_t>(steps) + 1);
    for (int n = 0; n <= steps; ++n) {
      values.push_back(Sum<T>::Apply(StepsInPixels<T>(step, n), one_pixel, start));
    }
    return values;
  }

 private:
  F form_;
  int x0_;
};

template <SteppedForm F>
using PlainIndexWalk = IndexWalk<F, ProductThenSum>;
template <SteppedForm F>
using FusedIndexWalk = IndexWalk<F, FusedSum>;

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_EDGE_WALKS_H_
