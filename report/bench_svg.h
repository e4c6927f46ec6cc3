// Error against run time as a picture: a panel a family.
#ifndef RASTERPROOF_REPORT_BENCH_SVG_H_
#define RASTERPROOF_REPORT_BENCH_SVG_H_

#include <cstdint>
#include <string>
#include <vector>

#include "core/bench_result.h"

namespace rasterproof::report {

/// The rows of a family and sink that no other one beats: cheaper by more than both intervals, and
/// no more wrong. Cheapest first. Rows outside their method's limit, with 1 % wrong or more, or not
/// judged are no rivals: a wrong answer is often fast.
///
/// Properties: of rows whose intervals overlap none beats the other by its time: they are tied.
std::vector<const BenchRow*> Frontier(const BenchResult& result, std::uint32_t family,
                                      const std::string& sink);

/// Whether the row counts for the frontier.
bool IsRival(const BenchResult& result, const BenchRow& row);

/// A panel a family: run time over the baseline's, of the sink that all methods have ("facing"),
/// against the share of wrong pairs at most a pixel from an edge, in three lanes: proved 0, 0 of N,
/// and a rate. Points of the frontier are numbered and named below; every point has its name as a
/// title. Hollow points are no rivals.
std::string BenchToSvg(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_SVG_H_
