// One legal grid point for every vertex and one legal tie rule explain every sample of every triangle, each drawn alone, and the mesh counts what its triangles count.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/free_choices.h"
#include "props/judging/model_search.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"

namespace rasterproof::props {
namespace {

void Add(CoverageCounts& sum, const CoverageCounts& more) {
  for (std::size_t k = 0; k < sum.size(); ++k) {
    sum.front[k] += more.front[k];
    sum.back[k] += more.back[k];
  }
}

// What a subject drew for each triangle alone.
struct Singles {
  Case drawn;  ///< the case with as many of its triangles as are looked at
  std::vector<CoverageCounts> alone;
};

Singles DrawSingles(Subject& subject, const Case& c) {
  Singles singles{c, {}};
  std::vector<Triangle>& triangles = singles.drawn.scene.triangles;
  triangles.resize(std::min(triangles.size(), ModelSearch::kMostTriangles));
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const Case one = OnlyTriangles(singles.drawn, {t});
    singles.alone.push_back(Drawn(subject, one.scene, c.profile, WholeTarget(c)));
  }
  return singles;
}

std::string PointsText(const std::vector<Point2>& points) {
  std::string text;
  for (const Point2 p : points) text += (text.empty() ? "" : " or ") + HexText(p);
  return text;
}

// For two triangles: the vertices that they have in common and what each needs of them.
std::string NeedsText(const Case& c, const ModelSearch& search,
                      const std::vector<std::size_t>& conflict) {
  if (conflict.size() != 2) return "";
  std::string text;
  const Triangle& first = c.scene.triangles[conflict[0]];
  const Triangle& second = c.scene.triangles[conflict[1]];
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex& v = c.scene.vertices[static_cast<std::size_t>(first[i])];
    for (std::size_t j = 0; j < 3; ++j) {
      const Vertex& w = c.scene.vertices[static_cast<std::size_t>(second[j])];
      if (v.x != w.x || v.y != w.y) continue;
      text += "; vertex " + HexText(WindowPoint(v)) + " at " +
              PointsText(search.PointsOf(conflict[0], i)) + " for one, at " +
              PointsText(search.PointsOf(conflict[1], j)) + " for the other";
    }
  }
  return text;
}

Verdict NotJudged(const Case& c, const char* why) {
  Verdict verdict{Outcome::kNotExercised, 0, 0, why, std::nullopt};
  verdict.not_judged = DecisionsOf(c);
  return verdict;
}

Verdict NoModel(const Singles& singles, const ModelSearch& search,
                const std::vector<std::size_t>& conflict, std::uint64_t exercised) {
  std::string names;
  for (const std::size_t t : conflict) names += (names.empty() ? "" : ", ") + std::to_string(t);
  const std::size_t t = conflict.front();
  const CoverageCounts canonical =
      exact::Coverage(OnlyTriangles(singles.drawn, {t}).scene, singles.drawn.profile);
  const CoverageDifference difference = Compare(singles.alone[t], canonical);
  Witness witness;
  if (difference.wrong != 0) {
    witness = WitnessOfCounts(singles.alone[t], canonical, difference.first_wrong);
  }
  witness.triangle = static_cast<int>(t);
  const std::string here = witness.observed;
  const std::string canonical_here = witness.expected;
  witness.observed =
      "triangles " + names + ", each drawn alone" + NeedsText(singles.drawn, search, conflict);
  witness.expected = "one legal grid point for each vertex and one tie rule that explain " +
                     std::string(conflict.size() == 1 ? "it" : "them together");
  if (!here.empty()) {
    witness.observed += "; triangle " + std::to_string(t) + " has " + here + " here";
    witness.expected += "; the canonical model has " + canonical_here + " here";
  }
  return Verdict::Violated(exercised,
                           conflict.size() == 1
                               ? "no legal model explains triangle " + names + " by itself"
                               : "no legal model explains triangles " + names + " together",
                           witness);
}

Verdict Judge(Subject& subject, const Case& c) {
  if (c.profile.freedom.IsNone()) {
    return Verdict::NotApplicable("the profile leaves nothing free: one model is legal");
  }
  if (c.profile.overdraw) {
    return Verdict::NotApplicable("the profile leaves it open how often an edge is drawn");
  }
  if (c.profile.contract != Contract::kSampleExact) {
    return Verdict::NotApplicable(
        "the profile's contract does not say what single triangles cover");
  }
  const Need need{.space = Space::kEither, .any_model_suffices = true};
  if (auto refusal = CannotJudgeCoverage(subject, c, need)) return *refusal;
  if (c.scene.clip_space) return NotJudged(c, "models are searched in window space alone");
  if (!IsUnclippedInEveryModel(c)) {
    return NotJudged(c, "a legal choice leaves the profile's no-clip rectangle");
  }
  const Singles singles = DrawSingles(subject, c);
  const std::uint64_t exercised = DecisionsOf(singles.drawn);
  ModelSearch search(singles.drawn);
  CoverageCounts sum(c.scene.width, c.scene.height, c.profile.lattice.samples());
  for (std::size_t t = 0; t < singles.alone.size(); ++t) {
    search.Observe(t, singles.alone[t]);
    Add(sum, singles.alone[t]);
  }
  const std::vector<std::size_t> conflict = search.Conflict();
  if (!conflict.empty()) return NoModel(singles, search, conflict, exercised);
  const CoverageCounts whole = Drawn(subject, singles.drawn.scene, c.profile, WholeTarget(c));
  Verdict verdict =
      SameCounts(whole, sum, exercised, "the sum of its triangles, each drawn alone,");
  verdict.not_judged = DecisionsOf(c) - exercised;  // of the triangles behind the most
  return verdict;
}

}  // namespace

constinit const Property kOneLegalModelExplainsTheMesh{
    .name = "OneLegalModelExplainsTheMesh",
    .group = "coverage",
    .clause =
        "A vertex has one position for all triangles that use it, and a sample on an edge "
        "one owner: D3D11.3 functional specification 3.4.1 (snapping within 0.6 ulp) and "
        "3.4.2.1.",
    .precondition =
        "contract sample-exact; the profile leaves grid points or the tie rule free; "
        "window space; coordinates within the limit",
    .tolerance = "the profile's own freedom, jointly for all triangles",
    .domains = kFreeSnaps,
    .check = Judge,
};

}  // namespace rasterproof::props
