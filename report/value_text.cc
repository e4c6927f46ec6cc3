#include "report/value_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

#include "fmt/format.h"
#include "report/value_advice.h"

namespace rasterproof::report {
namespace {

std::string ShareText(const ValueBenchRow& row) {
  if (std::isnan(row.share_of_bound)) return "-";
  return fmt::format("{:.3f}", row.share_of_bound);
}

}  // namespace

std::vector<const ValueBenchRow*> ValueRowsOf(const BenchResult& result, std::uint32_t family) {
  std::vector<const ValueBenchRow*> rows;
  for (const ValueBenchRow& row : result.value_rows) {
    if (row.family == family) rows.push_back(&row);
  }
  std::ranges::sort(rows, {}, [](const ValueBenchRow* row) {
    return std::tuple(row->shows != "value", row->ns, row->method, row->target);
  });
  return rows;
}

std::string ValuesToTable(const BenchResult& result) {
  std::string text;
  for (std::uint32_t k = 0; k < result.value_families.size(); ++k) {
    const ValueBenchFamily& family = result.value_families[k];
    text += fmt::format(
        "{}{}: {}\n{} triangles, {} pixels, {} judged; the frame alone {:.3g} ns a pixel.\n"
        "{:<24} {:<6} {:<5} {:>16} {:>9} {:>9} {:>9} {:>9} {:>9} {:>6}\n",
        k == 0 ? "" : "\n", family.name, family.summary, family.triangles, family.covered,
        family.judged, family.floor_ns, "method", "by", "shows", "ns a pixel", "ulps", "99.9 %",
        "texels", "99.9 %", "of bound", "NaN");
    for (const ValueBenchRow* row : ValueRowsOf(result, k)) {
      text += fmt::format(
          "{:<24} {:<6} {:<5} {:>5.3f} {:>5.3f}-{:<5.3f} {:>8.3g} {:>9.3g} {:>9.3g} {:>9.3g} {:>9} "
          "{:>6}\n",
          row->method, row->target, row->shows, row->ns, row->ns_low, row->ns_high, row->ulps,
          row->ulps_999, row->texels, row->texels_999, ShareText(*row), row->not_finite);
    }
  }
  for (const ValueAdvice& advice : ValueAdviceOf(result)) {
    text += fmt::format("\n\"{}\" ({}): {}.\n", advice.text, advice.method, advice.measured);
  }
  return text;
}

}  // namespace rasterproof::report
