// A difference over a quad is the difference of the values that the subject itself shows there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "core/scene.h"
#include "core/value_rule.h"
#include "props/judging/redraw.h"
#include "props/judging/values/compared_numbers.h"
#include "props/judging/values/derivative_queries.h"
#include "props/judging/values/one_by_one.h"
#include "props/judging/values/precision_units.h"
#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace quad_differences_equal_differences_of_values {

// The numbers that a drawing shows at a sample, or at one beside it.
struct Derivatives {
  const ShownValues& shown;
  const PlacedCase& c;

  // The sample of the pixel beside it that shows the same triangle; nothing if that shows another.
  std::optional<std::size_t> Beside(const ValueFragment& f, int dx, int drow) const {
    const CoverageCounts& counts = shown.drawing.counts;
    const int x = f.place.x + dx;
    const int row = f.place.row + drow;
    if (x < 0 || row < 0 || x >= counts.width || row >= counts.height) return std::nullopt;
    const std::size_t index = counts.Index(x, row, f.place.sample);
    if (shown.drawing.primitive_ids[index] != f.triangle) return std::nullopt;
    return index;
  }
  double Value(std::size_t index, std::size_t k) const {
    return shown.drawing.values[index * shown.channels.size() + k];
  }
  double Of(std::size_t index, std::size_t k, int axis) const {
    return shown.drawing
        .derivatives[index * shown.channels.size() + k][static_cast<std::size_t>(axis)];
  }
};

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

NumberKind KindOf(int axis) {
  return axis == 0 ? NumberKind::kDerivativeX : NumberKind::kDerivativeY;
}

// Whether a difference may be that to the next column or row from the top, and that from the one
// before.
std::pair<bool, bool> MayBeOf(const Derivatives& d, const ValueFragment& f, int axis) {
  const auto ends = DerivativeEnds(d.shown.rule, f.place.at, axis);
  const auto begins = [&](std::size_t end) {
    return std::ranges::any_of(ends, [&](const auto& pair) { return pair[end] == f.place.at; });
  };
  const bool is_reversed = axis == 1 && d.shown.is_y_up;
  return {begins(is_reversed ? 1 : 0), begins(is_reversed ? 0 : 1)};
}

// A fine difference is that to the next pixel of the row (column), or from the one before.
Verdict JudgeFine(const Derivatives& d, const ValueFragment& f) {
  std::uint64_t exercised = 0;
  const Precision precision = d.shown.precision;
  for (std::size_t k = 0; k < d.shown.channels.size(); ++k) {
    const Channel& channel = d.shown.channels[k];
    if (channel.at != EvaluatedAt::kSample) continue;
    for (const int axis : {0, 1}) {
      const auto before = d.Beside(f, axis == 0 ? -1 : 0, axis == 1 ? -1 : 0);
      const auto after = d.Beside(f, axis == 0 ? 1 : 0, axis == 1 ? 1 : 0);
      if (!before || !after) continue;  // the quad's other pixel may be one that shows nothing
      const double here = d.Value(f.index, k);
      const double previous = d.Value(*before, k);
      const double next = d.Value(*after, k);
      if (!std::isfinite(previous) || !std::isfinite(next) || !std::isfinite(here)) continue;
      // Rows are stored from the top, whichever way y grows.
      const double sign = axis == 1 && d.shown.is_y_up ? -1 : 1;
      const double x = sign * d.Of(f.index, k, axis);
      exercised += next != previous ? 1 : 0;
      const auto [is_to_next, is_from_before] = MayBeOf(d, f, axis);
      if ((is_to_next && IsTheDifference(x, next, here, precision)) ||
          (is_from_before && IsTheDifference(x, here, previous, precision)))
        continue;
      return ValueViolation(f, channel,
                            axis == 0 ? "changes otherwise along x than its neighbours say"
                                      : "changes otherwise along y than its neighbours say",
                            {x}, {next - here, " or ", here - previous}, KindOf(axis));
    }
  }
  return Verdict::Held(exercised);
}

// Whether the pixels of the fragment's quad that show its triangle have one derivative each, where
// quads begin at pixels of these parities. Fine ones differ between rows (columns).
bool HasOneDerivative(const Derivatives& d, const ValueFragment& f, std::size_t k, int axis,
                      int parity_x, int parity_row) {
  const bool is_coarse = d.shown.rule.derivatives == DerivativesBy::kCoarse;
  const int dx = (f.place.x - parity_x) % 2 == 0 ? 1 : -1;
  const int drow = (f.place.row - parity_row) % 2 == 0 ? 1 : -1;
  const double here = d.Of(f.index, k, axis);
  for (const auto& [x, row] : {std::pair(dx, 0), std::pair(0, drow), std::pair(dx, drow)}) {
    const bool is_along = axis == 0 ? row == 0 : x == 0;
    if (!is_coarse && !is_along) continue;
    const auto beside = d.Beside(f, x, row);
    if (beside && !(d.Of(*beside, k, axis) == here)) return false;
  }
  return true;
}

// At which parities quads may begin: bit 0 of an entry's number is of columns, bit 1 of rows from
// the top.
std::array<bool, 4> StatedParities(const ShownValues& shown) {
  const QuadOrigin quads = shown.rule.quads;
  if (quads == QuadOrigin::kUnstated) return {true, true, true, true};
  const int column = quads == QuadOrigin::kEven ? 0 : 1;
  const int row = shown.is_y_up ? (shown.drawing.counts.height + column) % 2 : column;
  std::array<bool, 4> stated{};
  stated[static_cast<std::size_t>(column) + 2 * static_cast<std::size_t>(row)] = true;
  return stated;
}

// One alignment of quads must explain all fragments of a triangle: how they lie over another one,
// no text says.
Verdict JudgeAlignment(const Derivatives& d, const std::vector<ValueFragment>& fragments) {
  std::map<int, std::array<bool, 4>> by_triangle;
  for (const ValueFragment& f : fragments) {
    std::array<bool, 4>& is_possible =
        by_triangle.try_emplace(f.triangle, StatedParities(d.shown)).first->second;
    for (std::size_t k = 0; k < d.shown.channels.size(); ++k) {
      if (d.shown.channels[k].at != EvaluatedAt::kSample || !std::isfinite(d.Value(f.index, k)))
        continue;
      for (const int axis : {0, 1}) {
        for (int parities = 0; parities < 4; ++parities) {
          bool& possible = is_possible[static_cast<std::size_t>(parities)];
          possible = possible && HasOneDerivative(d, f, k, axis, parities % 2, parities / 2);
        }
        if (std::ranges::any_of(is_possible, std::identity())) continue;
        return ValueViolation(f, d.shown.channels[k],
                              "has derivatives that no division of the target into quads explains",
                              {d.Of(f.index, k, axis)}, {"one for all pixels of a quad"},
                              KindOf(axis));
      }
    }
  }
  return Verdict::Held(0);
}

Verdict Judge(const PlacedCase& c, const SubjectInfo& info, const ShownValues& shown) {
  const Derivatives d{shown, c};
  const std::vector<ValueFragment> fragments =
      FragmentsOf(c, info, shown.drawing, FragmentChoice::kSome);
  Verdict alignment = JudgeAlignment(d, fragments);
  if (alignment.outcome == Outcome::kViolated) return alignment;
  if (shown.rule.derivatives != DerivativesBy::kFine)
    return Verdict::Held(fragments.empty() ? 0 : 1);
  return OneByOne(fragments.size(), [&](std::size_t k) { return JudgeFine(d, fragments[k]); });
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.before) return NotExercised("the subject takes the scene to the window itself");
  std::shared_ptr<const Scene> scene = SceneWithChannels(c);
  Questions questions;
  questions.draws.push_back(WholeCallOf(*scene, c.profile, c.options));
  questions.draws.back().job.wants = kValuesAndDerivatives;
  return OneCheck(std::move(questions),
                  [&c, &subject, scene = std::move(scene)](const Answers& answers) {
                    const ShownValues shown{*answers.draws[0], scene->channels, c.profile.values,
                                            subject.info.input, c.profile.y_axis == YAxis::kUp};
                    Verdict verdict = Judge(c, subject.info, shown);
                    AddNumbersAround(c, subject.info, shown, verdict);
                    return verdict;
                  });
}

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) {
                  return p.values.derivatives == DerivativesBy::kFine ||
                         p.values.derivatives == DerivativesBy::kCoarse;
                },
                "derivatives that are differences over quads",
                "the profile does not state that derivatives are differences over quads"}};

}  // namespace quad_differences_equal_differences_of_values

extern constinit const Property kQuadDifferencesEqualDifferencesOfValues{
    .name = "QuadDifferencesEqualDifferencesOfValues",
    .group = "values",
    .clause =
        "A fine derivative is the difference of the values in the own row, or column, of the quad; "
        "a coarse one may be one of another row for all four pixels (Vulkan 1.4, Derivative "
        "Operations; Direct3D 11.3 section 22.5.4).",
    .required_by = kFineDifferenceClauses,
    .tolerance = "two roundings of the difference, and subnormal numbers that are flushed",
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kDerivatives, quad_differences_equal_differences_of_values::kRules,
                   "fine ones: the pixels on both sides show the same triangle"),
    .ask = quad_differences_equal_differences_of_values::Ask,
};

}  // namespace rasterproof::props
