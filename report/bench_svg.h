// The plot of error against run time: the page shows it and `bench --svg` writes it.
#ifndef RASTERPROOF_REPORT_BENCH_SVG_H_
#define RASTERPROOF_REPORT_BENCH_SVG_H_

#include <cstdint>
#include <string>

#include "core/bench_result.h"

namespace rasterproof::report {

/// The panel of a family as an SVG element, 400 units wide: its frontier alone by real geometry, of
/// the sink that all methods have ("facing").
std::string FrontierPanel(const BenchResult& result, std::uint32_t family);

/// The panel of a family as a large SVG element that holds every sink and error. What is not of the
/// first ones has the class off. Parts that belong to an error or a sink say so by data-error (its
/// place in kErrorKinds) and data-sink; points and their names have their row as data-row, points
/// their height of each error as data-y, with nothing where the row has no such error.
std::string LargePanel(const BenchResult& result, std::uint32_t family);

/// A panel a family: run time over the baseline's, of the sink "facing", against the share of wrong
/// pairs at most a pixel from an edge: a rate, 0 of N, or proved 0. Points of the frontier are
/// numbered and named below; every point has its name as a title. Hollow points are no rivals.
std::string BenchToSvg(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_SVG_H_
