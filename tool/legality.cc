#include "tool/legality.h"

#include <algorithm>
#include <string>

#include "core/subject_info.h"
#include "fmt/format.h"
#include "fmt/ranges.h"
#include "props/judging/witness.h"

namespace rasterproof::tool {
namespace {

// "2", "1 or more", "1 to 2".
std::string SeenOf(const legal::Requirement& seen) {
  return seen.least == seen.most ? fmt::format("{}", seen.least)
                                 : fmt::format("{} or more", seen.least);
}

std::string RequirementText(const legal::Requirement& seen) {
  if (seen.triangles.empty()) return "no legal model lets any triangle cover it\n";
  const std::string of = fmt::format("{}", fmt::join(seen.triangles, ", "));
  std::string text = !seen.visible ? fmt::format("{} of triangles {} cover it", SeenOf(seen), of)
                     : *seen.visible == kNoPrimitive
                         ? fmt::format("none of triangles {} is visible", of)
                         : fmt::format("of triangles {} number {} is visible", of, *seen.visible);
  if (seen.legal_least == seen.legal_most)
    text += fmt::format("; in every legal model {} do", seen.legal_most);
  return text + "\n";
}

std::string HeadOf(const legal::Core& core) {
  const std::size_t samples = core.requirements.size();
  if (core.wrong_by_themselves > 1) {
    return fmt::format(
        "the values of {} samples contradict every legal model, each by itself; "
        "the first:\n",
        core.wrong_by_themselves);
  }
  if (core.wrong_by_themselves == 1)
    return "the value of one sample contradicts every legal model by itself:\n";
  if (!core.is_minimal)
    return fmt::format("a set of {} samples that no legal model explains together:\n", samples);
  return fmt::format(
      "a minimal set of {} samples that no legal model explains together; without "
      "any of them one does:\n",
      samples);
}

std::string PlaceText(std::size_t sample, const Scene& scene, std::size_t samples) {
  const std::size_t pixel = sample / samples;
  const auto width = static_cast<std::size_t>(scene.width);
  return fmt::format("column {} row {}: ", pixel % width, pixel / width);
}

}  // namespace

legal::Observed OneCall::Observed() const {
  legal::Observed observed;
  observed.last_is_visible = last_is_visible;
  if (has_counts) {
    observed.together = &drawing.counts;
    observed.is_mask = is_mask;
  } else {
    observed.primitive_ids = &drawing.primitive_ids;
  }
  return observed;
}

OneCall DrawInOneCall(Subject& subject, const Scene& scene) {
  const SubjectInfo& info = subject.Info();
  DrawJob job(scene, {}, info.profile.pattern.samples());
  job.wants = kCoverageAndPrimitiveIds;
  OneCall drawn{DrawOne(subject, job)};
  const bool counts =
      info.coverage == CoverageKind::kFacingCounts || info.coverage == CoverageKind::kCounts;
  drawn.has_counts = counts || drawn.drawing.primitive_ids.empty();
  drawn.is_mask = !counts;
  drawn.last_is_visible = info.fragments.visible == Visible::kLastDrawn;
  return drawn;
}

std::string CoreText(const legal::Core& core, const Scene& scene, std::size_t samples) {
  constexpr std::size_t kMostTold = 8;
  std::string text = HeadOf(core);
  for (std::size_t k = 0; k < core.requirements.size() && k < kMostTold; ++k) {
    const legal::Requirement& seen = core.requirements[k];
    text += "  " + PlaceText(seen.sample, scene, samples) + RequirementText(seen);
  }
  if (core.requirements.size() > kMostTold)
    text += fmt::format("  and {} more\n", core.requirements.size() - kMostTold);
  if (!core.vertices.empty()) text += "they are decided by where these vertices lie:\n";
  for (std::size_t k = 0; k < core.vertices.size() && k < kMostTold; ++k) {
    const Vertex& v = scene.vertices[core.vertices[k]];
    text += fmt::format("  vertex {} at ({}, {})\n", core.vertices[k], props::HexText(v.x),
                        props::HexText(v.y));
  }
  if (core.vertices.size() > kMostTold)
    text += fmt::format("  and {} more\n", core.vertices.size() - kMostTold);
  return text;
}

std::string CoreLine(const legal::Core& core, const Scene& scene, std::size_t samples) {
  const legal::Requirement& first = core.requirements.front();
  std::string line =
      HeadOf(core) + PlaceText(first.sample, scene, samples) + RequirementText(first);
  line.pop_back();
  std::ranges::replace(line, '\n', ' ');
  return line;
}

}  // namespace rasterproof::tool
