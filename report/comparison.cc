#include "report/comparison.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "fmt/format.h"
#include "io/json_writer.h"
#include "report/page_parts.h"
#include "report/proportion.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

std::string Displacement(double pixels) {
  return std::isfinite(pixels) ? fmt::format("{:.2g} px", pixels) : "broke down";
}

// One word for what a cell comes to, which is its class too.
std::string_view StateWord(const Cell& cell) {
  if (cell.cases == 0) return "excused";
  if (cell.wrong != 0) return "fails";
  if (cell.is_proved) return "proved";
  return cell.is_exhausted ? "exhausted" : "tested";
}

// What fits into a cell of the matrix: the failing share, or a mark.
std::string MatrixCell(const Cell& cell) {
  const std::string_view state = StateWord(cell);
  const std::string_view colour = state == "fails"     ? "wrong"
                                  : state == "excused" ? "none"
                                                       : "right";
  std::string text = "–";
  if (state == "fails") {
    text = Percent(static_cast<double>(cell.wrong) / static_cast<double>(cell.cases)) + " %";
  } else if (state != "excused") {
    text = state == "proved" ? "P" : state == "exhausted" ? "E" : "T";
  }
  std::string title = CellText(cell);
  if (const Case* const worst = cell.Worst()) title += ", " + worst->origin;
  if (cell.cases == 0 || cell.ended != 0) title += ": " + cell.why;
  return fmt::format("<span class=\"{}\" title=\"{}\">{}</span>", colour, Escaped(title), text);
}

void AddCell(io::JsonWriter& json, const Cell& cell) {
  json.BeginObjectLine().Key("state").Text(StateWord(cell));
  json.Key("cases").Integer(cell.cases).Key("wrong").Integer(cell.wrong);
  json.Key("ended").Integer(cell.ended).Key("triangles").Integer(cell.triangles);
  json.Key("samples").Integer(cell.samples).Key("wrong_samples").Integer(cell.wrong_samples);
  json.Key("worst_pixels").Shortest(cell.WorstPixels());
  json.Key("worst_case").Text(cell.Worst() != nullptr ? cell.Worst()->origin : "");
  json.Key("excused").Integer(cell.excused).Key("refused").Integer(cell.refused);
  json.Key("why").Text(cell.why).EndObject();
}

void AddFacts(io::JsonWriter& json, const Facts& facts) {
  for (const auto& [name, value] : facts) json.Key(JsonKey(name)).Text(value);
}

std::string SaveCommand(const ComparisonTable& table, const ComparedRow& family,
                        std::string_view subject) {
  return fmt::format(
      "rasterproof compare --families {} --subject {} --seed {} --cases {} --save worst",
      family.name, subject, table.seed, table.cases);
}

// Names lead to pages, where there are any: `folders` of subjects.
std::string MatrixHead(const ComparisonTable& table, const std::vector<std::string>& folders) {
  std::string html = fmt::format("<thead><tr><th>{}</th>", Escaped(table.one));
  for (std::size_t k = 0; k < table.subjects.size(); ++k) {
    const std::string& name = table.subjects[k].name;
    html += fmt::format("<th class=\"number\"><span class=\"upright\">{}</span></th>",
                        folders.empty() ? Escaped(name)
                                        : fmt::format("<a href=\"{}/report.html\">{}</a>",
                                                      Escaped(folders[k]), Escaped(name)));
  }
  return html + "</tr></thead>";
}

std::string Matrix(const ComparisonTable& table, const std::vector<std::string>& folders) {
  std::string html = "<div class=\"scroll\"><table class=\"matrix\">" + MatrixHead(table, folders);
  std::string_view theme;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const ComparedRow& family = table.rows[k];
    if (family.theme != theme) {
      if (!theme.empty()) html += "</tbody>";
      theme = family.theme;
      html += fmt::format("<tbody><tr><th colspan=\"{}\"><b>{}</b>: {}</th></tr>\n",
                          table.subjects.size() + 1, Escaped(theme), Escaped(family.right));
    }
    html +=
        fmt::format("<tr><th class=\"name\">{}</th>",
                    folders.empty() ? Escaped(family.name)
                                    : fmt::format("<a href=\"{}\" title=\"{}\">{}</a>",
                                                  Escaped(FamilyPagePath(family) + ".html"),
                                                  Escaped(family.summary), Escaped(family.name)));
    for (const ComparedSubject& subject : table.subjects) {
      html += "<td class=\"number\">";
      for (std::size_t y = 0; y < table.yardsticks.size(); ++y) {
        html += (y == 0 ? "" : "<br>") + MatrixCell(subject.cells[k][y]);
      }
      html += "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

// "own model: 90 families stand, 0 fail, 9 excused" for each yardstick.
std::string SummaryLine(const ComparisonTable& table, const ComparedSubject& subject) {
  std::string line = subject.name + ":";
  for (std::size_t y = 0; y < table.yardsticks.size(); ++y) {
    std::array<std::size_t, 3> counts{};  // of those that stand, fail, are excused
    for (const std::vector<Cell>& row : subject.cells) {
      ++counts[row[y].Fails() ? 1 : row[y].cases != 0 ? 0 : 2];
    }
    line += fmt::format("{} {}: {} {} stand, {} fail, {} excused", y == 0 ? "" : ";",
                        table.yardsticks[y], counts[0], table.what, counts[1], counts[2]);
  }
  return line + "\n";
}

}  // namespace

std::string JsonKey(std::string name) {
  std::ranges::replace(name, ' ', '_');
  return name;
}

std::string CellText(const Cell& cell) {
  if (cell.cases == 0) return cell.excused == 0 ? "not run" : "excused";
  const std::string_view state = StateWord(cell);
  std::string text;
  if (state == "fails") {
    text = fmt::format("fails {}, {}", CountedText(cell.wrong, cell.cases),
                       Displacement(cell.WorstPixels()));
  } else if (state == "exhausted") {
    text = fmt::format("exhausted, {}", cell.cases);
  } else {
    text = fmt::format("{}{} tested", state == "proved" ? "proved, " : "", cell.cases);
  }
  if (cell.by_snap != 0) text += fmt::format(", {} by the snap alone", cell.by_snap);
  return cell.excused == 0 ? text : text + fmt::format(", {} excused", cell.excused);
}

std::string ComparisonText(const ComparisonTable& table, const ComparedSubject& subject) {
  std::size_t name_width = 22;
  for (const ComparedRow& row : table.rows) name_width = std::max(name_width, row.name.size());
  std::vector<std::size_t> widths;
  for (std::size_t y = 0; y < table.yardsticks.size(); ++y) {
    widths.push_back(table.yardsticks[y].size());
    for (const auto& row : subject.cells) {
      widths[y] = std::max(widths[y], CellText(row[y]).size());
    }
  }
  std::string text =
      fmt::format("{}, seed {}, {} cases each\n", subject.name, table.seed, table.cases);
  for (const auto& [name, value] : subject.facts) text += fmt::format("  {}: {}\n", name, value);
  text += fmt::format("{:{}}", "", name_width + 2);
  const auto end_line = [&text] {
    text.resize(text.find_last_not_of(' ') + 1);
    text += '\n';
  };
  for (std::size_t y = 0; y < widths.size(); ++y) {
    text += fmt::format(" {:<{}}", table.yardsticks[y], widths[y]);
  }
  end_line();
  std::string_view theme;
  for (std::size_t k = 0; k < table.rows.size(); ++k) {
    const ComparedRow& row = table.rows[k];
    if (row.theme != theme) {
      theme = row.theme;
      text += fmt::format("\n{}: {}\n", row.theme, row.right);
    }
    text += fmt::format("  {:<{}}", row.name, name_width);
    std::string why;
    for (std::size_t y = 0; y < widths.size(); ++y) {
      const Cell& cell = subject.cells[k][y];
      text += fmt::format(" {:<{}}", CellText(cell), widths[y]);
      if (cell.ended != 0 && why.empty()) why = cell.why;
    }
    end_line();
    for (const auto& [name, value] : row.facts) {
      why += fmt::format("{}{}: {}", why.empty() ? "" : "; ", name, value);
    }
    if (!why.empty()) text += fmt::format("{:{}}{}\n", "", name_width + 3, why);
  }
  return CleanText(text + "\n" + SummaryLine(table, subject));
}

std::string ComparisonToJson(const ComparisonTable& table) {
  io::JsonWriter json;
  json.BeginObject().Key("rasterproof_comparison").Integer(1);
  json.Key("seed").Integer(table.seed).Key("cases").Integer(table.cases);
  json.Key("what").Text(table.what).Key("one").Text(table.one);
  json.Key("yardsticks").BeginArrayLine();
  for (const std::string& yardstick : table.yardsticks) json.Text(yardstick);
  json.EndArray().Key(table.what).BeginArray();
  for (const ComparedRow& row : table.rows) {
    json.BeginObject().Key("name").Text(row.name).Key("summary").Text(row.summary);
    json.Key("theme").Text(row.theme).Key("right").Text(row.right);
    AddFacts(json, row.facts);
    json.EndObject();
  }
  json.EndArray().Key("subjects").BeginArray();
  for (const ComparedSubject& subject : table.subjects) {
    json.BeginObject().Key("subject").Text(subject.name);
    AddFacts(json, subject.facts);
    json.Key("cells").BeginArray();
    for (std::size_t k = 0; k < subject.cells.size(); ++k) {
      json.BeginObject().Key(table.one).Text(table.rows[k].name);
      for (std::size_t y = 0; y < table.yardsticks.size(); ++y) {
        AddCell(json.Key(JsonKey(table.yardsticks[y])), subject.cells[k][y]);
      }
      json.EndObject();
    }
    json.EndArray().EndObject();
  }
  json.EndArray().EndObject();
  return json.Finish();
}

std::string ComparisonMatrix(const ComparisonTable& table) { return Matrix(table, {}); }

std::string CatalogueSection(const Catalogue& catalogue) {
  if (catalogue.table.subjects.empty()) return "";
  return Section(
      "catalogue", "Stiff and extreme cases",
      fmt::format(
          "Above: by the subject's own model; below: by real geometry. T: {} cases tested "
          "(seed {}), none wrong; E: every case of a small world tested, none wrong; P: tested, "
          "and the subject's decisions are proved (its page names the proofs); a share: cases with "
          "a wrong sample; –: excused, because the profile or the subject says nothing of the "
          "family. Each family has a page with rates, displacements, commands and a picture.",
          catalogue.table.cases, catalogue.table.seed),
      Matrix(catalogue.table, catalogue.folders));
}

std::string FamilyPagePath(const ComparedRow& family) { return "families/" + family.name; }

std::string FamilyPageToHtml(const Catalogue& catalogue, std::size_t k) {
  const ComparisonTable& table = catalogue.table;
  const ComparedRow& family = table.rows[k];
  std::string html = fmt::format(
      "<header>\n<h1><a href=\"../report.html\">report</a></h1>\n<h1 class=\"name\">{}</h1>\n"
      "<p class=\"lead\">{}</p>\n<p class=\"why\">{}</p>\n</header>\n",
      Escaped(family.name), Escaped(family.summary), Escaped(family.right));
  std::string rows =
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>subject</th><th>own model</th>"
      "<th>real geometry</th><th>saves its worst cases</th></tr>"
      "</thead><tbody>\n";
  for (const ComparedSubject& subject : table.subjects) {
    const Cell& own = subject.cells[k][0];
    const Cell& real = subject.cells[k][1];
    const std::string last = own.wrong + real.wrong != 0
                                 ? Command(SaveCommand(table, family, subject.name))
                                 : Escaped(own.cases == 0 ? own.why : "");
    rows +=
        fmt::format("<tr><th class=\"name\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                    Escaped(subject.name), Escaped(CellText(own)), Escaped(CellText(real)), last);
  }
  html += Section("subjects", "Subjects",
                  "Cases with a wrong sample, the 95 % interval of their share, and how far the "
                  "furthest wrong sample lies from the nearest edge.",
                  rows + "</tbody></table></div>\n");
  if (const std::optional<FamilyPicture>& picture = catalogue.pictures[k]) {
    html +=
        Section("picture", "The worst case",
                "Of all subjects' cases, by displacement: the grid with the exact triangles, the "
                "samples that the yardstick covers, those that were drawn, and the difference.",
                FigureHtml({.caption = picture->caption,
                            .command = SaveCommand(table, family, picture->subject),
                            .subject = {},
                            .file = FamilyPagePath(family) + ".svg",
                            .content = {}},
                           "../"));
  }
  return Document(family.name, html);
}

}  // namespace rasterproof::report
