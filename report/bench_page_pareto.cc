// Error against run time: the plots, the table of all rows, and the record that they show. The
// script chooses which of them are seen; without it those of the first family are.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "fmt/ranges.h"
#include "report/bench_decision.h"
#include "report/bench_json.h"
#include "report/bench_page_parts.h"
#include "report/bench_svg.h"
#include "report/claims.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// Rows of the first family and the sink that all methods have are shown at first.
std::string RowCells(const BenchResult& bench, const BenchRow& row) {
  const BenchMethod& method = bench.methods[row.method];
  return fmt::format(
      "<tr data-row=\"{}\"{}><th scope=\"row\" class=\"name\">{}</th><td>{}</td><td>{}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "<td>{}</td></tr>\n",
      &row - bench.rows.data(),
      row.family == 0 && method.sink == kCommonSink ? "" : " class=\"off\"", Escaped(method.name),
      Escaped(method.target), Escaped(method.sink), NumberText(NanosecondsATriangle(bench, row)),
      RatioText(row, 3), WrongText(bench, row),
      row.is_judged ? NumberText(row.real.displacement) : "–",
      row.is_judged ? Grouped(WrongBesideEdges(row, row.own)) : "–",
      row.is_judged ? Grouped(row.leaks.Sum()) : "–", NumberText(row.values.edge),
      NumberText(NanosecondsLessFloor(bench, row)), method.vertex_bytes, RemarkText(bench, row));
}

std::string RowsTable(const BenchResult& bench) {
  std::string html =
      "<div class=\"scroll\" id=\"bench-rows\"><table class=\"sorts rows\"><thead><tr>"
      "<th>method</th><th>by</th><th>into</th><th class=\"number\">ns a triangle</th>"
      "<th class=\"number\">time</th><th class=\"number\">wrong</th>"
      "<th class=\"number\">farthest, px</th><th class=\"number\">by own model</th>"
      "<th class=\"number\">leaks</th><th class=\"number\">edge value, px</th>"
      "<th class=\"number\">ns less floor</th><th "
      "class=\"number\">bytes</th><th>remark</th></tr></thead><tbody>\n";
  std::vector<const BenchRow*> rows;
  for (const BenchRow& row : bench.rows) {
    if (!IsBaselineAgain(bench, row)) rows.push_back(&row);
  }
  std::ranges::sort(rows, {}, [](const BenchRow* row) {
    return std::pair(row->ratio.median, row);  // of equal ones the first in the record
  });
  for (const BenchRow* row : rows) html += RowCells(bench, *row);
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
                    {"ns less floor",
                     "without what spans-known takes: the same sink, with nothing to find out"},
                    {"bytes", "that a vertex takes in the format that it reads"}});
}

std::string FamilyOptions(const BenchResult& bench) {
  std::string html;
  for (std::size_t k = 0; k < bench.families.size(); ++k) {
    html += fmt::format("<option value=\"{}\">{}</option>", k, Escaped(bench.families[k].name));
  }
  return html;
}

std::string ErrorOptions() {
  std::string html;
  for (std::size_t k = 0; k < kErrorKinds.size(); ++k) {
    html += fmt::format("<option value=\"{}\" data-unit=\"{}\">{}</option>", k,
                        IsInPixels(kErrorKinds[k]) ? "px" : "share", ErrorName(kErrorKinds[k]));
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
      FamilyOptions(bench), ErrorOptions(), Distinct(bench, &BenchMethod::sink, kCommonSink),
      Distinct(bench, &BenchMethod::target, ""));
}

std::string LargePanels(const BenchResult& bench) {
  std::string html;
  for (std::uint32_t family = 0; family < bench.families.size(); ++family) {
    html += fmt::format("<div{}>{}</div>\n", family == 0 ? "" : " class=\"off\"",
                        LargePanel(bench, family));
  }
  return html;
}

constexpr std::string_view kSaving =
    "<p class=\"save\" id=\"bench-save\" hidden><button type=\"button\" data-as=\"svg\">Save the "
    "plot as SVG</button> <button type=\"button\" data-as=\"png\">as PNG</button> <button "
    "type=\"button\" data-as=\"csv\">Save the table as CSV</button></p>\n";

}  // namespace

std::string RemarkText(const BenchResult& bench, const BenchRow& row) {
  const BenchMethod& method = bench.methods[row.method];
  std::vector<std::string> notes;
  if (method.is_users) notes.emplace_back("yours");
  if (method.coordinate_limit < bench.families[row.family].largest_coordinate) {
    notes.push_back("states nothing beyond " + NumberText(method.coordinate_limit) + " px");
  } else if (row.is_judged && !IsRival(bench, row)) {
    notes.emplace_back("1 % wrong or more");
  }
  if (row.real.lost != 0) notes.emplace_back("whole triangles lost");
  if (row.binds_at_store) notes.emplace_back("bound by storing");
  return fmt::format("{}", fmt::join(notes, "; "));
}

std::string ParetoParts(const BenchResult& bench) {
  if (bench.rows.empty()) return {};
  return Controls(bench) + fmt::format("<style id=\"bench-style\">{}</style>\n", kBenchStyle) +
         "<figure class=\"pareto\"><figcaption id=\"bench-caption\"></figcaption>"
         "<div id=\"bench-plot\">" +
         LargePanels(bench) +
         "</div><p id=\"bench-said\" class=\"why\" aria-live=\"polite\"></p></figure>\n" +
         std::string(kSaving) + RowsTable(bench) +
         "<script type=\"application/json\" id=\"bench-data\">" + BenchToJson(bench) +
         "</script>\n";
}

std::string FamilyPanels(const BenchResult& bench) {
  if (bench.families.empty()) return {};
  std::string html = "<div class=\"panels\">\n";
  for (std::uint32_t family = 0; family < bench.families.size(); ++family) {
    html += FrontierPanel(bench, family);
  }
  return html + "</div>\n";
}

}  // namespace rasterproof::report
