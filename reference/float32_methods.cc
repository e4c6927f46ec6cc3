// Every float32 method of the table.
#include <vector>

#include "reference/float_rows.h"

namespace rasterproof::reference {
namespace {

using Direct = DirectForm<float>;
using Arithmetic = EdgeArithmetic;

}  // namespace

Method DirectMethod() {
  return FloatMethod<FreshWalk<Direct>, Arithmetic::kDirect>(
      "f32-direct", "two differences, two products, one difference, at every sample");
}

std::vector<Method> Float32Methods() {
  return {
      FloatMethod<FreshWalk<Direct>, Arithmetic::kDirect, EdgeOwnership::kInclusive>(
          "textbook",
          "five operations a sample, winding normalised, >= on all edges: shared edges are covered "
          "twice"),
      FloatMethod<CornerWalk<Direct>, Arithmetic::kIncremental>(
          "f32-incremental", "Pineda's increments: one addition a step from the box's corner"),
      FloatMethod<RowWalk<Direct>, Arithmetic::kIncrementalRow>(
          "f32-incremental-row", "increments started afresh on each row"),
      FloatMethod<AnchoredWalk<Direct>, Arithmetic::kIncremental16>(
          "f32-incremental-16", "increments started afresh at every 16th column"),
      FloatMethod<PlainIndexWalk<Direct>, Arithmetic::kIndex>(
          "f32-index", "the row's first value plus the column's index times dY"),
      FloatMethod<FusedIndexWalk<Direct>, Arithmetic::kIndexFma>("f32-index-fma",
                                                                 "the same with one fma"),
      DirectMethod(),
      FloatMethod<FreshWalk<DirectFmaForm<float>>, Arithmetic::kDirectFma>(
          "f32-direct-fma", "the direct form as compilers contract it: fma(-c, d, a * b)"),
      FloatMethod<FreshWalk<KahanForm<float>>, Arithmetic::kKahan>(
          "f32-kahan", "the direct form with Kahan's difference of products"),
      FloatMethod<FreshWalk<AffineForm<float>>, Arithmetic::kAffine>(
          "f32-affine", "A x + B y + C: loses accuracy far from the origin"),
      FloatMethod<FreshWalk<AffineFmaForm<float>>, Arithmetic::kAffineFma>(
          "f32-affine-fma", "A x + B y + C with every product fused"),
      FloatMethod<CompensatedWalk<Direct>, Arithmetic::kCompensated>(
          "f32-incremental-compensated",
          "Pineda's increments with what each addition loses kept apart"),
  };
}

}  // namespace rasterproof::reference
