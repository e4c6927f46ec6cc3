// A library in this very process, and what it may do to it.
#include "subjects/plugin/plugin.h"

#include <gtest/gtest.h>

#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/drawing.h"
#include "core/error.h"

namespace rasterproof::subjects {
namespace {

// Counts 1 where it finds its own rounding mode, which it sets in its first call.
constexpr const char* kRounds = TEST_PLUGINS "/buggy_ROUNDS.so";

TEST(Plugin, KeepsItsRoundingModeToItself) {
  ASSERT_EQ(std::fegetround(), FE_TONEAREST);
  const LoadedPlugin loaded = LoadPlugin(kRounds);
  EXPECT_EQ(DrawOne(*loaded.subject, {}).counts.front[0], 0U);
  EXPECT_EQ(std::fegetround(), FE_TONEAREST) << "who judges is not to round as it does";
  EXPECT_EQ(DrawOne(*loaded.subject, {}).counts.front[0], 1U) << "it is drawn with as it is";
  EXPECT_EQ(std::fegetround(), FE_TONEAREST);
}

// A program that draws from one buffer gives other vertices at the same address. One that keeps
// images by addresses shows that they are reused here.
TEST(Plugin, IsGivenOtherVerticesAtTheSameAddresses) {
  const LoadedPlugin loaded = LoadPlugin(TEST_PLUGINS "/shown_KEEPS_BY_ADDRESSES.so");
  Scene scene;
  scene.width = scene.height = 4;
  scene.vertices = {{-9, -9}, {-9, 30}, {30, -9}};
  scene.triangles = {{0, 1, 2}};
  const Drawing covered = DrawOne(*loaded.subject, {scene, {}, 1});
  ASSERT_NE(covered.counts.front[0] + covered.counts.back[0], 0U);
  for (Vertex& v : scene.vertices) v.x += 1000;
  EXPECT_EQ(DrawOne(*loaded.subject, {scene, {}, 1}).counts, covered.counts) << "what it kept";
  const LoadedPlugin sound = LoadPlugin(TEST_PLUGINS "/shown_FACING_COUNTS.so");
  EXPECT_NE(DrawOne(*sound.subject, {scene, {}, 1}).counts, covered.counts);
}

TEST(Plugin, IsNotGivenTargetsThatNobodyTakes) {
  const LoadedPlugin loaded = LoadPlugin(kRounds);
  Scene wide;
  wide.width = 16384;
  wide.height = 16384;
  const DrawJob large(wide, {}, 4);
  EXPECT_THROW(DrawOne(*loaded.subject, large), SubjectStop);
}

// Returns a job for a triangle that covers the target, the second of its scene.
DrawJob SecondOfTwo(Outputs wants) {
  Scene scene;
  scene.width = scene.height = 4;
  scene.vertices = {{-9, -9, 0.5}, {-9, 30, 0.5}, {30, -9, 0.5}};
  scene.triangles = {{0, 0, 0}, {0, 1, 2}};
  DrawJob job(scene, {}, 1);
  job.triangles = {scene.triangles[1]};
  job.wants = wants;
  return job;
}

TEST(Plugin, IsAskedForWhatIsWantedIfItSaysThatItReadsIt) {
  for (const char* const name : {"/shown_FRAGMENTS.so", "/shown_NEEDS_ALL.so"}) {
    const LoadedPlugin loaded = LoadPlugin(std::string(TEST_PLUGINS) + name);
    const Drawing all = DrawOne(*loaded.subject, SecondOfTwo(kEverything));
    EXPECT_EQ(all.primitive_ids, std::vector<std::int32_t>(16, 0)) << "of the triangles of the job";
    ASSERT_EQ(all.depths.size(), 16U);
    EXPECT_EQ(all.depths[0], 0.5);
    EXPECT_EQ(all.barycentrics.size(), 16U);
    const Drawing ids = DrawOne(*loaded.subject, SecondOfTwo(kCoverageAndPrimitiveIds));
    EXPECT_EQ(ids.primitive_ids, all.primitive_ids);
    EXPECT_TRUE(ids.barycentrics.empty() && ids.depths.empty());
    const Drawing depths = DrawOne(*loaded.subject, SecondOfTwo({true, false, true}));
    EXPECT_EQ(depths.depths, all.depths);
    EXPECT_TRUE(depths.barycentrics.empty());
  }
}

TEST(Plugin, IsAskedForCentroidsIfItShowsThemAndTheyAreWanted) {
  Outputs wants = kCoverageAndPrimitiveIds;
  wants.centroids = true;
  const LoadedPlugin shows = LoadPlugin(TEST_PLUGINS "/shown_CENTROIDS.so");
  EXPECT_TRUE(shows.subject->Info().fragments.shows_centroids);
  const Drawing drawing = DrawOne(*shows.subject, SecondOfTwo(wants));
  ASSERT_EQ(drawing.centroids.size(), 16U);
  EXPECT_EQ(drawing.centroids, DrawOne(*shows.subject, SecondOfTwo(kEverything)).barycentrics);
  EXPECT_TRUE(drawing.barycentrics.empty() && drawing.depths.empty());
  EXPECT_TRUE(DrawOne(*shows.subject, SecondOfTwo(kEverything)).centroids.empty());
  // One of a header that had none is never asked.
  const LoadedPlugin older = LoadPlugin(TEST_PLUGINS "/shown_FRAGMENTS.so");
  EXPECT_FALSE(older.subject->Info().fragments.shows_centroids);
  EXPECT_TRUE(DrawOne(*older.subject, SecondOfTwo(wants)).centroids.empty());
  EXPECT_THROW(LoadPlugin(TEST_PLUGINS "/shown_CENTROIDS_OF_COUNTS.so"), InputError);
}

// As SecondOfTwo, with channels.
DrawJob WithChannels(bool wants_derivatives) {
  DrawJob job = SecondOfTwo(kCoverageAndPrimitiveIds);
  Scene scene = *job.scene;
  scene.channels = {{.name = "u", .values = {1, 2, 3}},
                    {"q", Interpolation::kInverseW, EvaluatedAt::kSample, {}},
                    {"id", Interpolation::kFlat, EvaluatedAt::kSample, {7, 8, 9}}};
  job.scene = std::make_shared<const Scene>(scene);
  job.wants.values = true;
  job.wants.derivatives = wants_derivatives;
  return job;
}

TEST(Plugin, IsGivenChannelsIfItShowsValuesAndTheyAreWanted) {
  const LoadedPlugin shows = LoadPlugin(TEST_PLUGINS "/shown_VALUES.so");
  EXPECT_TRUE(shows.subject->Info().fragments.shows_values);
  EXPECT_TRUE(shows.subject->Info().fragments.shows_derivatives);
  for (const bool derivatives : {false, true}) {
    const Drawing drawing = DrawOne(*shows.subject, WithChannels(derivatives));
    ASSERT_EQ(drawing.values.size(), 3U * 16U);
    ASSERT_EQ(drawing.derivatives.size(), derivatives ? 3U * 16U : 0U);
    EXPECT_TRUE(drawing.barycentrics.empty());
    for (std::size_t at = 0; at < 16; ++at) {  // the corners are 39 pixels apart
      const auto x = static_cast<double>(at % 4) + 9.5;
      const auto y = static_cast<double>(at / 4) + 9.5;
      EXPECT_NEAR(drawing.values[3 * at], 1 + (y + 2 * x) / 39, 1e-14);
      EXPECT_NEAR(drawing.values[3 * at + 1], 1, 1e-14);
      EXPECT_NEAR(drawing.values[3 * at + 2], 7, 1e-14);
      if (!derivatives) continue;
      EXPECT_NEAR(drawing.derivatives[3 * at][0], 2.0 / 39, 1e-14);
      EXPECT_NEAR(drawing.derivatives[3 * at][1], 1.0 / 39, 1e-14);
      EXPECT_NEAR(drawing.derivatives[3 * at + 1][0], 0, 1e-14);
    }
  }
  // It refuses a draw that gives it channels beside no values, or the other way round.
  DrawJob unasked = WithChannels(false);
  unasked.wants.values = false;
  EXPECT_TRUE(DrawOne(*shows.subject, unasked).values.empty());
  DrawJob none = SecondOfTwo(kEverything);
  none.wants.values = none.wants.derivatives = true;
  EXPECT_TRUE(DrawOne(*shows.subject, none).values.empty());
  const std::vector<DrawJob> both{WithChannels(true), unasked};
  const std::vector<DrawOutcome> outcomes = shows.subject->DrawMany(both);
  ASSERT_EQ(outcomes.size(), 2U);
  EXPECT_EQ(outcomes[0].Get().values.size(), 48U);
  EXPECT_TRUE(outcomes[1].Get().values.empty());
  // One of a header that had none is never asked.
  const LoadedPlugin older = LoadPlugin(TEST_PLUGINS "/shown_FRAGMENTS.so");
  EXPECT_FALSE(older.subject->Info().fragments.shows_values);
  EXPECT_TRUE(DrawOne(*older.subject, WithChannels(true)).values.empty());
}

TEST(Plugin, ThatWritesOutsideItsValuesBreaksDown) {
  const LoadedPlugin outside = LoadPlugin(TEST_PLUGINS "/shown_VALUES_OUTSIDE.so");
  try {
    DrawOne(*outside.subject, WithChannels(false));
    ADD_FAILURE() << "it wrote past its last row";
  } catch (const SubjectStop& stop) {
    EXPECT_NE(std::string(stop.what()).find("wrote outside its target"), std::string::npos);
  }
}

TEST(Plugin, ThatContradictsItselfIsRefused) {
  const auto refused = [](const std::string& name, const std::string& remedy) {
    try {
      LoadPlugin(TEST_PLUGINS "/shown_" + name + ".so");
      ADD_FAILURE() << name;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(remedy), std::string::npos) << error.what();
    }
  };
  refused("VALUES_OF_COUNTS", "set coverage to RASTERPROOF_FRAGMENTS");
  refused("DERIVATIVES_ALONE", "set RASTERPROOF_SHOWS_VALUES too");
  EXPECT_FALSE(LoadPlugin(TEST_PLUGINS "/shown_OLD_SIZE.so").subject->Info().takes_batches);
}

TEST(Plugin, DrawsPartsOfASharedSceneLikeScenesOfTheirOwn) {
  const LoadedPlugin loaded = LoadPlugin(TEST_PLUGINS "/shown_COUNTS.so");
  const DrawJob part = SecondOfTwo(kEverything);
  DrawJob both = part;
  both.triangles.reset();
  const std::vector<DrawJob> shared{part, both, part};
  std::vector<DrawJob> apart;
  for (const DrawJob& job : shared) apart.emplace_back(SceneOf(job), job.options, job.samples);
  const std::vector<DrawOutcome> a = loaded.subject->DrawMany(shared);
  const std::vector<DrawOutcome> b = loaded.subject->DrawMany(apart);
  ASSERT_EQ(a.size(), 3U);
  for (std::size_t k = 0; k < a.size(); ++k) {
    EXPECT_EQ(a[k].Get().counts, b[k].Get().counts);
    EXPECT_EQ(a[k].Get().counts, DrawOne(*loaded.subject, shared[k]).counts);
  }
}

}  // namespace
}  // namespace rasterproof::subjects
