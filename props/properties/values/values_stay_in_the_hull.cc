// A value in the closed triangle lies between the least and the greatest of its vertices' numbers.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace values_stay_in_the_hull {

bool IsBeforeTheEye(const ValueOwners& owners) {
  return std::ranges::all_of(owners.corners.front(),
                             [](const RayCorner& corner) { return corner.w > 0; });
}

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    const bool is_linear = channel.interpolation == Interpolation::kLinear;
    if (!is_linear && channel.interpolation != Interpolation::kPerspective) continue;
    if (channel.at == EvaluatedAt::kCentroid) continue;
    // What reaches behind the eye is unbounded on the screen.
    if (is_linear && !IsBeforeTheEye(owners)) continue;
    if (!IsInside(f, owners, channel)) continue;
    if (!RangeOf(shown, f, owners, channel, NumbersAt(f, channel))) continue;
    ++exercised;
    const std::array<double, 3> a = NumbersAt(f, channel);
    const auto [low, high] = std::minmax({a[0], a[1], a[2]});
    const double x = shown.Of(f, k);
    if (x >= low && x <= high) continue;
    return ValueViolation(f, channel, "leaves the hull", {x}, {"between ", low, " and ", high},
                          NumberKind::kHeldValue, /*to_the_bit=*/true);
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskValues(c, subject, kValuesAlone, Judge);
}

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) { return p.values.stays_in_hull; },
                "values that stay in the hull of their vertices'",
                "the profile does not promise that values stay in the hull"}};

}  // namespace values_stay_in_the_hull

extern constinit const Property kValuesStayInTheHull{
    .name = "ValuesStayInTheHull",
    .group = "values",
    .clause = "In the closed triangle the weights are not negative and sum to one.",
    .tolerance = kExact,
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kValues, values_stay_in_the_hull::kRules,
                   "evaluated in the closed triangle; on the screen, in front of the eye"),
    .ask = values_stay_in_the_hull::Ask,
};

}  // namespace rasterproof::props
