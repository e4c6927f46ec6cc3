#include "tool/legal/legal_hints.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/drawing.h"
#include "core/vertex.h"
#include "fmt/format.h"
#include "legal/decided.h"
#include "legal/joint.h"

namespace rasterproof::tool {
namespace {

// Clip space without a viewport lies in the square from -1 to 1, which is 2 pixels wide here.
bool LooksNormalised(const Scene& scene) {
  if (!scene.clip_space || scene.vertices.empty()) return false;
  if (scene.width <= 2 && scene.height <= 2) return false;
  return std::ranges::all_of(scene.vertices, [](const Vertex& v) {
    return IsFinite(v) && std::max(std::fabs(v.x), std::fabs(v.y)) <= std::fabs(v.w);
  });
}

bool MayCover(const legal::TriangleDecided& triangle, std::size_t sample) {
  return triangle.is_anything || std::ranges::binary_search(triangle.must, sample) ||
         std::ranges::binary_search(triangle.may, sample);
}

// Whether the numbers name triangles that may cover their samples if they are counted from 0, where
// 0 is the first triangle or none.
bool AreCountedFromZero(const legal::Decided& decided, const std::vector<std::int32_t>& ids) {
  bool names_others = false;
  for (std::size_t s = 0; s < ids.size(); ++s) {
    const std::size_t number = ids[s] == kNoPrimitive ? 0 : static_cast<std::size_t>(ids[s]) + 1;
    if (number >= decided.triangles.size()) return false;
    const bool is_none = number == 0 && decided.Least(s) == 0;
    if (!is_none && !MayCover(decided.triangles[number], s)) return false;
    names_others = names_others || number != 0;
  }
  return names_others;
}

std::size_t ContradictedBy(const legal::Decided& decided, const CoverageCounts& mask) {
  std::size_t contradicted = 0;
  for (std::size_t s = 0; s < mask.size(); ++s) {
    const bool is_covered = mask.front[s] != 0;
    if (is_covered ? decided.Most(s) == 0 : decided.Least(s) > 0) ++contradicted;
  }
  return contradicted;
}

std::size_t CoveredIn(const CoverageCounts& mask) {
  return static_cast<std::size_t>(
      std::ranges::count_if(mask.front, [](std::uint32_t n) { return n != 0; }));
}

// The picture read again with the colour of a corner as the background.
std::optional<std::string> BackgroundHint(const LegalOptions& options, const JudgedScene& judged,
                                          const OneCall& drawn) {
  const CoverageCounts& mask = drawn.drawing.counts;
  const std::size_t covered = CoveredIn(mask);
  if (options.image == "-" || 2 * covered <= mask.size() || drawn.corners.empty())
    return std::nullopt;
  const legal::Decided decided =
      legal::DecidedSamples(judged.scene, {judged.profile, judged.scene});
  std::size_t fewest = ContradictedBy(decided, mask);
  std::string best;
  for (const std::string& corner : drawn.corners) {
    LegalOptions other = options;
    other.background = corner;
    const std::size_t contradicted =
        ContradictedBy(decided, ReadDrawing(other, judged).drawing.counts);
    if (contradicted >= fewest) continue;
    fewest = contradicted;
    best = corner;
  }
  if (best.empty()) return std::nullopt;
  const std::string number = covered == mask.size() ? "all " : fmt::format("{} of ", covered);
  return fmt::format(
      "{}{} pixels differ from the background {}; {} corner is {}: give --background {}", number,
      mask.size(), options.background, drawn.corners.size() == 1 ? "the" : "a", best, best);
}

}  // namespace

std::vector<std::string> HintsOf(const LegalOptions& options, const JudgedScene& judged,
                                 const OneCall& drawn, const legal::JointVerdict& verdict) {
  std::vector<std::string> hints;
  if (LooksNormalised(judged.scene)) {
    hints.push_back(
        fmt::format("all vertices lie within 1 of the origin, x / w and y / w, on a target of {} x "
                    "{} pixels: this looks like normalised device coordinates; scale x and y to "
                    "the viewport (docs/scene-format.md, clip space)",
                    judged.scene.width, judged.scene.height));
  }
  if (verdict.legality == legal::Legality::kLegal) return hints;
  if (drawn.is_picture) {
    if (auto hint = BackgroundHint(options, judged, drawn)) hints.push_back(*std::move(hint));
  }
  if (options.ids && !options.image.empty() &&
      AreCountedFromZero(legal::DecidedSamples(judged.scene, {judged.profile, judged.scene}),
                         drawn.drawing.primitive_ids)) {
    hints.emplace_back(
        "the numbers would name triangles that cover their samples if they were counted from 0: "
        "write 1 + the triangle's number, and 0 where there is none");
  }
  return hints;
}

std::string RemedyOf(const std::string& why_not_joint) {
  std::string remedy = "give a profile whose models state single samples of this scene";
  if (why_not_joint == legal::kNoTransformError)
    remedy += ", or --assume-transform-error 2, which judges it under that assumption";
  return remedy;
}

}  // namespace rasterproof::tool
