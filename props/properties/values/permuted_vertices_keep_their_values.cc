// The values of a triangle whose corners are rotated are those of the triangle, up to their error.
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "props/judging/redraw.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/values/one_by_one.h"
#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace permuted_vertices_keep_their_values {

bool IsInterpolated(const Channel& channel) {
  return channel.interpolation != Interpolation::kFlat && channel.at != EvaluatedAt::kCentroid;
}

// Whether both may be shown of one triangle; nothing where that is not judged.
std::optional<bool> Agree(const ShownValues& shown, const ValueFragment& f, const Channel& channel,
                          double x, double y) {
  if (shown.rule.same_in_any_order) {
    if (std::isnan(x) && std::isnan(y)) return std::nullopt;
    return x == y;
  }
  // Where legal choices are left, another call may make others.
  if (f.readings.size() != 1 || !f.readings.front().known) return std::nullopt;
  const auto range = RangeOf(shown, f, f.readings.front(), channel, NumbersAt(f, channel));
  if (!range) return std::nullopt;
  const double most = range->tolerance + range->margin;
  return AgreeWithin(x, y, -1, most, most);
}

Verdict JudgeSample(const ShownValues& shown, const ShownValues& rotated, const ValueFragment& f) {
  std::uint64_t exercised = 0;
  if (rotated.drawing.primitive_ids[f.index] != f.triangle) return Verdict::Held(0);
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    if (!IsInterpolated(channel)) continue;
    const double x = shown.Of(f, k);
    const double y = rotated.Of(f, k);
    const std::optional<bool> agree = Agree(shown, f, channel, x, y);
    if (!agree) continue;
    ++exercised;
    if (*agree) continue;
    return OfDraw(0,
                  ValueViolation(f, channel, "is another once the corners are rotated", {x}, {y}));
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.before) return NotExercised("the subject takes the scene to the window itself");
  const std::shared_ptr<const Scene> scene = SceneWithChannels(c);
  const auto rotated = std::make_shared<Scene>(*scene);
  for (Triangle& t : rotated->triangles) t = {t[1], t[2], t[0]};
  Questions questions;
  for (const Scene& one : {*scene, *rotated}) {
    questions.draws.push_back(WholeCallOf(one, c.profile, c.options));
    questions.draws.back().job.wants = kValuesAlone;
  }
  return OneCheck(std::move(questions), [&c, &subject, scene, rotated](const Answers& answers) {
    const auto shown_by = [&](std::size_t draw, const std::shared_ptr<const Scene>& of) {
      return ShownValues{*answers.draws[draw], of->channels, c.profile.values, subject.info.input};
    };
    const ShownValues shown = shown_by(0, scene);
    const ShownValues other = shown_by(1, rotated);
    const auto some = FragmentsOf(c, subject.info, shown.drawing, FragmentChoice::kSome);
    return OneByOne(some.size(), [&](std::size_t k) { return JudgeSample(shown, other, some[k]); });
  });
}

}  // namespace permuted_vertices_keep_their_values

extern constinit const Property kPermutedVerticesKeepTheirValues{
    .name = "PermutedVerticesKeepTheirValues",
    .group = "values",
    .clause = "A value is a sum over the corners, in whichever order they are named.",
    .tolerance = "twice that of ValuesStayWithinTheirError; any_order stated, none: exact",
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kValues, {}, "known corners, or any_order stated"),
    .ask = permuted_vertices_keep_their_values::Ask,
};

}  // namespace rasterproof::props
