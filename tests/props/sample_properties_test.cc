// Several samples a pixel: what is wrong is found, what is left open is let through, and `infer`
// sees where samples lie.
#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/profile.h"
#include "core/sample_pattern.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/primitive_ids.h"
#include "props/domains/domain.h"
#include "props/infer/infer.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/mutants/mutants.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kSampleSeed = 5;

Outcome Found(Subject& subject, const Property& property, std::uint64_t cases) {
  Outcome outcome = Outcome::kNotExercised;
  for (std::uint64_t k = 0; k < cases && outcome != Outcome::kViolated; ++k) {
    const Verdict verdict =
        RunCase(subject, property, DrawCase(subject.Info(), property, kSampleSeed, k));
    if (verdict.outcome != Outcome::kNotExercised) outcome = verdict.outcome;
  }
  return outcome;
}

Outcome FoundOf(std::string_view variant, const Property& property) {
  constexpr std::uint64_t kCases = 200;
  return Found(*subjects::MakeMutant(variant), property, kCases);
}

// Where positions are open meshes are judged all the same, and singles are not.
TEST(Samples, WhatIsOpenIsNotJudgedAndMeshesAre) {
  for (const std::string_view legal :
       {"legal:samples-mirrored-under-gl", "legal:samples-in-corners",
        "legal:samples-vary-under-gl", "legal:samples-centre-under-vulkan"}) {
    if (kOneCaseIn > 1 && legal != "legal:samples-vary-under-gl") continue;
    EXPECT_EQ(FoundOf(legal, *FindProperty("SharedEdgeSamplesAreCoveredOnce")), Outcome::kHolds)
        << legal;
    EXPECT_EQ(FoundOf(legal, *FindProperty("EmbeddedMeshSamplesAreCoveredOnce")), Outcome::kHolds)
        << legal;
    EXPECT_EQ(FoundOf(legal, *FindProperty("FacingIsOneAtAllSamples")), Outcome::kHolds) << legal;
    EXPECT_EQ(FoundOf(legal, *FindProperty("OneLegalModelExplainsTheMesh")),
              Outcome::kNotApplicable)
        << legal;
  }
  EXPECT_EQ(
      FoundOf("legal:samples-mirrored-under-gl", *FindProperty("IntegerTranslationMovesCoverage")),
      Outcome::kHolds);
  EXPECT_EQ(
      FoundOf("legal:samples-vary-under-gl", *FindProperty("IntegerTranslationMovesCoverage")),
      Outcome::kNotApplicable);
}

const Property& InThePixel() { return *FindProperty("SamplesLieInTheirPixel"); }

// At the centre, in corners, on the far borders, another place in every other column.
TEST(Samples, LieAnywhereInTheirClosedPixel) {
  constexpr std::uint64_t kCases = 60;
  for (const std::string_view legal :
       {"legal:samples-on-far-borders", "legal:samples-in-corners",
        "legal:samples-vary-under-vulkan", "legal:samples-centre-under-vulkan",
        "legal:samples-16-under-vulkan", "legal:samples-mirrored-under-gl"}) {
    if (kOneCaseIn > 1 && legal != "legal:samples-on-far-borders") continue;
    EXPECT_EQ(Found(*subjects::MakeMutant(legal), InThePixel(), kCases), Outcome::kHolds) << legal;
  }
}

TEST(Samples, MayLieOutsideTheirPixelUnderOpenGlAlone) {
  const auto outside = subjects::MakeMutant("legal:samples-outside-under-gl");
  EXPECT_EQ(Found(*outside, InThePixel(), 20), Outcome::kNotApplicable);
  const auto inside = subjects::MakeMutant("legal:samples-standard-8");
  EXPECT_EQ(Found(*inside, InThePixel(), 20), Outcome::kNotApplicable);  // places are stated
}

// Four samples whose places the profile leaves open; each triangle has them where `place` says.
FakeSubject SamplesBy(void (*place)(const Scene& one, Point2& location)) {
  SubjectInfo info = testing::SnappedInfo(8);
  info.profile = *PresetProfile("vulkan-4x");
  return {info, [place, given = info.profile](const Scene& scene, const DrawOptions& options,
                                              CoverageCounts& counts) {
            for (const Triangle& t : scene.triangles) {
              Scene one = scene;
              one.triangles = {t};
              Profile profile = given;
              for (Point2& location : profile.pattern.locations) place(one, location);
              counts += exact::Coverage(one, profile, options);
            }
          }};
}

// Each triangle alone is explained by places in the pixel, together they are not.
TEST(Samples, HaveOnePlaceForAllTrianglesOfACase) {
  FakeSubject one = SamplesBy([](const Scene&, Point2& location) { location.x = 0.25; });
  EXPECT_EQ(Found(one, InThePixel(), Cases(60)), Outcome::kHolds);
  FakeSubject two = SamplesBy([](const Scene& scene, Point2& location) {
    const Vertex& first = scene.vertices[static_cast<std::size_t>(scene.triangles[0][0])];
    location.x = std::fmod(std::floor(std::fabs(first.x)), 2) == 0 ? 0.25 : 0.75;
  });
  EXPECT_EQ(Found(two, InThePixel(), 200), Outcome::kViolated);
}

// Each case alone is explained by places in the pixel, two cases are not.
TEST(Samples, HaveOnePlaceForAllCasesOfARun) {
  FakeSubject by_case = SamplesBy([](const Scene& scene, Point2& location) {
    const bool is_even = std::fmod(std::floor(16 * std::fabs(scene.vertices[0].x)), 2) == 0;
    location.x = is_even ? 0.25 : 0.75;
  });
  EXPECT_EQ(Found(by_case, InThePixel(), 200), Outcome::kViolated);
  FakeSubject by_length = SamplesBy([](const Scene& scene, Point2& location) {
    location.y = scene.vertices.size() > 64 ? 0.5 : 0.625;
  });
  EXPECT_EQ(Found(by_length, InThePixel(), 200), Outcome::kViolated);
}

// One triangle that holds the pixel (2, 2) by more than any grid moves it, and one far from it.
TEST(Samples, AreCoveredByWhatHoldsTheirPixelAndByNothingApartFromIt) {
  SubjectInfo info = testing::SnappedInfo(8);
  info.profile = *PresetProfile("vulkan-4x");
  for (const bool holds : {true, false}) {
    Case c;
    c.profile = info.profile;
    c.scene.width = c.scene.height = 8;
    c.scene.vertices = holds ? std::vector<Vertex>{{0, 0}, {0, 8}, {8, 0}}
                             : std::vector<Vertex>{{8, 8}, {4, 8}, {8, 4}};
    c.scene.triangles = {{0, 1, 2}};
    for (const bool wrong : {false, true}) {
      FakeSubject subject(
          info, [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            counts += exact::Coverage(scene, info.profile, options);
            if (wrong) counts.front[counts.Index(2, 2, 3)] = holds ? 0 : 1;
          });
      EXPECT_EQ(RunCase(subject, InThePixel(), c).outcome,
                wrong ? Outcome::kViolated : Outcome::kHolds)
          << holds;
    }
  }
}

// A fan about a hub to the right of its square: right of the square two triangles cover a sample,
// one of each facing.
TEST(Samples, AreCoveredFrontMinusBackWhereAMeshFolds) {
  SubjectInfo info = testing::SnappedInfo(8);
  info.profile = *PresetProfile("vulkan-4x");
  Case c;
  c.profile = info.profile;
  c.scene.width = c.scene.height = 24;
  c.scene.vertices = {{1, 1}, {1, 15}, {15, 15}, {15, 1}, {22, 8}};
  c.scene.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  // Vulkan leaves open which side is the front.
  for (const bool is_exchanged : {false, true}) {
    for (const bool wrong : {false, true}) {
      FakeSubject subject(
          info, [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            counts += exact::Coverage(scene, info.profile, options);
            if (wrong && scene.triangles.size() == 4) counts.back.assign(counts.size(), 0);
            if (is_exchanged) std::swap(counts.front, counts.back);
          });
      const Verdict verdict = RunCase(subject, InThePixel(), c);
      EXPECT_EQ(verdict.outcome, wrong ? Outcome::kViolated : Outcome::kHolds) << verdict.message;
    }
  }
}

// Shows the last triangle on each of four samples, or on the pixel's first one for all.
FakeSubject ShowsIds(bool by_pixel) {
  SubjectInfo info = testing::RealInfo();
  info.profile.pattern = *StandardPattern(4);
  info.coverage = CoverageKind::kPrimitiveIds;
  return FakeSubject::Showing(info, [by_pixel, profile = info.profile](const DrawJob& job) {
    const Scene scene = SceneOf(job);
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height, job.samples);
    drawing.primitive_ids = exact::PrimitiveIds({scene, profile}, job.options, Visible::kLastDrawn);
    std::vector<std::int32_t>& ids = drawing.primitive_ids;
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const std::size_t first = k - k % 4;
      if (by_pixel && ids[k] != kNoPrimitive && ids[first] != kNoPrimitive) ids[k] = ids[first];
      drawing.counts.front[k] = ids[k] != kNoPrimitive ? 1 : 0;
    }
    return drawing;
  });
}

TEST(Samples, PrimitiveIdsFollowTheOrderAtEachSample) {
  FakeSubject sound = ShowsIds(false);
  EXPECT_EQ(Found(sound, *FindProperty("PrimitiveIdFollowsTheStatedOrder"), 40), Outcome::kHolds);
  FakeSubject by_pixel = ShowsIds(true);
  EXPECT_EQ(Found(by_pixel, *FindProperty("PrimitiveIdFollowsTheStatedOrder"), 200),
            Outcome::kViolated);
}

Inference InferOf(std::string_view name) { return Infer(*subjects::MakeMutant(name)); }

TEST(SamplePlaces, AreThoseOfTheStatedPatternToOneStep) {
  const Inference found = InferOf("legal:samples-standard-8");
  ASSERT_TRUE(found.Fits());
  EXPECT_TRUE(found.Agrees());
  ASSERT_TRUE(found.sample_places);
  const SamplePattern pattern = *StandardPattern(8);
  for (std::size_t s = 0; s < 8; ++s) {
    const SeenPlace& place = found.sample_places->samples[s];
    EXPECT_LE(std::abs(place.x - pattern.locations[s].x * kPlaceSteps), 1) << s;
    EXPECT_LE(std::abs(place.y - pattern.locations[s].y * kPlaceSteps), 1) << s;
  }
  EXPECT_FALSE(found.sample_places->varying || found.sample_places->sharing);
}

TEST(SamplePlaces, ExchangedOnesComeOutExchanged) {
  const Inference found = InferOf("mutant:samples-exchanged-under-vulkan");
  ASSERT_TRUE(found.Fits());
  EXPECT_FALSE(found.Agrees());
  SamplePattern exchanged = *StandardPattern(4);
  std::swap(exchanged.locations[0], exchanged.locations[3]);
  EXPECT_EQ(found.remaining.front().pattern, exchanged);
}

TEST(SamplePlaces, SharedOnesAreNamed) {
  const Inference found = InferOf("mutant:samples-one-reused");
  ASSERT_TRUE(found.sample_places);
  EXPECT_EQ(found.sample_places->sharing, (std::array<int, 2>{1, 2}));
  EXPECT_FALSE(found.sample_places->varying);
}

TEST(SamplePlaces, VaryingOnesAreShownInTwoPixels) {
  for (const std::string_view name : {"mutant:samples-vary", "legal:samples-vary-under-gl"}) {
    if (kOneCaseIn > 1 && name.starts_with("legal:")) continue;
    const Inference found = InferOf(name);
    EXPECT_FALSE(found.Fits()) << name;
    ASSERT_TRUE(found.sample_places) << name;
    ASSERT_TRUE(found.sample_places->varying) << name;
    const auto& [a, b] = found.sample_places->varying->seen;
    EXPECT_NE(a.column % 2, b.column % 2) << name;
    EXPECT_EQ(PlacesText(*found.sample_places).back(),
              "positions vary: sample 0 lies in pixel (0, 0) at x 12/32 to 13/32, y 4/32 to 5/32, "
              "in pixel (1, 0) at x 20/32 to 21/32, y 4/32 to 5/32")
        << name;
  }
}

}  // namespace
}  // namespace rasterproof::props
