// Drawing triangles that are not finite or have no area among the others changes no count.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "core/profile.h"
#include "core/scene.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool IsGood(const Case& c, const Triangle& t) {
  return std::ranges::all_of(Corners(c.scene, t), [&](const Vertex& v) {
    return IsFinite(v) && std::fabs(v.x) <= c.profile.coordinate_limit &&
           std::fabs(v.y) <= c.profile.coordinate_limit;
  });
}

// Puts a bad triangle before and after every good one: with one vertex NaN, one infinite, two of
// them infinite with opposite signs, or all three the same. NaN in the place of infinities where
// the profile leaves open what these cover.
Scene Poisoned(const Scene& good, const Profile& profile) {
  Scene scene = good;
  const double far = profile.infinite_vertex == InfiniteVertex::kNothing ? kInfinity : kNan;
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  scene.vertices.push_back({kNan, 1, 0, 1});
  scene.vertices.push_back({1, far, 0, 1});
  scene.vertices.push_back({-far, far, 0, 1});
  scene.triangles.clear();
  for (std::size_t t = 0; t < good.triangles.size(); ++t) {
    const Triangle& triangle = good.triangles[t];
    const auto bad = first + static_cast<std::int32_t>(t % 3);
    scene.triangles.push_back({triangle[0], bad, triangle[2]});
    scene.triangles.push_back(triangle);
    if (profile.zero_area == ZeroArea::kNothing) {
      scene.triangles.push_back({triangle[1], triangle[1], triangle[1]});
    }
    scene.triangles.push_back({bad, first + 2, triangle[0]});
  }
  return scene;
}

Verdict Judge(Subject& subject, const Case& c) {
  if (c.profile.contract != Contract::kSampleExact) {
    return Verdict::NotApplicable(
        "the profile's contract does not say what single triangles cover");
  }
  if (c.profile.fixed) {
    return Verdict::NotApplicable("the subject's integers hold nothing that is not finite");
  }
  if (auto refusal = CannotDraw(subject, c, Space::kEither)) return *refusal;
  Case good = c;
  std::erase_if(good.scene.triangles, [&](const Triangle& t) { return !IsGood(c, t); });
  const CoverageCounts expected = Drawn(subject, good.scene, c.profile, WholeTarget(c));
  const CoverageCounts observed =
      Drawn(subject, Poisoned(good.scene, c.profile), c.profile, WholeTarget(c));
  return SameCounts(observed, expected, DecisionsOf(good), "that without the bad triangles");
}

}  // namespace

constinit const Property kBadTrianglesPoisonNoOthers{
    .name = "BadTrianglesPoisonNoOthers",
    .group = "extremes",
    .clause = "A triangle that covers nothing leaves the coverage of the others alone.",
    .precondition = "contract sample-exact; the other triangles finite and within the limit",
    .tolerance = kExact,
    .domains = kExtremes,
    .check = Judge,
};

}  // namespace rasterproof::props
