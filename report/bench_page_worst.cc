// Worst known cases: the triangle's edges near the sample that is decided wrong.
#include <algorithm>
#include <array>
#include <cctype>
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
#include "report/page_parts.h"
#include "report/text.h"

namespace rasterproof::report {
namespace {

// Pixels across and down in a picture; the sample lies in the middle one.
constexpr int kSide = 9;
constexpr int kMiddle = kSide / 2;
constexpr double kScale = 16;

struct Segment {
  Point2 from;
  Point2 to;
};

// The part of a segment within [0, kSide] x [0, kSide], by its parameter (Liang and Barsky 1984).
std::optional<Segment> Clipped(Point2 a, Point2 b) {
  const double dx = b.x - a.x;
  const double dy = b.y - a.y;
  double begin = 0;
  double end = 1;
  for (const auto& [towards, room] :
       {std::pair{-dx, a.x}, {dx, kSide - a.x}, {-dy, a.y}, {dy, kSide - a.y}}) {
    if (towards == 0 && room < 0) return std::nullopt;
    if (towards < 0) begin = std::max(begin, room / towards);
    if (towards > 0) end = std::min(end, room / towards);
  }
  if (!(begin <= end)) return std::nullopt;
  return Segment{{a.x + begin * dx, a.y + begin * dy}, {a.x + end * dx, a.y + end * dy}};
}

// Empty where a corner has no place in the window.
std::string PictureOf(const BenchWitness& witness) {
  std::array<Point2, 3> corners;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Vertex& v = witness.corners[k];
    if (!IsFinite(v) || !(v.w > 0)) return {};
    corners[k] = {v.x / v.w - witness.x + kMiddle, v.y / v.w - witness.y + kMiddle};
  }
  std::string svg;
  for (int k = 0; k <= kSide; ++k) {
    svg += fmt::format("<path class=\"grid\" d=\"M{0} 0V{1}M0 {0}H{1}\"/>", k * kScale,
                       kSide * kScale);
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const std::optional<Segment> edge = Clipped(corners[k], corners[(k + 1) % corners.size()]);
    if (!edge) continue;
    svg += fmt::format("<path class=\"edge\" d=\"M{:.2f} {:.2f}L{:.2f} {:.2f}\"/>",
                       edge->from.x * kScale, edge->from.y * kScale, edge->to.x * kScale,
                       edge->to.y * kScale);
  }
  const double middle = (kMiddle + 0.5) * kScale;
  return fmt::format(
      "<svg class=\"plot case\" role=\"img\" aria-label=\"The triangle's edges near the wrong "
      "sample\" viewBox=\"0 0 {0} {0}\">{1}<circle class=\"sample\" cx=\"{2}\" cy=\"{2}\" r=\"3\"/>"
      "</svg>",
      kSide * kScale, svg, middle);
}

std::string CommandOf(const BenchResult& bench, const WorstCase& worst, std::string_view folder) {
  const BenchMethod& method = bench.methods[worst.row->method];
  const BenchWitness& witness = *worst.row->real.worst;
  return fmt::format("rasterproof explain {}/{} --{} {}{} --pixel {} {}", folder, worst.file,
                     method.is_users ? "plugin" : "subject", method.name,
                     method.model == "real" ? "" : " --profile real", witness.x, witness.y);
}

std::string CaseHtml(const BenchResult& bench, const WorstCase& worst, std::string_view folder) {
  const BenchWitness& witness = *worst.row->real.worst;
  return fmt::format(
      "<figure class=\"case\">{}<figcaption><span class=\"name\">{}</span> {} wrong; this sample "
      "({}, {}) by {} px</figcaption>{}</figure>\n",
      PictureOf(witness), Escaped(bench.methods[worst.row->method].name),
      WrongText(bench, *worst.row), witness.x, witness.y, NumberText(witness.distance),
      Command(CommandOf(bench, worst, folder)));
}

}  // namespace

std::string FileOf(std::string_view prefix, const BenchMethod& method) {
  std::string name = fmt::format("{}-{}", prefix, method.name);
  std::ranges::replace_if(
      name, [](char c) { return std::isalnum(static_cast<unsigned char>(c)) == 0 && c != '-'; },
      '_');
  return "bench/" + name + ".json";
}

std::vector<WorstCase> WorstCasesOf(const BenchResult& bench) {
  std::vector<WorstCase> cases;
  for (const BenchRow& row : bench.rows) {
    if (!row.is_judged || !row.real.worst || IsBaselineAgain(bench, row)) continue;
    const std::string file = FileOf(bench.families[row.family].name, bench.methods[row.method]);
    const auto known = std::ranges::find(cases, file, &WorstCase::file);
    if (known == cases.end()) {
      cases.push_back({&row, file});
    } else if (known->row->real.worst->distance < row.real.worst->distance) {
      known->row = &row;
    }
  }
  return cases;
}

std::string WorstCases(const BenchResult& bench, std::string_view folder) {
  const std::vector<WorstCase> cases = WorstCasesOf(bench);
  std::string html;
  for (std::uint32_t family = 0; family < bench.families.size(); ++family) {
    std::vector<WorstCase> here;
    std::ranges::copy_if(cases, std::back_inserter(here),
                         [&](const WorstCase& worst) { return worst.row->family == family; });
    if (here.empty()) continue;
    std::ranges::sort(here, {}, [](const WorstCase& worst) {
      return std::pair(-worst.row->real.worst->distance, worst.row->method);
    });
    std::string body = "<div class=\"cases\">\n";
    for (const WorstCase& worst : here) body += CaseHtml(bench, worst, folder);
    const BenchWitness& farthest = *here.front().row->real.worst;
    html += Folded(
        fmt::format("<span class=\"name\">{}</span> <span class=\"why\">{}, the farthest by {} px"
                    "</span>",
                    Escaped(bench.families[family].name), Several(here.size(), "method"),
                    NumberText(farthest.distance)),
        body + "</div>\n", false);
  }
  return html;
}

}  // namespace rasterproof::report
