// What methods show of their edge values, with the bounds proved for them.
#ifndef RASTERPROOF_REFERENCE_EDGE_VALUES_H_
#define RASTERPROOF_REFERENCE_EDGE_VALUES_H_

#include <cmath>
#include <limits>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/evaluators.h"
#include "core/scene.h"
#include "library/exact_sign.h"
#include "reference/bounds.h"
#include "reference/edge_ownership.h"
#include "reference/edge_walks.h"
#include "reference/integer_form.h"

namespace rasterproof::reference {

/// Edge values of a floating-point walk; canonical: from the lexicographically smaller end.
template <class Walk_, EdgeArithmetic kArithmetic, bool kCanonical>
class FloatEdgeValues final : public EdgeEvaluator {
 public:
  double Value(Point2 a, Point2 b, Point2 p) const override {
    const auto at = Form::Convert(p);
    return FormOf(a, b).At(at.x, at.y);
  }
  double ErrorBound(Point2 a, Point2 b, Point2 p) const override {
    Order(a, b);
    return EdgeErrorBound(kArithmetic, kPrecision, a, b, p);
  }
  std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override {
    const auto at = Form::Convert(p);
    return Walk_::Values(FormOf(a, b), at.x, at.y, step, steps);
  }
  std::vector<double> SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                          int steps) const override {
    Order(a, b);
    return reference::SteppingErrorBounds(kArithmetic, kPrecision, a, b, p, step, steps);
  }

 private:
  using Form = typename Walk_::Form;
  static constexpr Precision kPrecision =
      std::is_same_v<typename Walk_::T, float> ? Precision::kFloat32 : Precision::kFloat64;

  /// Negation is exact, so the bound of the reversed edge is the edge's.
  static bool Order(Point2& a, Point2& b) {
    const bool reversed = kCanonical && RunsBackwards(a, b);
    if (reversed) std::swap(a, b);
    return reversed;
  }
  static Form FormOf(Point2 a, Point2 b) {
    const bool reversed = Order(a, b);
    return Form(Form::Convert(a), Form::Convert(b), reversed);
  }
};

/// Exact edge values, shown as the nearest double.
class ExactEdgeValues final : public EdgeEvaluator {
 public:
  double Value(Point2 a, Point2 b, Point2 p) const override;
  double ErrorBound(Point2 a, Point2 b, Point2 p) const override;
  std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override;
  std::vector<double> SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                          int steps) const override;
};

/// Edge values of snapped points in pixels squared, from integers inside the proven domain and from
/// exact sums outside.
///
/// Error:      0 for points on the grid while |E| < 2^53 units; points off the grid add what the
///             snap moves.
template <class I, int kBits>
class IntegerEdgeValues final : public EdgeEvaluator {
 public:
  double Value(Point2 a, Point2 b, Point2 p) const override;
  double ErrorBound(Point2 a, Point2 b, Point2 p) const override;
  std::vector<double> Steps(Point2 a, Point2 b, Point2 p, Step step, int steps) const override;
  std::vector<double> SteppingErrorBounds(Point2 a, Point2 b, Point2 p, Step step,
                                          int steps) const override;
};

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_EDGE_VALUES_H_
