// One legal grid point for every vertex and one legal tie rule explain all triangles of a mesh.
//
// They explain every sample of every triangle, each drawn alone; and the mesh counts what its
// triangles count.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <string>
#include <string_view>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "props/judging/as_shown.h"
#include "props/judging/free_choices.h"
#include "props/judging/model_search.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/properties/all.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"

namespace rasterproof::props {
namespace {

constexpr std::array kRules{ProfileRule{[](const Profile& p) { return !p.freedom.IsNone(); },
                                        "grid points or tie rule left free",
                                        "the profile leaves nothing free: one model is legal"},
                            kCountsTies, kSaysWhatSinglesCover};

// The case with as many of its triangles as are looked at.
Case LookedAt(const Case& c) {
  Case some = c;
  some.scene.triangles.resize(std::min(c.scene.triangles.size(), ModelSearch::kMostTriangles));
  return some;
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

Asked NotJudged(const Case& c, std::string_view why) {
  Asked asked = NothingAsked(std::string(why));
  asked.otherwise.not_judged = DecisionsOf(c);
  return asked;
}

Verdict NoModel(const Case& drawn, const Answers& alone, const ModelSearch& search,
                const std::vector<std::size_t>& conflict) {
  std::string names;
  for (const std::size_t t : conflict) names += (names.empty() ? "" : ", ") + std::to_string(t);
  const std::size_t t = conflict.front();
  const CoverageCounts& counts = alone.draws[t]->counts;
  const CoverageCounts canonical = exact::Coverage(OnlyTriangles(drawn, {t}).scene, drawn.profile);
  const CoverageDifference difference = Compare(counts, canonical);
  Witness witness;
  if (difference.wrong != 0) {
    witness = WitnessOfCounts(counts, canonical, difference.first_wrong);
  }
  witness.triangle = static_cast<int>(t);
  const std::string here = witness.observed;
  const std::string canonical_here = witness.expected;
  witness.observed =
      "triangles " + names + ", each drawn alone" + NeedsText(drawn, search, conflict);
  witness.expected = "one legal grid point for each vertex and one tie rule that explain " +
                     std::string(conflict.size() == 1 ? "it" : "them together");
  if (!here.empty()) {
    witness.observed += "; triangle " + std::to_string(t) + " has " + here + " here";
    witness.expected += "; the canonical model has " + canonical_here + " here";
  }
  return Verdict::Violated(DecisionsOf(drawn),
                           conflict.size() == 1
                               ? "no legal model explains triangle " + names + " by itself"
                               : "no legal model explains triangles " + names + " together",
                           witness);
}

// Violated if no model explains what was drawn for each triangle alone.
Verdict HaveOneModel(const Case& drawn, const Answers& alone) {
  ModelSearch search(drawn);
  for (std::size_t t = 0; t < alone.draws.size(); ++t) search.Observe(t, alone.draws[t]->counts);
  const std::vector<std::size_t> conflict = search.Conflict();
  return conflict.empty() ? Verdict::Held(0) : NoModel(drawn, alone, search, conflict);
}

Check OfEachAlone(const Case& c) {
  const auto scene = std::make_shared<const Scene>(LookedAt(c).scene);
  Check check;
  for (std::size_t t = 0; t < scene->triangles.size(); ++t) {
    check.questions.draws.push_back(CountsOfOne(scene, t, c.profile, WholeTarget(c)));
  }
  check.judge = [&c](const Answers& answers) { return HaveOneModel(LookedAt(c), answers); };
  return check;
}

// Compares the mesh with the sum of its triangles. The last drawing is its own.
Verdict IsTheSum(const Case& c, std::uint64_t exercised, const Answers& answers) {
  const CoverageCounts& whole = answers.draws.back()->counts;
  CoverageCounts sum(whole.width, whole.height, whole.samples);
  for (std::size_t t = 0; t + 1 < answers.draws.size(); ++t) sum += answers.draws[t]->counts;
  Verdict verdict =
      SameCounts(whole, sum, exercised, "the sum of its triangles, each drawn alone,");
  verdict.not_judged = DecisionsOf(c) - exercised;  // of the triangles behind the most
  return verdict;
}

Check OfAllTogether(const Case& c) {
  const Case drawn = LookedAt(c);
  Check check;
  check.questions.draws.push_back(CountsOf(drawn.scene, c.profile, WholeTarget(c)));
  check.bases.resize(drawn.scene.triangles.size());
  std::iota(check.bases.begin(), check.bases.end(), std::size_t{0});
  check.judge = [&c, exercised = DecisionsOf(drawn)](const Answers& answers) {
    return IsTheSum(c, exercised, answers);
  };
  return check;
}

Asked Ask(const Case& c, const Description& subject) {
  if (c.scene.clip_space) return NotJudged(c, "models are searched in window space alone");
  if (!IsUnclippedInEveryModel(c)) {
    return NotJudged(c, "a legal choice leaves the profile's guard-band rectangle");
  }
  if (IsJudgedAsShown(subject, LookedAt(c))) return NotJudged(c, kJudgedAsShown);
  Asked asked;
  asked.checks.push_back(OfEachAlone(c));
  asked.checks.push_back(OfAllTogether(c));
  return asked;
}

}  // namespace

constinit const Property kOneLegalModelExplainsTheMesh{
    .name = "OneLegalModelExplainsTheMesh",
    .group = "coverage",
    .clause =
        "A vertex has one position for all triangles that use it, and a sample on an edge "
        "one owner: D3D11.3 functional specification 3.4.1 (snapping within 0.6 ulp) and "
        "3.4.2.1.",
    .tolerance = "the profile's own freedom, jointly for all triangles",
    .domains = kFreeSnaps,
    .gate = {.space = Space::kEither,
             .any_model = true,
             .rules = kRules,
             .asks_oracle = true,
             .where = "window space"},
    .ask = Ask,
};

}  // namespace rasterproof::props
