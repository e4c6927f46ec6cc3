#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "fmt/format.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

constexpr std::string_view kRealProfile = "real";

std::string Link(const Certificate& certificate) {
  return fmt::format("<a class=\"name\" href=\"#{}\">{}</a>", AnchorOf(certificate),
                     Escaped(certificate.subject.name));
}

// A right-aligned cell; `loud` is the class of a number that is not 0.
std::string Number(std::uint64_t number, std::string_view loud = "") {
  return fmt::format("<td class=\"number {}\">{}</td>", number == 0 ? "zero" : loud,
                     Grouped(number));
}

std::string_view Mark(Outcome outcome) {
  switch (outcome) {
    case Outcome::kHolds:
      return "<span class=\"mark holds\">✓</span>";
    case Outcome::kViolated:
      return "<span class=\"mark violated\">✗</span>";
    case Outcome::kNotExercised:
      return "<span class=\"mark idle\">○</span>";
    case Outcome::kNotApplicable:
    case Outcome::kRefused:
      return "<span class=\"mark none\">–</span>";
    case Outcome::kInconclusive:
      return "<span class=\"mark idle\">?</span>";
  }
  return "";
}

// What a subject did on a scene, if it was measured there against the profile.
const SceneResult* Find(const Certificate& certificate, std::string_view scene,
                        std::string_view profile) {
  for (const SceneResult& result : certificate.measured) {
    if (result.scene == scene && result.profile == profile) return &result;
  }
  return nullptr;
}

// Wrong samples over all scenes within the limits of the profile that they were measured against.
// A difference from the canonical model of a profile that leaves others legal is none.
struct Total {
  std::uint64_t wrong = 0;
  std::uint64_t samples = 0;
};

enum class Counted : std::uint8_t { kJudged, kObserved };

Total TotalOf(const Certificate& certificate, std::string_view profile, Counted counted) {
  Total total;
  for (const SceneResult& result : certificate.measured) {
    // A scene may be there twice: under the subject's own profile, and that is the real one.
    if (Find(certificate, result.scene, profile) != &result) continue;
    if (!result.applicable || !result.message.empty()) continue;
    if (counted == Counted::kJudged && !IsJudged(certificate, result)) continue;
    total.wrong += result.difference.wrong;
    total.samples += result.difference.samples;
  }
  return total;
}

std::string TotalCell(const Total& total) {
  if (total.samples == 0) return "<td class=\"number none\">–</td>";
  return fmt::format("<td class=\"number {}\">{} of {}</td>", total.wrong == 0 ? "zero" : "wrong",
                     Grouped(total.wrong), Grouped(total.samples));
}

std::string VerdictRow(const Certificate& certificate) {
  const auto count = [&](Outcome outcome) {
    return static_cast<std::uint64_t>(
        std::ranges::count(certificate.tested, outcome, &PropertyResult::outcome));
  };
  const Overall overall = OverallOf(certificate);
  std::string row = fmt::format(
      "<tr><th scope=\"row\">{}</th><td title=\"{}\"><span class=\"chip {}\">{}</span>{}</td>"
      "<td>{}</td>",
      Link(certificate), Escaped(overall.reason), LookOf(overall.outcome),
      OutcomeName(overall.outcome), certificate.interrupted ? " interrupted" : "",
      certificate.subject.states_exact ? "exact" : "");
  row += Number(count(Outcome::kHolds)) + Number(count(Outcome::kViolated), "wrong") +
         Number(count(Outcome::kNotExercised)) + Number(count(Outcome::kInconclusive)) +
         Number(count(Outcome::kNotApplicable));
  row += TotalCell(TotalOf(certificate, certificate.subject.profile.name, Counted::kJudged));
  return row + TotalCell(TotalOf(certificate, kRealProfile, Counted::kObserved)) + "</tr>\n";
}

// Parts of a million, to three digits or to the unit.
std::string PerMillion(std::uint64_t count, std::uint64_t of) {
  const double share = of == 0 ? 0 : 1e6 * static_cast<double>(count) / static_cast<double>(of);
  return share < 1000 ? fmt::format("{:.3g}", share)
                      : Grouped(static_cast<std::uint64_t>(std::llround(share)));
}

std::string DifferenceCells(const SceneResult* result) {
  if (result == nullptr || !result->applicable) {
    const std::string why = result == nullptr ? "not measured" : Escaped(result->message);
    return fmt::format("<td class=\"split why\" colspan=\"4\">{}</td>", why);
  }
  const CoverageDifference& d = result->difference;
  const std::string wrong = fmt::format("<td class=\"number split {}\">{}</td>",
                                        d.wrong == 0 ? "zero" : "wrong", Grouped(d.wrong));
  return wrong + Number(d.missing, "missing") + Number(d.unexpected, "unexpected") +
         fmt::format("<td class=\"number {}\">{}</td>", d.wrong == 0 ? "zero" : "",
                     PerMillion(d.wrong, d.covered));
}

std::string SceneRow(const Certificate& certificate, std::string_view scene) {
  const std::string& own = certificate.subject.profile.name;
  const SceneResult* of_own = Find(certificate, scene, own);
  const SceneResult* of_real = Find(certificate, scene, kRealProfile);
  // A subject that does not take the scene at all is measured against neither.
  if (of_real == nullptr && of_own != nullptr && !of_own->applicable) of_real = of_own;
  std::string note;
  if (of_own != nullptr && of_own->applicable) note = WhyNotJudged(certificate, *of_own);
  return fmt::format("<tr><th scope=\"row\">{}</th><td class=\"why {}\">{}{}</td>{}{}</tr>\n",
                     Link(certificate), note.empty() ? "" : "noted", Escaped(own),
                     note.empty() ? "" : ": " + Escaped(note), DifferenceCells(of_own),
                     DifferenceCells(of_real));
}

// Scenes in the order of their first mention, each with a result that shows its extent.
std::vector<const SceneResult*> ScenesOf(const std::vector<Certificate>& certificates) {
  std::vector<const SceneResult*> scenes;
  for (const Certificate& certificate : certificates) {
    for (const SceneResult& result : certificate.measured) {
      auto found = std::ranges::find(scenes, result.scene, &SceneResult::scene);
      if (found == scenes.end()) {
        scenes.push_back(&result);
      } else if (!(*found)->applicable) {
        *found = &result;
      }
    }
  }
  return scenes;
}

// Wrong samples against real geometry, of every subject on every scene at a glance.
std::string SceneMatrix(const std::vector<Certificate>& certificates,
                        const std::vector<const SceneResult*>& scenes) {
  std::string html =
      "<p class=\"aside\">Wrong samples against real geometry:</p>\n"
      "<div class=\"scroll fit\"><table class=\"matrix\"><thead><tr><th></th>";
  for (const SceneResult* scene : scenes) {
    html += fmt::format("<th class=\"upright name\" scope=\"col\">{}</th>", Escaped(scene->scene));
  }
  html += "</tr></thead><tbody>\n";
  for (const Certificate& certificate : certificates) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", Link(certificate));
    for (const SceneResult* scene : scenes) {
      const SceneResult* result = Find(certificate, scene->scene, kRealProfile);
      html += result == nullptr || !result->applicable ? "<td class=\"number none\">–</td>"
                                                       : Number(result->difference.wrong, "wrong");
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string SceneTable(const std::vector<Certificate>& certificates, const SceneResult& any) {
  std::string html = fmt::format(
      "<details>\n<summary><strong>{}</strong> <span class=\"why\">{} triangles, {} samples, "
      "{} of them covered</span></summary>\n",
      Escaped(any.scene), Grouped(any.triangles), Grouped(any.difference.samples),
      Grouped(any.difference.covered));
  html +=
      "<div class=\"scroll\"><table><thead>"
      "<tr><th rowspan=\"2\">subject</th><th rowspan=\"2\">its profile</th>"
      "<th class=\"split\" colspan=\"4\">against its own profile</th>"
      "<th class=\"split\" colspan=\"4\">against real geometry</th></tr><tr>";
  for (int side = 0; side < 2; ++side) {
    html +=
        "<th class=\"number split\">wrong</th><th class=\"number\">missing</th>"
        "<th class=\"number\">unexpected</th><th class=\"number\">per million covered</th>";
  }
  html += "</tr></thead><tbody>\n";
  for (const Certificate& certificate : certificates) html += SceneRow(certificate, any.scene);
  return html + "</tbody></table></div>\n</details>\n";
}

NearEdgeCounts Sum(const Certificate& certificate) {
  NearEdgeCounts sum;
  for (const PropertyResult& result : certificate.tested) {
    sum.samples += result.near_edge.samples;
    sum.on_edge += result.near_edge.on_edge;
    sum.within_1 += result.near_edge.within_1;
    sum.within_16 += result.near_edge.within_16;
    sum.within_256 += result.near_edge.within_256;
  }
  return sum;
}

// A count over a bar as long as its logarithm, beside that of the largest.
std::string BarCell(std::uint64_t count, std::uint64_t largest) {
  const auto log = [](std::uint64_t n) { return std::log2(static_cast<double>(n) + 1); };
  const double share = largest == 0 ? 0 : 100 * log(count) / log(largest);
  return fmt::format(
      "<td class=\"number {}\">{}<svg class=\"bar\" viewBox=\"0 0 100 4\" "
      "preserveAspectRatio=\"none\" aria-hidden=\"true\"><rect width=\"{:.1f}\" height=\"4\"/>"
      "</svg></td>",
      count == 0 ? "zero" : "", Grouped(count), share);
}

std::uint64_t Less(std::uint64_t a, std::uint64_t b) { return a > b ? a - b : 0; }

}  // namespace

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

std::string AnchorOf(const Certificate& certificate) {
  std::string anchor = "subject-";
  for (const char c : certificate.subject.name) {
    const bool plain =
        (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    // Other characters by their code: names that differ keep anchors that differ.
    anchor += plain ? std::string(1, c)
                    : fmt::format("_{:02x}", static_cast<unsigned>(static_cast<unsigned char>(c)));
  }
  return anchor;
}

std::string VerdictTable(const std::vector<Certificate>& certificates) {
  if (certificates.empty()) return {};
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>subject</th><th>verdict</th><th>properties</th>"
      "<th class=\"number\">hold</th><th class=\"number\">violated</th>"
      "<th class=\"number\">not exercised</th><th class=\"number\">inconclusive</th>"
      "<th class=\"number\">not applicable</th>"
      "<th class=\"number\">wrong, own profile</th><th class=\"number\">wrong, real geometry</th>"
      "</tr></thead><tbody>\n";
  for (const Certificate& certificate : certificates) html += VerdictRow(certificate);
  return html + "</tbody></table></div>\n";
}

std::string SceneTables(const std::vector<Certificate>& certificates) {
  const std::vector<const SceneResult*> scenes = ScenesOf(certificates);
  if (scenes.empty()) return {};
  std::string html = SceneMatrix(certificates, scenes);
  for (const SceneResult* scene : scenes) html += SceneTable(certificates, *scene);
  return html;
}

std::string PropertyMatrix(const std::vector<Certificate>& certificates) {
  std::vector<std::string> properties;
  std::map<std::string, std::vector<const PropertyResult*>> rows;
  for (std::size_t k = 0; k < certificates.size(); ++k) {
    for (const PropertyResult& result : certificates[k].tested) {
      auto [row, is_new] = rows.try_emplace(result.property, certificates.size());
      if (is_new) properties.push_back(result.property);
      row->second[k] = &result;
    }
  }
  if (properties.empty()) return {};
  std::string html = "<div class=\"scroll fit\"><table class=\"matrix\"><thead><tr><th></th>";
  for (const Certificate& certificate : certificates) {
    html += fmt::format("<th class=\"upright\" scope=\"col\">{}</th>", Link(certificate));
  }
  html += "</tr></thead><tbody>\n";
  for (const std::string& property : properties) {
    html += fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>", Escaped(property));
    for (std::size_t k = 0; k < certificates.size(); ++k) {
      const PropertyResult* result = rows.at(property)[k];
      const Outcome outcome = result == nullptr ? Outcome::kNotApplicable : result->outcome;
      html += fmt::format("<td title=\"{}: {}\">{}</td>", Escaped(certificates[k].subject.name),
                          OutcomeName(outcome), Mark(outcome));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

std::string NearEdgeTable(const std::vector<Certificate>& certificates) {
  std::uint64_t largest = 0;
  for (const Certificate& certificate : certificates) {
    largest = std::max(largest, Sum(certificate).samples);
  }
  if (largest == 0) return {};
  std::string html =
      "<div class=\"scroll\"><table><thead><tr><th>subject</th><th class=\"number\">samples</th>"
      "<th class=\"number\">on the edge</th><th class=\"number\">within 1</th>"
      "<th class=\"number\">1 to 16</th><th class=\"number\">16 to 256</th>"
      "<th class=\"number\">farther</th></tr></thead><tbody>\n";
  for (const Certificate& certificate : certificates) {
    const NearEdgeCounts sum = Sum(certificate);
    html += fmt::format("<tr><th scope=\"row\">{}</th>{}", Link(certificate), Number(sum.samples));
    for (const std::uint64_t count : {sum.on_edge, sum.within_1, Less(sum.within_16, sum.within_1),
                                      Less(sum.within_256, sum.within_16),
                                      Less(Less(sum.samples, sum.on_edge), sum.within_256)}) {
      html += BarCell(count, largest);
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

}  // namespace rasterproof::report
