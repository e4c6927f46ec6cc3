// Triangles with an edge that passes a sample as nearly as floats allow.
#ifndef RASTERPROOF_BENCH_EDGE_CASES_H_
#define RASTERPROOF_BENCH_EDGE_CASES_H_

#include <vector>

#include "bench/parameter.h"

namespace rasterproof::bench {

// Each gives a few dozen cases of one value. An end of the edge that passes the sample is the place
// of its binade for which |E| is smallest but not zero (props/domains/hardest.h), on either side.

/// Needles 4096 pixels long and 4096 / `ratio` wide.
std::vector<HardCase> NeedleCases(double ratio);

/// Triangles of some 20 pixels whose sample is in column `pixels`. Beyond the largest target their
/// edge values are asked for alone.
std::vector<HardCase> DistantCases(double pixels);

/// Triangles whose box begins in the first of `columns` columns, and whose sample is in the last.
std::vector<HardCase> WalkCases(double columns);

/// Triangles with one corner 2^k times as far from the sample as the others.
std::vector<HardCase> GapCases(double ratio);

/// Samples at which the two products of E cancel: their sum S is `ratio` times |E|, within a factor
/// of 2.
std::vector<HardCase> CancellingCases(double ratio);

/// Triangles in clip space, one corner's w `ratio` times the others'.
std::vector<HardCase> ClipCases(double ratio);

}  // namespace rasterproof::bench

#endif  // RASTERPROOF_BENCH_EDGE_CASES_H_
