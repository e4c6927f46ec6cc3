// What a benchmark of kernels found, as a table and as data.
#ifndef RASTERPROOF_REPORT_KERNEL_BENCH_H_
#define RASTERPROOF_REPORT_KERNEL_BENCH_H_

#include <string>

#include "core/kernel_bench_result.h"

namespace rasterproof::report {

/// A table for each scene and sink, rows as measured, for a terminal.
std::string KernelBenchToTable(const KernelBenchResult& result);

/// Scenes, rows and limits as JSON: nanoseconds a triangle and a covered pixel, wrong samples.
std::string KernelBenchToJson(const KernelBenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_KERNEL_BENCH_H_
