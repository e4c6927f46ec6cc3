// The value of a channel at the centroid is that of the stated point, or of one where it may lie.
// By a profile of the subject's own a fragment has one centroid; of the APIs' texts, which speak of
// each input by itself, none says so.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/clauses/clauses.h"
#include "core/sample_pattern.h"
#include "props/judging/redraw.h"
#include "props/judging/values/centroid_values.h"
#include "props/judging/values/one_by_one.h"
#include "props/judging/values/value_queries.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace centroid_values_stay_within_their_error {

constexpr std::size_t kMostTriangles = 6;

bool IsJudged(const Channel& channel) {
  return channel.at == EvaluatedAt::kCentroid && channel.interpolation != Interpolation::kFlat;
}

template <bool kHasOneCentroid>
Verdict Judge(const ShownValues& shown, const ValueFragment& f, const ValueOwners& owners) {
  std::uint64_t exercised = 0;
  std::size_t last = 0;
  for (std::size_t k = 0; k < shown.channels.size(); ++k) {
    const Channel& channel = shown.channels[k];
    if (!IsJudged(channel)) continue;
    const double x = shown.Of(f, k);
    const ValueCheck check = CheckCentroidValue(shown, f, owners, channel, x);
    if (!check.is_judged) continue;
    if (!check.holds)
      return ValueViolation(f, channel, "at the centroid is of elsewhere", {x}, check.expected);
    exercised += check.tells ? 1 : 0;
    last = k;
  }
  if (kHasOneCentroid && exercised > 1 && !AreOfOnePoint(shown, f, owners)) {
    return ValueViolation(f, shown.channels[last],
                          "at the centroid is of another point than others", {shown.Of(f, last)},
                          {"that of the one point that all channels at the centroid are of"});
  }
  return Verdict::Held(exercised);
}

// The triangle alone, to show which samples it covers.
void AskAlone(const PlacedCase& c, const Description& subject, std::size_t t, Checks& asked) {
  const auto one = std::make_shared<const PlacedCase>(c.Only({t}));
  const std::shared_ptr<const Scene> scene = SceneWithChannels(*one);
  if (std::ranges::none_of(scene->channels, IsJudged)) return;
  Questions questions;
  questions.draws.push_back(WholeCallOf(*scene, c.profile, WholeTarget(c)));
  questions.draws.back().job.wants = kValuesAlone;
  asked.checks.push_back(
      {std::move(questions), [&subject, one, scene, t](const Answers& answers) {
         const Drawing& drawing = *answers.draws[0];
         const ShownValues shown{drawing, scene->channels, one->profile.values, subject.info.input};
         auto some = FragmentsOf(*one, subject.info, drawing, FragmentChoice::kInPartOfAPixel);
         return OneByOne(some.size(), [&](std::size_t k) {
           ValueFragment& f = some[k];
           f.centroid = CentroidOf(*one, subject.info, drawing, f);
           f.triangle = static_cast<int>(t);
           const bool has_one_centroid = SpecificationOf(one->profile) == nullptr;
           return JudgeFragment(shown, f, has_one_centroid ? &Judge<true> : &Judge<false>);
         });
       }});
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.before) return NotExercised("the subject takes the scene to the window itself");
  Checks asked;
  const std::size_t count = c.scene.triangles.size();
  for (std::size_t t = 0; t < count; t += count / kMostTriangles + 1)
    AskAlone(c, subject, t, asked);
  if (asked.checks.empty()) return NotExercised("no channel is asked for at the centroid");
  return asked;
}

constexpr std::array kRules{
    ProfileRule{[](const Profile& p) { return p.values.centroids; }, "values at centroids",
                "the profile does not state values at centroids"},
    kStatesCentroids};

}  // namespace centroid_values_stay_within_their_error

extern constinit const Property kCentroidValuesStayWithinTheirError{
    .name = "CentroidValuesStayWithinTheirError",
    .group = "values",
    .clause =
        "A value at the centroid is that of the pixel's centre or the first covered sample "
        "(Direct3D 11.3 section 3.5.5), or of any point of pixel and primitive (OpenGL 4.6 section "
        "15.2; Vulkan 1.3, Interpolation Decorations); with one sample of the centre. By a profile "
        "of its own it is one point for all channels.",
    .required_with_error = kValueErrorClauses,
    .tolerance = kValueTolerance,
    .domains = kValueDomains,
    .gate = AsksOf(Shows::kValues, centroid_values_stay_within_their_error::kRules,
                   "area not zero; pixels that the triangle covers in part, if there are any"),
    .ask = centroid_values_stay_within_their_error::Ask,
};

}  // namespace rasterproof::props
