// What a benchmark found, as a table, as data and as a plot.
#ifndef RASTERPROOF_REPORT_BENCH_PLOT_H_
#define RASTERPROOF_REPORT_BENCH_PLOT_H_

#include <string>

#include "core/bench_result.h"

namespace rasterproof::report {

/// A table per family, cheapest subject first, for a terminal.
std::string BenchToTable(const BenchResult& result);

/// The rows as JSON: ratios to the baseline as decimals, counts as integers. Times are left out
/// where they mean nothing: only ratios within one run do.
std::string BenchToJson(const BenchResult& result);

/// Wrong samples over run time, a panel per family, as a Vega-Lite 5 specification with its data
/// inline. The front (no subject is both cheaper and less wrong) is drawn as a line; the textbook
/// method and the baseline are marked.
std::string BenchPlotSpec(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_PLOT_H_
