#include "report/bench_page.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fmt/format.h"
#include "report/bench_decision.h"
#include "report/bench_page_parts.h"
#include "report/bench_text.h"
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// A float32 scene where float32 holds every corner.
Precision PrecisionOf(const BenchWitness& witness) {
  const bool is_narrow = std::ranges::all_of(witness.corners, [](const Vertex& v) {
    const auto fits = [](double value) {
      return static_cast<double>(static_cast<float>(value)) == value;
    };
    return fits(v.x) && fits(v.y) && fits(v.z) && fits(v.w);
  });
  return is_narrow ? Precision::kFloat32 : Precision::kFloat64;
}

Scene SceneOf(const BenchFamily& family, const BenchWitness& witness) {
  Scene scene;
  scene.name = family.name;
  scene.width = family.width;
  scene.height = family.height;
  scene.precision = PrecisionOf(witness);
  scene.clip_space = family.is_clip_space;
  scene.vertices.assign(witness.corners.begin(), witness.corners.end());
  scene.triangles = {{0, 1, 2}};
  return scene;
}

struct BenchQuestion {
  std::string_view text;
  std::string_view anchor;
  std::string_view where;
};

constexpr std::array kBenchQuestions{
    BenchQuestion{
        "Which method is cheapest for what I need, at 1080p or 4K, snapped or not?", "which",
        "the table of decisions: a row is a family of triangles, snapped-8 is snapping to "
        "1/256"},
    BenchQuestion{"What is fastest at zero wrong samples?", "which",
                  "its first two columns, proved and seen"},
    BenchQuestion{"Why not double, or stepping, or snapping?", "advice",
                  "textbook advice, measured"},
    BenchQuestion{"What does mine cost beside them?", "yours", "yours on the same inputs"},
    BenchQuestion{"What else is there, and how wrong is it?", "pareto",
                  "every method: choose family and error"},
    BenchQuestion{"Which interpolation may I trust? Is my du/dx right? Does my texture swim?",
                  "interpolation",
                  "errors of values and derivatives, and the advice that they test"},
    BenchQuestion{"Where does a method end: large triangles, long walks, far from the origin?",
                  "limits", "a matrix of methods and parameters, then curves"},
    BenchQuestion{
        "What happens at w → 0?", "curve-w",
        "curves over w, the column w of the matrix above them, and the family bunny-inside"},
    BenchQuestion{"How wrong can it get, and how do I see it?", "worst",
                  "worst known cases, each with a command"},
    BenchQuestion{"Which stage of a frame costs accuracy?", "stages", "an error budget"},
    BenchQuestion{"Does each method do what it states?", "verdicts", "the verdicts"}};

// Only questions that the page answers.
std::string Questions(const std::string& sections) {
  std::string html = "<nav class=\"questions\"><ul class=\"plain\">\n";
  for (const BenchQuestion& one : kBenchQuestions) {
    const std::string anchor = fmt::format("id=\"{}\"", one.anchor);
    if (one.anchor != "verdicts" && sections.find(anchor) == std::string::npos) continue;
    html += fmt::format("<li><a href=\"#{}\">{}</a> <span class=\"why\">{}</span></li>\n",
                        one.anchor, one.text, one.where);
  }
  return html + "</ul></nav>\n";
}

// Where it was measured, and how far the noise goes.
std::string SettingText(const BenchResult& bench) {
  double least = 1;
  double most = 1;
  for (const BenchRow& row : bench.rows) {
    const BenchFamily& family = bench.families[row.family];
    if (row.method != family.twin || family.twin == family.baseline) continue;
    least = std::min(least, row.ratio.median);
    most = std::max(most, row.ratio.median);
  }
  const BenchSetting& setting = bench.setting;
  return fmt::format(
      "<p class=\"why\">Measured on {}, {}, by {}. Processor time of one draw, median of paired "
      "rounds, the target cleared before it. The baseline measured against itself: {:.3f} to "
      "{:.3f}, the floor of the noise. {}{} {}</p>\n{}",
      Escaped(setting.processor), Escaped(setting.date), Escaped(setting.compiler), least, most,
      LoadText(setting),
      setting.is_quick ? " A quick run: families of an eighth of their size." : "",
      Escaped(NotMeasuredText(bench)), Command(setting.command));
}

constexpr std::string_view kYoursMissing =
    "<p>This record holds none of yours. Measure it on the same inputs in the same run, and make "
    "the page again:</p>\n";

std::string Yours(const BenchResult& bench, std::string_view folder) {
  std::string table = UsersTable(bench);
  if (!table.empty()) return table;
  return std::string(kYoursMissing) +
         Command(fmt::format("rasterproof bench --plugin mine.so --json {}/bench.json", folder)) +
         Command(fmt::format("rasterproof certify --all --bench {0}/bench.json --out {0}", folder));
}

std::string Limits(const BenchResult& bench, std::string_view folder) {
  return CliffTable(bench, folder) + CurvePlots(bench);
}

}  // namespace

std::string NumberText(double value) {
  if (!std::isfinite(value)) return "–";
  return value >= 999.5 ? Grouped(static_cast<std::uint64_t>(std::llround(value)))
                        : fmt::format("{:.3g}", value);
}

std::string WrongText(const BenchResult& bench, const BenchRow& row) {
  if (!row.is_judged) return "–";
  const RowError error = ErrorOf(bench, row, ErrorKind::kReal);
  if (error.lane == ErrorLane::kProved) return "proved 0";
  return fmt::format("{} of {}", Grouped(WrongBesideEdges(row, row.real)),
                     Grouped(row.boundary_pairs));
}

std::vector<BenchCase> BenchCases(const BenchResult& bench) {
  std::vector<BenchCase> cases;
  for (const auto& [row, file] : WorstCasesOf(bench)) {
    cases.push_back({file, SceneOf(bench.families[row->family], *row->real.worst)});
  }
  for (const BenchCliff& cliff : bench.cliffs) {
    if (cliff.scene) cases.push_back({CliffFile(bench, cliff), *cliff.scene});
  }
  return cases;
}

std::string BenchSentence(const BenchResult& bench) {
  std::vector<std::pair<double, std::string>> ratios;
  for (std::uint32_t family = 0; family < bench.families.size(); ++family) {
    const std::optional<Decision> proved = Decide(bench, family, Need::kProvedZero);
    if (proved) ratios.emplace_back(proved->ratio, bench.families[family].name);
  }
  if (ratios.empty()) return {};
  std::ranges::sort(ratios);
  if (ratios.size() == 1) {
    return fmt::format(
        "Coverage that is proved right takes {:.2f} times as long as the fastest "
        "method.",
        ratios.front().first);
  }
  return fmt::format(
      "Coverage that is proved right takes {:.2f} times as long as the fastest method, by the "
      "median "
      "of {} families of triangles, and {:.2f} times where it costs most (<a "
      "href=\"#which\">{}</a>).",
      ratios[ratios.size() / 2].first, ratios.size(), ratios.back().first,
      Escaped(ratios.back().second));
}

std::string BenchSections(const BenchResult& bench, std::string_view folder) {
  const auto section = [](std::string_view anchor, std::string_view title, std::string_view intro,
                          const std::string& body) { return Section(anchor, title, intro, body); };
  std::string html;
  html += section("which", "Which method for which triangles",
                  "The cheapest method that meets a need, and what it costs.",
                  DecisionTable(bench) + SettingText(bench));
  html += section("yours", "Yours beside them", "The same inputs, the same run, the same judge.",
                  Yours(bench, folder));
  html += section("advice", "Textbook advice, measured",
                  "Each by two methods that differ in one thing, in the same sink and by the same "
                  "vectors, less what the sink costs.",
                  ClaimTable(bench));
  html += section("pareto", "Error against run time",
                  "A point is a method. Left is fast, low is right; nothing beats the points on "
                  "the line.",
                  ParetoParts(bench));
  html += section("families", "Every family at a glance",
                  "The frontier alone: wrong pairs (up) against time over the baseline's (across), "
                  "by real geometry.",
                  FamilyPanels(bench));
  html += section("limits", "Where each method ends",
                  "One number of the triangles grows, the rest is kept. Failing is not monotone: "
                  "between proved and first seen failing nothing is stated.",
                  Limits(bench, folder));
  html += section("fingerprints", "Fingerprints",
                  "One end of an edge that two triangles share moves through 256 x 256 "
                  "neighbouring places: left what the method says of one sample, right its own "
                  "model. Grey-blue: the first triangle has it, white: the second, blue: both, "
                  "vermilion: neither.",
                  FingerprintPictures(bench));
  html += section("worst", "Worst known cases",
                  "The wrong sample farthest from its triangle's boundary, by real geometry, of "
                  "each method on each family.",
                  WorstCases(bench, folder));
  html += section("stages", "Error budget of a frame",
                  "Distance to the exact pipeline with one stage alone inexact.", StageBars(bench));
  html += section("interpolation", "Which interpolation may I trust, at what cost?",
                  "Values and derivatives by every method on the same spans, held to exact "
                  "rationals.",
                  ValueParts(bench));
  return Questions(html) + html;
}

}  // namespace rasterproof::report
