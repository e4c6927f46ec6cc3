// Error against run time as a picture: a panel a family.
#ifndef RASTERPROOF_REPORT_BENCH_SVG_H_
#define RASTERPROOF_REPORT_BENCH_SVG_H_

#include <cstdint>
#include <string>

#include "core/bench_result.h"

namespace rasterproof::report {

/// Size of a panel, in user units.
inline constexpr double kPanelWidth = 400;
inline constexpr double kPanelHeight = 310;

enum class PanelPoints : std::uint8_t { kAll, kFrontier };

/// The panel of a family, to be put into an SVG element whose style sheet has the classes soft,
/// grid, lane, bar, front and place.
std::string BenchPanel(const BenchResult& result, std::uint32_t family, PanelPoints which);

/// A panel a family: run time over the baseline's, of the sink that all methods have ("facing"),
/// against the share of wrong pairs at most a pixel from an edge, in three lanes: proved 0, 0 of N,
/// and a rate. Points of the frontier are numbered and named below; every point has its name as a
/// title. Hollow points are no rivals.
std::string BenchToSvg(const BenchResult& result);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_SVG_H_
