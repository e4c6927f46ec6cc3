// Error against run time: the plot that the script draws, and the table shown without the script.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "io/scene_json.h"
#include "report/bench_decision.h"
#include "report/bench_page_parts.h"
#include "report/bench_svg.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

struct ErrorName {
  ErrorKind kind;
  std::string_view name;
  std::string_view unit;  // "share" or "px"
};
constexpr std::array kErrorNames{
    ErrorName{ErrorKind::kReal, "share wrong, by real geometry", "share"},
    ErrorName{ErrorKind::kOwn, "share wrong, by the method's own model", "share"},
    ErrorName{ErrorKind::kDisplacement, "farthest wrong sample from the boundary", "px"},
    ErrorName{ErrorKind::kLeaks, "leaks along shared edges", "share"},
    ErrorName{ErrorKind::kEdge, "largest error of an edge's value", "px"}};

// A string within a script element: nothing in it ends the element.
std::string Quoted(std::string_view text) {
  std::string json = io::JsonString(text);
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos; ++at) {
    json.replace(at, 1, "\\u003c");
  }
  return json;
}

std::string NumberJson(double value) {
  return std::isfinite(value) ? fmt::format("{:.6g}", value) : "null";
}

std::string MethodJson(const BenchMethod& method) {
  return fmt::format(
      "{{\"name\":{},\"full\":{},\"summary\":{},\"kind\":{},\"target\":{},\"sink\":{},\"model\":{},"
      "\"proved\":{},\"yours\":{},\"limit\":{},\"bytes\":{},\"bits\":{}}}",
      Quoted(method.name), Quoted(FullName(method)), Quoted(method.summary), Quoted(method.kind),
      Quoted(method.target), Quoted(method.sink), Quoted(method.model), method.is_proved,
      method.is_users, NumberJson(method.coordinate_limit), method.vertex_bytes, method.pixel_bits);
}

std::string FamilyJson(const BenchResult& bench, const BenchFamily& family) {
  return fmt::format(
      "{{\"name\":{},\"summary\":{},\"baseline\":{},\"constructed\":{},\"random\":{},\"boundary\":{"
      "},"
      "\"shared\":{},\"covered\":{},\"reach\":{}}}",
      Quoted(family.name), Quoted(family.summary), Quoted(bench.methods[family.baseline].name),
      family.is_constructed, family.is_random, family.boundary_pairs, family.shared_pairs,
      family.covered, NumberJson(family.largest_coordinate));
}

// [lane, value, whether it is on the frontier] of each error.
std::string ErrorsJson(const BenchResult& bench, const BenchRow& row) {
  std::vector<std::string> errors;
  for (const ErrorName& error : kErrorNames) {
    const RowError one = ErrorOf(bench, row, error.kind);
    const std::vector<const BenchRow*> frontier =
        Frontier(bench, row.family, bench.methods[row.method].sink, error.kind);
    const bool is_on_frontier = std::ranges::find(frontier, &row) != frontier.end();
    errors.push_back(fmt::format("[{},{},{}]", static_cast<int>(one.lane), NumberJson(one.value),
                                 is_on_frontier ? 1 : 0));
  }
  return fmt::format("[{}]", fmt::join(errors, ","));
}

std::string RowJson(const BenchResult& bench, const BenchRow& row) {
  return fmt::format(
      "{{\"f\":{},\"m\":{},\"ratio\":[{},{},{}],\"ns\":{},\"ms\":{},\"rival\":{},\"store\":{},"
      "\"judged\":{},\"wrong\":{},\"own\":{},\"pairs\":{},\"lost\":{},\"leaks\":{},\"e\":{}}}",
      row.family, row.method, NumberJson(row.ratio.low), NumberJson(row.ratio.median),
      NumberJson(row.ratio.high), NumberJson(NanosecondsATriangle(bench, row)),
      NumberJson(MillisecondsAFrame(bench, row, kFramePixels[0])), IsRival(bench, row),
      row.binds_at_store, row.is_judged, WrongBesideEdges(row, row.real),
      WrongBesideEdges(row, row.own), row.boundary_pairs, row.real.lost, row.leaks.Sum(),
      ErrorsJson(bench, row));
}

// All that the script draws from.
std::string DataJson(const BenchResult& bench) {
  std::vector<std::string> errors;
  for (const ErrorName& error : kErrorNames) {
    errors.push_back(
        fmt::format("{{\"name\":{},\"unit\":{}}}", Quoted(error.name), Quoted(error.unit)));
  }
  std::vector<std::string> methods;
  for (const BenchMethod& method : bench.methods) methods.push_back(MethodJson(method));
  std::vector<std::string> families;
  for (const BenchFamily& family : bench.families) families.push_back(FamilyJson(bench, family));
  std::vector<std::string> rows;
  for (const BenchRow& row : bench.rows) {
    if (!IsBaselineAgain(bench, row)) rows.push_back(RowJson(bench, row));
  }
  return fmt::format(
      "{{\"processor\":{},\"errors\":[{}],\n\"methods\":[{}],\n\"families\":[{}],\n\"rows\":[{}]}}",
      Quoted(bench.setting.processor), fmt::join(errors, ","), fmt::join(methods, ",\n"),
      fmt::join(families, ",\n"), fmt::join(rows, ",\n"));
}

// Every cell that the script fills, of the first family.
std::string PlainRow(const BenchResult& bench, const BenchRow& row) {
  const BenchMethod& method = bench.methods[row.method];
  return fmt::format(
      "<tr><th scope=\"row\" class=\"name\">{}</th><td>{}</td><td>{}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{:.3g}</td><td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{}</td><td></td></tr>\n",
      Escaped(method.name), Escaped(method.target), Escaped(method.sink),
      NumberText(NanosecondsATriangle(bench, row)), row.ratio.median, WrongText(bench, row),
      row.is_judged ? NumberText(row.real.displacement) : "–",
      row.is_judged ? Grouped(WrongBesideEdges(row, row.own)) : "–",
      row.is_judged ? Grouped(row.leaks.Sum()) : "–", NumberText(row.values.edge),
      method.vertex_bytes);
}

std::string RowsTable(const BenchResult& bench) {
  std::string html =
      "<div class=\"scroll\" id=\"bench-rows\"><table class=\"sorts rows\"><thead><tr>"
      "<th>method</th><th>by</th><th>into</th><th class=\"number\">ns a triangle</th>"
      "<th class=\"number\">time</th><th class=\"number\">wrong</th>"
      "<th class=\"number\">farthest, px</th><th class=\"number\">by own model</th>"
      "<th class=\"number\">leaks</th><th class=\"number\">edge value, px</th>"
      "<th class=\"number\">bytes</th><th>remark</th></tr></thead><tbody>\n";
  std::vector<const BenchRow*> rows;
  for (const BenchRow& row : bench.rows) {
    const bool is_here = row.family == 0 && bench.methods[row.method].sink == kCommonSink;
    if (is_here && !IsBaselineAgain(bench, row)) rows.push_back(&row);
  }
  std::ranges::sort(rows, {}, [](const BenchRow* row) { return row->ratio.median; });
  for (const BenchRow* row : rows) html += PlainRow(bench, *row);
  return html + "</tbody></table></div>\n" +
         ColumnKey({{"by", "instruction set; compiler: as the compiler was told"},
                    {"into", "the sink: counts by facing, counts of 8 bits, a bit a pixel, ..."},
                    {"time", "times the baseline's, with its 95 % interval"},
                    {"wrong",
                     "pairs (triangle, sample) decided otherwise than real geometry, of "
                     "those at most a pixel from an edge"},
                    {"farthest", "distance of a wrong sample from its triangle's boundary"},
                    {"by own model",
                     "the same pairs by the method's own model, such as vertices "
                     "snapped to a grid"},
                    {"leaks", "gaps and overlaps along shared edges, by the own model"},
                    {"edge value",
                     "largest error of E over the edge's length; – where it "
                     "computes none"},
                    {"bytes", "that a vertex takes in the format that it reads"}});
}

std::string Options(const std::vector<std::string>& names) {
  std::string html;
  for (std::size_t k = 0; k < names.size(); ++k) {
    html += fmt::format("<option value=\"{}\">{}</option>", k, Escaped(names[k]));
  }
  return html;
}

// Sinks or instruction sets, each once, as values of a picker.
std::string Distinct(const BenchResult& bench, std::string BenchMethod::* member,
                     std::string_view chosen) {
  std::vector<std::string> names;
  std::string html;
  for (const BenchMethod& method : bench.methods) {
    const std::string& name = method.*member;
    if (std::ranges::find(names, name) != names.end()) continue;
    names.push_back(name);
    html += fmt::format("<option{}>{}</option>", name == chosen ? " selected" : "", Escaped(name));
  }
  return html;
}

std::string Controls(const BenchResult& bench) {
  std::vector<std::string> families;
  for (const BenchFamily& family : bench.families) families.push_back(family.name);
  std::vector<std::string> errors;
  for (const ErrorName& error : kErrorNames) errors.emplace_back(error.name);
  return fmt::format(
      "<form id=\"bench-pick\" class=\"pick\" hidden>\n"
      "<label>Triangles <select name=\"family\">{}</select></label>\n"
      "<label>Error <select name=\"error\">{}</select></label>\n"
      "<label>Into <select name=\"sink\">{}</select></label>\n"
      "<label>Instruction set <select name=\"target\"><option value=\"\">all</option>{}</select>"
      "</label>\n"
      "<label>Bytes a vertex, at most <select name=\"bytes\"><option value=\"\">any</option>"
      "<option>8</option><option>16</option><option>24</option></select></label>\n"
      "<label><input type=\"checkbox\" name=\"tight\"> leaks nothing</label>\n"
      "<label><input type=\"checkbox\" name=\"exact\"> 0 wrong by its own model</label>\n"
      "</form>\n",
      Options(families), Options(errors), Distinct(bench, &BenchMethod::sink, kCommonSink),
      Distinct(bench, &BenchMethod::target, ""));
}

std::string Panel(const BenchResult& bench, std::uint32_t family, PanelPoints points) {
  return fmt::format(
      "<svg class=\"plot panel\" role=\"img\" aria-label=\"Error against run time: {}\" "
      "viewBox=\"0 0 {} {}\">{}</svg>\n",
      Escaped(bench.families[family].name), kPanelWidth, kPanelHeight,
      BenchPanel(bench, family, points));
}

constexpr std::string_view kSaving =
    "<p class=\"save\" id=\"bench-save\" hidden><button type=\"button\" data-as=\"svg\">Save the "
    "plot as SVG</button> <button type=\"button\" data-as=\"png\">as PNG</button> <button "
    "type=\"button\" data-as=\"csv\">Save the table as CSV</button></p>\n";

}  // namespace

std::string ParetoParts(const BenchResult& bench) {
  if (bench.rows.empty()) return {};
  return Controls(bench) +
         "<figure class=\"pareto\"><figcaption id=\"bench-caption\"></figcaption>"
         "<div id=\"bench-plot\">" +
         Panel(bench, 0, PanelPoints::kAll) +
         "</div><p id=\"bench-said\" class=\"why\" aria-live=\"polite\"></p></figure>\n" +
         std::string(kSaving) + RowsTable(bench) +
         "<script type=\"application/json\" id=\"bench-data\">" + DataJson(bench) + "</script>\n";
}

std::string FamilyPanels(const BenchResult& bench) {
  if (bench.families.empty()) return {};
  std::string html = "<div class=\"panels\">\n";
  for (std::uint32_t family = 0; family < bench.families.size(); ++family) {
    html += Panel(bench, family, PanelPoints::kFrontier);
  }
  return html + "</div>\n";
}

}  // namespace rasterproof::report
