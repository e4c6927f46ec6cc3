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
#include "report/real_profile.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

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

// A scene over all subjects that were judged on it.
std::string SceneRow(const std::vector<Certificate>& certificates, const SceneResult& any) {
  std::uint64_t judged = 0;
  std::uint64_t failed = 0;
  std::uint64_t most = 0;
  const Certificate* by = nullptr;
  for (const Certificate& certificate : certificates) {
    const SceneResult* result = Find(certificate, any.scene, certificate.subject.profile.name);
    if (result == nullptr || !IsJudged(certificate, *result)) continue;
    ++judged;
    const std::uint64_t wrong = result->difference.wrong;
    if (wrong != 0) ++failed;
    if (wrong <= most) continue;
    most = wrong;
    by = &certificate;
  }
  return fmt::format("<tr><th scope=\"row\" class=\"name\">{}</th>{}{}{}{}{}<td>{}</td></tr>\n",
                     Escaped(any.scene), Number(any.triangles), Number(any.difference.samples),
                     Number(judged), Number(failed, "wrong"), Number(most, "wrong"),
                     by == nullptr ? "" : Link(*by));
}

std::string SceneTable(const std::vector<Certificate>& certificates,
                       const std::vector<const SceneResult*>& scenes) {
  std::string html =
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>scene</th>"
      "<th class=\"number\">triangles</th><th class=\"number\">samples</th>"
      "<th class=\"number\">judged</th><th class=\"number\">wrong</th>"
      "<th class=\"number\">most wrong</th><th>by</th></tr></thead><tbody>\n";
  for (const SceneResult* scene : scenes) html += SceneRow(certificates, *scene);
  return html + "</tbody></table></div>\n" +
         ColumnKey({{"judged", "subjects whose profile answers for every sample of the scene"},
                    {"wrong", "how many of them drew a sample wrong"},
                    {"most wrong, by", "the most wrong samples, and the subject that drew them"}});
}

std::string WrongCell(const SceneResult* result) {
  if (result == nullptr || !result->applicable) return "<td class=\"number none\">–</td>";
  return Number(result->difference.wrong, "wrong");
}

// Samples that differ from real geometry, of every subject on every scene at a glance.
std::string SceneMatrix(const std::vector<Certificate>& certificates,
                        const std::vector<const SceneResult*>& scenes) {
  std::string html =
      "<div class=\"scroll\"><table class=\"sorts matrix\"><thead><tr><th>subject</th>";
  for (const SceneResult* scene : scenes) {
    html += fmt::format("<th class=\"number\" scope=\"col\"><span class=\"upright\">{}</span></th>",
                        Escaped(scene->scene));
  }
  html += "</tr></thead><tbody>\n";
  for (const Certificate& certificate : certificates) {
    html += fmt::format("<tr><th scope=\"row\">{}</th>", Link(certificate));
    for (const SceneResult* scene : scenes) {
      html += WrongCell(Find(certificate, scene->scene, kRealProfile));
    }
    html += "</tr>\n";
  }
  return html + "</tbody></table></div>\n";
}

// One property over all subjects.
struct PropertyRow {
  std::map<Outcome, std::uint64_t> subjects;
  std::uint64_t quality = 0;  // subjects that violate it, but no clause requires it of them
  std::vector<const Certificate*> violated_by;
};

// A few names stand in the cell, more of them are folded.
std::string ViolatedBy(const std::vector<const Certificate*>& subjects) {
  constexpr std::size_t kFew = 2;
  std::string names;
  for (const Certificate* one : subjects) names += (names.empty() ? "" : ", ") + Link(*one);
  return subjects.size() <= kFew ? names
                                 : Folded(Several(subjects.size(), "subject"), names + "\n", false);
}

std::string PropertyRowOf(const std::string& property, PropertyRow& row) {
  auto& count = row.subjects;
  return fmt::format(
      "<tr><th scope=\"row\" class=\"name\">{}</th>{}{}{}{}{}<td class=\"names\">{}</td></tr>\n",
      Breakable(property), Number(count[Outcome::kHolds]),
      Number(count[Outcome::kViolated], "wrong"), Number(row.quality),
      Number(count[Outcome::kNotExercised] + count[Outcome::kInconclusive]),
      Number(count[Outcome::kNotApplicable] + count[Outcome::kRefused]),
      ViolatedBy(row.violated_by));
}

NearEdgeCounts Sum(const Certificate& certificate) {
  NearEdgeCounts sum;
  for (const PropertyResult& result : certificate.tested) sum += result.NearEdge();
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

std::string SceneTables(const std::vector<Certificate>& certificates) {
  const std::vector<const SceneResult*> scenes = ScenesOf(certificates);
  if (scenes.empty()) return {};
  return SceneTable(certificates, scenes) +
         Folded("Samples off real geometry, of every subject on every scene",
                SceneMatrix(certificates, scenes), certificates.size() <= kMostUnfolded);
}

std::string PropertyTable(const std::vector<Certificate>& certificates) {
  std::vector<std::string> properties;
  std::map<std::string, PropertyRow> rows;
  for (const Certificate& certificate : certificates) {
    for (const PropertyResult& result : certificate.tested) {
      const auto [row, is_new] = rows.try_emplace(NameOf(result));
      if (is_new) properties.push_back(NameOf(result));
      if (IsLackOfQuality(result, certificate.fail_on)) {
        ++row->second.quality;
        continue;
      }
      ++row->second.subjects[result.outcome];
      if (result.outcome == Outcome::kViolated) row->second.violated_by.push_back(&certificate);
    }
  }
  if (properties.empty()) return {};
  std::string html =
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>property</th>"
      "<th class=\"number\">hold</th><th class=\"number\">violated</th>"
      "<th class=\"number\">quality</th>"
      "<th class=\"number\">open</th><th class=\"number\">not asked</th><th>violated by</th>"
      "</tr></thead><tbody>\n";
  for (const std::string& property : properties) html += PropertyRowOf(property, rows.at(property));
  html += "</tbody></table></div>\n" +
          ColumnKey({{"hold, violated", "subjects with this outcome"},
                     {"quality", "subjects that violate it where no clause requires it"},
                     {"open", "subjects on which it was not exercised or could not be judged"},
                     {"not asked", "subjects to which it is not applicable"}});
  return Folded(fmt::format("{} properties, by how many subjects hold them", properties.size()),
                html, properties.size() <= kMostUnfolded);
}

std::string NearEdgeTable(const std::vector<Certificate>& certificates) {
  std::uint64_t largest = 0;
  for (const Certificate& certificate : certificates) {
    largest = std::max(largest, Sum(certificate).samples);
  }
  if (largest == 0) return {};
  std::string html =
      "<div class=\"scroll\"><table class=\"sorts\"><thead><tr><th>subject</th>"
      "<th class=\"number\">samples</th>"
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
  return Folded(Several(certificates.size(), "subject"), html + "</tbody></table></div>\n",
                certificates.size() <= kMostUnfolded);
}

}  // namespace rasterproof::report
