#include "report/page.h"

#include <set>
#include <string>
#include <string_view>

#include "fmt/format.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

std::string Section(std::string_view anchor, std::string_view title, std::string_view intro,
                    const std::string& body) {
  if (body.empty()) return {};
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p>{}</p>\n{}</section>\n", anchor, title,
                     intro, body);
}

// How much there is, in one line.
std::string Extent(const Page& page) {
  std::set<std::string> properties;
  std::set<std::string> scenes;
  std::set<std::string> seeds;
  for (const Certificate& certificate : page.certificates) {
    for (const PropertyResult& result : certificate.tested) properties.insert(result.property);
    for (const SceneResult& result : certificate.measured) scenes.insert(result.scene);
    seeds.insert(std::to_string(certificate.seed));
  }
  std::string text = fmt::format("{} subjects, {} properties, {} scenes", page.certificates.size(),
                                 properties.size(), scenes.size());
  if (!seeds.empty()) text += ", seed";
  for (const std::string& seed : seeds) text += " " + seed;
  return text;
}

std::string Commands(const Page& page) {
  std::set<std::string> commands;
  for (const Certificate& certificate : page.certificates) commands.insert(certificate.command);
  std::string html;
  for (const std::string& command : commands) {
    if (!command.empty()) html += fmt::format("<pre><code>{}</code></pre>\n", Escaped(command));
  }
  return html;
}

constexpr std::string_view kGlossary =
    "<dl class=\"glossary\">\n"
    "<div><dt>proved</dt><dd>derived, and checked by a proof script where it says so</dd></div>\n"
    "<div><dt>exhausted</dt><dd>all N cases were run</dd></div>\n"
    "<div><dt>tested</dt><dd>k of N cases were run, from a seed</dd></div>\n"
    "<div><dt>measured</dt><dd>observed on these scenes, on this machine</dd></div>\n"
    "</dl>\n"
    "<p class=\"key\"><span class=\"mark holds\">✓</span> holds "
    "<span class=\"mark violated\">✗</span> violated "
    "<span class=\"mark idle\">○</span> not exercised: neither good nor bad "
    "<span class=\"mark idle\">?</span> inconclusive: it could not be judged "
    "<span class=\"mark none\">–</span> not applicable: not asked of this subject</p>\n";

}  // namespace

std::string PageToHtml(const Page& page) {
  std::string details;
  for (const Certificate& certificate : page.certificates) details += SubjectDetails(certificate);
  std::string pictures;
  for (const Picture& picture : page.pictures) pictures += Figure(picture);

  // The policy is for the browser to enforce what the page states: nothing runs, nothing loads.
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "style-src 'unsafe-inline'; img-src data:\">\n"
      "<title>{0}</title>\n<style>\n{1}</style>\n</head>\n<body>\n<main>\n"
      "<header>\n<h1>{0}</h1>\n<p class=\"extent\">{2}</p>\n</header>\n",
      Escaped(page.title), kPageStyle, Extent(page));
  html +=
      Section("verdicts", "Verdicts",
              "One line per subject, by what each states. A built-in method that does not state "
              "to be exact may fail: that is what it is here to show.",
              VerdictTable(page.certificates));
  html += kGlossary;
  html += Section("scenes", "Wrong samples",
                  "Every sample of every scene against the exact oracle: under the subject's own "
                  "profile, which is what it can be held to, and against real geometry.",
                  SceneTables(page.certificates));
  html += Section("properties", "Properties", "Each property, for each subject.",
                  PropertyMatrix(page.certificates));
  html += Section("near-edge", "How near to the edges",
                  "Distance of the tested samples from their edge, in steps of the subject's own "
                  "input lattice. Bars are logarithmic.",
                  NearEdgeTable(page.certificates));
  html += Section("pictures", "Pictures", "Each with the command that makes it again.", pictures);
  html +=
      Section("subjects", "Subjects",
              "What was proved, exhausted, tested and measured, and how often each property was "
              "really put to the test.",
              details);
  html += Section("environment", "Environment", "Where this was found.",
                  Environments(page.certificates) + Commands(page));
  return html + "</main>\n</body>\n</html>\n";
}

}  // namespace rasterproof::report
