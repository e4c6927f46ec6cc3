// Each triangle alone, and the mesh, strays from the canonical model to the contract's side only.
//
// Under at-least-model it covers each sample at least as often as the model, under
// at-most-model at most as often.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "props/judging/as_shown.h"
#include "props/judging/redraw.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace coverage_keeps_to_its_side_of_the_model {

constexpr std::size_t kMostSingles = 64;

bool IsASideOfTheModel(const Profile& profile) {
  return profile.contract == Contract::kAtLeastModel || profile.contract == Contract::kAtMostModel;
}

constexpr std::array kRules{ProfileRule{IsASideOfTheModel,
                                        "contract at-least-model or at-most-model",
                                        "the profile's contract is not a side of the model", true}};

// Which way a subject may stray decides what fails; a facing that strays is not looked at.
Verdict KeepsToItsSide(const PlacedCase& c, const CoverageCounts& observed, bool as_shown = false) {
  // A triangle that is culled is not drawn with a margin either.
  const bool is_culled = c.scene.triangles.size() == 1 && !c.culled.empty();
  const bool over = c.profile.contract == Contract::kAtLeastModel && !is_culled;
  CoverageCounts expected = exact::Coverage(c, WholeTarget(c));
  if (as_shown) expected = AsShown(std::move(expected));
  std::uint64_t exercised = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    const std::uint32_t truth = expected.Count(k);
    const std::uint32_t seen = observed.Count(k);
    if (truth != 0 || seen != 0) ++exercised;
    if (over ? seen >= truth : seen <= truth) continue;
    return Verdict::Violated(exercised,
                             over        ? "at least the model: a covered sample is left out"
                             : is_culled ? "a triangle of the side that the profile always culls "
                                           "covers a sample"
                                         : "at most the model: a sample is covered that is not "
                                           "covered",
                             WitnessOfCounts(observed, expected, k));
  }
  return Verdict::Held(exercised);
}

Check OfOneTriangle(const PlacedCase& c, const std::shared_ptr<const Scene>& scene, std::size_t t) {
  Check check;
  check.questions.draws.push_back(CountsOfOne(scene, t, c.profile, WholeTarget(c)));
  check.judge = [&c, t](const Answers& answers) {
    Verdict verdict = KeepsToItsSide(c.Only({t}), answers.draws[0]->counts);
    if (verdict.witness) verdict.witness->triangle = static_cast<int>(t);
    return verdict;
  };
  return check;
}

Check OfTheMesh(const PlacedCase& c, const Description& subject) {
  Check check;
  check.questions.draws.push_back(CountsOf(c.scene, c.profile, WholeTarget(c)));
  check.judge = [&c, as_shown = IsJudgedAsShown(subject.info, c.scene)](const Answers& answers) {
    return KeepsToItsSide(c, answers.draws[0]->counts, as_shown);
  };
  return check;
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  Checks asked;
  const auto scene = std::make_shared<const Scene>(c.scene);
  // One triangle's excess must not make up for another's lack.
  for (std::size_t t = 0; t < std::min(kMostSingles, c.scene.triangles.size()); ++t) {
    asked.checks.push_back(OfOneTriangle(c, scene, t));
  }
  asked.checks.push_back(OfTheMesh(c, subject));
  return asked;
}

}  // namespace coverage_keeps_to_its_side_of_the_model

extern constinit const Property kCoverageKeepsToItsSideOfTheModel{
    .name = "CoverageKeepsToItsSideOfTheModel",
    .group = "coverage",
    .clause =
        "Coverage strays from the model to one side only: at-least-model leaves no covered sample "
        "out, at-most-model adds none.",
    .tolerance = kExact,
    .domains = kCoverageAnySpace,
    .gate = {.space = Space::kEither,
             .contract = ContractNeeded::kAny,
             .rules = coverage_keeps_to_its_side_of_the_model::kRules,
             .asks_oracle = true},
    .ask = coverage_keeps_to_its_side_of_the_model::Ask,
};

}  // namespace rasterproof::props
