// Judging wireframe distances inside the closed triangle.
#ifndef RASTERPROOF_PROPS_JUDGING_VALUES_WIREFRAME_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_VALUES_WIREFRAME_QUERIES_H_

#include <string>

#include "core/evaluators.h"
#include "exact/rational.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/estimate.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// A form's statement at one edge, in rationals or estimated: `scale` times lambda_i is the
/// distance it measures. NaN where an estimate leaves open how it is rounded.
template <class N>
struct WireframeScale {
  N square;          ///< of the exact distance
  double scale = 0;  ///< distance per unit of lambda_i, rounded
};

/// The nearest double, and the square root to within a few roundings: for scales and tolerances,
/// not for verdicts. NaN where an estimate leaves it open.
double Nearest(const exact::Rational& x);
double Nearest(const Estimate& x);
double RoundedRoot(const exact::Rational& square);
double RoundedRoot(const Estimate& square);

/// Whether |observed - sqrt(square)| <= bound, decided by squares.
bool IsWithin(double observed, const exact::Rational& square, double bound);
/// Whether that holds for any square of which this is the RoundedRoot, which is within 2^-52 of the
/// root, relatively.
bool IsSurelyWithin(double observed, double rounded_root, double bound);

/// What a form means: the same formula in both kinds of numbers.
struct WireframeMeaning {
  WireframeScale<exact::Rational> (*exact)(const BarycentricQuery& q, int edge);
  WireframeScale<Estimate> (*estimated)(const BarycentricQuery& q, int edge);
};

/// Asks for the distances in the closed triangle. Holds if they mean what `meaning` says, up to
/// (2 bound_i + kWireframeErrorMultiplier u |lambda_i|) scale + the least subnormal, where bound_i
/// is the bound stated for barycentric i over the vertex area.
Checks AskDistances(const PlacedCase& c, const Description& subject, WireframeForm form,
                    WireframeMeaning meaning, std::string property);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_VALUES_WIREFRAME_QUERIES_H_
