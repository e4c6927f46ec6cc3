// Where methods end: cliffs, curves, fingerprints, and the budget of a frame.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "fmt/format.h"
#include "report/bench_decision.h"
#include "report/bench_page_parts.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// Of a plot, in user units.
constexpr double kWidth = 560;
constexpr double kHeight = 300;
constexpr double kLeftEdge = 62;
constexpr double kTopEdge = 28;
constexpr double kAcross = 310;
constexpr double kDown = 216;
constexpr double kZeroLane = 32;  // below the axis
constexpr double kLineHeight = 12;

// A power of two where it is one, as cliffs mostly are; else all digits.
std::string ValueText(double value) {
  if (std::isnan(value)) return "–";
  int exponent = 0;
  const double half = std::frexp(value, &exponent);
  const bool is_long = value >= 1024 || value < 1;
  if (half == 0.5 && is_long) return fmt::format("2^{}", exponent - 1);
  return fmt::format("{}", value);
}

enum class Measure : std::uint8_t { kBound, kShare, kTime };

double ValueOf(const BenchPoint& point, Measure measure) {
  switch (measure) {
    case Measure::kBound:
      return point.share_of_bound;
    case Measure::kShare:
      return point.asked == 0 ? std::numeric_limits<double>::quiet_NaN()
                              : static_cast<double>(point.wrong) / static_cast<double>(point.asked);
    case Measure::kTime:
      return 1e9 * point.time.median;
  }
  return 0;
}

std::string_view MeasureName(Measure measure) {
  switch (measure) {
    case Measure::kBound:
      return "worst error of E over its proven bound";
    case Measure::kShare:
      return "share of wrong decisions";
    case Measure::kTime:
      return "nanoseconds a triangle";
  }
  return "";
}

// Smallest and largest positive number, as powers of ten around them.
struct Decades {
  double low = std::numeric_limits<double>::infinity();
  double high = 0;

  void Take(double value) {
    if (!std::isfinite(value) || value <= 0) return;
    low = std::min(low, value);
    high = std::max(high, value);
  }
  bool IsEmpty() const { return high == 0; }
  double At(double value) const {
    const double span = std::log(high / low);
    return span == 0 ? 0.5 : std::log(std::clamp(value, low, high) / low) / span;
  }
  void Round() {
    low = std::pow(10, std::floor(std::log10(low)));
    high = std::pow(10, std::ceil(std::log10(high)));
    if (low == high) high *= 10;
  }
};

struct Plot {
  Decades x;
  Decades y;

  double XOf(double value) const { return kLeftEdge + kAcross * x.At(value); }
  // What is 0 lies in a lane of its own.
  double YOf(double value) const {
    return value <= 0 ? kTopEdge + kDown + kZeroLane / 2 : kTopEdge + kDown * (1 - y.At(value));
  }
};

std::string TextAt(double x, double y, std::string_view anchor, std::string_view look,
                   std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>", x,
                     y, anchor, look, Escaped(text));
}

std::string AxesOf(const Plot& plot, const BenchParameter& parameter, Measure measure) {
  std::string svg = TextAt(0, 12, "start", "", MeasureName(measure));
  const double bottom = kTopEdge + kDown + kZeroLane;
  const double decades = std::log10(plot.y.high / plot.y.low);
  const int step = std::max(1, static_cast<int>(std::ceil(decades / 8)));
  for (int k = 0; k <= decades + 0.5; k += step) {
    const double value = plot.y.low * std::pow(10, k);
    svg += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}h{}\"/>", kLeftEdge, plot.YOf(value),
                       kAcross);
    svg += TextAt(kLeftEdge - 6, plot.YOf(value) + 4, "end", "soft", fmt::format("{:.0e}", value));
  }
  svg +=
      fmt::format("<path class=\"lane\" d=\"M{} {}h{}\"/>", kLeftEdge, kTopEdge + kDown, kAcross);
  svg += TextAt(kLeftEdge - 6, plot.YOf(0) + 5, "end", "soft", "0");
  for (const auto& [value, anchor] : {std::pair{plot.x.low, "start"}, {plot.x.high, "end"}}) {
    svg += TextAt(plot.XOf(value), bottom + 15, anchor, "soft", ValueText(value));
  }
  return svg + TextAt(kLeftEdge + kAcross / 2, bottom + 15, "middle", "soft", parameter.name);
}

// Names at the lines' right ends, pushed apart; those that find no room are left to the titles.
std::string EndNames(const BenchResult& bench, const Plot& plot,
                     const std::vector<const BenchCurve*>& curves, Measure measure) {
  std::vector<std::pair<double, std::string>> names;
  for (const BenchCurve* curve : curves) {
    const double end = ValueOf(curve->points.back(), measure);
    if (std::isfinite(end)) {
      names.emplace_back(plot.YOf(end), FullName(bench.methods[curve->method]));
    }
  }
  std::ranges::sort(names);
  std::string svg;
  double least = kTopEdge;
  for (const auto& [y, name] : names) {
    const double at = std::max(y + 4, least);
    if (at > kHeight - 4) break;
    svg += TextAt(kLeftEdge + kAcross + 8, at, "start", "place", name);
    least = at + kLineHeight;
  }
  return svg;
}

std::string LineOf(const BenchResult& bench, const Plot& plot, const BenchCurve& curve,
                   Measure measure) {
  std::string path;
  for (const BenchPoint& point : curve.points) {
    const double value = ValueOf(point, measure);
    if (!std::isfinite(value)) continue;
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", plot.XOf(point.value),
                        plot.YOf(value));
  }
  const BenchMethod& method = bench.methods[curve.method];
  std::string kind = method.is_users ? "yours" : method.kind;
  std::ranges::replace(kind, ' ', '-');
  return fmt::format("<path class=\"line {}\" d=\"{}\"><title>{}</title></path>\n", kind, path,
                     Escaped(FullName(method)));
}

// Nothing if no curve has a positive number.
std::string CurvePlot(const BenchResult& bench, std::uint32_t parameter, Measure measure) {
  std::vector<const BenchCurve*> curves;
  Plot plot;
  for (const BenchCurve& curve : bench.curves) {
    if (curve.parameter != parameter || curve.points.empty()) continue;
    Decades seen;
    for (const BenchPoint& point : curve.points) {
      plot.x.Take(point.value);
      seen.Take(ValueOf(point, measure));
    }
    if (seen.IsEmpty()) continue;
    plot.y.Take(seen.low);
    plot.y.Take(seen.high);
    curves.push_back(&curve);
  }
  if (curves.empty() || plot.x.IsEmpty()) return {};
  plot.y.Round();
  std::string svg = AxesOf(plot, bench.parameters[parameter], measure);
  for (const BenchCurve* curve : curves) svg += LineOf(bench, plot, *curve, measure);
  return fmt::format(
      "<svg class=\"plot curve\" role=\"img\" aria-label=\"{} by {}\" viewBox=\"0 0 {} {}\">{}{}"
      "</svg>\n",
      MeasureName(measure), Escaped(bench.parameters[parameter].name), kWidth, kHeight, svg,
      EndNames(bench, plot, curves, measure));
}

// Those that no plot shows: 0 wrong at every value.
std::string FlatNames(const BenchResult& bench, std::uint32_t parameter) {
  std::string names;
  for (const BenchCurve& curve : bench.curves) {
    const bool is_flat =
        std::ranges::all_of(curve.points, [](const BenchPoint& point) { return point.wrong == 0; });
    if (curve.parameter != parameter || !is_flat) continue;
    names += (names.empty() ? "" : ", ") + Escaped(FullName(bench.methods[curve.method]));
  }
  return names.empty() ? ""
                       : fmt::format("<p class=\"why\">0 wrong at every value: {}.</p>\n", names);
}

std::string CaseOf(const BenchResult& bench, const BenchCliff& cliff, std::string_view folder) {
  if (!cliff.scene) return "–";
  const BenchMethod& method = bench.methods[cliff.method];
  return Command(fmt::format("rasterproof explain {}/{} --{} {} --pixel {} {}", folder,
                             CliffFile(bench, cliff), method.is_users ? "plugin" : "subject",
                             method.name, cliff.x, cliff.y));
}

}  // namespace

std::string CliffTable(const BenchResult& bench, std::string_view folder) {
  if (bench.cliffs.empty()) return {};
  std::string html =
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>method</th><th>what grows</th>"
      "<th class=\"number\">proved to</th><th class=\"number\">held to</th>"
      "<th class=\"number\">first seen failing at</th><th>its case</th></tr></thead><tbody>\n";
  for (const BenchCliff& cliff : bench.cliffs) {
    const BenchParameter& parameter = bench.parameters[cliff.parameter];
    html += fmt::format(
        "<tr><th scope=\"row\" class=\"name\">{}</th><td>{} <span class=\"why\">{}</span></td>"
        "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number {}\">{}</td>"
        "<td>{}</td></tr>\n",
        Escaped(FullName(bench.methods[cliff.method])), Escaped(parameter.name),
        Escaped(parameter.unit == "1" ? "" : parameter.unit), ValueText(cliff.proved_to),
        ValueText(cliff.held_to), std::isnan(cliff.first_failing) ? "zero" : "wrong",
        ValueText(cliff.first_failing), CaseOf(bench, cliff, folder));
  }
  return Folded(fmt::format("Cliffs: {} of methods over parameters", bench.cliffs.size()),
                html + "</tbody></table></div>\n", true);
}

std::string CurvePlots(const BenchResult& bench) {
  std::string html;
  for (std::uint32_t k = 0; k < bench.parameters.size(); ++k) {
    const BenchParameter& parameter = bench.parameters[k];
    std::string plots;
    if (parameter.is_cost) {
      plots = CurvePlot(bench, k, Measure::kTime);
    } else {
      plots = CurvePlot(bench, k, Measure::kBound) + CurvePlot(bench, k, Measure::kShare);
    }
    if (!parameter.is_cost) plots += FlatNames(bench, k);
    if (plots.empty()) continue;
    html += fmt::format("<h3>{}</h3>\n<p class=\"why\">{}</p>\n<div class=\"curves\">{}</div>\n",
                        Escaped(parameter.name), Escaped(parameter.summary), plots);
  }
  return html;
}

std::string FingerprintPictures(const BenchResult& bench) {
  if (bench.fingerprints.empty()) return {};
  std::string html = "<div class=\"prints\">\n";
  for (const BenchFingerprint& print : bench.fingerprints) {
    const std::string name = Escaped(FullName(bench.methods[print.method]));
    const std::string step = Escaped(print.step);
    html += fmt::format(
        "<figure><img alt=\"Fingerprint of {0} in steps of {1}\" loading=\"lazy\" "
        "src=\"data:image/png;base64,{2}\"><figcaption><span class=\"name\">{0}</span> steps of "
        "{1}: {3} of {4} places not as exact</figcaption></figure>\n",
        name, step, Escaped(print.png), Grouped(print.wrong), Grouped(256ULL * 256));
  }
  return html + "</div>\n";
}

std::string StageBars(const BenchResult& bench) {
  if (bench.stages.empty()) return {};
  std::uint64_t most = 1;
  for (const BenchStage& stage : bench.stages) most = std::max(most, stage.wrong);
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>stage</th><th>how it is done</th>"
      "<th class=\"number\">pairs that differ</th><th class=\"number\">per million</th>"
      "<th class=\"number\">farthest, px</th></tr></thead><tbody>\n";
  for (const BenchStage& stage : bench.stages) {
    const double million = stage.asked == 0 ? 0
                                            : 1e6 * static_cast<double>(stage.wrong) /
                                                  static_cast<double>(stage.asked);
    html += fmt::format(
        "<tr><th scope=\"row\">{}</th><td class=\"remark\">{}</td><td class=\"number\">{}"
        "<svg class=\"bar\" viewBox=\"0 0 100 4\" preserveAspectRatio=\"none\" "
        "aria-hidden=\"true\"><rect width=\"{:.1f}\" height=\"4\"/></svg></td>"
        "<td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
        Escaped(stage.name), Escaped(stage.summary), Grouped(stage.wrong),
        100.0 * static_cast<double>(stage.wrong) / static_cast<double>(most), NumberText(million),
        NumberText(stage.displacement));
  }
  return html + "</tbody></table></div>\n";
}

std::string CliffFile(const BenchResult& bench, const BenchCliff& cliff) {
  const BenchMethod& method = bench.methods[cliff.method];
  return FileOf("cliff-" + bench.parameters[cliff.parameter].name, method);
}

}  // namespace rasterproof::report
