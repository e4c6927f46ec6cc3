// The derivatives of a value are those of its plane, or the differences over a quad that the
// subject states, within their error.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/value_rule.h"
#include "props/judging/values/derivative_queries.h"
#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace derivatives_stay_within_their_error {

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  std::uint64_t exercised = 0;
  double worst = 0;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    const bool is_flat = channel.interpolation == Interpolation::kFlat;
    if (is_flat || channel.at != EvaluatedAt::kSample) continue;
    for (const int axis : {0, 1}) {
      const double x = shown.DerivativesOf(f, k)[static_cast<std::size_t>(axis)];
      const DerivativeCheck check = CheckDerivative(shown, f, owners, channel, axis, x);
      if (!check.is_judged) continue;
      if (!check.holds) {
        return ValueViolation(
            f, channel, axis == 0 ? "has a wrong derivative by x" : "has a wrong derivative by y",
            {x}, check.expected, axis == 0 ? NumberKind::kDerivativeX : NumberKind::kDerivativeY);
      }
      exercised += check.tells ? 1 : 0;
      worst = std::max(worst, check.ratio);
    }
  }
  return Verdict::Held(exercised, worst);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskValues(c, subject, kValuesAndDerivatives, Judge);
}

}  // namespace derivatives_stay_within_their_error

extern constinit const Property kDerivativesStayWithinTheirError{
    .name = "DerivativesStayWithinTheirError",
    .group = "values",
    .clause =
        "A derivative is the partial derivative of the value's plane, or a difference of values in "
        "a quad of 2 x 2 pixels (OpenGL Shading Language 4.60 section 8.14.1; Vulkan 1.4, "
        "Derivative Operations; Direct3D 11.3 sections 22.5.2 and 22.5.4), as the subject states.",
    .tolerance =
        "the stated derivative_error; none stated: twice 16 u times the condition of the "
        "derivative "
        "or, of a difference, of both its values",
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kDerivatives, {},
                   "known corners; another axis, sign or pixel would give another number"),
    .ask = derivatives_stay_within_their_error::Ask,
};

}  // namespace rasterproof::props
