// The values of a triangle in front of the eye do not both rise and fall along a row of samples.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>

#include "props/judging/freedom/outline.h"
#include "props/judging/redraw.h"
#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace values_are_monotone_along_rows {

bool IsInFront(const Scene& scene, const Triangle& t) {
  return !scene.clip_space ||
         std::ranges::all_of(Corners(scene, t), [](const Vertex& v) { return v.w > 0; });
}

bool IsJudged(const Channel& channel) {
  return channel.interpolation != Interpolation::kFlat && channel.at != EvaluatedAt::kCentroid;
}

// The samples of one number along a row, from pixel to pixel.
class Row {
 public:
  Row(const PlacedCase& c, const ShownValues& shown, int row, int sample)
      : c_(c), shown_(shown), row_(row), sample_(sample) {}

  // Looks at the samples of one triangle after another.
  Verdict Judge(std::size_t channel) {
    std::uint64_t exercised = 0;
    const int width = shown_.drawing.counts.width;
    for (int x = 0; x < width;) {
      const std::int32_t id = shown_.drawing.primitive_ids[Index(x)];
      bool rises = false, falls = false;
      const int first = x++;
      for (; x < width && shown_.drawing.primitive_ids[Index(x)] == id; ++x) {
        if (id == kNoPrimitive) continue;
        const double before = Value(x - 1, channel), here = Value(x, channel);
        if (!std::isfinite(before) || !std::isfinite(here)) continue;
        rises = rises || here > before;
        falls = falls || here < before;
        if (!rises || !falls) continue;
        if (!IsInFront(c_.scene, TriangleOf(id))) continue;
        return ValueViolation(FragmentAt(x, id), shown_.channels[channel],
                              "turns back along its row", {here}, {before});
      }
      const bool tells = id != kNoPrimitive && x - first > 2 && (rises || falls);
      exercised += tells && IsInFront(c_.scene, TriangleOf(id)) ? 1 : 0;
    }
    return Verdict::Held(exercised);
  }

 private:
  std::size_t Index(int x) const { return shown_.drawing.counts.Index(x, row_, sample_); }
  double Value(int x, std::size_t channel) const {
    return shown_.drawing.values[Index(x) * shown_.channels.size() + channel];
  }
  const Triangle& TriangleOf(std::int32_t id) const {
    return c_.scene.triangles[static_cast<std::size_t>(id)];
  }
  ValueFragment FragmentAt(int x, std::int32_t id) const {
    ValueFragment f;
    f.index = Index(x);
    f.triangle = id;
    f.vertices = TriangleOf(id);
    f.place = PlaceOf(c_, x, row_, sample_);
    return f;
  }

  const PlacedCase& c_;
  const ShownValues& shown_;
  int row_;
  int sample_;
};

Verdict JudgeRows(const PlacedCase& c, const ShownValues& shown) {
  std::uint64_t exercised = 0;
  const CoverageCounts& counts = shown.drawing.counts;
  for (int row = 0; row < counts.height; ++row) {
    for (int sample = 0; sample < counts.samples; ++sample) {
      for (std::size_t k = 0; k < shown.channels.size(); ++k) {
        if (!IsJudged(shown.channels[k])) continue;
        Verdict verdict = Row(c, shown, row, sample).Judge(k);
        if (verdict.outcome == Outcome::kViolated) return verdict;
        exercised += verdict.exercised;
      }
    }
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.before) return NotExercised("the subject takes the scene to the window itself");
  if (SampleReach(c.profile) != 0) return NotExercised("samples need not lie in a row");
  const std::shared_ptr<const Scene> scene = SceneWithChannels(c);
  Questions questions;
  questions.draws.push_back(WholeCallOf(*scene, c.profile, c.options));
  questions.draws.back().job.wants = kValuesAlone;
  return OneCheck(std::move(questions), [&c, &subject, scene](const Answers& answers) {
    return JudgeRows(c, {*answers.draws[0], scene->channels, c.profile.values, subject.info.input});
  });
}

constexpr std::array kRules{ProfileRule{
    [](const Profile& p) { return p.values.monotone_along_rows; }, "values monotone along rows",
    "the profile does not promise that values are monotone along rows"}};

}  // namespace values_are_monotone_along_rows

extern constinit const Property kValuesAreMonotoneAlongRows{
    .name = "ValuesAreMonotoneAlongRows",
    .group = "values",
    .clause =
        "Along a line on the screen a value is a quotient of affine functions, whose denominator "
        "keeps its sign in front of the eye.",
    .tolerance = kExact,
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kValues, values_are_monotone_along_rows::kRules,
                   "every w positive; three samples of a triangle in a row, not all of one value"),
    .ask = values_are_monotone_along_rows::Ask,
};

}  // namespace rasterproof::props
