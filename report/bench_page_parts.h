// The parts of the page's sections on error against run time, each a piece of HTML.
#ifndef RASTERPROOF_REPORT_BENCH_PAGE_PARTS_H_
#define RASTERPROOF_REPORT_BENCH_PAGE_PARTS_H_

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/bench_result.h"
#include "report/bench_decision.h"

namespace rasterproof::report {

/// Pixels of a frame: 1920 x 1080 and 3840 x 2160.
inline constexpr std::array<std::uint64_t, 2> kFramePixels{std::uint64_t{1920} * 1080,
                                                           std::uint64_t{3840} * 2160};

/// Three digits, or the unit in groups: "0.0123", "34.2", "157 583".
std::string NumberText(double value);
/// "proved 0", "0 of 12 345", "45 of 12 345": of the pairs of the row's family at most a pixel from
/// an edge.
std::string WrongText(const BenchResult& bench, const BenchRow& row);
/// "yours; bound by storing"
std::string RemarkText(const BenchResult& bench, const BenchRow& row);

/// Of each family and need the cheapest method.
std::string DecisionTable(const BenchResult& bench);
/// A row a claim of claims.h: how long its methods take, and in what they differ.
std::string ClaimTable(const BenchResult& bench);
/// A row a family of each method of the user's: beside the fastest and the proved.
std::string UsersTable(const BenchResult& bench);

/// Pickers, plots, table of all rows, and the record: the bytes of BenchToJson.
std::string ParetoParts(const BenchResult& bench);
/// A panel a family, the frontier alone.
std::string FamilyPanels(const BenchResult& bench);

/// "2^-24 + 1" with its exponent raised.
std::string RaisedText(const std::string& text);
/// Where each method ends: a row for methods that end alike, a column for each parameter, below it
/// the commands that show the failing cases. `folder`: of the page, in commands.
std::string CliffTable(const BenchResult& bench, std::string_view folder);
/// Returns a plot for each parameter and measure; indistinguishable curves are one line.
std::string CurvePlots(const BenchResult& bench);
std::string FingerprintPictures(const BenchResult& bench);
/// Pictures and commands, folded by family.
std::string WorstCases(const BenchResult& bench, std::string_view folder);
std::string StageBars(const BenchResult& bench);
/// Errors and times of interpolated values, folded by family, and the advice that they measure.
std::string ValueParts(const BenchResult& bench);

/// "bench/fan-f32-affine.json"
std::string FileOf(std::string_view prefix, const BenchMethod& method);

/// The row's worst case by real geometry and the file that it has beside the page.
struct WorstCase {
  const BenchRow* row = nullptr;
  std::string file;
};
/// One for each family and name of a method that has one.
std::vector<WorstCase> WorstCasesOf(const BenchResult& bench);
/// The file of a cliff's scene.
std::string CliffFile(const BenchResult& bench, const BenchCliff& cliff);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_BENCH_PAGE_PARTS_H_
