#include "report/bench_svg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/bench_decision.h"
#include "report/bench_page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// Of a panel, in user units.
constexpr double kLeft = 66;
constexpr double kTop = 56;
constexpr double kPlotWidth = 310;
constexpr double kPlotHeight = 170;
constexpr int kColumns = 3;
// The lanes of zero lie below the axis of rates.
constexpr double kRateHeight = 116;
constexpr double kLeastRate = 1e-7;

struct Kind {
  std::string_view name;
  std::string_view colour;
};
// Colours of Okabe and Ito, which every kind of sight distinguishes.
constexpr std::array<Kind, 5> kKinds{{{"float32", "#0072b2"},
                                      {"float64", "#56b4e9"},
                                      {"fixed point", "#e69f00"},
                                      {"exact", "#009e73"},
                                      {"yours", "#d55e00"}}};

// The decades that hold every ratio, the same in all panels; at least those from a tenth to ten.
struct RatioAxis {
  int least = -1;
  int most = 1;

  double XOf(double ratio) const {
    const double at = (std::log10(std::max(ratio, 1e-300)) - least) / (most - least);
    return kLeft + std::clamp(at, 0.0, 1.0) * kPlotWidth;
  }
};

RatioAxis AxisOf(const BenchResult& result) {
  RatioAxis axis;
  for (const BenchRow& row : result.rows) {
    if (result.methods[row.method].sink != kCommonSink) continue;
    for (const double ratio : {row.ratio.low, row.ratio.median, row.ratio.high}) {
      if (!(ratio > 0) || !std::isfinite(ratio)) continue;
      axis.least = std::min(axis.least, static_cast<int>(std::floor(std::log10(ratio))));
      axis.most = std::max(axis.most, static_cast<int>(std::ceil(std::log10(ratio))));
    }
  }
  return axis;
}

double YOf(const BenchResult& result, const BenchRow& row) {
  const double lane = (kPlotHeight - kRateHeight) / 2;
  const RowError error = ErrorOf(result, row, ErrorKind::kReal);
  if (error.lane == ErrorLane::kProved) return kTop + kRateHeight + 1.5 * lane;
  if (error.lane == ErrorLane::kNone) return kTop + kRateHeight + 0.5 * lane;
  return kTop +
         kRateHeight * std::log(std::clamp(error.value, kLeastRate, 1.0)) / std::log(kLeastRate);
}

// Circle, triangle upside down, square, triangle or diamond, by kind.
std::string Mark(std::string_view kind, double x, double y, bool is_hollow) {
  const auto found = std::ranges::find(kKinds, kind, &Kind::name);
  const Kind& shown = found == kKinds.end() ? kKinds.front() : *found;
  const std::string style = fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.4\"",
                                        is_hollow ? "none" : shown.colour, shown.colour);
  constexpr double kR = 4;
  if (shown.name == "exact") {
    return fmt::format("<path d=\"M{:.1f} {:.1f}l{} {}h{}z\" {}/>", x, y - kR, kR, 2 * kR, -2 * kR,
                       style);
  }
  if (shown.name == "float64") {
    return fmt::format("<path d=\"M{:.1f} {:.1f}l{} {}h{}z\" {}/>", x, y + kR, kR, -2 * kR, -2 * kR,
                       style);
  }
  if (shown.name == "fixed point") {
    return fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{}\" height=\"{}\" {}/>", x - kR,
                       y - kR, 2 * kR, 2 * kR, style);
  }
  if (shown.name == "yours") {
    return fmt::format("<path d=\"M{:.1f} {:.1f}l{} {}l{} {}l{} {}z\" {}/>", x, y - 6.0, 6, 6, -6,
                       6, -6, -6, style);
  }
  return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>", x, y, kR, style);
}

std::string Text(double x, double y, std::string_view anchor, std::string_view text,
                 std::string_view more = "") {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" {}>{}</text>\n", x, y,
                     anchor, more, Escaped(std::string(text)));
}

// The title that a browser shows where the pointer rests.
std::string Title(const BenchResult& result, const BenchRow& row) {
  const BenchMethod& method = result.methods[row.method];
  return fmt::format(
      "{} ({}): {} of the baseline's time, {:.4g} ns a triangle; {} of {} pairs wrong", method.name,
      method.target, RatioText(row, 3), NanosecondsATriangle(result, row),
      WrongBesideEdges(row, row.real), row.boundary_pairs);
}

// A sentence at its last blank that leaves the first line short enough for a panel.
std::pair<std::string, std::string> InTwoLines(const std::string& sentence) {
  constexpr std::size_t kMost = 56;
  if (sentence.size() <= kMost) return {sentence, ""};
  const std::size_t blank = sentence.rfind(' ', kMost);
  if (blank == std::string::npos) return {sentence, ""};
  return {sentence.substr(0, blank), sentence.substr(blank + 1)};
}

std::string Axes(const BenchFamily& family, const RatioAxis& axis) {
  std::string svg = Text(kLeft, 18, "start", family.name, "font-weight=\"600\" font-size=\"14\"");
  const auto [first, second] = InTwoLines(family.summary);
  svg += Text(kLeft, 33, "start", first, "class=\"soft\"");
  svg += Text(kLeft, 46, "start", second, "class=\"soft\"");
  const double bottom = kTop + kPlotHeight;
  for (int decade = axis.least; decade <= axis.most; ++decade) {
    const double ratio = std::pow(10, decade);
    const double x = axis.XOf(ratio);
    svg += fmt::format("<path class=\"grid\" d=\"M{:.1f} {}V{}\"/>\n", x, kTop, bottom);
    svg += Text(x, bottom + 14, "middle", fmt::format("{:g}", ratio), "class=\"soft\"");
  }
  for (const auto& [share, name] :
       {std::pair{1.0, "100 %"}, {1e-2, "1 %"}, {1e-4, "100 / M"}, {1e-6, "1 / M"}}) {
    const double y = kTop + kRateHeight * std::log(share) / std::log(kLeastRate);
    svg += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}h{}\"/>\n", kLeft, y, kPlotWidth);
    svg += Text(kLeft - 6, y + 3.5, "end", name, "class=\"soft\"");
  }
  const double lane = (kPlotHeight - kRateHeight) / 2;
  for (const auto& [at, name] : {std::pair{0, "0 of N"}, {1, "proved 0"}}) {
    const double y = kTop + kRateHeight + at * lane;
    svg += fmt::format("<path class=\"lane\" d=\"M{} {:.1f}h{}\"/>\n", kLeft, y, kPlotWidth);
    svg += Text(kLeft - 6, y + lane / 2 + 3.5, "end", name, "class=\"soft\"");
  }
  return svg;
}

std::string Point(const BenchResult& result, const BenchRow& row, const RatioAxis& axis) {
  const double y = YOf(result, row);
  const std::string bar = HasInterval(row)
                              ? fmt::format("<path class=\"bar\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>",
                                            axis.XOf(row.ratio.low), y, axis.XOf(row.ratio.high))
                              : "";
  return fmt::format(
      "<g><title>{}</title>{}{}</g>\n", Escaped(Title(result, row)), bar,
      Mark(result.methods[row.method].kind, axis.XOf(row.ratio.median), y, !IsRival(result, row)));
}

// Those that are numbered and named: the cheapest of the frontier, and its least wrong; the user's
// own in place of others.
std::vector<const BenchRow*> Named(const BenchResult& result, std::uint32_t family,
                                   std::vector<const BenchRow*> frontier) {
  constexpr std::size_t kMost = 4;
  std::vector<const BenchRow*> own;
  for (const BenchRow& row : result.rows) {
    const BenchMethod& method = result.methods[row.method];
    const bool is_new = std::ranges::find(frontier, &row) == frontier.end();
    if (row.family == family && method.is_users && method.sink == kCommonSink && is_new)
      own.push_back(&row);
  }
  own.resize(std::min(own.size(), kMost - 1));
  const std::size_t room = kMost - own.size();
  if (frontier.size() > room) {
    const auto first = frontier.begin() + static_cast<std::ptrdiff_t>(room) - 1;
    frontier.erase(first, frontier.end() - 1);
  }
  frontier.insert(frontier.end(), own.begin(), own.end());
  return frontier;
}

// Numbers beside points, each where it meets none before it.
std::string Numbers(const BenchResult& result, const std::vector<const BenchRow*>& named,
                    const RatioAxis& axis) {
  constexpr std::array<std::array<double, 2>, 8> kPlaces{
      {{0, -7}, {0, 15}, {9, 3}, {-9, 3}, {9, -7}, {-9, -7}, {9, 15}, {-9, 15}}};
  std::vector<std::array<double, 2>> taken;
  std::string svg;
  for (std::size_t k = 0; k < named.size(); ++k) {
    std::array<double, 2> at{};
    for (const auto& [dx, dy] : kPlaces) {
      at = {axis.XOf(named[k]->ratio.median) + dx, YOf(result, *named[k]) + dy};
      const bool is_free = std::ranges::none_of(taken, [&](const std::array<double, 2>& other) {
        return std::abs(other[0] - at[0]) < 8 && std::abs(other[1] - at[1]) < 12;
      });
      if (is_free) break;
    }
    taken.push_back(at);
    svg += Text(at[0], at[1], "middle", std::to_string(k + 1), "class=\"place\"");
  }
  return svg;
}

std::string NamesBelow(const BenchResult& result, const std::vector<const BenchRow*>& named) {
  std::string svg;
  double y = kTop + kPlotHeight + 32;
  for (std::size_t k = 0; k < named.size(); ++k, y += 13) {
    svg += Text(kLeft, y, "start",
                fmt::format("{} {}: {:.3g} x, {} ns/triangle", k + 1,
                            FullName(result.methods[named[k]->method]), named[k]->ratio.median,
                            NumberText(NanosecondsATriangle(result, *named[k]))));
  }
  return svg;
}

constexpr std::string_view kStyle =
    "<style>text{font:11px system-ui,'DejaVu Sans',sans-serif;fill:#23262d}.soft{fill:#626975}"
    ".grid{stroke:#eceef1}.lane{stroke:#b8bdc6;stroke-dasharray:3 3}.bar{stroke:#3a3f48;"
    "stroke-width:1}.front{fill:none;stroke:#009e73;stroke-width:1.5;opacity:.6}"
    ".place{font-weight:600;font-size:9px}</style>\n";

}  // namespace

std::string BenchPanel(const BenchResult& result, std::uint32_t family, PanelPoints which) {
  const RatioAxis axis = AxisOf(result);
  std::string svg = Axes(result.families[family], axis);
  const std::vector<const BenchRow*> frontier =
      Frontier(result, family, kCommonSink, ErrorKind::kReal);
  std::string path;
  for (const BenchRow* row : frontier) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", axis.XOf(row->ratio.median),
                        YOf(result, *row));
  }
  if (frontier.size() > 1) svg += fmt::format("<path class=\"front\" d=\"{}\"/>\n", path);
  for (const BenchRow& row : result.rows) {
    const bool is_here = row.family == family && result.methods[row.method].sink == kCommonSink;
    const bool is_shown =
        which == PanelPoints::kAll || std::ranges::find(frontier, &row) != frontier.end();
    if (is_here && row.is_judged && is_shown && !IsBaselineAgain(result, row))
      svg += Point(result, row, axis);
  }
  const std::vector<const BenchRow*> named = Named(result, family, frontier);
  return svg + Numbers(result, named, axis) + NamesBelow(result, named);
}

std::string BenchToSvg(const BenchResult& result) {
  const auto panels = static_cast<int>(result.families.size());
  const int rows = (panels + kColumns - 1) / kColumns;
  const double width = kColumns * kPanelWidth;
  const double height = rows * kPanelHeight + 56;
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
      "height=\"{1}\">\n{2}<rect width=\"{0}\" height=\"{1}\" fill=\"#fff\"/>\n",
      width, height, kStyle);
  for (int k = 0; k < panels; ++k) {
    svg += fmt::format("<g transform=\"translate({} {})\">\n", (k % kColumns) * kPanelWidth,
                       (k / kColumns) * kPanelHeight);
    svg += BenchPanel(result, static_cast<std::uint32_t>(k), PanelPoints::kAll) + "</g>\n";
  }
  double x = kLeft;
  for (const Kind& kind : kKinds) {
    svg += Mark(kind.name, x, height - 38, false);
    svg += Text(x + 9, height - 34, "start", kind.name);
    x += 95;
  }
  svg += Text(x, height - 34, "start",
              "hollow: 1 % wrong or more, or outside the method's limit. Line: the frontier.");
  const std::string baseline = result.families.empty() || result.methods.empty()
                                   ? ""
                                   : result.methods[result.families.front().baseline].name;
  svg +=
      Text(kLeft, height - 14, "start",
           fmt::format("Across: processor time over that of {} (bars: 95 % intervals). Up: wrong "
                       "pairs (triangle, sample) of those at most a pixel from an edge. {}",
                       baseline, result.setting.processor),
           "class=\"soft\"");
  return svg + "</svg>\n";
}

}  // namespace rasterproof::report
