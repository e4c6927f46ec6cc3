// The hardest triangles whose corners and sample lie on a grid, from number theory.
#ifndef RASTERPROOF_BENCH_GRID_CASES_H_
#define RASTERPROOF_BENCH_GRID_CASES_H_

#include <vector>

#include "bench/parameter.h"

namespace rasterproof::bench {

/// Triangles with corners on the grid 2^-bits pixel whose larger side is `steps` of its steps and
/// whose sample lies at a corner of their box: |E| as small as the grid allows, with products as
/// large as the box allows; E = 0 at a vertex; and |E| as large as the box allows. On every side
/// of the sample, evaluated from either end.
///
/// Source:     extended Euclid: u dY - v dX = +-1 (docs/mathematics.md, 8).
std::vector<HardCase> GridCases(double steps, int bits);

/// Triangles of a box of `steps` steps of 2^-8 pixel whose edge values need the most bits.
std::vector<HardCase> ValueCases(double steps);

/// Triangles with corners on whole pixels whose larger side is `pixels` pixels, and a sample at
/// least a quarter of a pixel from every edge: a wrong answer there is no matter of rounding.
std::vector<HardCase> ExtentCases(double pixels);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_GRID_CASES_H_
