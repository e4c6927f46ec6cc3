// The value of a channel at a covered sample is near the exact one, as stated.
#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace values_stay_within_their_error {

// A number that an exchange of vertices, or the other plane, would give as well shows nothing.
Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  std::uint64_t exercised = 0;
  std::uint64_t indistinct = 0;
  double worst = 0;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    if (channel.interpolation == Interpolation::kFlat || channel.at == EvaluatedAt::kCentroid)
      continue;
    const double x = shown.Of(f, k);
    const ValueCheck check = CheckValue(shown, f, owners, channel, NumbersAt(f, channel), x);
    if (!check.is_judged) continue;
    if (!check.holds)
      return ValueViolation(f, channel, "is off by more than its error", {x}, check.expected);
    exercised += check.tells ? 1 : 0;
    indistinct += check.is_too_wide ? 1 : 0;
    worst = std::max(worst, check.ratio);
  }
  Verdict held = Verdict::Held(exercised, worst);
  held.indistinct = indistinct;
  return held;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskValues(c, subject, kValuesAlone, Judge);
}

}  // namespace values_stay_within_their_error

extern constinit const Property kValuesStayWithinTheirError{
    .name = "ValuesStayWithinTheirError",
    .group = "values",
    .clause =
        "A value is sum b_i a_i / sum b_i with b_i the signed area of the part opposite vertex i, "
        "in perspective divided by w_i (OpenGL 4.6 section 14.6.1, equations 14.9 and 14.10; "
        "Vulkan 1.4, Basic Polygon Rasterization), of the vertices that the subject names.",
    .required_with_error = kValueErrorClauses,
    .tolerance = kValueTolerance,
    .domains = kValueDomains,
    .gate = Where(kAsksValues, kTellsMistakes),
    .ask = values_stay_within_their_error::Ask,
};

}  // namespace rasterproof::props
