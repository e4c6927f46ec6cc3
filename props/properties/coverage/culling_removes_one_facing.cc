// Culling a facing removes its counts and keeps the others.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "props/judging/by_facing.h"
#include "props/judging/freedom/facing_freedom.h"
#include "props/judging/freedom/free_choices.h"
#include "props/judging/places.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace culling_removes_one_facing {

constexpr std::size_t kMostCulled = 8;

const char* WhatIsLeft(Cull cull) {
  return cull == Cull::kFront ? "the back counts alone" : "the front counts alone";
}

// Compares a subject that reports facings with the part of its own counts that remains.
Checks AgainstItsFacings(const PlacedCase& c) {
  DrawOptions options = WholeTarget(c);
  Checks asked;
  asked.checks.push_back(BaseDraw(WholeCallOf(c.scene, c.profile, options)));
  for (const Cull cull : {Cull::kFront, Cull::kBack}) {
    options.cull = cull;
    asked.checks.push_back(CheckAgainstBase(
        WholeCallOf(c.scene, c.profile, options),
        [&c, cull](const CoverageCounts& observed, const CoverageCounts& whole) {
          CoverageCounts expected = whole;
          std::ranges::fill(cull == Cull::kFront ? expected.front : expected.back, 0U);
          return SameCounts(observed, expected, DecisionsOf(c), WhatIsLeft(cull));
        }));
  }
  return asked;
}

// Compares a subject that reports none with its draw of only the triangles that face the other way,
// by the one model that is legal.
Checks AgainstTheOtherSide(const PlacedCase& c) {
  Checks asked;
  TrianglesByFacing sides(c);
  for (const Cull cull : {Cull::kFront, Cull::kBack}) {
    DrawOptions options = WholeTarget(c);
    Check check;
    check.questions.draws.push_back(WholeCallOf(c.scene, c.profile, options));
    check.questions.draws.back().job.triangles =
        std::move(cull == Cull::kFront ? sides.back : sides.front);
    options.cull = cull;
    check.questions.draws.push_back(WholeCallOf(c.scene, c.profile, options));
    check.judge = [&c, cull](const Answers& answers) {
      return SameCounts(answers.draws[1]->counts, answers.draws[0]->counts, DecisionsOf(c),
                        WhatIsLeft(cull));
    };
    asked.checks.push_back(std::move(check));
  }
  return asked;
}

bool ShowsAnything(const CoverageCounts& counts) {
  for (std::size_t k = 0; k < counts.size(); ++k) {
    if (counts.Count(k) != 0) return true;
  }
  return false;
}

Witness FirstCovered(const CoverageCounts& counts) {
  std::size_t k = 0;
  while (counts.Count(k) == 0) ++k;
  Witness witness = WitnessAtIndex(counts, k);
  witness.observed = {counts.Count(k)};
  return witness;
}

// The facing of a triangle by what culling leaves of it: +1 if it is seen without backs alone, -1
// without fronts alone, 0 both or never.
int KeptFacing(const CoverageCounts& without_front, const CoverageCounts& without_back) {
  const bool back = ShowsAnything(without_front);
  const bool front = ShowsAnything(without_back);
  if (front == back) return 0;
  return front ? 1 : -1;
}

// Of the reference: one of the two removes it.
Verdict RemovesOneSide(const CoverageCounts& without_front, const CoverageCounts& without_back,
                       FrontFace stated, int facing, bool tells) {
  const int kept = KeptFacing(without_front, without_back);
  const bool is_stated = stated == FrontFace::kPositiveArea;
  if (ShowsAnything(without_front) && kept == 0) {
    Witness witness = FirstCovered(without_front);
    witness.expected = {std::int64_t{0}};
    return Verdict::Violated(
        1, std::string(kReferenceWords) + " is culled neither as front nor as back", witness);
  }
  if (is_stated && kept == -facing) {
    Witness witness = FirstCovered(kept > 0 ? without_back : without_front);
    witness.expected = {std::int64_t{0}};
    return Verdict::Violated(
        1,
        "the profile says that the side of positive area is the front, and culling takes the other",
        witness);
  }
  const CoverageCounts& left = kept > 0 ? without_back : without_front;
  if (tells && kept != 0 && ShownFacing(left) != kept) {
    Witness witness = FirstCovered(left);
    witness.expected = {kept > 0 ? "front counts alone" : "back counts alone"};
    return Verdict::Violated(1, "what culling leaves is counted on the side that it removes",
                             witness);
  }
  Verdict held = Verdict::Held(0);
  if (!is_stated && kept != 0) held.front_sign = kept * facing;
  return held;
}

// Two draws of the same triangles: without fronts, and without backs.
Questions BothWays(const Scene& scene, const PlacedCase& c) {
  Questions questions;
  DrawOptions options = WholeTarget(c);
  for (const Cull cull : {Cull::kFront, Cull::kBack}) {
    options.cull = cull;
    questions.draws.push_back(WholeCallOf(scene, c.profile, options));
  }
  return questions;
}

// How many of the triangles may be left at the sample, and how many must be.
struct TrianglesLeft {
  std::uint32_t least = 0;
  std::uint32_t most = 0;
};

TrianglesLeft LeftAt(const std::vector<LegalTriangle>& triangles, Point2 p, int facing) {
  TrianglesLeft left;
  for (const LegalTriangle& t : triangles) {
    if (!t.MayCover(p) || t.facing() == -facing) continue;
    ++left.most;
    if (t.CoversInEveryModel(p)) ++left.least;
  }
  return left;
}

// Of the triangles, in one call without those that face the other way, what may be left is.
Verdict LeavesOneFacing(const PlacedCase& drawn, const std::vector<LegalTriangle>& triangles,
                        const CoverageCounts& counts, int facing, Cull cull) {
  std::uint64_t exercised = 0;
  const bool may_drop = drawn.profile.max_primitive_extent.has_value();
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const Witness at = WitnessAtIndex(counts, k);
    const auto [least, most] = LeftAt(triangles, PlaceOf(drawn, at.x, at.y, at.sample).at, facing);
    exercised += least;
    const bool is_missing = counts.Count(k) == 0 && least != 0 && !may_drop;
    if (counts.Count(k) <= most && !is_missing) continue;
    Witness witness = at;
    witness.observed = {counts.Count(k)};
    witness.expected = is_missing ? WitnessValue{1, " or more"} : WitnessValue{"at most ", most};
    return Verdict::Violated(1,
                             std::string("culling of ") +
                                 (cull == Cull::kFront ? "front" : "back") +
                                 " faces leaves others than the triangles that face the other way, "
                                 "by what it leaves of " +
                                 kReferenceWords,
                             witness);
  }
  return Verdict::Held(exercised);
}

Check AsItsReference(const PlacedCase& drawn, const Reference& reference) {
  Check check{BothWays(drawn.scene, drawn), {}, {0, 1}};
  check.judge = [drawn, facing = reference.facing](const Answers& answers) {
    const int kept = KeptFacing(answers.draws[0]->counts, answers.draws[1]->counts);
    if (kept == 0) return Verdict::Held(0);
    std::vector<LegalTriangle> triangles;
    for (const Triangle& t : drawn.scene.triangles) triangles.emplace_back(drawn, t);
    // Fronts are of this area.
    const int front = kept * facing;
    Verdict verdict =
        LeavesOneFacing(drawn, triangles, answers.draws[2]->counts, -front, Cull::kFront);
    if (verdict.outcome == Outcome::kViolated) return verdict;
    const std::uint64_t exercised = verdict.exercised;
    verdict = LeavesOneFacing(drawn, triangles, answers.draws[3]->counts, front, Cull::kBack);
    if (verdict.outcome != Outcome::kViolated)
      verdict = Verdict::Held(exercised + verdict.exercised);
    return verdict;
  };
  return check;
}

// Where models leave other places legal: of triangles that none of them turns, by a triangle that
// none turns either.
Checks AgainstTheReference(const PlacedCase& c, bool tells) {
  if (c.scene.clip_space) return NotExercised("the profile leaves open where clip space lies");
  const std::vector<Reference> references = ReferencesOf(c);
  if (references.empty()) return NotExercised("the profile's limit leaves no reference triangle");
  const Reference& reference = references.front();
  Checks asked;
  Check& base = asked.checks.emplace_back();
  base.questions = BothWays(reference.value.scene, c);
  base.judge = [stated = c.profile.front_face, facing = reference.facing,
                tells](const Answers& answers) {
    return RemovesOneSide(answers.draws[0]->counts, answers.draws[1]->counts, stated, facing,
                          tells);
  };
  const std::size_t count = std::min(kMostCulled, c.scene.triangles.size());
  for (std::size_t t = 0; t < count; ++t) {
    asked.checks.push_back(AsItsReference(c.Only({t}), reference));
  }
  asked.checks.push_back(AsItsReference(BehindItsReference(c, references, count), reference));
  return asked;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  if (!HasOneModel(c.profile)) return AgainstTheReference(c, TellsFacings(subject));
  return TellsFacings(subject) ? AgainstItsFacings(c) : AgainstTheOtherSide(c);
}

}  // namespace culling_removes_one_facing

extern constinit const Property kCullingRemovesOneFacing{
    .name = "CullingRemovesOneFacing",
    .group = "coverage",
    .clause =
        "Culling discards triangles of one facing (Vulkan 1.3, Basic Polygon Rasterization) "
        "and changes no other.",
    .required_by = kFacingClauses,
    .tolerance = kExact,
    .domains = kFacingsAnySpace,
    .gate = {.space = Space::kEither,
             .shows = Shows::kCulling,
             .any_model = true,
             .where = "with legal choices: window space, triangles that none of them turns"},
    .ask = culling_removes_one_facing::Ask,
};

}  // namespace rasterproof::props
