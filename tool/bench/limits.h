// What `bench --limits` does.
#ifndef RASTERPROOF_TOOL_BENCH_LIMITS_H_
#define RASTERPROOF_TOOL_BENCH_LIMITS_H_

#include <memory>
#include <span>

#include "bench/contender.h"
#include "core/bench_result.h"
#include "tool/bench/cmd_bench.h"

namespace rasterproof::tool {

/// Finds the cliffs of the contenders and of the subjects outside that the options name (of these
/// alone, unless built-in ones are asked for too), prints them, and writes what the options want.
///
/// Domain:     a result that holds its setting and nothing else.
void PrintLimits(std::span<const std::unique_ptr<bench::Contender>> contenders,
                 const BenchOptions& options, BenchResult& result);

}  // namespace rasterproof::tool

#endif  // RASTERPROOF_TOOL_BENCH_LIMITS_H_
