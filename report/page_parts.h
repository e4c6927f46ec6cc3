// The parts of the report's pages, each a piece of HTML.
#ifndef RASTERPROOF_REPORT_PAGE_PARTS_H_
#define RASTERPROOF_REPORT_PAGE_PARTS_H_

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/certificate.h"
#include "report/page.h"

namespace rasterproof::report {

/// page.css, the style sheet of every page.
extern const std::string_view kPageStyle;
/// bench.css, the style sheet of the plot of error against run time: elements of the class bench.
extern const std::string_view kBenchStyle;
/// page.js, the script of every page. The page says the most important of it without.
extern const std::string_view kPageScript;
/// base64(SHA-256(kPageScript)), by which the page's policy allows this script and no other.
extern const std::string_view kPageScriptHash;

/// Tables of more rows, and lists of more pictures, are folded at first.
inline constexpr std::size_t kMostUnfolded = 12;

/// A whole document. `body` goes into its main element.
std::string Document(std::string_view title, const std::string& body);
/// Nothing if the body is empty.
std::string Section(std::string_view anchor, std::string_view title, std::string_view intro,
                    const std::string& body);
/// A part that the reader folds and unfolds. `summary` is HTML.
std::string Folded(const std::string& summary, const std::string& body, bool is_open);
/// What the columns of a table say: pairs of name and explanation.
std::string ColumnKey(const std::vector<std::pair<std::string_view, std::string_view>>& columns);
/// A command to be typed again.
std::string Command(std::string_view command);
/// The picture, which opens by itself, with caption, command and PlaygroundLink(). `above` leads
/// from the page that shows it to the page of all subjects: "" or "../".
std::string FigureHtml(const Picture& picture, std::string_view above,
                       std::string_view playground = {});
/// A link into Page::playground; nothing if there is none, or no fragment.
std::string PlaygroundLink(std::string_view playground, std::string_view fragment,
                           std::string_view above);
/// Returns the text, with places to break a line within names: at humps, after colons.
std::string Breakable(std::string_view name);
/// The name, as a link to the subject's page if it has a folder.
std::string Link(const Certificate& certificate);
/// The outcome's word on its colour.
std::string Chip(Outcome outcome);
/// That of a result: of a violation that fails nothing, "quality".
std::string Chip(const Certificate& certificate, const PropertyResult& result);
/// A right-aligned cell; `loud` is the class of a number that is not 0.
std::string Number(std::uint64_t number, std::string_view loud = "");
/// "1 subject", "2 subjects".
std::string Several(std::uint64_t count, std::string_view what);

/// What a subject did on a scene, if it was measured there against the profile.
const SceneResult* Find(const Certificate& certificate, std::string_view scene,
                        std::string_view profile);

/// The verdict on all subjects in a sentence or two.
std::string VerdictSentence(const Page& page);
/// The subjects in groups by what they state, a row each: verdict, properties, wrong samples.
std::string VerdictGroups(const Page& page);
/// A row per scene, and wrong samples of every subject on every scene.
std::string SceneTables(const std::vector<Certificate>& certificates);
/// What was found of values, by the questions that readers have; of subjects that show none, a
/// line.
std::string ValuesSection(const std::vector<Certificate>& certificates,
                          const std::vector<ValueMethodRow>& methods);
/// A row per property: how many subjects hold it, and which violate it.
std::string PropertyTable(const std::vector<Certificate>& certificates);
/// How many samples lay on an edge, and how near the others were.
std::string NearEdgeTable(const std::vector<Certificate>& certificates);
/// Compiler, flags and floating-point environment, once for all subjects that share them.
std::string Environments(const std::vector<Certificate>& certificates);

}  // namespace rasterproof::report

#endif  // RASTERPROOF_REPORT_PAGE_PARTS_H_
