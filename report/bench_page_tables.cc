// The tables that decide: by need, by claims, of the user's own.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/bench_decision.h"
#include "report/bench_page_parts.h"
#include "report/bench_text.h"
#include "report/claims.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

std::string FamilyHead(const BenchFamily& family) {
  return fmt::format(
      "<th scope=\"row\"><span class=\"name\">{}</span><span class=\"why\">{}</span></th>",
      Escaped(family.name), Escaped(family.summary));
}

std::string NameOf(const BenchMethod& method) {
  return fmt::format("<span class=\"name\">{}</span>{}", Escaped(FullName(method)),
                     method.is_users ? " <span class=\"yours\">yours</span>" : "");
}

std::string TiedText(const BenchResult& bench, const Decision& decision) {
  constexpr std::size_t kMostNamed = 2;
  if (decision.tied.empty()) return {};
  std::string names;
  for (std::size_t k = 0; k < std::min(kMostNamed, decision.tied.size()); ++k) {
    names += (k == 0 ? "" : ", ") + Escaped(FullName(bench.methods[decision.tied[k]->method]));
  }
  if (decision.tied.size() > kMostNamed) {
    names += fmt::format(" and {} more", decision.tied.size() - kMostNamed);
  }
  return fmt::format("<span class=\"why tied\">~ {}</span>", names);
}

// A cell over several columns says so: it is no cell of the first one alone.
std::string SpanText(std::size_t columns) {
  if (columns == 1) return {};
  return fmt::format("<span class=\"why\">also the cheapest in the next {}</span>",
                     columns == 2 ? "column" : fmt::format("{} columns", columns - 1));
}

std::string DecisionCell(const BenchResult& bench, const std::optional<Decision>& decision,
                         std::size_t columns) {
  if (!decision) {
    return fmt::format("<td colspan=\"{}\" class=\"none\">no method shown here</td>", columns);
  }
  const BenchRow& row = *decision->row;
  return fmt::format(
      "<td colspan=\"{}\">{}<span class=\"figures\"><b>{} ns</b> · {} / {} ms · {}{:.2f} "
      "x</span>{}{}"
      "</td>",
      columns, NameOf(bench.methods[row.method]), NumberText(NanosecondsATriangle(bench, row)),
      NumberText(MillisecondsAFrame(bench, row, kFramePixels[0])),
      NumberText(MillisecondsAFrame(bench, row, kFramePixels[1])),
      decision->is_tied_with_fastest ? "~" : "", decision->ratio, TiedText(bench, *decision),
      SpanText(columns));
}

// Neighbouring needs that the same method meets cheapest share a cell.
std::string DecisionRow(const BenchResult& bench, std::uint32_t family) {
  std::array<std::optional<Decision>, kNeeds.size()> decisions;
  for (std::size_t k = 0; k < kNeeds.size(); ++k) decisions[k] = Decide(bench, family, kNeeds[k]);
  const auto row_of = [&](std::size_t k) { return decisions[k] ? decisions[k]->row : nullptr; };
  std::string html = "<tr>" + FamilyHead(bench.families[family]);
  for (std::size_t k = 0; k < kNeeds.size();) {
    std::size_t end = k + 1;
    while (end < kNeeds.size() && row_of(end) == row_of(k)) ++end;
    // The loosest need has the most that are tied.
    html += DecisionCell(bench, decisions[end - 1], end - k);
    k = end;
  }
  return html + "</tr>\n";
}

// Names in backticks, as the documents have them.
std::string WithNames(const std::string& text) {
  std::string html;
  bool is_name = false;
  for (const char c : Escaped(text)) {
    if (c != '`') {
      html += c;
    } else {
      html += is_name ? "</span>" : "<span class=\"name\">";
      is_name = !is_name;
    }
  }
  return html;
}

std::string ClaimCells(const BenchResult& bench, const ClaimCell& cell) {
  const std::string name = Escaped(bench.families[cell.family].name);
  if (!cell.ratio) return fmt::format("<li>{}: at the floor</li>", name);
  return fmt::format("<li>{}: {:.3g} [{:.3g}, {:.3g}]{}</li>", name, cell.ratio->median,
                     cell.ratio->low, cell.ratio->high, cell.Overlaps() ? ", overlap" : "");
}

std::string RowOfClaim(const BenchResult& bench, const Claim& claim) {
  const ClaimFigure figure = FigureOf(claim, bench);
  if (figure.cells.empty()) return {};
  std::string cells;
  for (const ClaimCell& cell : figure.cells) cells += ClaimCells(bench, cell);
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td>{}</td><td>{}</td><td><details><summary>by family</summary>"
      "<ul class=\"plain\">{}</ul></details></td></tr>\n",
      claim.about, WithNames(figure.sentence.substr(claim.about.size() + 2)), DifferenceText(claim),
      cells);
}

// What was not judged is not 0.
std::string IfJudged(const BenchRow& row, const std::string& text) {
  return row.is_judged ? text : "–";
}

// Of a method whose triangles were not judged one by one: the whole drawing.
std::string DrawingCell(const BenchRow& row) {
  return row.drawing_wrong ? fmt::format("{} in the drawing", Grouped(*row.drawing_wrong)) : "–";
}

std::string UsersRow(const BenchResult& bench, const BenchRow& row) {
  const BenchMethod& method = bench.methods[row.method];
  const std::optional<Decision> proved = Decide(bench, row.family, Need::kProvedZero);
  const std::optional<Decision> fastest = Decide(bench, row.family, Need::kAnything);
  const auto beside = [&](const std::optional<Decision>& other) {
    return !other ? std::string("<td class=\"number none\">–</td>")
                  : fmt::format("<td class=\"number\">{:.2f} x</td>",
                                row.time.median / other->row->time.median);
  };
  return fmt::format(
      "<tr>{}<td>{}</td><td class=\"number\">{}</td>{}{}<td class=\"number\">{}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td></tr>\n",
      FamilyHead(bench.families[row.family]),
      NameOf(method) +
          fmt::format("<span class=\"why\">-march: {}</span>", Escaped(MarchText(method))),
      NumberText(NanosecondsATriangle(bench, row)), beside(proved), beside(fastest),
      row.is_judged ? WrongText(bench, row) : DrawingCell(row),
      IfJudged(row, NumberText(row.real.displacement)), IfJudged(row, Grouped(row.leaks.Sum())),
      NumberText(1e9 * row.conversion_seconds));
}

}  // namespace

std::string DecisionTable(const BenchResult& bench) {
  if (bench.families.empty()) return {};
  std::string html =
      "<div class=\"scroll whole\"><table class=\"decisions needs\"><thead><tr><th>triangles</th>";
  for (const Need need : kNeeds) html += fmt::format("<th>{}</th>", NeedName(need));
  html += "</tr></thead><tbody>\n";
  for (std::uint32_t family = 0; family < bench.families.size(); ++family) {
    html += DecisionRow(bench, family);
  }
  return html + "</tbody></table></div>\n" +
         ColumnKey(
             {{"proved 0", "no wrong sample against real geometry, by proof"},
              {"0 of N", "none was seen in this run, which proves nothing of other triangles"},
              {"leaks nothing",
               "no gap and no overlap was seen along shared edges, by the "
               "method's own model"},
              {"under 1/1000 px",
               "no triangle lost, and no wrong sample lay farther from its triangle's boundary"},
              {"anything", "the fastest that is under 1 % wrong inside its stated coordinates"},
              {"ns", "for a triangle of the family, drawn into counts by facing"},
              {"ms",
               "for a frame at 1080p / at 4K whose every pixel is covered once: time for a "
               "covered pixel of this family times the pixels of the frame"},
              {"x", "times as long as the row's fastest; ~ where the two can't be told apart"},
              {"~ names",
               "tied with the cheapest: the 95 % intervals of their ratios overlap. Of "
               "tied methods the one with the least error is named first"}});
}

std::string ClaimTable(const BenchResult& bench) {
  std::string rows;
  for (const Claim& claim : Claims()) rows += RowOfClaim(bench, claim);
  if (rows.empty()) return {};
  return "<div class=\"scroll\"><table><thead><tr><th>about</th><th>measured</th><th>differ in</th>"
         "<th></th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n" +
         ColumnKey({{"measured",
                     "time of the first over that of the second, least and most over the families, "
                     "with its 95 % interval, paired within rounds; less the time of spans-known "
                     "in the same sink where one thing differs"},
                    {"overlap", "the interval holds 1: the run does not tell the two apart"},
                    {"at the floor", "one of them costs no more than storing known spans"},
                    {"not like for like",
                     "a scalar loop over boxes beside vectors over spans: no advice"}});
}

std::string UsersTable(const BenchResult& bench) {
  std::string rows;
  for (const BenchRow& row : bench.rows) {
    if (bench.methods[row.method].is_users) rows += UsersRow(bench, row);
  }
  for (const BenchLeftOut& out : bench.left_out) {
    if (!bench.methods[out.method].is_users) continue;
    rows +=
        fmt::format("<tr>{}<td>{}</td><td colspan=\"7\" class=\"none\">left out: {}</td></tr>\n",
                    FamilyHead(bench.families[out.family]), NameOf(bench.methods[out.method]),
                    Escaped(out.why));
  }
  if (rows.empty()) return {};
  return "<div class=\"scroll\"><table class=\"decisions\"><thead><tr><th>triangles</th>"
         "<th>method</th><th class=\"number\">ns a triangle</th><th class=\"number\">over the "
         "proved</th><th class=\"number\">over the fastest</th><th class=\"number\">wrong</th><th "
         "class=\"number\">farthest, px</th><th class=\"number\">leaks</th><th "
         "class=\"number\">converting, ns</th></tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n" +
         ColumnKey({{"over the proved", "times as long as the cheapest method proved right"},
                    {"over the fastest", "times as long as the cheapest in the column anything"},
                    {"converting",
                     "for a triangle, of a library its vertices into its own format and its "
                     "answer into counts: not part of its time; of a program that takes no repeats "
                     "a request for a scene without triangles: part of it"}});
}

}  // namespace rasterproof::report
