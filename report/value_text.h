// Error against run time of values, as a table.
#ifndef RASTERPROOF_REPORT_VALUE_TEXT_H_
#define RASTERPROOF_REPORT_VALUE_TEXT_H_

#include <cstdint>
#include <string>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::report {

/// The rows of a family, those by values first, cheapest first.
std::vector<const ValueBenchRow*> ValueRowsOf(const BenchResult& result, std::uint32_t family);

/// "held to 2^20, fails at 2^21".
std::string ValueLimitText(const ValueBenchLimit& limit);
/// The parameters that there are limits of.
std::vector<std::string> ValueParametersOf(const BenchResult& result);

/// A table a family, and the advice that it measures.
std::string ValuesToTable(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_VALUE_TEXT_H_
