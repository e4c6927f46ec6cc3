#include "report/bench_text.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "report/bench_decision.h"
#include "report/claims.h"

namespace rasterproof::report {
namespace {

// Rows of a family, by sink in the order of the first row of each, then by time.
std::vector<const BenchRow*> BenchRowsOf(const BenchResult& result, std::size_t family) {
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

// "proved 0", "0 of 12345", "12.3 %": of the pairs at most a pixel from an edge; "3 of 12345" of
// constructed ones, which are no sample of anything; "far alone" if all wrong pairs lie farther.
std::string ShareText(const BenchErrors& errors, std::uint64_t of, const BenchMethod& method,
                      const BenchFamily& family, bool proves) {
  if (errors.Wrong() == 0) {
    return method.is_proved && proves ? "proved 0" : fmt::format("0 of {}", of);
  }
  if (errors.beside_edges == 0) return "far alone";
  if (family.is_constructed) return fmt::format("{} of {}", errors.beside_edges, of);
  return fmt::format(
      "{:.3g} %",
      of == 0 ? 0 : 100.0 * static_cast<double>(errors.beside_edges) / static_cast<double>(of));
}

std::string DistanceText(double pixels) {
  return std::isnan(pixels) ? "-" : fmt::format("{:.3g}", pixels);
}

std::string DrawingText(const BenchRow& row) {
  return row.drawing_wrong ? std::to_string(*row.drawing_wrong) : "-";
}

// What the user's own subjects' times are, and what of theirs was judged.
std::string UsersText(const BenchResult& result, std::size_t at) {
  std::string text;
  for (const BenchRow* row : BenchRowsOf(result, at)) {
    const BenchMethod& method = result.methods[row->method];
    if (!method.is_users) continue;
    text += fmt::format(
        "  {}: {:.1f} ns a triangle {}{}; -march: {}; {} triangles judged\n", method.name,
        1e9 * row->conversion_seconds,
        method.times_requests
            ? "are those of a scene without triangles: it takes no repeats, so that its time is "
              "that of\n  a request, reading the scene and writing the answer included"
            : "for what is converted are not part of its time",
        method.clock == BenchClock::kWall ? "; elapsed time: another processor draws" : "",
        MarchText(method), row->judged_triangles);
  }
  for (const BenchLeftOut& out : result.left_out) {
    const BenchMethod& method = result.methods[out.method];
    if (out.family == at && method.is_users) {
      text += fmt::format("  {} is left out: {}\n", method.name, out.why);
    }
  }
  return text;
}

std::string TableOf(const BenchResult& result, std::size_t at) {
  const BenchFamily& family = result.families[at];
  std::string table = fmt::format(
      "\n{}: {}.\n  {} triangles, {} pairs covered; judged: {} triangles, {} pairs at most a pixel "
      "from an edge,\n  {} beside a shared edge; {} rounds, ratios to {}\n",
      family.name, family.summary, family.triangles, family.covered, family.judged_triangles,
      family.boundary_pairs, family.shared_pairs, family.rounds,
      result.methods.empty() ? "" : result.methods[family.baseline].name);
  table += fmt::format(
      "  {:<28} {:<8} {:<7} {:>10} {:>10} {:>22} {:>14} {:>9} {:>14} {:>6} {:>6} {:>8}\n", "method",
      "target", "sink", "ns/tri", "less floor", "ratio", "wrong", "px", "own model", "gaps", "over",
      "drawing");
  for (const BenchRow* row : BenchRowsOf(result, at)) {
    const BenchMethod& method = result.methods[row->method];
    const std::string ratio = RatioText(*row, 4);
    const double less = NanosecondsLessFloor(result, *row);
    table += fmt::format("  {:<28} {:<8} {:<7} {:>10.1f} {:>10} {:>22}", method.name, method.target,
                         method.sink, NanosecondsATriangle(result, *row),
                         std::isnan(less) ? "-" : fmt::format("{:.1f}", less), ratio);
    if (!row->is_judged) {
      table += fmt::format(" {:>14} {:>9} {:>14} {:>6} {:>6} {:>8}\n", "-", "-", "-", "-", "-",
                           DrawingText(*row));
      continue;
    }
    const bool is_real = method.model == "real";
    table +=
        fmt::format(" {:>14} {:>9} {:>14} {:>6} {:>6} {:>8}\n",
                    ShareText(row->real, row->boundary_pairs, method, family, is_real),
                    DistanceText(row->real.displacement),
                    is_real ? "" : ShareText(row->own, row->boundary_pairs, method, family, true),
                    row->leaks.gaps, row->leaks.overlaps, DrawingText(*row));
  }
  return table + UsersText(result, at);
}

}  // namespace

std::string NotMeasuredText(const BenchResult& result) {
  // "limits: a" and "limits: b" are told together.
  std::vector<std::pair<std::string_view, std::vector<std::string_view>>> groups;
  constexpr std::string_view kOf = ": ";
  for (const std::string_view one : result.not_measured) {
    const std::size_t of = one.find(kOf);
    const std::string_view what = one.substr(0, of);
    auto group = std::ranges::find(groups, what, [](const auto& known) { return known.first; });
    if (group == groups.end()) group = groups.insert(group, {what, {}});
    if (of != one.npos) group->second.push_back(one.substr(of + kOf.size()));
  }
  if (groups.empty()) return "";
  std::vector<std::string> words;
  for (const auto& [what, whose] : groups) {
    words.push_back(whose.empty() ? std::string(what)
                                  : fmt::format("{} ({})", what, fmt::join(whose, ", ")));
  }
  return fmt::format(
      "Not measured, for want of time: {}. Give a larger --budget, or choose by --family.",
      fmt::join(words, "; "));
}

std::string_view MarchText(const BenchMethod& method) {
  return method.march.empty() ? "not said" : std::string_view(method.march);
}

std::string LoadText(const BenchSetting& setting) {
  if (std::isnan(setting.load_before)) return "Load of the machine: not said.";
  return fmt::format("Load of the machine: {:.2f} at the start, {:.2f} at the end.",
                     setting.load_before, setting.load_after);
}

std::string BenchToTable(const BenchResult& result) {
  const BenchSetting& setting = result.setting;
  std::string table = fmt::format(
      "{}\n{}. {}\nTime: median of the rounds, processor time of one draw, target cleared before "
      "it; "
      "ratio with its 95 %\ninterval, paired within rounds. Wrong: share of the pairs (triangle, "
      "sample) at most a pixel from an edge;\npx: largest distance of a wrong sample from its "
      "triangle's boundary.\n",
      setting.command, setting.processor, LoadText(setting));
  for (std::size_t at = 0; at < result.families.size(); ++at) table += TableOf(result, at);
  const std::string lacking = NotMeasuredText(result);
  return lacking.empty() ? table : table + "\n" + lacking + "\n";
}

std::string CostsToTable(const BenchResult& result) {
  std::string text;
  for (std::uint32_t k = 0; k < result.parameters.size(); ++k) {
    const BenchParameter& parameter = result.parameters[k];
    std::string lines;
    for (const BenchCurve& curve : result.curves) {
      if (!parameter.is_cost || curve.parameter != k) continue;
      const BenchMethod& method = result.methods[curve.method];
      lines +=
          fmt::format("  {:<36}", fmt::format("{} {} {}", method.name, method.target, method.sink));
      for (const BenchPoint& point : curve.points) {
        lines += fmt::format("  {:g}: {:.4g}", point.value, 1e9 * point.time.median);
      }
      lines += '\n';
    }
    if (lines.empty()) continue;
    text += fmt::format("{}{}\n  {}: nanoseconds a triangle\n{}", text.empty() ? "" : "\n",
                        parameter.summary, parameter.unit, lines);
  }
  const std::string lacking = NotMeasuredText(result);
  return lacking.empty() ? text : text + "\n" + lacking + "\n";
}

}  // namespace rasterproof::report
