#include "report/page.h"

#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/bench_page.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

std::string Headline(const Page& page) {
  const std::string cost = page.bench ? BenchSentence(*page.bench) : "";
  return cost.empty() ? VerdictSentence(page) : cost + " " + VerdictSentence(page);
}

// How much there is, in one line.
std::string Extent(const Page& page) {
  std::set<std::string> properties;
  std::set<std::string> scenes;
  std::set<std::string> seeds;
  for (const Certificate& certificate : page.certificates) {
    for (const PropertyResult& result : certificate.tested) properties.insert(NameOf(result));
    for (const SceneResult& result : certificate.measured) scenes.insert(result.scene);
    seeds.insert(std::to_string(certificate.seed));
  }
  std::string text =
      fmt::format("{}, {} properties, {} scenes", Several(page.certificates.size(), "subject"),
                  properties.size(), scenes.size());
  if (!seeds.empty()) text += ", seed";
  for (const std::string& seed : seeds) text += " " + seed;
  return text;
}

std::string Commands(const Page& page) {
  std::set<std::string> commands;
  for (const Certificate& certificate : page.certificates) commands.insert(certificate.command);
  std::string html;
  for (const std::string& command : commands) html += Command(command);
  return html;
}

// A page opens on the first pictures; the others are a click away.
std::string Failures(const Page& page) {
  constexpr std::size_t kMostShown = 2;
  std::string shown;
  std::string folded;
  std::size_t count = 0;
  for (const Picture& picture : page.pictures) {
    if (picture.subject.empty() || !picture.is_on_front) continue;
    (count++ < kMostShown ? shown : folded) += FigureHtml(picture, "", page.playground);
  }
  if (folded.empty()) return shown;
  return shown + Folded(fmt::format("More pictures: {}", count - kMostShown), folded, false);
}

std::string Renders(const Page& page) {
  std::string html;
  for (const Picture& picture : page.pictures) {
    if (picture.subject.empty()) html += FigureHtml(picture, "", page.playground);
  }
  return html.empty() ? html : Folded("The scenes, drawn", html, false);
}

constexpr std::string_view kGlossary =
    "<dl class=\"columns\">\n"
    "<div><dt>proved</dt><dd>derived, and checked by a proof script where it says so</dd></div>\n"
    "<div><dt>exhausted</dt><dd>all N cases were run</dd></div>\n"
    "<div><dt>tested</dt><dd>k of N cases were run, from a seed</dd></div>\n"
    "<div><dt>measured</dt><dd>observed on these scenes, on this machine</dd></div>\n"
    "<div><dt>holds</dt><dd>no case or scene contradicts it</dd></div>\n"
    "<div><dt>violated</dt><dd>a case or a scene contradicts it, and a command shows "
    "it</dd></div>\n"
    "<div><dt>not exercised</dt><dd>no case put it to the test: neither good nor bad</dd></div>\n"
    "<div><dt>inconclusive</dt><dd>it could not be judged</dd></div>\n"
    "<div><dt>not applicable</dt><dd>not asked of this subject</dd></div>\n"
    "</dl>\n";

}  // namespace

std::string PageToHtml(const Page& page) {
  std::string html = fmt::format(
      "<header>\n<h1>{}</h1>\n<p class=\"lead\">{}</p>\n<p class=\"why\">{}</p>\n"
      "</header>\n",
      Escaped(page.title), Headline(page), Extent(page));
  if (page.bench) html += BenchSections(*page.bench, page.folder);
  html += Section("verdicts", "Verdicts", "A name leads to all that is known of the subject.",
                  VerdictGroups(page));
  html += ValuesSection(page.certificates, page.value_methods);
  if (page.catalogue) html += CatalogueSection(*page.catalogue);
  html += page.surveys;
  html += Section("pictures", "Failures",
                  "Where a subject first differs from the exact oracle, each with the command that "
                  "shows it again.",
                  Failures(page));
  html += Section("scenes", "Scenes",
                  "Every sample of every scene against the exact oracle, front and back counted "
                  "apart.",
                  SceneTables(page.certificates) + Renders(page));
  html += Section("properties", "Properties",
                  "What must hold of every scene, on cases drawn from the seed.",
                  PropertyTable(page.certificates));
  html += Section("near-edge", "How near to the edges",
                  "Distance of the tested samples from their edge, in steps of the subject's own "
                  "input lattice. Bars are logarithmic.",
                  NearEdgeTable(page.certificates));
  html +=
      Section("words", "Words", "What the report says, and means by it.", std::string(kGlossary));
  html += Section("environment", "Environment", "Where this was found, and by which command.",
                  Environments(page.certificates) + Commands(page));
  return Document(page.title, html);
}

}  // namespace rasterproof::report
