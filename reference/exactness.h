// The exactness table: up to which box floating point makes no error at all, as data.
#ifndef RASTERPROOF_REFERENCE_EXACTNESS_H_
#define RASTERPROOF_REFERENCE_EXACTNESS_H_

#include <array>
#include <cstdint>
#include <string_view>

#include "reference/bounds.h"

namespace rasterproof::reference {

/// What is proved of a method where every corner and every sample evaluated lies on the grid 2^-s
/// pixel, in a box of side W. In steps of the grid. The affine form: corners and samples within
/// W + 384 of 0.
///
/// Source:     docs/mathematics.md, 8. Direct, fused and stepped forms: proofs/exactness.g (E and
///             its products are integers up to W^2, steps are differences of them). Kahan's: a
///             relative error of 2u on exact differences, which are integers up to W. Affine: with
///             W = 2048 C is at most 2 2432^2, the line's sum 2 2048 2432, and E less either of
///             its terms 2048^2 + 2048 2432, all below 2^24; the last sum is E.
struct ExactnessRow {
  std::string_view method;
  std::int64_t values = 0;  ///< largest W whose edge values are proved exact
  std::int64_t signs = 0;   ///< largest W whose decisions are proved right
  int columns_before = 0;   ///< a draw starts at most this many pixels before the box
};

inline constexpr std::int64_t kFloat32Box = 4096;      // 4096^2 = 2^24
inline constexpr std::int64_t kFloat32Affine = 2048;   // see above
inline constexpr std::int64_t kFloat64Box = 94906265;  // the largest whose square is below 2^53
inline constexpr std::int64_t kFloat32Differences = std::int64_t{1} << 24;
inline constexpr std::int64_t kFloat64Differences = std::int64_t{1} << 53;

// Of (V_j x V_i) . (p, 1) and det(V0, V1, V2), where x, y, w and p are whole numbers of at most N.
// A component of the product is at most 2 N^2, times p 2 N^3, the sum of two of these 4 N^3. The
// last sum is a determinant of entries up to N: affine in each, so at most 4 N^3, since 4 is the
// largest of entries +-1. 4 161^3 < 2^24, 4 (2^17)^3 = 2^53. Proof: proofs/exactness.g.
inline constexpr std::int64_t kFloat32Homogeneous = 161;
inline constexpr std::int64_t kFloat64Homogeneous = std::int64_t{1} << 17;

inline constexpr std::array kExactnessTable{
    ExactnessRow{"f32-incremental", kFloat32Box, kFloat32Box},
    ExactnessRow{"f32-incremental-row", kFloat32Box, kFloat32Box},
    ExactnessRow{"f32-incremental-16", kFloat32Box, kFloat32Box, kReanchorSteps - 1},
    ExactnessRow{"f32-index", kFloat32Box, kFloat32Box},
    ExactnessRow{"f32-index-fma", kFloat32Box, kFloat32Box},
    ExactnessRow{"f32-direct", kFloat32Box, kFloat32Box},
    ExactnessRow{"f32-direct-fma", kFloat32Box, kFloat32Box},
    ExactnessRow{"f32-kahan", kFloat32Box, kFloat32Differences},
    ExactnessRow{"f32-affine", kFloat32Affine, kFloat32Affine},
    ExactnessRow{"f32-affine-fma", kFloat32Affine, kFloat32Affine},
    ExactnessRow{"f32-incremental-compensated", kFloat32Box, kFloat32Box},
    ExactnessRow{"f64-incremental", kFloat64Box, kFloat64Box},
    ExactnessRow{"f64-direct", kFloat64Box, kFloat64Box},
    ExactnessRow{"f64-kahan", kFloat64Box, kFloat64Differences},
};

/// nullptr if the table has no row of that method.
constexpr const ExactnessRow* FindExactness(std::string_view method) {
  for (const ExactnessRow& row : kExactnessTable) {
    if (row.method == method) return &row;
  }
  return nullptr;
}

}  // namespace rasterproof::reference

#endif  // RASTERPROOF_REFERENCE_EXACTNESS_H_
