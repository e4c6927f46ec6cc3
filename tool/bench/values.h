// What `bench --values` does.
#ifndef RASTERPROOF_TOOL_BENCH_VALUES_H_
#define RASTERPROOF_TOOL_BENCH_VALUES_H_

#include "core/bench_result.h"
#include "tool/bench/cmd_bench.h"

namespace rasterproof::tool {

/// Measures methods of interpolation, prints them, and writes the record if the options want it.
///
/// Domain:     a result that holds its setting; its values are replaced.
void PrintValues(const BenchOptions& options, BenchResult& result);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_BENCH_VALUES_H_
