// Error against run time of values: a picker of families, a plot and a table each.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/bench_page_parts.h"
#include "report/page_parts.h"
#include "report/text.h"
#include "report/value_advice.h"
#include "report/value_text.h"

namespace rasterproof::report {
namespace {

// Of a plot, in user units: errors from 2^-2 ulps up, times from their least.
constexpr double kValuesAcross = 560;
constexpr double kValuesDown = 220;
constexpr double kValuesEdge = 48;

// Where a positive number lies between both ends, by its logarithm.
double Along(double value, double low, double high) {
  const double at = std::log(std::clamp(value, low, high) / low);
  return at / std::log(high / low);
}

struct LabelBox {
  double x;
  double y;
  double width;
};

// The row beside (x, y), or the nearest above or below it, where the label covers no other.
double FreeRow(double x, double y, double width, std::vector<LabelBox>& taken) {
  constexpr double kHeight = 11;
  for (int n = 0;; ++n) {
    const double row = y + kHeight * (n % 2 == 0 ? n / 2 : -(n + 1) / 2);
    const auto covers = [&](const LabelBox& box) {
      return std::abs(row - box.y) < kHeight && x < box.x + box.width && box.x < x + width;
    };
    if (std::ranges::any_of(taken, covers)) continue;
    taken.push_back({x, row, width});
    return row;
  }
}

std::string ValuePlotOf(const std::vector<const ValueBenchRow*>& rows) {
  std::vector<const ValueBenchRow*> shown;
  std::ranges::copy_if(rows, std::back_inserter(shown), [](const ValueBenchRow* row) {
    return row->shows == "value" && row->ns > 0;
  });
  if (shown.empty()) return {};
  constexpr double kLeastUlps = 0.25;
  double most_ulps = 1;
  double least_ns = std::numeric_limits<double>::infinity();
  double most_ns = 0;
  for (const ValueBenchRow* row : shown) {
    if (std::isfinite(row->ulps)) most_ulps = std::max(most_ulps, row->ulps);
    least_ns = std::min(least_ns, row->ns);
    most_ns = std::max(most_ns, row->ns);
  }
  most_ns = std::max(most_ns, 2 * least_ns);
  std::string svg = fmt::format(
      "<svg class=\"bench\" viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"Largest error in ulps "
      "over nanoseconds a pixel\">",
      kValuesAcross + 4 * kValuesEdge, kValuesDown + kValuesEdge);
  constexpr double kCharacter = 6.2;
  const auto place = [&](const ValueBenchRow& row) {
    return std::pair{kValuesEdge + kValuesAcross * Along(row.ns, least_ns, most_ns),
                     kValuesDown - (kValuesDown - 16) * Along(row.ulps, kLeastUlps, 2 * most_ulps)};
  };
  std::vector<LabelBox> labels;
  for (const ValueBenchRow* row : shown) {
    const auto [x, y] = place(*row);
    labels.push_back({x - 4, y + 3, 8});  // the point itself
  }
  for (const ValueBenchRow* row : shown) {
    const auto [x, y] = place(*row);
    const double width = kCharacter * static_cast<double>(row->method.size());
    const double label = FreeRow(x + 6, y + 3, width, labels);
    if (label != y + 3) {
      svg += fmt::format(
          "<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"currentColor\" opacity=\".4\"/>", x, y,
          x + 6, label - 3);
    }
    svg += fmt::format(
        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"4\"><title>{2}: {3:.3f} ns, {4:.3g} "
        "ulps</title></circle><text x=\"{5:.1f}\" y=\"{6:.1f}\" font-size=\"10\">{2}</text>",
        x, y, Escaped(row->method), row->ns, row->ulps, x + 6, label);
  }
  return svg + fmt::format(
                   "<text x=\"{}\" y=\"{}\" font-size=\"11\">{:.3g} to {:.3g} ns a covered pixel "
                   "(across); {} to {:.3g} ulps (up); both by logarithm</text></svg>\n",
                   kValuesEdge, kValuesDown + 32, least_ns, most_ns, kLeastUlps, 2 * most_ulps);
}

std::string ValueTableOf(const std::vector<const ValueBenchRow*>& rows) {
  std::string html =
      "<div class=\"scroll\"><table class=\"sorts rows\"><thead><tr><th>method</th><th>by</th>"
      "<th>shows</th><th class=\"number\">ns a pixel</th><th class=\"number\">ulps</th>"
      "<th class=\"number\">99.9 %</th><th class=\"number\">texels</th>"
      "<th class=\"number\">99.9 %</th><th class=\"number\">of its bound</th></tr></thead>"
      "<tbody>\n";
  for (const ValueBenchRow* row : rows) {
    html += fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td>{}</td><td>{}</td>"
        "<td class=\"number\">{:.3f}</td><td class=\"number\">{:.3g}</td>"
        "<td class=\"number\">{:.3g}</td><td class=\"number\">{:.3g}</td>"
        "<td class=\"number\">{:.3g}</td><td class=\"number\">{}</td></tr>\n",
        Escaped(row->method), Escaped(row->target), Escaped(row->shows), row->ns, row->ulps,
        row->ulps_999, row->texels, row->texels_999,
        std::isnan(row->share_of_bound) ? "–" : fmt::format("{:.3f}", row->share_of_bound));
  }
  return html + "</tbody></table></div>\n";
}

// A row a method, a column a parameter.
std::string LimitsOf(const BenchResult& bench) {
  const std::vector<std::string> parameters = ValueParametersOf(bench);
  if (parameters.empty()) return {};
  std::string html = "<div class=\"scroll\"><table><thead><tr><th>method</th>";
  for (const std::string& parameter : parameters) {
    html += fmt::format("<th>{}</th>", Escaped(parameter));
  }
  html += "</tr></thead><tbody>\n";
  std::vector<std::string> shown;
  for (const ValueBenchLimit& limit : bench.value_limits) {
    const std::string name = limit.method + " by " + limit.target;
    if (std::ranges::find(shown, name) != shown.end()) continue;
    shown.push_back(name);
    html += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>", Escaped(name));
    for (const std::string& parameter : parameters) {
      const auto found = std::ranges::find_if(bench.value_limits, [&](const auto& one) {
        return one.parameter == parameter && one.method == limit.method &&
               one.target == limit.target;
      });
      html += fmt::format("<td class=\"why\">{}</td>",
                          found == bench.value_limits.end() ? "–" : ValueLimitText(*found));
    }
    html += "</tr>\n";
  }
  return Folded("Where each ends: a value in [0, 1] is off by half a texel of 4096",
                html + "</tbody></table></div>\n", false);
}

}  // namespace

std::string ValueParts(const BenchResult& bench) {
  if (bench.value_families.empty()) return {};
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>advice</th><th>who follows it</th>"
      "<th>measured</th></tr></thead><tbody>\n";
  for (const ValueAdvice& advice : ValueAdviceOf(bench)) {
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"name\">{}</td><td class=\"why\">{}</td></tr>\n",
        Escaped(advice.text), Escaped(advice.method), Escaped(advice.measured));
  }
  html += "</tbody></table></div>\n";
  for (std::uint32_t k = 0; k < bench.value_families.size(); ++k) {
    const ValueBenchFamily& family = bench.value_families[k];
    const std::vector<const ValueBenchRow*> rows = ValueRowsOf(bench, k);
    html += Folded(fmt::format("<span class=\"name\">{}</span> {}", Escaped(family.name),
                               Escaped(family.summary)),
                   ValuePlotOf(rows) + ValueTableOf(rows), k == 0);
  }
  return html + LimitsOf(bench) +
         ColumnKey({{"ns a pixel",
                     "of a covered one, from a triangle's set-up to the last store, less the same "
                     "frame storing a constant"},
                    {"ulps", "largest error in float32's last places of the exact number"},
                    {"99.9 %", "of the judged pixels err at most so much"},
                    {"texels", "the error times 4096, of u over a texture of that size"},
                    {"of its bound", "largest error over the bound that the method states"}});
}

}  // namespace rasterproof::report
