// Comparing a floating-point value with an exact one, without rounding in between.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_EXACT_COMPARISON_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_EXACT_COMPARISON_H_

#include <optional>

#include "core/vertex.h"
#include "exact/rational.h"
#include "props/judging/values/estimate.h"

namespace rasterproof::props {

/// Whether |observed - exact| <= bound, decided exactly, and the quotient of both for the reader.
struct Distance {
  bool within = true;
  /// |observed - exact| / bound, rounded; 0 if both are 0, infinite if only the bound is.
  double ratio = 0;
};

/// Domain:     finite, non-negative bound; an observed value that is not finite is never within.
Distance CompareWithExact(double observed, const exact::Rational& exact,
                          const exact::Rational& bound);

/// The same, if the observed value is within the bound whatever the estimate misses; else nothing,
/// and CompareWithExact decides.
std::optional<Distance> CompareWithEstimate(double observed, const Estimate& estimate,
                                            double bound);

/// The same for the edge function E(a, b; p) as the exact value.
///
/// Domain:     finite points.
/// Cost:       a few dozen operations in double where they decide; rationals where they don't.
Distance CompareWithEdge(double observed, Point2 a, Point2 b, Point2 p, double bound);

/// Returns whether |x + sign * y| <= bound_x + bound_y, exactly. Not finite: false.
bool AgreeWithin(double x, double y, int sign, double bound_x, double bound_y);

/// Returns whether x is a number of this sign; both zeros have sign 0.
bool HasSign(double x, int sign);

/// Returns whether a subject's bound promises anything: it is a number, not NaN or infinity.
bool IsStated(double bound);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_EXACT_COMPARISON_H_
