// A row of the table for one floating-point walk.
#ifndef RASTERPROOF_REFERENCE_FLOAT_ROWS_H_
#define RASTERPROOF_REFERENCE_FLOAT_ROWS_H_

#include <string_view>
#include <type_traits>

#include "reference/edge_forms.h"
#include "reference/edge_values.h"
#include "reference/edge_walks.h"
#include "reference/fill.h"
#include "reference/method_rows.h"
#include "reference/proved.h"

namespace rasterproof::reference {

template <RowWalking Walk, EdgeArithmetic kArithmetic,
          EdgeOwnership kTies = EdgeOwnership::kTopLeft>
Method FloatMethod(std::string_view name, std::string_view summary) {
  static const FloatEdgeValues<Walk, kArithmetic, false> own_direction;
  static const FloatEdgeValues<Walk, kArithmetic, true> canonical;
  constexpr bool kSingle = std::is_same_v<typename Walk::T, float>;
  Method method = WindowMethod(name, summary, kSingle ? Precision::kFloat32 : Precision::kFloat64);
  // The bound of an edge is that of the edge reversed: canonical edges share the proofs.
  method.info.proofs = EdgeProofs(kArithmetic);
  method.can_be_canonical = true;
  method.steps_from_corner = kStepsFromCorner<Walk>;
  method.stages.facing = &FacingBy<typename Walk::Form>;
  method.stages.fill = &FillByWalk<Walk, kTies>;
  method.edges = &own_direction;
  method.canonical_edges = &canonical;
  return method;
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_FLOAT_ROWS_H_
