// What a benchmark found, as a table.
#ifndef RASTERPROOF_REPORT_BENCH_TEXT_H_
#define RASTERPROOF_REPORT_BENCH_TEXT_H_

#include <string>

#include "core/bench_result.h"

namespace rasterproof::report {

/// What there was no time for, as a sentence; nothing if there was time for all.
std::string NotMeasuredText(const BenchResult& result);

/// A table a family, cheapest first within a sink.
std::string BenchToTable(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_TEXT_H_
