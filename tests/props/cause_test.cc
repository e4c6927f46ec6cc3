// What was planted in a subject is named as the cause of its violations, and nothing else is.
#include "props/cause/cause.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "exact/coverage.h"
#include "props/cause/evidence.h"
#include "props/cause/suspect.h"
#include "props/infer/infer.h"
#include "props/run/campaign.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutants.h"

namespace rasterproof::props {
namespace {

constexpr double kLongest = 800;  // seconds: what is found may not depend on the clock

const Property& EqualsTheModel() { return *FindProperty("CoverageEqualsTheModel"); }

// The violation of a property that a short campaign finds.
FailedProperty FailureOf(const MakesSubject& make, const Property& property) {
  CampaignOptions options;
  options.cases = 300;
  options.shrink_budget = 300;
  const PropertyResult result = RunCampaign(*make(), property, options);
  EXPECT_EQ(result.outcome, Outcome::kViolated) << result.message;
  if (!result.counterexample) return {};
  return {&property, {result.counterexample->value}};
}

MakesSubject MutantMaker(std::string_view name) {
  return [name = std::string(name)] { return subjects::MakeMutant(name); };
}

Cause CauseOf(std::string_view mutant, std::string_view property = "CoverageEqualsTheModel") {
  const MakesSubject make = MutantMaker(mutant);
  const FailedProperty failure = FailureOf(make, *FindProperty(property));
  if (failure.property == nullptr) return {};
  const Causes found = FindCauses(make, std::span(&failure, 1), kLongest);
  EXPECT_EQ(found.all.size(), 1U);
  return found.all.empty() ? Cause() : found.all.front();
}

TEST(Suspect, WithoutAChangeDrawsTheModel) {
  for (const char* preset : {"real", "d3d11-canonical", "gl-canonical-4x"}) {
    SubjectInfo info;
    info.name = "model";
    info.profile = *PresetProfile(preset);
    info.takes_clip = false;
    const std::unique_ptr<Subject> model = MakeSuspect(info, {});
    std::size_t drawn = 0;
    for (std::uint64_t k = 0; k < 200; ++k) {
      const Case c = DrawCase(info, EqualsTheModel(), 1, k);
      if (!SuspectsDraw(c.scene, info)) continue;
      CoverageCounts counts(c.scene.width, c.scene.height, info.profile.pattern.samples());
      DrawOnto(*model, c.scene, c.options, counts);
      ASSERT_EQ(counts, exact::Coverage(c.scene, c.profile, c.options)) << preset << c.origin;
      ++drawn;
    }
    EXPECT_GT(drawn, 150U);
  }
}

TEST(Suspect, IsNamedInWholeWords) {
  const std::vector<Suspect> suspects = SuspectsOf(*PresetProfile("d3d11-canonical"));
  EXPECT_GT(suspects.size(), 300U);
  for (const Suspect& suspect : suspects) {
    EXPECT_FALSE(suspect.cause.empty() || suspect.what.empty());
    EXPECT_EQ(suspect.what.find("{}") != std::string::npos, static_cast<bool>(suspect.within))
        << suspect.what;
  }
}

TEST(Cause, OfABudgetNamesItsNumber) {
  for (const auto& [mutant, what] :
       {std::pair("mutant:target-2048", "never draws pixels from column 2048 on"),
        std::pair("mutant:many-vertices-lost",
                  "leaves out triangles with vertices from number 256 on")}) {
    const Cause cause = CauseOf(mutant);
    EXPECT_EQ(cause.kind, CauseKind::kModel) << mutant;
    EXPECT_EQ(cause.what, std::vector<std::string>{what}) << mutant;
  }
}

TEST(Cause, OfTruncationIsTruncation) {
  const Cause cause = CauseOf("mutant:snap-truncates");
  EXPECT_EQ(cause.kind, CauseKind::kModel);
  EXPECT_EQ(cause.name, "truncation");
  ASSERT_EQ(cause.what.size(), 1U);
  EXPECT_EQ(cause.what.front(), "truncates coordinates toward zero");
  EXPECT_EQ(cause.reproduced, cause.draws);
  EXPECT_GT(cause.draws, 100U);
}

TEST(Cause, OfRoundingDownIsNotTruncationTowardZero) {
  const Cause cause = CauseOf("mutant:snap-floors");
  EXPECT_EQ(cause.name, "truncation");
  ASSERT_EQ(cause.what.size(), 1U);
  EXPECT_EQ(cause.what.front(), "rounds coordinates down");
}

TEST(Cause, OfSamplesInTheCornerIsTheirPlace) {
  const Cause cause = CauseOf("mutant:sample-corner");
  EXPECT_EQ(cause.name, "sample-location");
  ASSERT_EQ(cause.what.size(), 1U);
  EXPECT_NE(cause.what.front().find("(-128/256, -128/256)"), std::string::npos);
}

TEST(Cause, OfInclusiveEdgesIsTheTieRule) {
  const Cause cause = CauseOf("mutant:ties-inclusive");
  EXPECT_EQ(cause.name, "tie-rule");
  ASSERT_EQ(cause.what.size(), 1U);
  EXPECT_EQ(cause.what.front(), "covers every sample on an edge (>= on all edges)");
}

TEST(Cause, OfAScissorThatEndsLateIsTheScissor) {
  EXPECT_EQ(CauseOf("mutant:scissor-right-inclusive").name, "scissor");
}

TEST(Cause, OfAStateIsTheList) {
  const Cause cause = CauseOf("mutant:leak-repeated", "OneCallDrawsLikeItsTriangles");
  EXPECT_EQ(cause.kind, CauseKind::kCircumstance);
  EXPECT_EQ(cause.name, "list");
}

TEST(Cause, IsNotNamedWhereNoSuspectDrawsAlike) {
  const Cause cause = CauseOf("mutant:lost-1-in-1e4");
  EXPECT_EQ(cause.kind, CauseKind::kUnexplained);
  EXPECT_TRUE(cause.name.empty());
}

// Three bugs, in triangles of three kinds.
std::unique_ptr<Subject> ThreeBugs() {
  subjects::mutants::FixedStages stages;
  stages.drops = [](const Scene& scene, std::size_t number) {
    const auto v = Corners(scene, scene.triangles[number]);
    return std::fabs((v[2].x - v[0].x) * (v[1].y - v[0].y) -
                     (v[2].y - v[0].y) * (v[1].x - v[0].x)) < 2;
  };
  stages.owns = [](const auto& edge, const auto&, const auto&) {
    return edge.owns || edge.a.y == edge.b.y;
  };
  stages.options = [](DrawOptions& options, const Scene&) { options.scissor.reset(); };
  return subjects::mutants::Make("three", "three bugs", std::move(stages));
}

Case Triangle3(std::vector<Vertex> vertices) {
  Case c;
  c.scene.width = c.scene.height = 8;
  c.scene.vertices = std::move(vertices);
  c.scene.triangles = {{0, 1, 2}};
  c.profile = ThreeBugs()->Info().profile;
  return c;
}

TEST(Cause, OfThreeBugsIsToldAsThree) {
  const Case small = Triangle3({{1, 1, 0, 1}, {2, 1, 0, 1}, {1, 2.25, 0, 1}});
  const Case tie = Triangle3({{1, 5.5, 0, 1}, {6, 5.5, 0, 1}, {3, 1, 0, 1}});
  Case cut = Triangle3({{0, 0, 0, 1}, {7, 0.25, 0, 1}, {0, 7, 0, 1}});
  cut.options.scissor = PixelRect{0, 0, 2, 2};
  const std::vector<FailedProperty> failures{
      {&EqualsTheModel(), {small}}, {&EqualsTheModel(), {tie}}, {&EqualsTheModel(), {cut}}};
  const Causes found = FindCauses(ThreeBugs, failures, kLongest);
  std::vector<std::string> names;
  for (const Cause& cause : found.all) {
    names.push_back(cause.name);
    EXPECT_EQ(cause.kind, CauseKind::kPart) << cause.name;
  }
  std::ranges::sort(names);
  EXPECT_EQ(names, (std::vector<std::string>{"lost-triangles", "scissor", "tie-rule"}));
}

TEST(Infer, NamesTheDrawThatRefutedTheModelThatWasLeftLast) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant("mutant:lost-small");
  const Inference inference = Infer(*subject, {.nearest_checks = 64});
  ASSERT_TRUE(!inference.Fits() && inference.last_refuted.has_value());
  const Case& last = *inference.last_refuted;
  CoverageCounts drawn(last.scene.width, last.scene.height);
  DrawOnto(*subject, last.scene, {}, drawn);
  EXPECT_NE(drawn, exact::Coverage(last.scene, last.profile));
}

TEST(OnlyWith, NamesWhatTheWrongDrawsShare) {
  const MakesSubject make = MutantMaker("mutant:overflow-unsigned");
  const FailedProperty failure = FailureOf(make, EqualsTheModel());
  ASSERT_NE(failure.property, nullptr);
  const Causes found = FindCauses(make, std::span(&failure, 1), kLongest);
  ASSERT_EQ(found.all.size(), 1U);
  EXPECT_EQ(found.all.front().name, "overflow");
}

}  // namespace
}  // namespace rasterproof::props
