// The page of one subject: all that is known of it, what failed first.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "fmt/format.h"
#include "report/grounds.h"
#include "report/page_parts.h"
#include "report/play_link.h"
#include "report/real_profile.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

std::string EvidenceList(std::string_view title, const std::vector<Evidence>& list) {
  if (list.empty()) return {};
  std::string html = fmt::format("<h3>{}</h3>\n<ul class=\"plain\">\n", title);
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
  return fmt::format("{}observed {}, expected {}", place, TextOfValue(w.observed),
                     TextOfValue(w.expected));
}

std::string TextLine(std::string_view look, std::string_view text) {
  if (text.empty()) return {};
  return fmt::format("<div class=\"{}\">{}</div>\n", look, Escaped(text));
}

bool Shows(const Picture& picture, const Certificate& certificate, const PropertyResult& result) {
  return picture.subject == certificate.subject.name && result.outcome == Outcome::kViolated &&
         picture.command == ReplayCommand(certificate, result);
}

// What opens the scene that was drawn.
std::string FragmentOf(const Counterexample& found, const std::string& subject) {
  Case drawn = found.value;
  if (found.verdict.drawn != nullptr) drawn.scene = found.verdict.drawn->scene;
  return PlayFragment(drawn, subject);
}

// What failed, where, and how to see it again.
std::string Failure(const Page& page, const Certificate& certificate,
                    const PropertyResult& result) {
  std::string html =
      fmt::format("<article>\n<h3 class=\"name\">{}</h3>\n{}{}", Breakable(NameOf(result)),
                  TextLine("why", result.clause + " (" + AuthorityText(result) + ")"),
                  TextLine("said", Said(result)));
  if (result.counterexample) {
    const Counterexample& found = *result.counterexample;
    const Scene& scene = found.value.scene;
    if (found.verdict.witness) html += TextLine("why", WitnessText(*found.verdict.witness));
    html += TextLine(
        "why", fmt::format("case {}, shrunk to {} in {} x {}", found.failing_case,
                           Several(scene.triangles.size(), "triangle"), scene.width, scene.height));
  }
  const auto picture = std::ranges::find_if(
      page.pictures, [&](const Picture& one) { return Shows(one, certificate, result); });
  if (picture != page.pictures.end()) {
    html += FigureHtml(*picture, "../", page.playground);
  } else if (result.counterexample || certificate.replay.contains(NameOf(result))) {
    html += Command(ReplayCommand(certificate, result));
    if (const auto& found = result.counterexample)
      html += PlaygroundLink(page.playground, FragmentOf(*found, certificate.subject.name), "../");
  }
  return html + "</article>\n";
}

std::string Failures(const Page& page, const Certificate& certificate) {
  std::string html;
  for (const Picture& picture : page.pictures) {
    const bool is_of_case = std::ranges::any_of(
        certificate.tested,
        [&](const PropertyResult& result) { return Shows(picture, certificate, result); });
    if (picture.subject == certificate.subject.name && !is_of_case)
      html += FigureHtml(picture, "../", page.playground);
  }
  for (const PropertyResult& result : certificate.tested) {
    if (IsFailure(result, certificate.fail_on)) html += Failure(page, certificate, result);
  }
  return html;
}

// What nobody but users asks for, and is not there.
std::string LacksOfQuality(const Page& page, const Certificate& certificate) {
  std::string html;
  for (const PropertyResult& result : certificate.tested) {
    if (IsLackOfQuality(result, certificate.fail_on)) html += Failure(page, certificate, result);
  }
  return html;
}

std::string TestedRow(const Certificate& certificate, const PropertyResult& result) {
  // A property without a bound has no ratio to it.
  const std::string ratio =
      result.worst_ratio == 0 ? "" : fmt::format("{:.3g}", result.worst_ratio);
  return fmt::format(
      "<tr><th scope=\"row\"><span class=\"name\">{}</span></th><td>{}</td>"
      "<td class=\"number\">{}</td><td class=\"number\">{}</td><td class=\"number\">{}</td>"
      "<td class=\"number\" title=\"{}\">{}</td><td class=\"remark\">{}{}</td></tr>\n",
      Breakable(NameOf(result)), Chip(certificate, result), Grouped(result.cases),
      Grouped(result.cases_exercised), Grouped(result.exercised), Escaped(result.tolerance), ratio,
      TextLine("why", result.clause + " (" + AuthorityText(result) + ")"),
      TextLine("", Said(result)));
}

std::string TestedTable(const Certificate& certificate) {
  std::string rows;
  std::size_t count = 0;
  for (const PropertyResult& result : certificate.tested) {
    if (result.outcome == Outcome::kNotApplicable || IsExhausted(result)) continue;
    rows += TestedRow(certificate, result);
    ++count;
  }
  if (rows.empty()) return {};
  const std::string key = ColumnKey(
      {{"cases", "how many were drawn and run"},
       {"exercised", "how many of them put the property to the test"},
       {"checks", "how often it was put to the test in them"},
       {"error / bound", "the largest seen, where the property has a bound; 1 is the bound"}});
  const std::string html =
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>property</th>"
      "<th>outcome</th><th class=\"number\">cases</th><th class=\"number\">exercised</th>"
      "<th class=\"number\">checks</th><th class=\"number\">error / bound</th>"
      "<th>what it states, and what was said</th></tr></thead><tbody>\n" +
      rows + "</tbody></table></div>\n";
  return Folded(fmt::format("{} properties, seed {}", count, certificate.seed), html + key,
                count <= kMostUnfolded);
}

// Parts of a million, to three digits or to the unit.
std::string PerMillion(std::uint64_t count, std::uint64_t of) {
  const double share = of == 0 ? 0 : 1e6 * static_cast<double>(count) / static_cast<double>(of);
  return share < 1000 ? fmt::format("{:.3g}", share)
                      : Grouped(static_cast<std::uint64_t>(std::llround(share)));
}

std::string DifferenceCells(const SceneResult* result) {
  if (result == nullptr || !result->applicable) {
    return "<td class=\"split why\" colspan=\"4\">not measured</td>";
  }
  const CoverageDifference& d = result->difference;
  return fmt::format("<td class=\"number split {}\">{}</td>", d.wrong == 0 ? "zero" : "wrong",
                     Grouped(d.wrong)) +
         Number(d.missing, "missing") + Number(d.unexpected, "unexpected") +
         fmt::format("<td class=\"number {}\">{}</td>", d.wrong == 0 ? "zero" : "",
                     PerMillion(d.wrong, d.covered));
}

// Why the own profile does not judge the scene, and how it was compared.
std::string SceneNote(const Certificate& certificate, const SceneResult& result) {
  std::string note = WhyNotJudged(certificate, result);
  if (!result.as_shown) return note;
  return note + (note.empty() ? "" : "; ") + "compared as covered or not: it shows no counts";
}

// Whether real geometry is something else than what the subject is held to.
bool HasOtherProfile(const Certificate& certificate) {
  return certificate.subject.profile.name != kRealProfile;
}

std::string SceneRow(const Certificate& certificate, const SceneResult& own) {
  std::string cells = DifferenceCells(&own);
  if (HasOtherProfile(certificate)) {
    cells += DifferenceCells(Find(certificate, own.scene, kRealProfile));
  }
  return fmt::format(
      "<tr><th scope=\"row\" class=\"name\">{}</th>{}{}{}<td class=\"split remark why\">{}</td>"
      "</tr>\n",
      Escaped(own.scene), Number(own.triangles),
      own.applicable ? Number(own.difference.samples) : "<td class=\"number none\">–</td>", cells,
      Escaped(SceneNote(certificate, own)));
}

std::string MeasuredTable(const Certificate& certificate) {
  const std::string& profile = certificate.subject.profile.name;
  std::string rows;
  for (const SceneResult& result : certificate.measured) {
    if (Find(certificate, result.scene, profile) == &result) rows += SceneRow(certificate, result);
  }
  if (rows.empty()) return {};
  std::string html = fmt::format(
      "<div class=\"scroll\"><table><thead><tr><th rowspan=\"2\">scene</th>"
      "<th rowspan=\"2\" class=\"number\">triangles</th>"
      "<th rowspan=\"2\" class=\"number\">samples</th>"
      "<th class=\"split\" colspan=\"4\">against its profile, {}</th>{}"
      "<th class=\"split\" rowspan=\"2\">remark</th></tr><tr>",
      Escaped(profile),
      HasOtherProfile(certificate) ? "<th class=\"split\" colspan=\"4\">against real geometry</th>"
                                   : "");
  for (int side = 0; side < (HasOtherProfile(certificate) ? 2 : 1); ++side) {
    html +=
        "<th class=\"number split\">wrong</th><th class=\"number\">missing</th>"
        "<th class=\"number\">unexpected</th><th class=\"number\">per million</th>";
  }
  return html + "</tr></thead><tbody>\n" + rows + "</tbody></table></div>\n" +
         ColumnKey({{"missing", "samples covered less often than the exact oracle has it"},
                    {"unexpected", "samples covered more often"},
                    {"per million", "wrong samples of a million covered ones"}});
}

std::string TierList(const Certificate& certificate) {
  std::vector<Evidence> tiers;
  for (const auto& [name, count] : TiersByName(certificate)) {
    tiers.push_back({name, Grouped(count)});
  }
  return EvidenceList("the oracle's tiers: which decided how often", tiers);
}

// The files that say the same to programs.
std::string Files(const Certificate& certificate) {
  if (certificate.folder.empty()) return {};
  return "<p><a href=\"certificate.json\">certificate.json</a>, "
         "<a href=\"junit.xml\">junit.xml</a></p>\n";
}

std::string EvidenceLists(const Certificate& certificate) {
  return EvidenceList("proved, by script", certificate.proved) +
         EvidenceList("exhausted", Exhausted(certificate)) +
         EvidenceList("assumed: readings that no sentence of the specification settles",
                      AssumptionsUnder(certificate.subject.profile)) +
         TierList(certificate) + EvidenceList("not applicable", NotApplicable(certificate)) +
         EvidenceList("not asked: what it shows or takes, and nothing put to the test",
                      certificate.not_asked);
}

}  // namespace

std::string SubjectPageToHtml(const Page& page, const Certificate& certificate) {
  const std::string& name = certificate.subject.name;
  const Overall overall = OverallOf(certificate);
  std::string html = fmt::format(
      "<nav><a href=\"../report.html\">← all subjects</a></nav>\n<header>\n"
      "<h1 class=\"name\">{}</h1>\n<p class=\"lead\">{} {}</p>\n<p class=\"why\">{}</p>\n"
      "</header>\n",
      Escaped(name), Chip(overall.outcome), Escaped(overall.reason),
      Escaped(certificate.subject.summary));
  html += Section("failures", "Failures",
                  "What is violated, each with the command that shows it again.",
                  Failures(page, certificate));
  html += Section("quality", "Quality", "Violated, but no clause requires it: users want it.",
                  LacksOfQuality(page, certificate));
  if (certificate.subject.fragments.shows_values) html += ValuesSection({certificate}, {});
  html += Section("scenes", "Scenes", "Every sample against the exact oracle.",
                  MeasuredTable(certificate));
  html += Section("properties", "Properties", "How often each was really put to the test.",
                  TestedTable(certificate));
  html += Section("evidence", "Evidence", "What else this rests on, and what was not asked.",
                  EvidenceLists(certificate));
  html += Section("environment", "Environment", "Where this was found, and by which command.",
                  Environments({certificate}) + Command(certificate.command) + Files(certificate));
  return Document(name + ": " + page.title, html);
}

}  // namespace rasterproof::report
