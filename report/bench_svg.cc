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
#include "report/bench_text.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

constexpr std::string_view kSink = "facing";
constexpr double kMostWrong = 0.01;

// Of a panel, in user units.
constexpr double kPanelWidth = 400;
constexpr double kPanelHeight = 310;
constexpr double kLeft = 66;
constexpr double kTop = 56;
constexpr double kPlotWidth = 310;
constexpr double kPlotHeight = 170;
constexpr int kColumns = 3;
// The lanes of zero lie below the axis of rates.
constexpr double kRateHeight = 116;
constexpr double kLeastRate = 1e-7;
constexpr double kLeastRatio = 1e-3;
constexpr double kMostRatio = 10;

struct Kind {
  std::string_view name;
  std::string_view colour;
};
// Colours of Okabe and Ito, told apart by every kind of sight.
constexpr std::array<Kind, 5> kKinds{{{"float32", "#0072b2"},
                                      {"float64", "#56b4e9"},
                                      {"fixed point", "#e69f00"},
                                      {"exact", "#009e73"},
                                      {"yours", "#d55e00"}}};

double WrongShare(const BenchResult& result, const BenchRow& row) {
  const std::uint64_t of = result.families[row.family].boundary_pairs;
  return of == 0 ? 0 : static_cast<double>(row.real.Wrong()) / static_cast<double>(of);
}

double XOf(double ratio) {
  const double at = std::log(std::clamp(ratio, kLeastRatio, kMostRatio) / kLeastRatio) /
                    std::log(kMostRatio / kLeastRatio);
  return kLeft + at * kPlotWidth;
}

double YOf(const BenchResult& result, const BenchRow& row) {
  const double lane = (kPlotHeight - kRateHeight) / 2;
  switch (LaneOf(result, row)) {
    case ErrorLane::kProved:
      return kTop + kRateHeight + 1.5 * lane;
    case ErrorLane::kNone:
      return kTop + kRateHeight + 0.5 * lane;
    case ErrorLane::kRate:
    case ErrorLane::kNotJudged:
      break;
  }
  const double share = std::clamp(WrongShare(result, row), kLeastRate, 1.0);
  return kTop + kRateHeight * std::log(share) / std::log(kLeastRate);
}

// Circle, square, triangle or diamond, by kind.
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
      "{} ({}): {:.3g} [{:.3g}, {:.3g}] of the baseline's time, {:.4g} ns a "
      "triangle; {} of {} pairs wrong",
      method.name, method.target, row.ratio.median, row.ratio.low, row.ratio.high,
      NanosecondsATriangle(result, row), row.real.Wrong(),
      result.families[row.family].boundary_pairs);
}

// A sentence at its last blank that leaves the first line short enough for a panel.
std::pair<std::string, std::string> InTwoLines(const std::string& sentence) {
  constexpr std::size_t kMost = 56;
  if (sentence.size() <= kMost) return {sentence, ""};
  const std::size_t blank = sentence.rfind(' ', kMost);
  if (blank == std::string::npos) return {sentence, ""};
  return {sentence.substr(0, blank), sentence.substr(blank + 1)};
}

std::string Axes(const BenchFamily& family) {
  std::string svg = Text(kLeft, 18, "start", family.name, "font-weight=\"600\" font-size=\"14\"");
  const auto [first, second] = InTwoLines(family.summary);
  svg += Text(kLeft, 33, "start", first, "class=\"soft\"");
  svg += Text(kLeft, 46, "start", second, "class=\"soft\"");
  const double bottom = kTop + kPlotHeight;
  for (const double ratio : {0.001, 0.01, 0.1, 1.0, 10.0}) {
    svg += fmt::format("<path class=\"grid\" d=\"M{:.1f} {}V{}\"/>\n", XOf(ratio), kTop, bottom);
    svg += Text(XOf(ratio), bottom + 14, "middle", fmt::format("{}", ratio), "class=\"soft\"");
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

std::string PanelOf(const BenchResult& result, std::uint32_t family) {
  std::string svg = Axes(result.families[family]);
  const std::vector<const BenchRow*> frontier = Frontier(result, family, std::string(kSink));
  std::string path;
  for (const BenchRow* row : frontier) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", XOf(row->ratio.median),
                        YOf(result, *row));
  }
  if (frontier.size() > 1) svg += fmt::format("<path class=\"front\" d=\"{}\"/>\n", path);
  for (const BenchRow& row : result.rows) {
    if (row.family != family || result.methods[row.method].sink != kSink || !row.is_judged)
      continue;
    const double y = YOf(result, row);
    svg += fmt::format("<g><title>{}</title>", Escaped(Title(result, row)));
    svg += fmt::format("<path class=\"bar\" d=\"M{:.1f} {:.1f}H{:.1f}\"/>", XOf(row.ratio.low), y,
                       XOf(row.ratio.high));
    svg += Mark(result.methods[row.method].kind, XOf(row.ratio.median), y, !IsRival(result, row)) +
           "</g>\n";
  }
  double below = kTop + kPlotHeight + 32;
  for (std::size_t k = 0; k < frontier.size(); ++k) {
    const BenchMethod& method = result.methods[frontier[k]->method];
    svg += Text(XOf(frontier[k]->ratio.median), YOf(result, *frontier[k]) - 7, "middle",
                std::to_string(k + 1), "font-weight=\"600\" font-size=\"9\"");
    if (k < 4) {
      svg += Text(
          kLeft, below, "start",
          fmt::format("{} {} ({}): {:.3g} x, {:.4g} ns/triangle", k + 1, method.name, method.target,
                      frontier[k]->ratio.median, NanosecondsATriangle(result, *frontier[k])));
    }
    below += 13;
  }
  return svg;
}

constexpr std::string_view kStyle =
    "<style>text{font:11px system-ui,'DejaVu Sans',sans-serif;fill:#23262d}.soft{fill:#626975}"
    ".grid{stroke:#eceef1}.lane{stroke:#b8bdc6;stroke-dasharray:3 3}.bar{stroke:#3a3f48;"
    "stroke-width:1}.front{fill:none;stroke:#009e73;stroke-width:1.5;opacity:.6}</style>\n";

}  // namespace

bool IsRival(const BenchResult& result, const BenchRow& row) {
  const BenchFamily& family = result.families[row.family];
  return row.is_judged && WrongShare(result, row) < kMostWrong &&
         family.largest_coordinate <= result.methods[row.method].coordinate_limit;
}

std::vector<const BenchRow*> Frontier(const BenchResult& result, std::uint32_t family,
                                      const std::string& sink) {
  std::vector<const BenchRow*> rivals;
  for (const BenchRow& row : result.rows) {
    const bool is_here = row.family == family && result.methods[row.method].sink == sink;
    if (is_here && IsRival(result, row)) rivals.push_back(&row);
  }
  // Proved before 0 of N before rates; then by the share.
  const auto error = [&](const BenchRow* row) {
    return std::pair(LaneOf(result, *row), WrongShare(result, *row));
  };
  std::vector<const BenchRow*> frontier;
  for (const BenchRow* row : rivals) {
    const bool is_beaten = std::ranges::any_of(rivals, [&](const BenchRow* other) {
      return other->ratio.high < row->ratio.low && error(other) <= error(row);
    });
    const bool is_tied_and_worse = std::ranges::any_of(rivals, [&](const BenchRow* other) {
      return !AreApart(other->ratio, row->ratio) && error(other) < error(row);
    });
    if (!is_beaten && !is_tied_and_worse) frontier.push_back(row);
  }
  std::ranges::sort(frontier, {},
                    [](const BenchRow* row) { return std::pair(row->ratio.median, row->method); });
  return frontier;
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
    svg += PanelOf(result, static_cast<std::uint32_t>(k)) + "</g>\n";
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
