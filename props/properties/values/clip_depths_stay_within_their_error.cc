// In clip space the depth at a covered sample is z / w, affine on the screen.
#include <array>
#include <cstddef>
#include <utility>

#include "core/value_rule.h"
#include "props/judging/values/fragment_queries.h"
#include "props/judging/values/value_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace clip_depths_stay_within_their_error {

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  // DepthsAreOfTheirFormat holds these to the depth that is clamped and rounded.
  if (DepthStep(shown.rule.depth) != 0) return Verdict::Held(0);
  const Channel channel{"depth", Interpolation::kInverseW};
  const double x = shown.drawing.depths[f.index];
  const ValueCheck check = CheckValue(shown, f, owners, channel, shown.DepthsOf(f), x);
  if (!check.is_judged) return Verdict::Held(0);
  if (check.holds) return Verdict::Held(check.tells ? 1 : 0, check.ratio);
  return NumberViolation(NumberKind::kDepth,
                         "the depth of a fragment in clip space is off by more than its error",
                         WitnessAt(f.triangle, -1, f.place, {x}, check.expected));
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskFragmentValues(c, subject, kDepthsAlone, Judge);
}

}  // namespace clip_depths_stay_within_their_error

extern constinit const Property kClipDepthsStayWithinTheirError{
    .name = "ClipDepthsStayWithinTheirError",
    .group = "values",
    .clause =
        "Depth is interpolated linearly on the screen, of z divided by w (OpenGL 4.6 section "
        "14.6.1, equation 14.10; Vulkan 1.4, Basic Polygon Rasterization; Direct3D 11.3 section "
        "16.3; WebGPU section 23.2.5.4).",
    .required_with_error = kDepthErrorClauses,
    .tolerance =
        "the stated depth error; none stated: 16 u times the condition, where every w is 2^-30 to "
        "2^30",
    .domains = kClipValues,
    .gate = {.space = Space::kClip,
             .shows = Shows::kDepths,
             .contract = ContractNeeded::kNone,
             .any_owners = true,
             .unwrapped = true,
             .where = "no normalized format of depth; exchanged vertices would give another depth"},
    .ask = clip_depths_stay_within_their_error::Ask,
};

}  // namespace rasterproof::props
