// Judging wireframe distances inside the closed triangle.
#ifndef RASTERPROOF_PROPS_JUDGING_WIREFRAME_QUERIES_H_
#define RASTERPROOF_PROPS_JUDGING_WIREFRAME_QUERIES_H_

#include <optional>
#include <string>

#include "core/evaluators.h"
#include "exact/rational.h"
#include "props/judging/barycentric_queries.h"
#include "props/placed_case.h"
#include "props/property.h"

namespace rasterproof::props {

/// A form's statement at one edge: `scale` times lambda_i is the distance it measures.
struct WireframeScale {
  exact::Rational exact_square;  ///< square of the exact distance
  double scale = 0;              ///< distance per unit of lambda_i, rounded
};

/// The square root to within a few roundings: for scales and tolerances, not for verdicts.
double RoundedRoot(const exact::Rational& square);

/// Nothing if the edge has no length.
using WireframeMeaning = std::optional<WireframeScale> (*)(const BarycentricQuery& q, int edge);

/// Asks for the distances in the closed triangle. Holds if they mean what `meaning` says, up to
/// (2 bound_i + kWireframeErrorMultiplier u |lambda_i|) scale + the least subnormal, where bound_i
/// is the bound stated for barycentric i over the vertex area.
Checks AskDistances(const PlacedCase& c, const Description& subject, WireframeForm form,
                    WireframeMeaning meaning, std::string property);

}  // namespace rasterproof::props

#endif  // RASTERPROOF_PROPS_JUDGING_WIREFRAME_QUERIES_H_
