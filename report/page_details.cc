#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fmt/format.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

std::string Chip(Outcome outcome) {
  return fmt::format("<span class=\"chip {}\">{}</span>", LookOf(outcome), OutcomeName(outcome));
}

std::string EvidenceList(std::string_view title, const std::vector<Evidence>& list) {
  if (list.empty()) return {};
  std::string html = fmt::format("<h4>{}</h4>\n<ul class=\"plain\">\n", title);
  for (const Evidence& evidence : list) {
    html += fmt::format("<li>{} <span class=\"why\">{}</span></li>\n", Escaped(evidence.statement),
                        Escaped(evidence.by));
  }
  return html + "</ul>\n";
}

std::string WitnessText(const Witness& w) {
  std::string place;
  if (w.triangle >= 0) place += fmt::format("triangle {} ", w.triangle);
  if (w.edge >= 0) place += fmt::format("edge {} ", w.edge);
  if (w.x >= 0) place += fmt::format("pixel ({}, {}) ", w.x, w.y);
  return fmt::format("{}observed {}, expected {}", place, w.observed, w.expected);
}

// What was said of a property: its clause, and what failed and how to see it again.
std::string Remarks(const Certificate& certificate, const PropertyResult& result) {
  std::string html = fmt::format("<div class=\"why\">{}</div>", Escaped(result.clause));
  const std::string said = Said(result);
  if (!said.empty()) html += fmt::format("<div>{}</div>", Escaped(said));
  if (result.outcome != Outcome::kViolated) return html;
  if (result.verdict && result.verdict->witness) {
    html +=
        fmt::format("<div class=\"why\">{}</div>", Escaped(WitnessText(*result.verdict->witness)));
  }
  if (result.counterexample) {
    html += fmt::format("<div class=\"why\">case {}, shrunk to {} triangles in {}x{}</div>",
                        Escaped(result.failing_case), result.counterexample->scene.triangles.size(),
                        result.counterexample->scene.width, result.counterexample->scene.height);
  }
  if (result.counterexample || certificate.replay.contains(result.property)) {
    html += fmt::format("<pre><code>{}</code></pre>", Escaped(ReplayCommand(certificate, result)));
  }
  return html;
}

std::string TestedRow(const Certificate& certificate, const PropertyResult& result) {
  // A property without a bound has no ratio to it.
  const std::string ratio =
      result.worst_ratio == 0 ? "" : fmt::format("{:.3g}", result.worst_ratio);
  return fmt::format(
      "<tr><th scope=\"row\"><span class=\"name\">{}</span>{}</th><td>{}</td>"
      "<td class=\"number\">{} of {}</td><td class=\"number\">{}</td>"
      "<td class=\"number\" title=\"{}\">{}</td></tr>\n",
      Escaped(result.property), Remarks(certificate, result), Chip(result.outcome),
      Grouped(result.cases_exercised), Grouped(result.cases), Grouped(result.exercised),
      Escaped(result.tolerance), ratio);
}

std::string TestedTable(const Certificate& certificate) {
  std::string rows;
  for (const PropertyResult& result : certificate.tested) {
    if (result.outcome != Outcome::kNotApplicable) rows += TestedRow(certificate, result);
  }
  if (rows.empty()) return {};
  return fmt::format(
      "<h4>tested, seed {}</h4>\n<div class=\"scroll\"><table><thead><tr><th>property</th>"
      "<th>outcome</th><th class=\"number\">cases that put it to the test</th>"
      "<th class=\"number\">times</th><th class=\"number\">largest error / bound</th>"
      "</tr></thead><tbody>\n{}</tbody></table></div>\n",
      certificate.seed, rows);
}

std::string MeasuredList(const Certificate& certificate) {
  if (certificate.measured.empty()) return {};
  std::string html = "<h4>measured</h4>\n<ul class=\"plain\">\n";
  for (const SceneResult& result : certificate.measured) {
    const CoverageDifference& d = result.difference;
    const std::string why = WhyNotJudged(certificate, result);
    const std::string what =
        result.applicable
            ? fmt::format("{} of {} samples {}{}{}{}", Grouped(d.wrong), Grouped(d.samples),
                          why.empty() ? "wrong" : "differ",
                          result.as_shown ? "; covered or not: it shows no counts" : "",
                          why.empty() ? "" : "; ", Escaped(why))
            : Escaped(why);
    html += fmt::format("<li>{} against {} <span class=\"why\">{}</span></li>\n",
                        Escaped(result.scene), Escaped(result.profile), what);
  }
  return html + "</ul>\n";
}

std::string TierList(const Certificate& certificate) {
  if (certificate.oracle_tiers.empty()) return {};
  std::string html = "<h4>the oracle's tiers: which decided how often</h4>\n<ul class=\"plain\">\n";
  for (const auto& [tier, count] : certificate.oracle_tiers) {
    html +=
        fmt::format("<li>{} <span class=\"why\">{}</span></li>\n", Escaped(tier), Grouped(count));
  }
  return html + "</ul>\n";
}

}  // namespace

std::string SubjectDetails(const Certificate& certificate) {
  const Overall overall = OverallOf(certificate);
  std::string html = fmt::format(
      "<details id=\"{}\">\n<summary><span class=\"name\">{}</span>{}</summary>\n<p>{}</p>\n",
      AnchorOf(certificate), Escaped(certificate.subject.name), Chip(overall.outcome),
      Escaped(certificate.subject.summary));
  if (!overall.reason.empty()) html += fmt::format("<p>{}</p>\n", Escaped(overall.reason));
  html += EvidenceList("proved, by script", certificate.proved);
  html += EvidenceList("exhausted", certificate.exhausted);
  html += TestedTable(certificate);
  html += MeasuredList(certificate);
  html += EvidenceList("not applicable", NotApplicable(certificate));
  html += TierList(certificate);
  return html + "</details>\n";
}

std::string Environments(const std::vector<Certificate>& certificates) {
  std::map<std::map<std::string, std::string>, std::vector<std::string>> subjects_of;
  for (const Certificate& certificate : certificates) {
    subjects_of[certificate.environment].push_back(certificate.subject.name);
  }
  std::string html;
  for (const auto& [environment, subjects] : subjects_of) {
    if (environment.empty()) continue;
    if (subjects_of.size() > 1) {
      html += "<h3>";
      for (const std::string& subject : subjects) html += Escaped(subject) + " ";
      html += "</h3>\n";
    }
    html += "<div class=\"scroll\"><table><tbody>\n";
    for (const auto& [name, value] : environment) {
      html += fmt::format("<tr><th scope=\"row\">{}</th><td class=\"name\">{}</td></tr>\n",
                          Escaped(name), Escaped(value));
    }
    html += "</tbody></table></div>\n";
  }
  return html;
}

std::string Figure(const Picture& picture) {
  std::string image;
  if (!picture.svg.empty()) {
    image = PlainSvg(picture.svg);
    if (image.empty()) image = "<p class=\"why\">left out: not a well-formed SVG</p>";
  } else if (!picture.png.empty()) {
    image = fmt::format("<img alt=\"{}\" src=\"data:image/png;base64,{}\">",
                        Escaped(picture.caption), Base64(picture.png));
  }
  std::string html =
      fmt::format("<figure>\n<figcaption>{}</figcaption>\n{}\n", Escaped(picture.caption), image);
  if (!picture.command.empty()) {
    html += fmt::format("<pre><code>{}</code></pre>\n", Escaped(picture.command));
  }
  return html + "</figure>\n";
}

}  // namespace rasterproof::report
