// A triangle drawn alone is front at every sample that it covers, or back at every one.
#include <algorithm>
#include <cstddef>
#include <memory>

#include "core/coverage.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/properties/all.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"

namespace rasterproof::props {
namespace {

constexpr std::size_t kMostDrawn = 32;

Verdict HasOneFacing(const CoverageCounts& counts, std::size_t triangle) {
  const auto covered = [](std::uint32_t n) { return n != 0; };
  const auto front = std::ranges::find_if(counts.front, covered);
  const auto back = std::ranges::find_if(counts.back, covered);
  if (front == counts.front.end() || back == counts.back.end()) return Verdict::Held(1);
  const auto index = static_cast<std::size_t>(back - counts.back.begin());
  Witness witness = WitnessAtIndex(counts, index);
  witness.triangle = static_cast<int>(triangle);
  const Witness other =
      WitnessAtIndex(counts, static_cast<std::size_t>(front - counts.front.begin()));
  witness.observed = "back";
  witness.expected = "front, as at sample " + std::to_string(other.sample) + " of pixel (" +
                     std::to_string(other.x) + ", " + std::to_string(other.y) + ")";
  return Verdict::Violated(1, "a triangle alone is front at one sample and back at another",
                           witness);
}

Asked Ask(const Case& c, const Description& /*subject*/) {
  if (c.scene.triangles.empty()) return NothingAsked("the scene has no triangles");
  const auto scene = std::make_shared<const Scene>(c.scene);
  Asked asked;
  for (std::size_t t = 0; t < std::min(kMostDrawn, scene->triangles.size()); ++t) {
    Questions questions;
    questions.draws.push_back(CountsOfOne(scene, t, c.profile, WholeTarget(c)));
    asked.checks.push_back({std::move(questions), [t](const Answers& answers) {
                              return HasOneFacing(answers.draws[0]->counts, t);
                            }});
  }
  return asked;
}

}  // namespace

constinit const Property kFacingIsOneAtAllSamples{
    .name = "FacingIsOneAtAllSamples",
    .group = "coverage",
    .clause =
        "Facing is the sign of the triangle's area, one for all its samples (OpenGL 4.6 section "
        "14.6.1; Vulkan 1.3, Basic Polygon Rasterization; D3D11.3 functional specification 3.4.1, "
        "of the snapped area).",
    .required_by = kFacingClauses,
    .tolerance = kExact,
    .domains = kCoverage,
    .gate = {.shows = Shows::kFacings,
             .contract = ContractNeeded::kAny,
             .any_model = true,
             .judges_clipped = true},
    .ask = Ask,
};

}  // namespace rasterproof::props
