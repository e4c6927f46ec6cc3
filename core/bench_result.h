// What a benchmark found: measured by bench, rendered by report.
#ifndef RASTERPROOF_CORE_BENCH_RESULT_H_
#define RASTERPROOF_CORE_BENCH_RESULT_H_

#include <cstdint>
#include <string>
#include <vector>

#include "core/coverage.h"

namespace rasterproof {

/// One subject on one family of scenes. Times mean something only as ratios within one run.
struct BenchRow {
  std::string family;  ///< "medium", "large", "wide", "needles"
  std::string subject;
  std::string arithmetic;  ///< "exact", "float32", "float64" or "fixed point", as it states
  std::uint64_t triangles = 0;
  std::uint64_t box_pixels = 0;  ///< pixels in the triangles' clipped bounding boxes
  double median_seconds = 0;     ///< thread CPU time of one draw of the family
  double least_seconds = 0;
  double ratio = 0;                 ///< least_seconds over the baseline's, same family, same run
  CoverageDifference against_own;   ///< the oracle under the subject's own profile
  CoverageDifference against_real;  ///< the oracle under real geometry
};

struct BenchResult {
  std::string baseline;  ///< the subject whose time is 1
  int repetitions = 0;
  std::uint64_t seed = 0;
  std::vector<BenchRow> rows;
};

}  // namespace rasterproof

#endif  // RASTERPROOF_CORE_BENCH_RESULT_H_
