// Properties about pixels as squares: whom they judge, what they let pass, what they find.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "core/square_presets.h"
#include "core/subject.h"
#include "exact/square_coverage.h"
#include "props/properties/contract_properties.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"
#include "subjects/mutants/mutants.h"
#include "tests/fake_subject.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

SubjectInfo InfoOf(std::string_view preset) {
  SubjectInfo info;
  info.name = preset;
  info.profile = *SquarePreset(preset);
  return info;
}

// Draws the least or the most that its profile allows, whatever its vertices' places.
FakeSubject AtItsBound(std::string_view preset, bool draws_most) {
  const auto cover = draws_most ? exact::MayCover : exact::MustCover;
  return {InfoOf(preset),
          [cover, profile = *SquarePreset(preset)](const Scene& scene, const DrawOptions& options,
                                                   CoverageCounts& counts) {
            counts += cover({scene, profile}, options);
          }};
}

constexpr std::string_view kNames[] = {
    "SquaresThatMustBeAreCovered", "SquaresOutsideTheMayRegionStayFree",
    "MetSquaresIncludeCoveredCentres", "HeldSquaresHaveCoveredCentres",
    "SubdivisionLeavesNoSquareUntouched"};

struct JudgedSquares {
  std::uint64_t exercised = 0;
  std::string violated;
};

JudgedSquares RunAll(Subject& subject, std::uint64_t seed, std::uint64_t cases) {
  JudgedSquares run;
  for (const std::string_view name : kNames) {
    const Property& property = *FindProperty(name);
    if (DomainsFor(subject.Info(), property).empty()) continue;
    for (std::uint64_t n = 0; n < cases; ++n) {
      const Case c = DrawCase(subject.Info(), property, seed, n);
      const Verdict verdict = RunCase(subject, property, c);
      run.exercised += verdict.exercised;
      if (verdict.outcome != Outcome::kViolated) continue;
      run.violated = std::string(name) + ", " + c.origin + ": " + verdict.message;
      return run;
    }
  }
  return run;
}

TEST(Squares, OfALegalVariantHoldInFiveSeeds) {
  for (const subjects::MutantInfo& variant : subjects::Mutants()) {
    if (!variant.name.starts_with("legal:squares-")) continue;
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(variant.name);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
      const JudgedSquares run = RunAll(*subject, seed, Cases<std::uint64_t>(40));
      EXPECT_EQ(run.violated, "") << variant.name << ", seed " << seed;
      EXPECT_GT(run.exercised, 0U) << variant.name;
    }
  }
}

TEST(Squares, OfAMutantAreFound) {
  int mutants = 0;
  for (const subjects::MutantInfo& mutant : subjects::Mutants()) {
    if (!mutant.name.starts_with("mutant:squares-")) continue;
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(mutant.name);
    EXPECT_NE(RunAll(*subject, 1, 400).violated, "") << mutant.name;
    ++mutants;
  }
  EXPECT_GE(mutants, 20);
}

TEST(Squares, AtTheBoundsOfAnyPresetHold) {
  for (const SquarePresetInfo& preset : kSquarePresets) {
    for (const bool most : {false, true}) {
      FakeSubject subject = AtItsBound(preset.name, most);
      const SquareRule& rule = *subject.Info().profile.squares;
      // On a grid line no open square meets a flat triangle, and one must show it all the same.
      const bool shows_too_little =
          !most && rule.flat == FlatSquares::kDrawn && rule.must->square == Closure::kOpen;
      if (!(most ? rule.may : rule.must) || shows_too_little) continue;
      const JudgedSquares run = RunAll(subject, 3, Cases<std::uint64_t>(60));
      EXPECT_EQ(run.violated, "") << preset.name << (most ? ", most" : ", least");
      EXPECT_GT(run.exercised, 0U) << preset.name;
    }
  }
}

TEST(Squares, AFlatTriangleThatMustBeDrawnMayNotFallBetweenThem) {
  FakeSubject least = AtItsBound("d3d12-conservative-2", false);
  Case c;
  c.scene.width = c.scene.height = 8;
  c.scene.vertices = {{3, 3}, {5, 3}, {4, 3}};
  c.scene.triangles = {{0, 1, 2}};
  c.profile = least.Info().profile;
  const Property& property = *FindProperty("SquaresThatMustBeAreCovered");
  const Verdict verdict = RunCase(least, property, c);
  EXPECT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_EQ(verdict.message, "squares: a flat triangle that must be drawn falls through");
  FakeSubject most = AtItsBound("d3d12-conservative-2", true);
  EXPECT_EQ(RunCase(most, property, c).outcome, Outcome::kHolds);
  c.scene.triangles = {{0, 1, 1}};
  EXPECT_NE(RunCase(least, property, c).outcome, Outcome::kViolated) << "a vertex named twice";
}

TEST(Squares, AFlatTriangleIsJudgedWhereItMayCoverNothing) {
  FakeSubject most = AtItsBound("vulkan-underestimate", true);
  FakeSubject touched(InfoOf("vulkan-underestimate"),
                      [](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                        counts += exact::MayCover({scene, *SquarePreset("voxel")}, options);
                      });
  Case c;
  c.scene.width = c.scene.height = 8;
  c.scene.vertices = {{3, 3}, {5, 3}, {4, 3}};
  c.scene.triangles = {{0, 1, 2}};
  c.profile = most.Info().profile;
  const Property& property = *FindProperty("SquaresOutsideTheMayRegionStayFree");
  const Verdict verdict = RunCase(most, property, c);
  EXPECT_EQ(verdict.outcome, Outcome::kHolds);
  EXPECT_EQ(verdict.exercised, 8U) << "four columns in two rows that the segment touches";
  EXPECT_EQ(RunCase(touched, property, c).outcome, Outcome::kViolated);
  c.scene.triangles = {{0, 0, 0}};
  EXPECT_EQ(RunCase(most, property, c).outcome, Outcome::kHolds);
  c.scene.vertices[0] = {-9, 3};
  EXPECT_EQ(RunCase(most, property, c).outcome, Outcome::kNotExercised) << "beside the target";
}

TEST(Squares, AreJudgedWhereTheProfileStatesThemAndNowhereElse) {
  const auto applies = [](std::string_view property, std::string_view preset) {
    Description description;
    description.info.profile = *PresetProfile(preset);
    return !DoesNotApply(FindProperty(property)->gate, description);
  };
  for (const std::string_view name : kNames) EXPECT_FALSE(applies(name, "gl")) << name;
  EXPECT_TRUE(applies("SquaresThatMustBeAreCovered", "voxel"));
  EXPECT_FALSE(applies("SquaresThatMustBeAreCovered", "vulkan-underestimate"));
  EXPECT_FALSE(applies("SquaresOutsideTheMayRegionStayFree", "vulkan-overestimate"));
  EXPECT_TRUE(applies("MetSquaresIncludeCoveredCentres", "vulkan-overestimate"));
  EXPECT_FALSE(applies("MetSquaresIncludeCoveredCentres", "d3d12-inner"));
  EXPECT_TRUE(applies("HeldSquaresHaveCoveredCentres", "d3d12-inner"));
  EXPECT_FALSE(applies("HeldSquaresHaveCoveredCentres", "voxel"));
  EXPECT_TRUE(applies("SubdivisionLeavesNoSquareUntouched", "d3d12-conservative-1"));
  EXPECT_FALSE(applies("SubdivisionLeavesNoSquareUntouched", "vulkan-overestimate"));
  for (const std::string_view name : {"CoverageEqualsTheModel", "VertexRotationKeepsCoverage"}) {
    EXPECT_FALSE(applies(name, "voxel")) << name;
  }
  for (const std::string_view name : PropertiesOf(Contract::kSquares)) {
    EXPECT_NE(FindProperty(name), nullptr) << name;
  }
}

}  // namespace
}  // namespace rasterproof::props
