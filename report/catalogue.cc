#include "report/catalogue.h"

#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "fmt/format.h"
#include "report/json_writer.h"
#include "report/page_parts.h"
#include "report/proportion.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

std::string Displacement(double pixels) {
  return std::isfinite(pixels) ? fmt::format("{:.2g} px", pixels) : "broke down";
}

// One word for what a cell comes to, which is its class too.
std::string_view StateWord(const CatalogueCell& cell) {
  if (cell.cases == 0) return "excused";
  if (cell.wrong != 0) return "fails";
  if (cell.is_proved) return "proved";
  return cell.is_exhausted ? "exhausted" : "tested";
}

// What fits into a cell of the matrix: the failing share, or a mark.
std::string MatrixCell(const CatalogueCell& cell) {
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
  std::string title = FamilyText(cell);
  if (cell.cases == 0) title += ": " + cell.why;
  return fmt::format("<span class=\"{}\" title=\"{}\">{}</span>", colour, Escaped(title), text);
}

void AddCell(JsonWriter& json, const CatalogueCell& cell) {
  json.BeginObjectLine().Key("state").Text(StateWord(cell));
  json.Key("cases").Integer(cell.cases).Key("wrong").Integer(cell.wrong);
  json.Key("samples").Integer(cell.samples).Key("wrong_samples").Integer(cell.wrong_samples);
  json.Key("worst_pixels").Shortest(cell.worst_pixels).Key("worst_case").Text(cell.worst_case);
  json.Key("excused").Integer(cell.excused).Key("why").Text(cell.why).EndObject();
}

std::string SaveCommand(const Catalogue& catalogue, const CatalogueFamily& family,
                        std::string_view subject) {
  return fmt::format(
      "rasterproof check --catalogue --family {} --subject {} --seed {} --cases {} --save worst",
      family.name, subject, catalogue.seed, catalogue.cases);
}

std::string MatrixHead(const Catalogue& catalogue) {
  std::string html = "<thead><tr><th>family</th>";
  for (const CatalogueColumn& column : catalogue.columns) {
    const std::string name = Escaped(column.subject);
    html += fmt::format("<th class=\"number\"><span class=\"upright\">{}</span></th>",
                        column.folder.empty() ? name
                                              : fmt::format("<a href=\"{}/report.html\">{}</a>",
                                                            Escaped(column.folder), name));
  }
  return html + "</tr></thead>";
}

std::string Matrix(const Catalogue& catalogue) {
  std::string html = "<div class=\"scroll\"><table class=\"matrix\">" + MatrixHead(catalogue);
  std::string_view theme;
  for (std::size_t k = 0; k < catalogue.families.size(); ++k) {
    const CatalogueFamily& family = catalogue.families[k];
    if (family.theme != theme) {
      if (!theme.empty()) html += "</tbody>";
      theme = family.theme;
      html += fmt::format("<tbody><tr><th colspan=\"{}\"><b>{}</b>: {}</th></tr>\n",
                          catalogue.columns.size() + 1, Escaped(theme), Escaped(family.right));
    }
    html += fmt::format("<tr><th class=\"name\"><a href=\"{}\" title=\"{}\">{}</a></th>",
                        Escaped(FamilyPagePath(family) + ".html"), Escaped(family.summary),
                        Escaped(family.name));
    for (const CatalogueColumn& column : catalogue.columns) {
      html += "<td class=\"number\">" + MatrixCell(column.cells[k][0]) + "<br>" +
              MatrixCell(column.cells[k][1]) + "</td>";
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace

std::string FamilyText(const CatalogueCell& cell) {
  if (cell.cases == 0) return cell.excused == 0 ? "not run" : "excused";
  const std::string_view state = StateWord(cell);
  std::string text;
  if (state == "fails") {
    text = fmt::format("fails {}, {}", CountedText(cell.wrong, cell.cases),
                       Displacement(cell.worst_pixels));
  } else if (state == "exhausted") {
    text = fmt::format("exhausted, {}", cell.cases);
  } else {
    text = fmt::format("{}{} tested", state == "proved" ? "proved, " : "", cell.cases);
  }
  return cell.excused == 0 ? text : text + fmt::format(", {} excused", cell.excused);
}

std::string CatalogueToJson(const Catalogue& catalogue) {
  JsonWriter json;
  json.BeginObject().Key("rasterproof_catalogue").Integer(1);
  json.Key("seed").Integer(catalogue.seed).Key("cases").Integer(catalogue.cases);
  json.Key("families").BeginArray();
  for (const CatalogueFamily& family : catalogue.families) {
    json.BeginObject().Key("name").Text(family.name).Key("summary").Text(family.summary);
    json.Key("theme").Text(family.theme).Key("right").Text(family.right).EndObject();
  }
  json.EndArray().Key("subjects").BeginArray();
  for (const CatalogueColumn& column : catalogue.columns) {
    json.BeginObject().Key("subject").Text(column.subject).Key("cells").BeginArray();
    for (std::size_t k = 0; k < column.cells.size(); ++k) {
      json.BeginObject().Key("family").Text(catalogue.families[k].name);
      json.Key("own_model");
      AddCell(json, column.cells[k][0]);
      json.Key("real_geometry");
      AddCell(json, column.cells[k][1]);
      json.EndObject();
    }
    json.EndArray().EndObject();
  }
  json.EndArray().EndObject();
  return json.Finish();
}

std::string CatalogueSection(const Catalogue& catalogue) {
  if (catalogue.columns.empty()) return "";
  return Section(
      "catalogue", "Stiff and extreme cases",
      fmt::format(
          "Above: by the subject's own model; below: by real geometry. T: {} cases tested "
          "(seed {}), none wrong; E: every case of a small world tested, none wrong; P: tested, "
          "and the subject's decisions are proved (its page names the proofs); a share: cases with "
          "a wrong sample; –: excused, because the profile or the subject says nothing of the "
          "family. Each family has a page with rates, displacements, commands and a picture.",
          catalogue.cases, catalogue.seed),
      Matrix(catalogue));
}

std::string FamilyPagePath(const CatalogueFamily& family) { return "families/" + family.name; }

std::string FamilyPageToHtml(const Catalogue& catalogue, std::size_t k) {
  const CatalogueFamily& family = catalogue.families[k];
  std::string html = fmt::format(
      "<header>\n<h1><a href=\"../report.html\">report</a></h1>\n<h1 class=\"name\">{}</h1>\n"
      "<p class=\"lead\">{}</p>\n<p class=\"why\">{}</p>\n</header>\n",
      Escaped(family.name), Escaped(family.summary), Escaped(family.right));
  std::string rows =
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>subject</th><th>own model</th>"
      "<th>real geometry</th><th>saves its worst cases</th></tr>"
      "</thead><tbody>\n";
  for (const CatalogueColumn& column : catalogue.columns) {
    const auto& [own, real] = column.cells[k];
    const std::string last = own.wrong + real.wrong != 0
                                 ? Command(SaveCommand(catalogue, family, column.subject))
                                 : Escaped(own.cases == 0 ? own.why : "");
    rows += fmt::format("<tr><th class=\"name\">{}</th><td>{}</td><td>{}</td><td>{}</td></tr>\n",
                        Escaped(column.subject), Escaped(FamilyText(own)),
                        Escaped(FamilyText(real)), last);
  }
  html += Section("subjects", "Subjects",
                  "Cases with a wrong sample, the 95 % interval of their share, and how far the "
                  "furthest wrong sample lies from the nearest edge.",
                  rows + "</tbody></table></div>\n");
  if (family.picture) {
    html +=
        Section("picture", "The worst case",
                "Of all subjects' cases, by displacement: the grid with the exact triangles, the "
                "samples that the yardstick covers, those that were drawn, and the difference.",
                FigureHtml({.caption = family.picture->caption,
                            .command = SaveCommand(catalogue, family, family.picture->subject),
                            .subject = {},
                            .file = FamilyPagePath(family) + ".svg",
                            .content = {}},
                           "../"));
  }
  return Document(family.name, html);
}

}  // namespace rasterproof::report
