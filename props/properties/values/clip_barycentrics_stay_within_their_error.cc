// In clip space every barycentric at a covered sample is near the exact one of the plane that the
// subject states: of the screen, or of the triangle before the division by w.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "core/value_rule.h"
#include "props/judging/redraw.h"
#include "props/judging/values/fragment_queries.h"
#include "props/judging/values/one_by_one.h"
#include "props/judging/values/value_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace clip_barycentrics_stay_within_their_error {

constexpr std::array<std::array<double, 3>, 3> kUnits{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// All three by one plane; a barycentric is a value that is one at its vertex.
Verdict JudgeBy(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners,
                Interpolation plane) {
  const std::array<double, 3>& weights = shown.drawing.barycentrics[f.index];
  const Channel channel{"barycentric", plane};
  std::uint64_t exercised = 0;
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const ValueCheck check = CheckValue(shown, f, owners, channel, kUnits[i], weights[i]);
    if (!check.is_judged) continue;
    if (!check.holds) {
      return NumberViolation(
          plane == Interpolation::kLinear ? NumberKind::kScreenBarycentric
                                          : NumberKind::kBarycentric,
          "a barycentric of a fragment in clip space is off by more than its error",
          WitnessAt(f.triangle, static_cast<int>(i), f.place, Listed(weights), check.expected));
    }
    exercised += check.tells ? 1 : 0;
    worst = std::max(worst, check.ratio);
  }
  return Verdict::Held(exercised, worst);
}

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  if (shown.rule.weights == WeightsIn::kScreen)
    return JudgeBy(shown, f, owners, Interpolation::kLinear);
  Verdict in_perspective = JudgeBy(shown, f, owners, Interpolation::kPerspective);
  if (shown.rule.weights == WeightsIn::kPerspective) return in_perspective;
  if (in_perspective.outcome != Outcome::kViolated) return in_perspective;
  Verdict on_screen = JudgeBy(shown, f, owners, Interpolation::kLinear);
  return on_screen.outcome != Outcome::kViolated ? on_screen : in_perspective;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskFragmentValues(c, subject, kBarycentricsAlone, Judge);
}

}  // namespace clip_barycentrics_stay_within_their_error

extern constinit const Property kClipBarycentricsStayWithinTheirError{
    .name = "ClipBarycentricsStayWithinTheirError",
    .group = "values",
    .clause =
        "A barycentric is the signed area of the part opposite vertex i over that of the whole, on "
        "the screen or, divided by the vertices' w, in perspective (OpenGL 4.6 section 14.6.1; "
        "Vulkan 1.4, Basic Polygon Rasterization and Barycentric Interpolation).",
    .required_with_error = kClipBarycentricErrorClauses,
    .tolerance =
        "the stated barycentric error; none stated: 16 u times the condition, where every w is "
        "2^-30 to 2^30",
    .domains = kClipValues,
    .gate = {.space = Space::kClip,
             .shows = Shows::kFragments,
             .contract = ContractNeeded::kNone,
             .any_owners = true,
             .unwrapped = true,
             .where = kTellsMistakes},
    .ask = clip_barycentrics_stay_within_their_error::Ask,
};

}  // namespace rasterproof::props
