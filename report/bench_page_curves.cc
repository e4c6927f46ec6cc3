// Curves of errors and costs over parameters, as small multiples. Methods that draw the same line
// are one line.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/bench_decision.h"
#include "report/bench_page_parts.h"
#include "report/limits_text.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// Of a plot, in user units.
constexpr double kWidth = 400;
constexpr double kHeight = 244;
constexpr double kLeftEdge = 46;
constexpr double kTopEdge = 16;
constexpr double kAcross = 322;
constexpr double kDown = 168;
constexpr double kZeroLane = 24;  // below the axis
constexpr double kBottom = kTopEdge + kDown + kZeroLane;
constexpr double kLineHeight = 11;

enum class Measure : std::uint8_t { kDistance, kShare, kBound, kTime };

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double ValueOf(const BenchPoint& point, Measure measure) {
  switch (measure) {
    case Measure::kDistance:
      return point.asked == 0 ? kNone : point.displacement;
    case Measure::kShare:
      return point.asked == 0 ? kNone
                              : static_cast<double>(point.wrong) / static_cast<double>(point.asked);
    case Measure::kBound:
      return point.share_of_bound;
    case Measure::kTime:
      return 1e9 * point.time.median;
  }
  return kNone;
}

std::string_view MeasureName(Measure measure) {
  switch (measure) {
    case Measure::kDistance:
      return "farthest wrong sample from the boundary, pixels";
    case Measure::kShare:
      return "share of wrong decisions";
    case Measure::kBound:
      return "worst error of E over its proven bound";
    case Measure::kTime:
      return "nanoseconds a triangle";
  }
  return "";
}

// Lines that differ by less are one: errors of a few constructed cases, times of a few rounds.
double SameWithin(Measure measure) { return measure == Measure::kTime ? 1.25 : 2; }

// Smallest and largest positive number.
struct Range {
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
  void RoundToDecades() {
    low = std::pow(10, std::floor(std::log10(low)));
    high = std::pow(10, std::ceil(std::log10(high)));
    if (low == high) high *= 10;
  }
};

// Curves that are one line.
struct Line {
  std::vector<const BenchCurve*> curves;
};

struct Plot {
  std::uint32_t parameter = 0;
  Measure measure = Measure::kDistance;
  Range x;
  Range y;
  std::vector<Line> lines;

  double XOf(double value) const { return kLeftEdge + kAcross * x.At(value); }
  // Returns the row of the value; the value 0 has a separate lane.
  double YOf(double value) const {
    return value <= 0 ? kTopEdge + kDown + kZeroLane / 2 : kTopEdge + kDown * (1 - y.At(value));
  }
};

// Points that have the measure.
std::vector<std::pair<double, double>> PointsOf(const BenchCurve& curve, Measure measure) {
  std::vector<std::pair<double, double>> points;
  for (const BenchPoint& point : curve.points) {
    const double value = ValueOf(point, measure);
    if (std::isfinite(value)) points.emplace_back(point.value, value);
  }
  return points;
}

bool AreOneLine(const BenchCurve& a, const BenchCurve& b, Measure measure) {
  const auto same = [&](const auto& p, const auto& q) {
    if (p.first != q.first || (p.second <= 0) != (q.second <= 0)) return false;
    return p.second <= 0 ||
           std::max(p.second / q.second, q.second / p.second) <= SameWithin(measure);
  };
  return std::ranges::equal(PointsOf(a, measure), PointsOf(b, measure), same);
}

// Nothing if no curve has a positive number.
std::optional<Plot> PlotOf(const BenchResult& bench, std::uint32_t parameter, Measure measure) {
  Plot plot;
  plot.parameter = parameter;
  plot.measure = measure;
  for (const BenchCurve& curve : bench.curves) {
    if (curve.parameter != parameter) continue;
    Range seen;
    for (const auto& [at, value] : PointsOf(curve, measure)) {
      plot.x.Take(at);
      seen.Take(value);
    }
    if (seen.IsEmpty()) continue;
    plot.y.Take(seen.low);
    plot.y.Take(seen.high);
    // The user's subject is always a separate line.
    const bool is_users = bench.methods[curve.method].is_users;
    const auto same = std::ranges::find_if(plot.lines, [&](const Line& line) {
      return !is_users && !bench.methods[line.curves[0]->method].is_users &&
             AreOneLine(*line.curves[0], curve, measure);
    });
    if (same == plot.lines.end()) {
      plot.lines.push_back({{&curve}});
    } else {
      same->curves.push_back(&curve);
    }
  }
  if (plot.lines.empty()) return std::nullopt;
  plot.y.RoundToDecades();
  return plot;
}

std::string TextAt(double x, double y, std::string_view anchor, std::string_view look,
                   std::string_view text) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\">{}</text>", x,
                     y, anchor, look, Escaped(text));
}

std::string PowerText(double value) {
  const int exponent = static_cast<int>(std::lround(std::log10(value)));
  return std::abs(exponent) <= 3 ? fmt::format("{:g}", value)
                                 : RaisedText(fmt::format("10^{}", exponent));
}

std::string VerticalAxis(const Plot& plot) {
  std::string svg;
  const int decades = static_cast<int>(std::lround(std::log10(plot.y.high / plot.y.low)));
  const int step = std::max(1, (decades + 6) / 7);
  for (int k = 0; k <= decades; k += step) {
    const double value = plot.y.low * std::pow(10, k);
    svg += fmt::format("<path class=\"grid\" d=\"M{} {:.1f}h{}\"/>", kLeftEdge, plot.YOf(value),
                       kAcross);
    svg += TextAt(kLeftEdge - 5, plot.YOf(value) + 4, "end", "soft", PowerText(value));
  }
  if (plot.measure == Measure::kTime) return svg;
  svg +=
      fmt::format("<path class=\"lane\" d=\"M{} {}h{}\"/>", kLeftEdge, kTopEdge + kDown, kAcross);
  return svg + TextAt(kLeftEdge - 5, plot.YOf(0) + 4, "end", "soft", "0");
}

// Powers of two, four or five of them.
std::string HorizontalAxis(const Plot& plot, const BenchParameter& parameter) {
  std::string svg;
  const int first = static_cast<int>(std::ceil(std::log2(plot.x.low) - 1e-9));
  const int last = static_cast<int>(std::floor(std::log2(plot.x.high) + 1e-9));
  const int step = std::max(1, (last - first + 3) / 4);
  for (int k = first; k <= last; k += step) {
    const double value = std::ldexp(1, k);
    svg += fmt::format("<path class=\"grid\" d=\"M{:.1f} {}V{}\"/>", plot.XOf(value), kTopEdge,
                       kBottom);
    svg += TextAt(plot.XOf(value), kBottom + 14, "middle", "soft", RaisedText(ValueText(value)));
  }
  const std::string unit =
      parameter.unit == "1" || parameter.unit == parameter.name ? "" : ", " + parameter.unit;
  return svg +
         TextAt(kLeftEdge + kAcross / 2, kBottom + 30, "middle", "soft", parameter.name + unit);
}

// Between two points as the line is drawn; nothing outside of them.
std::optional<double> YOnLine(const Plot& plot, const BenchCurve& curve, double at) {
  const auto points = PointsOf(curve, plot.measure);
  for (std::size_t k = 0; k + 1 < points.size(); ++k) {
    if (at < points[k].first || at > points[k + 1].first) continue;
    const double x0 = plot.XOf(points[k].first);
    const double x1 = plot.XOf(points[k + 1].first);
    const double t = x0 == x1 ? 0 : (plot.XOf(at) - x0) / (x1 - x0);
    return std::lerp(plot.YOf(points[k].second), plot.YOf(points[k + 1].second), t);
  }
  return std::nullopt;
}

// A cross where a method of the line was first seen failing.
std::string CliffMarks(const BenchResult& bench, const Plot& plot, const Line& line) {
  std::string svg;
  std::vector<double> marked;
  for (const BenchCurve* curve : line.curves) {
    for (const BenchCliff& cliff : bench.cliffs) {
      if (cliff.method != curve->method || cliff.parameter != plot.parameter) continue;
      if (std::isnan(cliff.first_failing)) continue;
      if (std::ranges::find(marked, cliff.first_failing) != marked.end()) continue;
      const std::optional<double> y = YOnLine(plot, *line.curves[0], cliff.first_failing);
      if (!y) continue;
      marked.push_back(cliff.first_failing);
      svg += fmt::format(
          "<path class=\"cliff\" d=\"M{:.1f} {:.1f}l6 6m-6 0l6 -6\"><title>{}: {}</title></path>",
          plot.XOf(cliff.first_failing) - 3, *y - 3, Escaped(FullName(bench.methods[cliff.method])),
          Escaped(CliffText(cliff)));
    }
  }
  return svg;
}

std::string KindOf(const BenchMethod& method) {
  std::string kind = method.is_users ? "yours" : method.kind;
  std::ranges::replace(kind, ' ', '-');
  return kind;
}

std::string AllNames(const BenchResult& bench, const Line& line) {
  std::string names;
  for (const BenchCurve* curve : line.curves) {
    names += (names.empty() ? "" : ", ") + Escaped(FullName(bench.methods[curve->method]));
  }
  return names;
}

std::string LinePath(const BenchResult& bench, const Plot& plot, const Line& line) {
  std::string path;
  for (const auto& [at, value] : PointsOf(*line.curves[0], plot.measure)) {
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? "M" : "L", plot.XOf(at), plot.YOf(value));
  }
  return fmt::format("<path class=\"line {}\" d=\"{}\"><title>{}</title></path>\n",
                     KindOf(bench.methods[line.curves[0]->method]), path, AllNames(bench, line));
}

// Draws the vertical line where float32 ends: beyond it only the other formats have values.
std::string FloatEnd(const BenchResult& bench, const Plot& plot) {
  double end = 0;
  for (const Line& line : plot.lines) {
    for (const BenchCurve* curve : line.curves) {
      if (bench.methods[curve->method].kind != "float32") continue;
      end = std::max(end, PointsOf(*curve, plot.measure).back().first);
    }
  }
  if (end == 0 || end >= plot.x.high) return {};
  const double x = plot.XOf(end);
  return fmt::format("<path class=\"lane\" d=\"M{:.1f} {}V{}\"/>", x, kTopEdge, kBottom) +
         TextAt(x, kTopEdge - 5, "middle", "soft", "float32 ends");
}

// Numbers of the list below at the lines' ends, pushed apart; what finds no room has its title.
std::string EndNumbers(const Plot& plot) {
  std::vector<std::array<double, 2>> taken;
  std::string svg;
  for (std::size_t n = 0; n < plot.lines.size(); ++n) {
    const auto [at, value] = PointsOf(*plot.lines[n].curves[0], plot.measure).back();
    const double x = plot.XOf(at) + 5;
    for (int k = 0; k < 24; ++k) {
      const int lines = (k % 2 == 0 ? 1 : -1) * ((k + 1) / 2);
      const double y = plot.YOf(value) + 4 + lines * kLineHeight;
      const bool is_free = std::ranges::none_of(taken, [&](const std::array<double, 2>& other) {
        return std::abs(other[0] - x) < 18 && std::abs(other[1] - y) < kLineHeight;
      });
      if (!is_free || y < kTopEdge + 4 || y > kBottom) continue;
      taken.push_back({x, y});
      svg += TextAt(x, y, "start", "place", std::to_string(n + 1));
      break;
    }
  }
  return svg;
}

// "f32-direct and 7 more", all of them when it is unfolded.
std::string LineNames(const BenchResult& bench, const Plot& plot) {
  std::string html = "<ol>\n";
  for (const Line& line : plot.lines) {
    const BenchMethod& first = bench.methods[line.curves[0]->method];
    const std::string name = Escaped(FullName(first)) + (first.is_users ? " (yours)" : "");
    html += fmt::format("<li class=\"{}\">", KindOf(first));
    html += line.curves.size() == 1
                ? name
                : Folded(fmt::format("{} and {} more", name, line.curves.size() - 1),
                         AllNames(bench, line), false);
    html += "</li>\n";
  }
  return html + "</ol>\n";
}

std::string CurveFigure(const BenchResult& bench, const Plot& plot, const std::string& about,
                        const std::string& below) {
  const BenchParameter& parameter = bench.parameters[plot.parameter];
  std::string svg = VerticalAxis(plot) + HorizontalAxis(plot, parameter) + FloatEnd(bench, plot);
  for (const Line& line : plot.lines) svg += LinePath(bench, plot, line);
  for (const Line& line : plot.lines) svg += CliffMarks(bench, plot, line);
  return fmt::format(
      "<figure class=\"curve\"><figcaption><b>{0}</b>: {1}{2}</figcaption>\n"
      "<svg class=\"plot\" role=\"img\" aria-label=\"{1} by {0}\" viewBox=\"0 0 {3} {4}\">{5}{6}"
      "</svg>\n{7}{8}</figure>\n",
      Escaped(parameter.name), MeasureName(plot.measure), about, kWidth, kHeight, svg,
      EndNumbers(plot), LineNames(bench, plot), below);
}

// Those that no plot shows: 0 wrong at every value.
std::string FlatNames(const BenchResult& bench, std::uint32_t parameter) {
  constexpr std::size_t kMostUnfoldedNames = 3;
  std::string names;
  std::size_t count = 0;
  for (const BenchCurve& curve : bench.curves) {
    const bool is_flat =
        std::ranges::all_of(curve.points, [](const BenchPoint& point) { return point.wrong == 0; });
    if (curve.parameter != parameter || !is_flat) continue;
    names += (names.empty() ? "" : ", ") + Escaped(FullName(bench.methods[curve.method]));
    ++count;
  }
  if (count == 0) return {};
  if (count <= kMostUnfoldedNames) {
    return fmt::format("<p class=\"why\">0 wrong at every value: {}.</p>", names);
  }
  return "<div class=\"why\">" +
         Folded(fmt::format("0 wrong at every value: {} methods", count), names, false) +
         "</div>\n";
}

// How wrong it gets, in pixels where a distance says it, and what of the bound is used up.
std::string ErrorFigures(const BenchResult& bench, std::uint32_t parameter) {
  std::optional<Plot> wrong = PlotOf(bench, parameter, Measure::kDistance);
  if (!wrong) wrong = PlotOf(bench, parameter, Measure::kShare);
  const std::string flat = FlatNames(bench, parameter);
  std::string html;
  if (wrong) html += CurveFigure(bench, *wrong, "", flat);
  const std::optional<Plot> bound = PlotOf(bench, parameter, Measure::kBound);
  if (bound) html += CurveFigure(bench, *bound, "", wrong ? "" : flat);
  if (html.empty()) return html;
  return fmt::format("<div class=\"pair\" id=\"curve-{}\">{}</div>\n",
                     Escaped(bench.parameters[parameter].name), html);
}

constexpr std::string_view kErrorsIntro =
    "<h3>How wrong they get on the way</h3>\n<p class=\"why\">Each plot grows one parameter, named "
    "in the key above. At each value the hardest cases known are drawn, so that a share is no "
    "rate. "
    "Methods that differ by less than a factor of 2 everywhere are one line; a number at its end "
    "is "
    "that of the list below. A cross: first seen failing.</p>\n";
constexpr std::string_view kCostsIntro =
    "<h3>What a triangle costs</h3>\n<p class=\"why\">Methods that differ by less than a quarter "
    "everywhere are one line.</p>\n";

}  // namespace

std::string CurvePlots(const BenchResult& bench) {
  std::string errors;
  std::string costs;
  for (std::uint32_t k = 0; k < bench.parameters.size(); ++k) {
    if (!bench.parameters[k].is_cost) {
      errors += ErrorFigures(bench, k);
      continue;
    }
    const std::optional<Plot> plot = PlotOf(bench, k, Measure::kTime);
    const std::string summary =
        fmt::format(" <span class=\"why\">{}</span>", Escaped(bench.parameters[k].summary));
    if (plot) costs += CurveFigure(bench, *plot, summary, "");
  }
  std::string html;
  if (!errors.empty()) {
    html += fmt::format("{}<div class=\"curves\">{}</div>\n", kErrorsIntro, errors);
  }
  if (!costs.empty()) {
    html += fmt::format("{}<div class=\"curves costs\">{}</div>\n", kCostsIntro, costs);
  }
  return html;
}

}  // namespace rasterproof::report
