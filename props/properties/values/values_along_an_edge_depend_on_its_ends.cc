// The values of two triangles with a common edge are equal, to the bit, at a sample on it: the
// third vertex has no part in them.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "props/judging/redraw.h"
#include "props/judging/values/value_queries.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace values_along_an_edge_depend_on_its_ends {

constexpr std::size_t kMostTriangles = 6;

// The third vertex halfway to the first edge's end, on the same side: it owns the same samples.
std::optional<Vertex> OtherThird(const PlacedCase& c, const std::array<Vertex, 3>& v) {
  Vertex other = v[2];
  const auto middle = [&](double a, double b) {
    const double x = (a + b) / 2;
    return c.scene.precision == Precision::kFloat32 ? static_cast<double>(static_cast<float>(x))
                                                    : x;
  };
  other.x = middle(v[2].x, v[0].x);
  other.y = middle(v[2].y, v[0].y);
  if (c.scene.clip_space) other.w = middle(v[2].w, v[0].w);
  if (!IsFinite(other) || (other.x == v[2].x && other.y == v[2].y)) return std::nullopt;
  return other;
}

// One triangle, and the same with another third vertex and its numbers, each alone.
struct Pair {
  PlacedCase one;
  PlacedCase other;
  std::array<std::shared_ptr<const Scene>, 2> scenes;
};

std::optional<Pair> PairOf(const PlacedCase& c, std::size_t t) {
  const std::array<Vertex, 3> v = Corners(c.scene, c.scene.triangles[t]);
  const std::optional<Vertex> third = OtherThird(c, v);
  if (!third) return std::nullopt;
  Scene one = c.scene;
  one.vertices = {v[0], v[1], v[2], *third};
  one.triangles = {{0, 1, 2}};
  one.channels.clear();
  Scene other = one;
  other.triangles = {{0, 1, 3}};
  if (!CanBeGiven(other, c.profile)) return std::nullopt;
  Pair pair{c.With(one), c.With(other), {}};
  pair.scenes = {SceneWithChannels(pair.one), SceneWithChannels(pair.other)};
  return pair;
}

// Whether the value is judged at all by the owners of one of the two.
bool IsJudged(const PlacedCase& c, const std::shared_ptr<const Scene>& scene,
              const Drawing& drawing, const SubjectInfo& info, const ValueFragment& f,
              const Channel& channel) {
  const ShownValues shown{drawing, scene->channels, c.profile.values, info.input};
  return std::ranges::all_of(f.readings, [&](const ValueOwners& owners) {
    return RangeOf(shown, f, owners, channel, NumbersAt(f, channel)).has_value();
  });
}

Verdict JudgePair(const Pair& pair, const Drawing& one, const Drawing& other,
                  const SubjectInfo& info) {
  std::uint64_t exercised = 0;
  const std::vector<Channel>& channels = pair.scenes[0]->channels;
  const auto others = FragmentsOf(pair.other, info, other, FragmentChoice::kOnTheFirstEdge);
  for (const ValueFragment& f : FragmentsOf(pair.one, info, one, FragmentChoice::kOnTheFirstEdge)) {
    const auto same = std::ranges::find(others, f.index, &ValueFragment::index);
    if (same == others.end()) continue;
    for (std::size_t k = 0; k < channels.size(); ++k) {
      const Interpolation by = channels[k].interpolation;
      const bool is_interpolated =
          by == Interpolation::kLinear || by == Interpolation::kPerspective;
      if (!is_interpolated || channels[k].at != EvaluatedAt::kSample) continue;
      if (!IsJudged(pair.one, pair.scenes[0], one, info, f, channels[k]) ||
          !IsJudged(pair.other, pair.scenes[1], other, info, *same, channels[k])) {
        continue;
      }
      ++exercised;
      const double x = one.values[f.index * channels.size() + k];
      const double y = other.values[f.index * channels.size() + k];
      if (x == y) continue;
      return OfDraw(0, ValueViolation(f, channels[k],
                                      "depends on the third vertex at a sample of the first edge",
                                      {x}, {y}, NumberKind::kValue, /*to_the_bit=*/true));
    }
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (c.before) return NotExercised("the subject takes the scene to the window itself");
  Checks asked;
  const std::size_t count = c.scene.triangles.size();
  for (std::size_t t = 0; t < count; t += count / kMostTriangles + 1) {
    std::optional<Pair> pair = PairOf(c, t);
    if (!pair) continue;
    Questions questions;
    for (const auto& scene : pair->scenes) {
      questions.draws.push_back(WholeCallOf(*scene, c.profile, WholeTarget(c)));
      questions.draws.back().job.wants = kValuesAlone;
    }
    asked.checks.push_back(
        {std::move(questions),
         [&subject, pair = std::make_shared<const Pair>(*std::move(pair))](const Answers& answers) {
           return JudgePair(*pair, *answers.draws[0], *answers.draws[1], subject.info);
         }});
  }
  if (asked.checks.empty()) return NotExercised("no triangle can be given another third vertex");
  return asked;
}

constexpr std::array kRules{ProfileRule{
    [](const Profile& p) { return p.values.agrees_along_edges; }, "values that agree along edges",
    "the profile does not promise that values agree along edges"}};

}  // namespace values_along_an_edge_depend_on_its_ends

extern constinit const Property kValuesAlongAnEdgeDependOnItsEnds{
    .name = "ValuesAlongAnEdgeDependOnItsEnds",
    .group = "values",
    .clause = "On an edge the weight of the vertex opposite is zero.",
    .tolerance = kExact,
    .domains = kEdgeValueDomains,
    .gate = AsksOf(Shows::kValues, values_along_an_edge_depend_on_its_ends::kRules,
                   "a covered sample on the first edge of its triangle, by known corners"),
    .ask = values_along_an_edge_depend_on_its_ends::Ask,
};

}  // namespace rasterproof::props
