// Drawing triangles that are not finite or have no area among the others changes no count.
//
// Where every call may choose another legal model, samples are compared that all of them decide
// alike.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "props/judging/open_by_call.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace bad_triangles_poison_no_others {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

bool IsGood(const PlacedCase& c, const Triangle& t) {
  return std::ranges::all_of(Corners(c.scene, t), [&](const Vertex& v) {
    return IsFinite(v) && std::fabs(v.x) <= c.profile.coordinate_limit &&
           std::fabs(v.y) <= c.profile.coordinate_limit;
  });
}

// The case, its vertices that no triangle uses in one ordinary place.
Scene WithoutUnused(Scene scene) {
  std::vector<bool> is_used(scene.vertices.size());
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t v : t) is_used[static_cast<std::size_t>(v)] = true;
  }
  for (std::size_t v = 0; v < is_used.size(); ++v) {
    if (!is_used[v]) scene.vertices[v] = {0, 0, 0, 1};
  }
  return scene;
}

// Puts a bad triangle before and after every good one: with one vertex NaN, one infinite, two of
// them infinite with opposite signs, or all three the same. Of NaN and infinity only those of which
// the profile says that they cover nothing.
Scene Poisoned(const Scene& good, const Profile& profile) {
  Scene scene = good;
  const bool nan_covers_nothing = profile.nan_vertex == NanVertex::kNothing;
  const bool far_covers_nothing = profile.infinite_vertex == InfiniteVertex::kNothing;
  const bool has_bad = nan_covers_nothing || far_covers_nothing;
  const double nan = nan_covers_nothing ? kNan : kInfinity;
  const double far = far_covers_nothing ? kInfinity : kNan;
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  scene.vertices.push_back({nan, 1, 0, 1});
  scene.vertices.push_back({1, far, 0, 1});
  scene.vertices.push_back({-far, far, 0, 1});
  scene.triangles.clear();
  for (std::size_t t = 0; t < good.triangles.size(); ++t) {
    const Triangle& triangle = good.triangles[t];
    const auto bad = first + static_cast<std::int32_t>(t % 3);
    if (has_bad) scene.triangles.push_back({triangle[0], bad, triangle[2]});
    scene.triangles.push_back(triangle);
    if (profile.degenerate_triangles == DegenerateTriangles::kNothing) {
      scene.triangles.push_back({triangle[1], triangle[1], triangle[1]});
    }
    if (has_bad) scene.triangles.push_back({bad, first + 2, triangle[0]});
  }
  return scene;
}

constexpr std::array kRules{
    kSaysWhatSinglesCover,
    ProfileRule{[](const Profile& p) {
                  return p.nan_vertex == NanVertex::kNothing ||
                         p.infinite_vertex == InfiniteVertex::kNothing ||
                         p.degenerate_triangles == DegenerateTriangles::kNothing;
                },
                "a NaN, an infinity or no area that covers nothing",
                "the profile leaves open what triangles with a NaN, an infinity or no area cover"},
    ProfileRule{[](const Profile& p) { return !p.fixed; }, "no fixed-point input",
                "the subject's integers hold nothing that is not finite"}};

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  Scene good = c.scene;
  std::erase_if(good.triangles, [&](const Triangle& t) { return !IsGood(c, t); });
  const bool they_may = c.profile.freedom.ties == TieOwnership::kOpen || MayChooseByCall(c.profile);
  const auto open = WhereCallsMayDiffer(c.With(WithoutUnused(good)), they_may);
  if (!open) return NotExercised(kPlacesNotKnown);
  Questions questions;
  for (const Scene& scene : {good, Poisoned(good, c.profile)}) {
    questions.draws.push_back(WholeCallOf(scene, c.profile, WholeTarget(c)));
  }
  return OneCheck(std::move(questions), [decisions = open->Judged(DecisionsOf(c.With(good))),
                                         open = *open](const Answers& answers) {
    const CoverageCounts& observed = answers.draws[1]->counts;
    return OfDraw(1, SameCounts(observed, open.Expected(observed, answers.draws[0]->counts),
                                decisions, "that without the bad triangles"));
  });
}

}  // namespace bad_triangles_poison_no_others

extern constinit const Property kBadTrianglesPoisonNoOthers{
    .name = "BadTrianglesPoisonNoOthers",
    .group = "extremes",
    .clause = "A triangle that covers nothing leaves the coverage of the others alone.",
    .required_by = kPoisonClauses,
    .tolerance = kExact,
    .domains = kExtremes,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kNone,
             .judges_degenerates = true,
             .bound_by = BoundBy::kSizes,
             .rules = bad_triangles_poison_no_others::kRules,
             .where = "the other triangles finite and within the limit"},
    .ask = bad_triangles_poison_no_others::Ask,
};

}  // namespace rasterproof::props
