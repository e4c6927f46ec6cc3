// A triangle with a NaN or infinite x, y or w covers nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "model/snap_scene.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace non_finite_triangles_cover_nothing {

// What is finite of it must be within the limit: beyond that nothing is stated.
bool IsWithin(double x, double limit) { return !std::isfinite(x) || std::fabs(x) <= limit; }

std::vector<std::size_t> NonFiniteTriangles(const PlacedCase& c) {
  std::vector<std::size_t> triangles;
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = Corners(c.scene, c.scene.triangles[t]);
    const bool within = std::ranges::all_of(v, [&](const Vertex& p) {
      return IsWithin(p.x, c.profile.coordinate_limit) && IsWithin(p.y, c.profile.coordinate_limit);
    });
    if (within && FinitenessOf(v, c.profile) == Finiteness::kCoversNothing) triangles.push_back(t);
  }
  return triangles;
}

Checks Ask(const PlacedCase& c, const Description& /*subject*/) {
  const std::vector<std::size_t> bad = NonFiniteTriangles(c);
  if (bad.empty()) {
    return NotExercised("every triangle is finite, or the profile leaves its infinite vertex open");
  }
  Questions questions;
  questions.draws.push_back(CountsOf(c.Only(bad).scene, c.profile, WholeTarget(c)));
  return OneCheck(std::move(questions), [exercised = bad.size()](const Answers& answers) {
    const CoverageCounts& observed = answers.draws[0]->counts;
    const CoverageCounts nothing(observed.width, observed.height, observed.samples);
    return SameCounts(observed, nothing, exercised, "none, the triangles are not finite,");
  });
}

// The one that covers the witness's sample by itself, or none: then it is their company.
Checks Blame(const PlacedCase& c, const Verdict& verdict, const Description& /*subject*/) {
  Checks asked;
  const auto scene = std::make_shared<const Scene>(c.scene);
  for (const std::size_t t : NonFiniteTriangles(c)) {
    Check check;
    check.questions.draws.push_back(CountsOfOne(scene, t, c.profile, WholeTarget(c)));
    check.judge = [t, witness = *verdict.witness](const Answers& answers) {
      const CoverageCounts& counts = answers.draws[0]->counts;
      if (counts.Count(counts.Index(witness.x, witness.y, witness.sample)) == 0) {
        return Verdict::Held(1);
      }
      Witness culprit = witness;
      culprit.triangle = static_cast<int>(t);
      return Verdict::Violated(1, "", std::move(culprit));
    };
    asked.checks.push_back(std::move(check));
  }
  return asked;
}

constexpr std::array kRules{
    kSaysWhatSinglesCover,
    ProfileRule{[](const Profile& p) {
                  return p.nan_vertex == NanVertex::kNothing || p.nan_z == NanZ::kNothing ||
                         p.infinite_vertex == InfiniteVertex::kNothing;
                },
                "a NaN or an infinity that covers nothing",
                "the profile leaves open what triangles with a NaN or an infinity cover"}};

}  // namespace non_finite_triangles_cover_nothing

extern constinit const Property kNonFiniteTrianglesCoverNothing{
    .name = "NonFiniteTrianglesCoverNothing",
    .group = "extremes",
    .clause =
        "A triangle with NaN or infinity in x, y or w covers nothing (the profile says so; "
        "D3D11.3 drops NaN).",
    .required_by = kNanClauses,
    .tolerance = kExact,
    .domains = kNonFinite,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kNone,
             .judges_degenerates = true,
             .bound_by = BoundBy::kSizes,
             .rules = non_finite_triangles_cover_nothing::kRules,
             .where = "a vertex that is NaN, or infinite where the profile says what it covers"},
    .ask = non_finite_triangles_cover_nothing::Ask,
    .blame = non_finite_triangles_cover_nothing::Blame,
};

}  // namespace rasterproof::props
