// What a benchmark found, as a table.
#ifndef RASTERPROOF_REPORT_BENCH_TEXT_H_
#define RASTERPROOF_REPORT_BENCH_TEXT_H_

#include <string>
#include <string_view>

#include "core/bench_result.h"

namespace rasterproof::report {

/// What there was no time for, as a sentence; nothing if there was time for all.
std::string NotMeasuredText(const BenchResult& result);

/// "Load of the machine: 0.05 at the start, 0.12 at the end."
std::string LoadText(const BenchSetting& setting);

/// "-march" of a user's library; "not said".
std::string_view MarchText(const BenchMethod& method);

/// A table a family, cheapest first within a sink.
std::string BenchToTable(const BenchResult& result);

/// A table a parameter of costs: nanoseconds a triangle of each method at each value.
std::string CostsToTable(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_TEXT_H_
