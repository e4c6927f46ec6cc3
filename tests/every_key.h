// A profile that says something by every key.
#ifndef RASTERPROOF_TESTS_EVERY_KEY_H_
#define RASTERPROOF_TESTS_EVERY_KEY_H_

#include "core/profile.h"

namespace rasterproof {

/// Returns a profile each of whose members differs from that of Profile{}. With another member this
/// does not compile: give it a value here, and its key a row in core/profile_keys.h.
inline Profile EveryKeySet() {
  Profile profile;
  auto& [name, specification, snap, scanline_rounding, pattern, sample_positions, centroid, y_axis,
         tie_rule, front_face, contract, freedom, transform, coordinate_limit, degenerate_triangles,
         infinite_vertex, nan_vertex, nan_z, translation_invariant, shares_edge_samples,
         by_target_size, fixed, max_primitive_extent, guard_band, squares] = profile;
  auto& [bits, rule, form, origin] = snap;
  auto& [snap_tolerance, any_rounding, least_bits, ties, transform_error] = freedom;
  name = "every key";
  specification = "d3d11";
  bits = 5;
  rule = SnapRule::kHalfUp;
  form = SnapForm::kExactDifference;
  origin = 0.25;
  scanline_rounding = {7, SnapRule::kFloor, SnapForm::kExactDifference, 0.5};
  pattern = {{{0.125, 0.875}, {0.5, 0.25}}};
  sample_positions = SamplePositions::kFixed;
  centroid = Centroid::kInside;
  y_axis = YAxis::kUp;
  tie_rule = {+1, -1, true};
  front_face = FrontFace::kUnstated;
  contract = Contract::kSquares;
  snap_tolerance = 0.625;
  any_rounding = true;
  least_bits = 3;
  ties = TieOwnership::kPerEdge;
  transform_error = 1.5;
  transform = {Precision::kFloat64, Division::kReciprocal, ViewportForm::kNone, false,
               MapGrid{8, 9, 0.5, -0.5}};
  coordinate_limit = 4096;
  degenerate_triangles = DegenerateTriangles::kUnspecified;
  infinite_vertex = InfiniteVertex::kUnspecified;
  nan_vertex = NanVertex::kUnspecified;
  nan_z = NanZ::kNothing;
  translation_invariant = true;
  shares_edge_samples = true;
  by_target_size = {{.max_width = 64, .snap = {6}, .pattern = {{{0, 0}, {0.5, 0.5}}}},
                    {.snap = snap, .pattern = pattern, .tie_rule = {.inclusive = true}}};
  fixed = {12, 4, false, true};
  max_primitive_extent = {1023, 511};
  guard_band = AroundTarget{64};
  squares = {SquareRegion{.half_width = 0.25}, std::nullopt, FlatSquares::kDrawn};
  return profile;
}

}  // namespace rasterproof

#endif  // RASTERPROOF_TESTS_EVERY_KEY_H_
