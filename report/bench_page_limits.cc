// Where methods end: a matrix of cliffs; fingerprints, and the budget of a frame.
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
#include "report/limits_text.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// Methods of which the same is said of every parameter.
struct CliffRow {
  std::vector<std::uint32_t> methods;
  /// Of each parameter those of the methods; none: it is not theirs.
  std::vector<std::vector<const BenchCliff*>> cells;
};

std::vector<std::string> SaidOf(const CliffRow& row) {
  std::vector<std::string> said;
  for (const auto& cell : row.cells) said.push_back(cell.empty() ? "" : CliffText(*cell.front()));
  return said;
}

CliffRow CliffRowOf(const BenchResult& bench, std::uint32_t method) {
  CliffRow row{{method}, std::vector<std::vector<const BenchCliff*>>(bench.parameters.size())};
  for (const BenchCliff& cliff : bench.cliffs) {
    if (cliff.method == method) row.cells[cliff.parameter] = {&cliff};
  }
  return row;
}

std::vector<CliffRow> CliffRows(const BenchResult& bench) {
  std::vector<CliffRow> rows;
  for (std::uint32_t method = 0; method < bench.methods.size(); ++method) {
    CliffRow row = CliffRowOf(bench, method);
    if (std::ranges::all_of(row.cells, [](const auto& cell) { return cell.empty(); })) continue;
    // The user's subject always has a separate row.
    const auto same = std::ranges::find_if(rows, [&](const CliffRow& other) {
      return bench.methods[method].is_users == bench.methods[other.methods[0]].is_users &&
             SaidOf(other) == SaidOf(row);
    });
    if (same == rows.end()) {
      rows.push_back(std::move(row));
      continue;
    }
    same->methods.push_back(method);
    for (std::size_t k = 0; k < row.cells.size(); ++k) {
      same->cells[k].insert(same->cells[k].end(), row.cells[k].begin(), row.cells[k].end());
    }
  }
  return rows;
}

std::string NamesOf(const BenchResult& bench, const CliffRow& row) {
  std::string names;
  for (const std::uint32_t method : row.methods) {
    names += fmt::format("{}<span class=\"name\">{}</span>", names.empty() ? "" : ", ",
                         Escaped(FullName(bench.methods[method])));
  }
  return names +
         (bench.methods[row.methods[0]].is_users ? " <span class=\"yours\">yours</span>" : "");
}

std::string CaseName(std::size_t row, std::size_t parameter) {
  return fmt::format("cliff-{}-{}", row, parameter);
}

bool HasCase(const std::vector<const BenchCliff*>& cell) {
  return std::ranges::any_of(cell,
                             [](const BenchCliff* cliff) { return cliff->scene.has_value(); });
}

std::string CliffCell(const BenchResult& bench, const std::vector<const BenchCliff*>& cell,
                      const std::string& name) {
  if (cell.empty()) return "<td></td>";
  const BenchCliff& cliff = *cell.front();
  const bool is_failing = !std::isnan(cliff.first_failing);
  const bool is_proved = !std::isnan(cliff.proved_to);
  return fmt::format("<td class=\"number {}\" title=\"{}: {}\"{}><b>{}</b><i>{}</i></td>",
                     is_failing  ? "fails"
                     : is_proved ? "holds"
                                 : "held",
                     Escaped(bench.parameters[cliff.parameter].name), Escaped(CliffText(cliff)),
                     HasCase(cell) ? fmt::format(" data-case=\"{}\"", name) : "",
                     is_proved ? "≤ " + RaisedText(ValueText(cliff.proved_to)) : "–",
                     is_failing ? "✗ " + RaisedText(ValueText(cliff.first_failing)) : "–");
}

std::string CommandsOf(const BenchResult& bench, const std::vector<const BenchCliff*>& cell,
                       std::string_view folder) {
  std::string commands;
  for (const BenchCliff* cliff : cell) {
    if (!cliff->scene) continue;
    const BenchMethod& method = bench.methods[cliff->method];
    commands += Command(fmt::format(
        "rasterproof explain {}/{} --{} {} --pixel {} {}", folder, CliffFile(bench, *cliff),
        method.is_users ? "plugin" : "subject", method.name, cliff->x, cliff->y));
  }
  return commands;
}

// The columns: parameters that some method has a limit of.
std::vector<std::size_t> ColumnsOf(const std::vector<CliffRow>& rows) {
  std::vector<std::size_t> columns;
  for (std::size_t k = 0; k < rows[0].cells.size(); ++k) {
    const bool is_said =
        std::ranges::any_of(rows, [&](const CliffRow& row) { return !row.cells[k].empty(); });
    if (is_said) columns.push_back(k);
  }
  return columns;
}

std::string MatrixKey(const BenchResult& bench, const std::vector<std::size_t>& columns) {
  std::vector<std::string> sentences;
  for (const std::size_t k : columns) {
    const BenchParameter& parameter = bench.parameters[k];
    sentences.push_back(
        Escaped(parameter.summary + (parameter.unit == "1" ? "" : "; in " + parameter.unit)));
  }
  std::vector<std::pair<std::string_view, std::string_view>> key{
      {"≤", "proved right up to this value; –: nothing is proved"},
      {"✗", "first seen failing at this value; –, shaded: never seen failing"}};
  for (std::size_t k = 0; k < columns.size(); ++k) {
    key.emplace_back(bench.parameters[columns[k]].name, sentences[k]);
  }
  return ColumnKey(key);
}

// What the script shows below the matrix for the cell chosen.
std::string CliffCases(const BenchResult& bench, const std::vector<CliffRow>& rows,
                       std::string_view folder) {
  std::string html;
  std::size_t count = 0;
  for (std::size_t n = 0; n < rows.size(); ++n) {
    for (std::size_t k = 0; k < rows[n].cells.size(); ++k) {
      const auto& cell = rows[n].cells[k];
      if (!HasCase(cell)) continue;
      ++count;
      html += fmt::format("<div id=\"{}\"><p class=\"why\">{}: {}</p>{}</div>\n", CaseName(n, k),
                          Escaped(bench.parameters[k].name), Escaped(CliffText(*cell.front())),
                          CommandsOf(bench, cell, folder));
    }
  }
  if (count == 0) return {};
  return fmt::format(
      "<div id=\"cliff-cases\">{}</div>\n",
      Folded(fmt::format("Commands that show the failing cases of {}", Several(count, "cell")),
             html, false));
}

}  // namespace

std::string RaisedText(const std::string& text) {
  constexpr std::array<std::string_view, 10> kRaised{"⁰", "¹", "²", "³", "⁴",
                                                     "⁵", "⁶", "⁷", "⁸", "⁹"};
  std::string raised;
  bool is_up = false;
  for (const char c : text) {
    if (c == '^') {
      is_up = true;
    } else if (is_up && c == '-') {
      raised += "⁻";
    } else if (is_up && c >= '0' && c <= '9') {
      raised += kRaised[static_cast<std::size_t>(c - '0')];
    } else {
      is_up = false;
      raised += c;
    }
  }
  return raised;
}

std::string CliffTable(const BenchResult& bench, std::string_view folder) {
  if (bench.cliffs.empty()) return {};
  const std::vector<CliffRow> rows = CliffRows(bench);
  const std::vector<std::size_t> columns = ColumnsOf(rows);
  std::string html = "<div class=\"scroll cliffs\"><table id=\"cliffs\"><thead><tr><th>method</th>";
  for (const std::size_t k : columns) {
    html += fmt::format("<th class=\"number\">{}</th>", Escaped(bench.parameters[k].name));
  }
  html += "</tr></thead><tbody>\n";
  for (std::size_t n = 0; n < rows.size(); ++n) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", NamesOf(bench, rows[n]));
    for (const std::size_t k : columns) {
      html += CliffCell(bench, rows[n].cells[k], CaseName(n, k));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n<div id=\"cliff-shown\" aria-live=\"polite\"></div>\n" +
         CliffCases(bench, rows, folder) + MatrixKey(bench, columns);
}

// Pictures of those that are wrong somewhere; of the others the left half is the right one.
std::string FingerprintPictures(const BenchResult& bench) {
  std::string html;
  std::string right;
  for (const BenchFingerprint& print : bench.fingerprints) {
    const std::string name = Escaped(FullName(bench.methods[print.method]));
    const std::string step = Escaped(print.step);
    if (print.wrong == 0) {
      right += fmt::format("{}{} ({})", right.empty() ? "" : ", ", name, step);
      continue;
    }
    html += fmt::format(
        "<figure><img alt=\"Fingerprint of {0} in steps of {1}\" src=\"data:image/png;base64,{2}\">"
        "<figcaption><span class=\"name\">{0}</span> steps of {1}: {3} of {4} places wrong"
        "</figcaption></figure>\n",
        name, step, Escaped(print.png), Grouped(print.wrong), Grouped(print.places));
  }
  if (!html.empty()) html = "<div class=\"prints\">\n" + html + "</div>\n";
  if (!right.empty())
    html += Folded("0 wrong in every place", "<p class=\"why\">" + right + "</p>", false);
  return html;
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
