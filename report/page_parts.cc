#include "report/page_parts.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// The class of the style sheet that shows an outcome.
std::string_view LookOf(Outcome outcome) {
  switch (outcome) {
    case Outcome::kHolds:
      return "holds";
    case Outcome::kViolated:
      return "violated";
    case Outcome::kNotExercised:
    case Outcome::kInconclusive:
      return "idle";
    case Outcome::kNotApplicable:
    case Outcome::kRefused:
      return "none";
  }
  return "none";
}

}  // namespace

std::string Document(std::string_view title, const std::string& body) {
  // The policy is for the browser to enforce what the page states: pictures that lie beside it or
  // in it, one script by its hash, and nothing else.
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta name=\"color-scheme\" content=\"light dark\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; "
      "style-src 'unsafe-inline'; img-src 'self' data:; script-src 'sha256-{}'; "
      "base-uri 'none'; form-action 'none'\">\n"
      "<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n<main>\n{}</main>\n"
      "<script>{}</script>\n</body>\n</html>\n",
      kPageScriptHash, Escaped(title), kPageStyle, body, kPageScript);
}

std::string Section(std::string_view anchor, std::string_view title, std::string_view intro,
                    const std::string& body) {
  if (body.empty()) return {};
  return fmt::format("<section id=\"{}\">\n<h2>{}</h2>\n<p class=\"why\">{}</p>\n{}</section>\n",
                     anchor, title, intro, body);
}

std::string Folded(const std::string& summary, const std::string& body, bool is_open) {
  return fmt::format("<details{}>\n<summary>{}</summary>\n{}</details>\n", is_open ? " open" : "",
                     summary, body);
}

std::string ColumnKey(const std::vector<std::pair<std::string_view, std::string_view>>& columns) {
  std::string html = "<dl class=\"columns\">\n";
  for (const auto& [name, text] : columns) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>\n", name, text);
  }
  return html + "</dl>\n";
}

std::string Command(std::string_view command) {
  if (command.empty()) return {};
  // Each word is an element by itself: a line ends between words, not after an option's hyphens.
  std::string words;
  for (std::size_t at = 0; at < command.size();) {
    const std::size_t end = std::min(command.find(' ', at), command.size());
    words +=
        fmt::format("{}<span>{}</span>", at == 0 ? "" : " ", Escaped(command.substr(at, end - at)));
    at = end + 1;
  }
  return fmt::format("<pre><code>{}</code></pre>\n", words);
}

std::string FigureHtml(const Picture& picture, std::string_view above,
                       std::string_view playground) {
  const std::string file = Escaped(fmt::format("{}{}", above, picture.file));
  return fmt::format(
      "<figure>\n<figcaption>{0}</figcaption>\n<div class=\"scroll{3}\"><a href=\"{1}\">"
      "<img loading=\"lazy\" alt=\"{0}\" src=\"{1}\"></a></div>\n{2}{4}</figure>\n",
      Escaped(picture.caption), file, Command(picture.command),
      picture.subject.empty() ? "" : " wide", PlaygroundLink(playground, picture.fragment, above));
}

std::string PlaygroundLink(std::string_view playground, std::string_view fragment,
                           std::string_view above) {
  if (playground.empty() || fragment.empty()) return {};
  const bool is_beside = playground.find(':') == std::string::npos;
  return fmt::format("<p><a href=\"{}{}{}\">Open it in the playground</a></p>\n",
                     is_beside ? above : "", Escaped(playground), fragment);
}

std::string Breakable(std::string_view name) {
  std::string html;
  char before = ' ';
  for (const char c : Escaped(name)) {
    const bool is_hump = before >= 'a' && before <= 'z' && c >= 'A' && c <= 'Z';
    if (is_hump || before == ':') html += "<wbr>";
    html += c;
    before = c;
  }
  return html;
}

std::string Link(const Certificate& certificate) {
  const std::string name = Breakable(certificate.subject.name);
  if (certificate.folder.empty()) return fmt::format("<span class=\"name\">{}</span>", name);
  return fmt::format("<a class=\"name\" href=\"{}/report.html\">{}</a>",
                     Escaped(certificate.folder), name);
}

std::string Chip(Outcome outcome) {
  return fmt::format("<span class=\"chip {}\">{}</span>", LookOf(outcome), OutcomeName(outcome));
}

std::string Chip(const Certificate& certificate, const PropertyResult& result) {
  if (!IsLackOfQuality(result, certificate.fail_on)) return Chip(result.outcome);
  return fmt::format("<span class=\"chip idle\">{}</span>", AuthorityName(result.authority));
}

std::string Number(std::uint64_t number, std::string_view loud) {
  return fmt::format("<td class=\"number {}\">{}</td>", number == 0 ? "zero" : loud,
                     Grouped(number));
}

std::string Several(std::uint64_t count, std::string_view what) {
  return fmt::format("{} {}{}", Grouped(count), what, count == 1 ? "" : "s");
}

const SceneResult* Find(const Certificate& certificate, std::string_view scene,
                        std::string_view profile) {
  for (const SceneResult& result : certificate.measured) {
    if (result.scene == scene && result.profile == profile) return &result;
  }
  return nullptr;
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

}  // namespace rasterproof::report
