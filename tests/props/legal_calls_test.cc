// What a specification leaves open from call to call is let pass; what it leaves open within its
// range and on its grids too. What lies just outside is found.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <string>

#include "core/profile.h"
#include "props/judging/open_by_call.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/mutants/mutants.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

PropertyResult CampaignOn(const std::string& name, const Property& property, std::uint64_t seed,
                          std::uint64_t cases) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant(name);
  return RunCampaign(*subject, property, {.seed = seed, .cases = cases, .shrink_budget = 20});
}

void ExpectLegal(const std::string& name, const Property& property) {
  for (std::uint64_t seed = 1; seed <= Cases(3U); ++seed) {
    const PropertyResult result = CampaignOn(name, property, seed, Cases(200U));
    EXPECT_EQ(result.outcome, Outcome::kHolds)
        << name << ", " << property.name << ", seed " << seed << ": " << result.message;
  }
}

void ExpectFound(const std::string& name, const Property& property) {
  for (std::uint64_t seed = 1; seed <= Cases(3U); ++seed) {
    EXPECT_EQ(CampaignOn(name, property, seed, 200).outcome, Outcome::kViolated)
        << name << ", " << property.name << ", seed " << seed;
  }
}

TEST(MayChooseByCall, WhereNoClauseSaysThatEqualDrawsAreEqual) {
  for (const char* name : {"d3d11", "d3d11-4x", "webgpu"})
    EXPECT_TRUE(MayChooseByCall(*PresetProfile(name))) << name;
  for (const char* name : {"vulkan", "gl", "real", "d3d11-canonical"})
    EXPECT_FALSE(MayChooseByCall(*PresetProfile(name))) << name;
}

TEST(LegalCalls, AnotherLegalModelInAnotherCallIsTaken) {
  for (const char* name : {"legal:d3d11-snap-by-call", "legal:webgpu-grid-by-call"}) {
    ExpectLegal(name, *FindProperty("OneLegalModelExplainsTheMesh"));
  }
  ExpectLegal("legal:webgpu-grid-by-call", *FindProperty("TriangleOrderKeepsCoverage"));
  ExpectLegal("legal:webgpu-grid-by-call", *FindProperty("OneCallDrawsLikeItsTriangles"));
  ExpectLegal("legal:d3d11-snap-by-call", *FindProperty("BadTrianglesPoisonNoOthers"));
}

TEST(LegalCalls, AnotherModelForAnotherTriangleIsFound) {
  ExpectFound("mutant:d3d11-snap-by-triangle", *FindProperty("OneLegalModelExplainsTheMesh"));
}

TEST(LegalCalls, OwnersThatChangeFromCallToCallAreTakenWhereTheyAreOpen) {
  ExpectLegal("legal:webgpu-owner-by-number", *FindProperty("TriangleOrderKeepsCoverage"));
  ExpectLegal("legal:webgpu-owner-by-number", *FindProperty("OneCallDrawsLikeItsTriangles"));
}

TEST(LegalCalls, SamplesOffEdgesThatChangeFromCallToCallAreFound) {
  ExpectFound("mutant:webgpu-lost-by-number", *FindProperty("TriangleOrderKeepsCoverage"));
  ExpectFound("mutant:webgpu-lost-by-number", *FindProperty("OneCallDrawsLikeItsTriangles"));
}

// An edge through samples, to a vertex at the far end; what lies on it is not covered.
Verdict OfEdgeTo(double far, const std::string& name) {
  Case c;
  c.scene.width = 64;
  c.scene.height = 64;
  c.scene.vertices = {{0.5, 0.5, 0, 1}, {far, 0.5 + (far - 0.5) / 2, 0, 1}, {0.5, 90, 0, 1}};
  c.scene.triangles = {{0, 1, 2}, {0, 2, 1}};
  const std::unique_ptr<Subject> subject = subjects::MakeMutant(name);
  c.profile = subject->Info().profile;
  return RunCase(*subject, *FindProperty("OneLegalModelExplainsTheMesh"), c);
}

TEST(LegalRange, EndsAtWhatSixteenPointEightHolds) {
  // A clamped vertex bends the edge, and no legal model does, if its place is said to be legal.
  constexpr double kEnd = 0x1p15 - 0x1p-7;
  EXPECT_EQ(OfEdgeTo(kEnd, "legal:d3d11-clamps-to-range").outcome, Outcome::kHolds);
  EXPECT_EQ(OfEdgeTo(0x1p15 + 0.5, "legal:d3d11-clamps-to-range").outcome, Outcome::kNotExercised);
  EXPECT_EQ(OfEdgeTo(0x1p15, "legal:d3d11-clamps-to-range").outcome, Outcome::kNotExercised);
  EXPECT_EQ(OfEdgeTo(kEnd, "mutant:d3d11-clamps-to-half-range").outcome, Outcome::kViolated);
  ExpectLegal("legal:d3d11-clamps-to-range", *FindProperty("OneLegalModelExplainsTheMesh"));
}

TEST(LegalGrids, AreOfAnyNumberOfBitsFromTheFewest) {
  ExpectLegal("legal:vulkan-17-bits", *FindProperty("OneLegalModelExplainsTheMesh"));
  ExpectLegal("legal:vulkan-23-bits", *FindProperty("OneLegalModelExplainsTheMesh"));
  ExpectFound("mutant:vulkan-17-bits-some-3", *FindProperty("OneLegalModelExplainsTheMesh"));
}

}  // namespace
}  // namespace rasterproof::props
