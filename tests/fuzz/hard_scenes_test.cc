// Hard scenes for engines of others: drawn by name, simpler in a well-founded order, and minimal
// where RapidCheck is done.
#include "kit/hard_scenes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>

#include "core/error.h"
#include "exact/coverage.h"
#include "kit/rapidcheck.h"

namespace rasterproof::kit {
namespace {

TEST(HardScenes, AreDrawnByNameAndAreTheSameForGood) {
  for (const char* profile : {"real", "gl-canonical", "vulkan"}) {
    const auto names = HardDomains(profile);
    EXPECT_GT(names.size(), 40U) << profile;
    for (const std::string_view name : names) {
      const Scene scene = DrawHardScene(name, profile, 7);
      EXPECT_EQ(scene, DrawHardScene(name, profile, 7)) << name;
      EXPECT_FALSE(scene.clip_space) << name;
      for (const Vertex& v : scene.vertices)
        EXPECT_EQ(v.x, static_cast<double>(static_cast<float>(v.x))) << name;
    }
  }
}

TEST(HardScenes, OfNoDomainOrPresetAreRefused) {
  EXPECT_THROW(DrawHardScene("near-edges", "real", 1), InputError);
  EXPECT_THROW(DrawHardScene("perspective", "real", 1), InputError);
  EXPECT_THROW(HardDomains("gll"), InputError);
}

TEST(HardScenes, HaveSimplerOnesThatEnd) {
  Scene scene = DrawHardScene("grids", "real", 3);
  std::size_t steps = 0;
  for (auto next = SimplerScenes(scene); !next.empty(); next = SimplerScenes(scene), ++steps) {
    ASSERT_LT(steps, 2000U);
    scene = next.back();
  }
  EXPECT_TRUE(SimplerScenes(scene).empty());
}

TEST(EdgeSamples, ShrinkToTheSmallestThatStillIsOnItsEdge) {
  EdgeSample at = DrawEdgeSample("real", 5);
  for (std::uint64_t n = 0; ExactSign(at) != 0; ++n) at = DrawEdgeSample("real", n);
  for (bool is_over = false; !is_over;) {
    is_over = true;
    for (const EdgeSample& simpler : SimplerEdgeSamples(at)) {
      if (ExactSign(simpler) != 0) continue;
      at = simpler;
      is_over = false;
      break;
    }
  }
  EXPECT_EQ(ExactSign(at), 0);
  std::ostringstream out;
  showValue(at, out);
  EXPECT_LT(out.str().size(), 90U) << out.str();
}

// The last failing value that RapidCheck tried.
template <class Value>
Value Smallest(const rc::Gen<Value>& values, const std::function<bool(const Value&)>& holds) {
  Value last{};
  std::ostringstream said;
  for (std::uint64_t seed = 1; seed < 50; ++seed) {
    rc::Shrinkable<Value> tried = values(rc::Random(seed), 10);
    if (holds(tried.value())) continue;
    for (bool is_over = false; !is_over;) {
      is_over = true;
      auto simpler = tried.shrinks();
      while (auto next = simpler.next()) {
        if (holds(next->value())) continue;
        tried = *next;
        is_over = false;
        break;
      }
    }
    return tried.value();
  }
  ADD_FAILURE() << "nothing was found";
  return last;
}

TEST(Generators, ShrinkAPairToOneSampleAndTwoTriangles) {
  const Scene pair = Smallest<Scene>(PairsThatShareAnEdge(), [](const Scene& scene) {
    Profile inclusive;
    inclusive.tie_rule = {.inclusive = true};
    const CoverageCounts counts = exact::Coverage(scene, inclusive);
    for (std::size_t k = 0; k < counts.size(); ++k) {
      if (counts.Count(k) > 1) return false;
    }
    return true;
  });
  EXPECT_EQ(pair.width * pair.height, 1);
  EXPECT_EQ(pair.triangles.size(), 2U);
}

TEST(Generators, ShrinkATriangleToOneSample) {
  for (const auto& of : {HardTriangles(), Slivers(), Meshes()}) {
    const Scene scene = Smallest<Scene>(of, [](const Scene& drawn) {
      const CoverageCounts counts = exact::Coverage(drawn, Profile{});
      for (std::size_t k = 0; k < counts.size(); ++k) {
        if (counts.Count(k) != 0) return false;
      }
      return true;
    });
    EXPECT_EQ(scene.width * scene.height, 1);
    EXPECT_EQ(scene.triangles.size(), 1U);
    EXPECT_NE(SceneText(scene).find("\"rasterproof_scene\": 1"), std::string::npos);
  }
}

TEST(Generators, ShrinkAnEdgeBesideItsSample) {
  const EdgeSample at = Smallest<EdgeSample>(
      NearEdgeSamples(), [](const EdgeSample& one) { return ExactSign(one) == 0; });
  EXPECT_NE(ExactSign(at), 0);
  std::ostringstream out;
  showValue(at, out);
  EXPECT_LT(out.str().size(), 90U) << out.str();
}

}  // namespace
}  // namespace rasterproof::kit
