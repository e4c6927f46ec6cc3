// A bench of two families, made up: each number is there for a test.
#ifndef RASTERPROOF_TESTS_REPORT_SAMPLE_BENCH_H_
#define RASTERPROOF_TESTS_REPORT_SAMPLE_BENCH_H_

#include "core/bench_result.h"

namespace rasterproof::report {

/// Every list of the record holds something.
BenchResult SampleBench();

}  // namespace rasterproof::report

#endif  // RASTERPROOF_TESTS_REPORT_SAMPLE_BENCH_H_
