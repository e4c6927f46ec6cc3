// Equal numbers at a triangle's vertices give that number at each of its samples, to the bit.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace equal_values_stay_equal {

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    if (channel.interpolation == Interpolation::kInverseW) continue;
    const bool is_flat = channel.interpolation == Interpolation::kFlat;
    const std::array<double, 3> a = NumbersAt(f, channel);
    if (a[0] != a[1] || a[1] != a[2] || !std::isfinite(a[0])) continue;
    if (!is_flat && !RangeOf(shown, f, owners, channel, NumbersAt(f, channel))) continue;
    ++exercised;
    const double x = shown.Of(f, k);
    if (x == a[0]) continue;
    return ValueViolation(f, channel, "is another than all its vertices'", {x}, {a[0]},
                          NumberKind::kValue, /*to_the_bit=*/true);
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskValues(c, subject, kValuesAlone, Judge);
}

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) { return p.values.equal_stay_equal; },
                "values that stay equal where they are",
                "the profile does not promise that equal values stay equal"}};

}  // namespace equal_values_stay_equal

extern constinit const Property kEqualValuesStayEqual{
    .name = "EqualValuesStayEqual",
    .group = "values",
    .clause = "The weights sum to one: of equal numbers the sum is that number.",
    .tolerance = kExact,
    .domains = kValueDomains,
    .gate =
        AsksOf(Shows::kValues, equal_values_stay_equal::kRules, "equal numbers at all vertices"),
    .ask = equal_values_stay_equal::Ask,
};

}  // namespace rasterproof::props
