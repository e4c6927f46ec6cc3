// A depth is a number of the stated format, next to the exact one.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include "core/value_rule.h"
#include "exact/values.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/fragment_queries.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/values/value_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace depths_are_of_their_format {

Verdict Judge(const ShownValues& given, const ValueFragment& f, const ValueOwners& owners) {
  const double x = given.drawing.depths[f.index];
  if (!IsOfDepthFormat(x, given.rule.depth)) {
    return NumberViolation(NumberKind::kDepth, "a depth is no number of the stated format",
                           WitnessAt(f.triangle, -1, f.place, {x}, {"a number of the format"}));
  }
  const std::array<double, 3> z = given.DepthsOf(f);
  const Channel channel{"depth",
                        given.is_clip_space ? Interpolation::kInverseW : Interpolation::kLinear};
  std::optional<ValueRange> range = RangeOf(given, f, owners, channel, z);
  if (!range) return Verdict::Held(0);
  if (DepthStep(given.rule.depth) != 0) {
    range->low = std::clamp(range->low, 0.0, 1.0);
    range->high = std::clamp(range->high, 0.0, 1.0);
  }
  range->tolerance += DepthRoundingOf(given.rule, range->high);
  if (!range->SurelyExcludes(x)) return Verdict::Held(1);
  if (owners.known) {  // an estimate acquits; only the exact depth convicts
    const auto depth = exact::Interpolant(*owners.known, f.place.at)
                           .Value(channel.interpolation, exact::ToAttribute(z));
    if (!depth) return Verdict::Held(0);
    const exact::Rational clamped =
        DepthStep(given.rule.depth) != 0 ? std::clamp<exact::Rational>(*depth, 0, 1) : *depth;
    if (CompareWithExact(x, clamped, range->tolerance).within) return Verdict::Held(1);
  }
  return NumberViolation(
      NumberKind::kDepth, "a depth is not next to the exact one in the stated format",
      WitnessAt(f.triangle, -1, f.place, {x}, {range->low, " within ", range->tolerance}));
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskFragmentValues(c, subject, kDepthsAlone, Judge);
}

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) { return p.values.depth != DepthFormat::kUnstated; },
                "a stated format of depth", "the profile states no format of depth"}};

}  // namespace depths_are_of_their_format

extern constinit const Property kDepthsAreOfTheirFormat{
    .name = "DepthsAreOfTheirFormat",
    .group = "values",
    .clause =
        "A depth is converted to the format of the depth buffer, to one of its two neighbours "
        "there (OpenGL 4.6 section 2.3.5.2; Vulkan 1.4, Conversion From Floating-Point to "
        "Normalized Fixed-Point), or to the nearest (Direct3D 11.3 section 17.11, within 0.6 of a "
        "step by 3.2.3.6), as the subject states.",
    .required_with_error = kDepthFormatErrorClauses,
    .tolerance = "a step of the format, or half of it, and the depth's own error",
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kDepths, depths_are_of_their_format::kRules,
                   "normalized ones: of a depth clamped to [0, 1]"),
    .ask = depths_are_of_their_format::Ask,
};

}  // namespace rasterproof::props
