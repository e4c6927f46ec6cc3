// A difference over a quad is the difference of the values that the subject itself shows there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/scene.h"
#include "core/value_rule.h"
#include "props/judging/values/derivative_queries.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace quad_differences_equal_differences_of_values {

// The sample of the pixel beside it that shows the same triangle; nothing if that shows another.
std::optional<std::size_t> Beside(const ShownValues& shown, const ValueFragment& f, int axis,
                                  int by) {
  const CoverageCounts& counts = shown.drawing.counts;
  const int x = f.place.x + (axis == 0 ? by : 0);
  const int row = f.place.row + (axis == 1 ? by : 0);
  if (x < 0 || row < 0 || x >= counts.width || row >= counts.height) return std::nullopt;
  const std::size_t index = counts.Index(x, row, f.place.sample);
  if (shown.drawing.primitive_ids[index] != f.triangle) return std::nullopt;
  return index;
}

// One rounding of the difference in the format of the values. What overflows there is not judged;
// subnormal numbers may be flushed to zero, before and after.
bool IsTheDifference(double shown, double to, double from, Precision precision) {
  const bool is_float = precision == Precision::kFloat32;
  const double most = is_float ? 0x1p127 : 0x1p1022;
  const double least_normal = is_float ? 0x1p-126 : 0x1p-1022;
  const double difference = to - from;
  if (!(std::fabs(difference) <= most)) return true;
  return std::fabs(shown - difference) <= 2 * UnitRoundoff(precision) * std::fabs(difference) +
                                              0x1p-52 * (std::fabs(to) + std::fabs(from)) +
                                              3 * least_normal;
}

Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& /*owners*/) {
  std::uint64_t exercised = 0;
  const Precision precision = shown.precision;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    if (channel.at != EvaluatedAt::kSample) continue;
    const double here = shown.Of(f, k);
    for (const int axis : {0, 1}) {
      const auto before = Beside(shown, f, axis, -1);
      const auto after = Beside(shown, f, axis, 1);
      if (!before || !after) continue;  // the quad's other pixel may be one that shows nothing
      const double previous = shown.drawing.values[*before * shown.channels.size() + k];
      const double next = shown.drawing.values[*after * shown.channels.size() + k];
      if (!std::isfinite(previous) || !std::isfinite(next) || !std::isfinite(here)) continue;
      const double x = shown.DerivativesOf(f, k)[static_cast<std::size_t>(axis)];
      // Rows are stored from the top, whichever way y grows.
      const double sign = axis == 1 && shown.is_y_up ? -1 : 1;
      exercised += next != previous ? 1 : 0;
      if (IsTheDifference(sign * x, next, here, precision) ||
          IsTheDifference(sign * x, here, previous, precision)) {
        continue;
      }
      return ValueViolation(f, channel,
                            axis == 0 ? "changes otherwise along x than its neighbours say"
                                      : "changes otherwise along y than its neighbours say",
                            {x}, {sign * (next - here), " or ", sign * (here - previous)});
    }
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskValues(c, subject, kValuesAndDerivatives, Judge);
}

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) { return p.values.derivatives == DerivativesBy::kFine; },
                "derivatives that are fine differences",
                "the profile does not state that derivatives are fine differences over a quad"}};

}  // namespace quad_differences_equal_differences_of_values

extern constinit const Property kQuadDifferencesEqualDifferencesOfValues{
    .name = "QuadDifferencesEqualDifferencesOfValues",
    .group = "values",
    .clause =
        "A fine derivative is the difference of the values in the own row, or column, of the quad "
        "(Vulkan 1.4, Derivative Operations; Direct3D 11.3 section 22.5.4).",
    .required_by = kFineDifferenceClauses,
    .tolerance = "two roundings of the difference, and subnormal numbers that are flushed",
    .domains = kValueDomains,
    .gate = {.space = Space::kEither,
             .shows = Shows::kDerivatives,
             .contract = ContractNeeded::kNone,
             .any_owners = true,
             .unwrapped = true,
             .rules = quad_differences_equal_differences_of_values::kRules,
             .where = "the pixels on both sides show the same triangle"},
    .ask = quad_differences_equal_differences_of_values::Ask,
};

}  // namespace rasterproof::props
