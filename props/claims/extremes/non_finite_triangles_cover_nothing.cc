// A triangle with a NaN or infinite x, y or w covers nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/error.h"
#include "core/scene.h"
#include "core/subject_errors.h"
#include "props/claims/all.h"
#include "props/claims/domain_lists.h"
#include "props/claims/row_words.h"
#include "props/judging/precondition.h"
#include "props/judging/redraw.h"

namespace rasterproof::props {
namespace {

// What is finite of it must be within the limit: beyond that nothing is promised.
bool IsWithin(double x, double limit) { return !std::isfinite(x) || std::fabs(x) <= limit; }

// Of what is not judged for an infinity, no vertex says more if another one is NaN: such a triangle
// covers nothing under every profile.
bool IsJudged(const std::array<Vertex, 3>& v, const Profile& profile) {
  if (std::ranges::all_of(v, IsFinite)) return false;
  if (profile.infinite_vertex == InfiniteVertex::kNothing) return true;
  return std::ranges::any_of(
      v, [](const Vertex& p) { return std::isnan(p.x) || std::isnan(p.y) || std::isnan(p.w); });
}

std::vector<std::size_t> NonFiniteTriangles(const Case& c) {
  std::vector<std::size_t> triangles;
  for (std::size_t t = 0; t < c.scene.triangles.size(); ++t) {
    const std::array<Vertex, 3> v = Corners(c.scene, c.scene.triangles[t]);
    const bool within = std::ranges::all_of(v, [&](const Vertex& p) {
      return IsWithin(p.x, c.profile.coordinate_limit) && IsWithin(p.y, c.profile.coordinate_limit);
    });
    if (within && IsJudged(v, c.profile)) triangles.push_back(t);
  }
  return triangles;
}

// The one that covers the witness's sample by itself, or none: then it is their company.
int Culprit(Subject& subject, const Case& c, const std::vector<std::size_t>& bad,
            const Witness& witness) {
  try {
    for (const std::size_t t : bad) {
      const CoverageCounts counts =
          Drawn(subject, OnlyTriangles(c, {t}).scene, c.profile, WholeTarget(c));
      if (counts.Count(counts.Index(witness.x, witness.y, witness.sample)) != 0) {
        return static_cast<int>(t);
      }
    }
  } catch (const InputError&) {
    return -1;  // what was seen of all of them stays so, whatever becomes of one
  } catch (const SubjectFault&) {
    return -1;
  } catch (const SubjectTooSlow&) {
    return -1;
  }
  return -1;
}

Verdict Judge(Subject& subject, const Case& c) {
  if (c.profile.contract != Contract::kSampleExact) {
    return Verdict::NotApplicable(
        "the profile's contract does not say what single triangles cover");
  }
  const std::vector<std::size_t> bad = NonFiniteTriangles(c);
  const Case alone = OnlyTriangles(c, bad);
  if (auto refusal = CannotDraw(subject, alone, Space::kEither)) return *refusal;
  if (bad.empty()) {
    return {Outcome::kNotExercised, 0, 0,
            "every triangle is finite, or the profile leaves its infinite vertex open",
            std::nullopt};
  }
  const CoverageCounts observed = Drawn(subject, alone.scene, c.profile, WholeTarget(c));
  const CoverageCounts nothing(c.scene.width, c.scene.height, c.profile.lattice.samples());
  Verdict verdict =
      SameCounts(observed, nothing, bad.size(), "none, the triangles are not finite,");
  if (verdict.witness) verdict.witness->triangle = Culprit(subject, c, bad, *verdict.witness);
  return verdict;
}

}  // namespace

constinit const Property kNonFiniteTrianglesCoverNothing{
    .name = "NonFiniteTrianglesCoverNothing",
    .group = "extremes",
    .clause =
        "A triangle with NaN or infinity in x, y or w covers nothing (the profile says so; "
        "D3D11.3 drops NaN).",
    .precondition =
        "contract sample-exact; a vertex that is NaN, or infinite where the profile "
        "says what it covers",
    .tolerance = kExact,
    .domains = kNonFinite,
    .check = Judge,
};

}  // namespace rasterproof::props
