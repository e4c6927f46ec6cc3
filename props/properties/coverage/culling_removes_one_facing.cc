// Culling a facing removes its counts and keeps the others.
#include <algorithm>
#include <utility>

#include "core/coverage.h"
#include "props/judging/free_choices.h"
#include "props/judging/redraw.h"
#include "props/judging/sides.h"
#include "props/properties/all.h"
#include "props/properties/clause_lists.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"

namespace rasterproof::props {
namespace {

const char* WhatIsLeft(Cull cull) {
  return cull == Cull::kFront ? "the back counts alone" : "the front counts alone";
}

// Of a subject that tells facings: what is left of its own counts.
Asked AgainstItsFacings(const Case& c) {
  DrawOptions options = WholeTarget(c);
  Asked asked;
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

// Of one that tells none: what it shows of the triangles that face the other way alone, by the one
// model that is legal.
Asked AgainstTheOtherSide(const Case& c) {
  Asked asked;
  Sides sides = SidesOf(c.scene, c.scene.triangles, c.profile);
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

Asked Ask(const Case& c, const Description& subject) {
  return TellsFacings(subject) ? AgainstItsFacings(c) : AgainstTheOtherSide(c);
}

}  // namespace

constinit const Property kCullingRemovesOneFacing{
    .name = "CullingRemovesOneFacing",
    .group = "coverage",
    .clause =
        "Culling discards triangles of one facing (Vulkan 1.3, Basic Polygon Rasterization) "
        "and changes no other.",
    .required_by = kFacingClauses,
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .gate = {.space = Space::kEither, .shows = Shows::kCulling},
    .ask = Ask,
};

}  // namespace rasterproof::props
