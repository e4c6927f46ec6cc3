#include "report/bench_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "fmt/format.h"
#include "report/bench_decision.h"

namespace rasterproof::report {
namespace {

// Rows of a family, by sink in the order of the first row of each, then by time.
std::vector<const BenchRow*> RowsOf(const BenchResult& result, std::size_t family) {
  std::vector<const BenchRow*> rows;
  std::vector<std::string_view> sinks;
  for (const BenchRow& row : result.rows) {
    if (row.family != family) continue;
    rows.push_back(&row);
    const std::string_view sink = result.methods[row.method].sink;
    if (std::ranges::find(sinks, sink) == sinks.end()) sinks.push_back(sink);
  }
  const auto place = [&](const BenchRow* row) {
    return std::ranges::find(sinks, result.methods[row->method].sink) - sinks.begin();
  };
  std::ranges::sort(rows, {}, [&](const BenchRow* row) {
    return std::tuple(place(row), row->time.median, row->method);
  });
  return rows;
}

// "proved 0", "0 of 12,345", "12.3 %": of the pairs at most a pixel from an edge.
std::string ShareText(const BenchErrors& errors, std::uint64_t of, bool is_proved) {
  if (errors.Wrong() == 0) return is_proved ? "proved 0" : fmt::format("0 of {}", of);
  return fmt::format(
      "{:.3g} %",
      of == 0 ? 0 : 100.0 * static_cast<double>(errors.Wrong()) / static_cast<double>(of));
}

std::string DistanceText(double pixels) {
  return std::isnan(pixels) ? "-" : fmt::format("{:.3g}", pixels);
}

std::string DrawingText(const BenchRow& row) {
  return row.drawing_wrong ? std::to_string(*row.drawing_wrong) : "-";
}

std::string TableOf(const BenchResult& result, std::size_t at) {
  const BenchFamily& family = result.families[at];
  std::string table = fmt::format(
      "\n{}: {}.\n  {} triangles, {} pairs covered; judged: {} triangles, {} pairs at most a pixel "
      "from an edge,\n  {} beside a shared edge; {} rounds, ratios to {}\n",
      family.name, family.summary, family.triangles, family.covered, family.judged_triangles,
      family.boundary_pairs, family.shared_pairs, family.rounds,
      result.methods.empty() ? "" : result.methods[family.baseline].name);
  table += fmt::format("  {:<28} {:<8} {:<7} {:>10} {:>22} {:>14} {:>9} {:>14} {:>6} {:>6}\n",
                       "method", "target", "sink", "ns/tri", "ratio", "wrong", "px", "own model",
                       "gaps", "over", "drawing");
  for (const BenchRow* row : RowsOf(result, at)) {
    const BenchMethod& method = result.methods[row->method];
    const std::string ratio =
        fmt::format("{:.3f} [{:.3f}, {:.3f}]", row->ratio.median, row->ratio.low, row->ratio.high);
    table += fmt::format("  {:<28} {:<8} {:<7} {:>10.1f} {:>22}", method.name, method.target,
                         method.sink, NanosecondsATriangle(result, *row), ratio);
    if (!row->is_judged) {
      table += fmt::format(" {:>14} {:>9} {:>14} {:>6} {:>6} {:>8}\n", "-", "-", "-", "-", "-",
                           DrawingText(*row));
      continue;
    }
    const bool is_real = method.model == "real";
    table +=
        fmt::format(" {:>14} {:>9} {:>14} {:>6} {:>6} {:>8}\n",
                    ShareText(row->real, family.boundary_pairs, method.is_proved && is_real),
                    DistanceText(row->real.displacement),
                    is_real ? "" : ShareText(row->own, family.boundary_pairs, method.is_proved),
                    row->leaks.gaps, row->leaks.overlaps, DrawingText(*row));
  }
  return table;
}

}  // namespace

std::string BenchToTable(const BenchResult& result) {
  const BenchSetting& setting = result.setting;
  std::string table = fmt::format(
      "{}\n{}\nTime: median of the rounds, processor time of one draw, target cleared before it; "
      "ratio with its 95 %\ninterval, paired within rounds. Wrong: share of the pairs (triangle, "
      "sample) at most a pixel from an edge;\npx: largest distance of a wrong sample from its "
      "triangle's boundary.\n",
      setting.command, setting.processor);
  for (std::size_t at = 0; at < result.families.size(); ++at) table += TableOf(result, at);
  return table;
}

}  // namespace rasterproof::report
