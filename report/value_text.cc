#include "report/value_text.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/value_advice.h"

namespace rasterproof::report {
namespace {

std::string BoundShareText(const ValueBenchRow& row) {
  if (std::isnan(row.share_of_bound)) return "-";
  return fmt::format("{:.3f}", row.share_of_bound);
}

// Methods of which the same is said stand together.
std::string LimitsText(const BenchResult& result, const std::string& parameter) {
  std::vector<std::pair<std::string, std::string>> lines;
  for (const ValueBenchLimit& limit : result.value_limits) {
    if (limit.parameter != parameter) continue;
    const std::string said = ValueLimitText(limit);
    auto line = std::ranges::find(lines, said, &decltype(lines)::value_type::first);
    if (line == lines.end()) line = lines.insert(line, {said, {}});
    line->second += (line->second.empty() ? "" : ", ") + limit.method;
  }
  std::string text =
      fmt::format("\n{}, until a value in [0, 1] is off by half a texel:\n", parameter);
  for (const auto& [said, names] : lines) text += fmt::format("  {}: {}\n", said, names);
  return text;
}

}  // namespace

std::string ValueLimitText(const ValueBenchLimit& limit) {
  const std::string held =
      std::isnan(limit.held_to) ? "never held" : fmt::format("held to 2^{:g}", limit.held_to);
  return std::isnan(limit.fails_at) ? held + ", the end"
                                    : held + fmt::format(", fails at 2^{:g}", limit.fails_at);
}

std::vector<std::string> ValueParametersOf(const BenchResult& result) {
  std::vector<std::string> names;
  for (const ValueBenchLimit& limit : result.value_limits) {
    if (std::ranges::find(names, limit.parameter) == names.end()) names.push_back(limit.parameter);
  }
  return names;
}

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
          row->ulps_999, row->texels, row->texels_999, BoundShareText(*row), row->not_finite);
    }
  }
  for (const std::string& parameter : ValueParametersOf(result)) {
    text += LimitsText(result, parameter);
  }
  for (const ValueAdvice& advice : ValueAdviceOf(result)) {
    text += fmt::format("\n\"{}\" ({}): {}.\n", advice.text, advice.method, advice.measured);
  }
  return text;
}

}  // namespace rasterproof::report
