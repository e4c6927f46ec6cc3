// The tables that decide: by need, by textbook advice, of the user's own.
#include <algorithm>
#include <array>
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

// A method beside the cheapest proved one, over the families where both stand.
struct Beside {
  std::size_t families = 0;
  double least_ratio = std::numeric_limits<double>::infinity();
  double most_ratio = 0;
  std::size_t wrong_in = 0;
  std::size_t leaks_in = 0;
  double farthest = 0;
};

Beside BesideProved(const BenchResult& bench, std::string_view name) {
  Beside beside;
  for (const BenchRow& row : bench.rows) {
    const BenchMethod& method = bench.methods[row.method];
    if (method.name != name || method.sink != kCommonSink || !row.is_judged) continue;
    const std::optional<Decision> proved = Decide(bench, row.family, Need::kProvedZero);
    if (!proved) continue;
    const double ratio = row.time.median / proved->row->time.median;
    ++beside.families;
    beside.least_ratio = std::min(beside.least_ratio, ratio);
    beside.most_ratio = std::max(beside.most_ratio, ratio);
    if (row.real.Wrong() != 0) ++beside.wrong_in;
    if (row.leaks.Sum() != 0) ++beside.leaks_in;
    beside.farthest = std::max(beside.farthest, row.real.displacement);
  }
  return beside;
}

struct Advice {
  std::string_view text;
  std::string_view method;
  std::string_view remark;
};

constexpr std::array kAdvice{
    Advice{"Use doubles", "f64-direct",
           "that none was wrong here proves nothing of constructed input"},
    Advice{"Float32 is good enough", "f32-direct", "five operations a sample"},
    Advice{"Step, don't multiply", "f32-incremental",
           "one addition a pixel, and each waits for the one before it"},
    Advice{"A x + B y + C is the same", "f32-affine", "it is not: C cancels"},
    Advice{"Snap to 1/256 and be safe", "i64-snap8",
           "right by its own model, off real geometry by what snapping moves"},
    Advice{"Divide by w first", "hom-projected-f32", "clip space alone; wrong for w at most 0"}};

std::string AdviceRow(const BenchResult& bench, const Advice& advice) {
  const Beside beside = BesideProved(bench, advice.method);
  if (beside.families == 0) return {};
  return fmt::format(
      "<tr><th scope=\"row\">{}</th><td><span class=\"name\">{}</span></td>"
      "<td class=\"number\">{} to {}</td><td class=\"number\">{} of {}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{} of {}</td><td class=\"remark why\">{}"
      "</td></tr>\n",
      advice.text, advice.method, NumberText(beside.least_ratio), NumberText(beside.most_ratio),
      beside.wrong_in, beside.families, NumberText(beside.farthest), beside.leaks_in,
      beside.families, advice.remark);
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
      FamilyHead(bench.families[row.family]), NameOf(method),
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

std::string AdviceTable(const BenchResult& bench) {
  std::string rows;
  for (const Advice& advice : kAdvice) rows += AdviceRow(bench, advice);
  if (rows.empty()) return {};
  return "<div class=\"scroll\"><table><thead><tr><th>advice</th><th>method</th><th "
         "class=\"number\">time over the proved</th><th class=\"number\">wrong in</th><th "
         "class=\"number\">farthest, px</th><th class=\"number\">leaks in</th><th>remark</th>"
         "</tr></thead><tbody>\n" +
         rows + "</tbody></table></div>\n" +
         ColumnKey({{"time over the proved",
                     "its time over that of the cheapest method that is proved right, least and "
                     "most over the families; above 1, the proved one is faster"},
                    {"wrong in", "families in which a sample was wrong against real geometry"},
                    {"farthest", "distance of a wrong sample from its triangle's boundary"},
                    {"leaks in", "families with a gap or an overlap by the method's own model"}});
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
