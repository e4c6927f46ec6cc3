// Small worlds: every case is there once, a sound subject holds in all, a bug of one case is found.
#include "props/domains/worlds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "core/error.h"
#include "exact/coverage.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

PropertyResult Exhaust(Subject& subject, std::string_view world, std::string_view property) {
  CampaignOptions options;
  options.world = FindWorld(world);
  options.cases = options.world->cases;
  return RunCampaign(subject, *FindProperty(property), options);
}

// The vertices and the triangles, as one text.
std::string ContentOf(const Case& c) {
  std::string text;
  for (const Vertex& v : c.scene.vertices) {
    text += std::to_string(v.x) + " " + std::to_string(v.y) + ";";
  }
  for (const Triangle& t : c.scene.triangles) {
    for (const std::int32_t index : t) text += std::to_string(index) + " ";
  }
  return text;
}

TEST(Worlds, AreOrderedByTheirCasesAndNameProperties) {
  for (const World& world : Worlds()) {
    EXPECT_EQ(FindWorld(world.name), &world);
    EXPECT_EQ(FindDomain(world.name), nullptr);  // a case's name says which it is
    EXPECT_FALSE(world.properties.empty());
    for (const std::string_view name : world.properties) EXPECT_NE(FindProperty(name), nullptr);
  }
  EXPECT_EQ(FindWorld("triangles-7x7")->cases, 117'649U);
  EXPECT_EQ(FindWorld("pairs-7x7")->cases, 5'764'801U);
  EXPECT_EQ(FindWorld("fans-4x4")->cases, 268'435'456U);
  EXPECT_EQ(FindWorld("near-edge"), nullptr);
}

TEST(Worlds, HoldEveryCaseOnce) {
  for (const std::string_view name : {"pairs-3x3", "pairs-4x4"}) {
    const World& world = *FindWorld(name);
    std::set<std::string> seen;
    for (std::uint64_t k = 0; k < world.cases; ++k) {
      seen.insert(ContentOf(CaseOfWorld(world, k, RealInfo())));
    }
    EXPECT_EQ(seen.size(), world.cases) << name;
  }
}

// Nothing of a case is left to chance, and all subjects are given the same.
TEST(Worlds, AskPlainDrawsOfEverySubject) {
  const World& world = *FindWorld("fans-3x3");
  for (const std::uint64_t k : {std::uint64_t{0}, std::uint64_t{1'234'567}, world.cases - 1}) {
    const Case c = CaseOfWorld(world, k, RealInfo());
    EXPECT_EQ(c.options, DrawOptions());
    EXPECT_EQ(c.scene.triangles.size(), 6U);
    EXPECT_EQ(c.scene.vertices.size(), 7U);
    EXPECT_EQ(ContentOf(c), ContentOf(CaseOfWorld(world, k, SnappedInfo(1))));
    EXPECT_EQ(ContentOf(c), ContentOf(CaseOfWorld(world, k, RealInfo(Precision::kFloat64))));
  }
}

TEST(Worlds, AreGivenOnlyWhereTheGridIsTaken) {
  const World& world = *FindWorld("triangles-7x7");
  EXPECT_EQ(WhyNotGiven(world, SnappedInfo(1)), "");
  EXPECT_NE(WhyNotGiven(world, SnappedInfo(0)), "");
  SubjectInfo near = RealInfo();
  near.profile.coordinate_limit = 3;
  EXPECT_EQ(WhyNotGiven(world, near), "");
  near.profile.coordinate_limit = 2.75;
  EXPECT_NE(WhyNotGiven(world, near), "");
  SubjectInfo transforms = RealInfo();
  transforms.profile.transform.emplace();
  EXPECT_NE(WhyNotGiven(world, transforms), "");

  FakeSubject coarse = testing::Sound(SnappedInfo(0));
  const PropertyResult result = Exhaust(coarse, "pairs-3x3", "SharedEdgeSamplesAreCoveredOnce");
  EXPECT_EQ(result.outcome, Outcome::kNotApplicable) << result.message;
}

TEST(Worlds, AreExhaustedBySoundSubjects) {
  for (const SubjectInfo& info : {RealInfo(), SnappedInfo(8)}) {
    FakeSubject sound = testing::Sound(info);
    for (const std::string_view world : {"pairs-3x3", "pairs-4x4"}) {
      if (kOneCaseIn > 1 && world == "pairs-4x4") continue;
      const PropertyResult result = Exhaust(sound, world, "CoverageEqualsTheModel");
      EXPECT_TRUE(IsExhausted(result)) << result.message;
      EXPECT_EQ(result.cases, FindWorld(world)->cases);
      EXPECT_GT(result.cases_exercised, result.cases / 2);
    }
  }
}

// One triangle of 117,649 is drawn wrong: a world has it, and cases drawn by chance do not.
TEST(Worlds, ShowABugOfASingleCase) {
  constexpr std::uint64_t kNumber = 77'777;
  const SubjectInfo info = RealInfo();
  const Case only = CaseOfWorld(*FindWorld("triangles-7x7"), kNumber, info);
  FakeSubject bug(
      info, [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        const bool is_it = scene.vertices == only.scene.vertices && scene.width == only.scene.width;
        if (!is_it) counts = exact::Coverage(scene, info.profile, options);
      });
  const PropertyResult result = Exhaust(bug, "triangles-7x7", "CoverageEqualsTheModel");
  EXPECT_EQ(result.outcome, Outcome::kViolated) << result.message;
  EXPECT_EQ(result.counterexample->failing_case, "triangles-7x7:77777@0");
  EXPECT_EQ(result.cases, kNumber + 1);
  EXPECT_FALSE(IsExhausted(result));

  CampaignOptions drawn;
  drawn.cases = Cases<std::uint64_t>(1000);
  EXPECT_EQ(RunCampaign(bug, *FindProperty("CoverageEqualsTheModel"), drawn).outcome,
            Outcome::kHolds);
}

// A cut of one kind of number, and the world that shows it.
struct Cut {
  std::string_view what;
  std::string_view world;
  std::function<Scene(Scene)> cut;
};

// Each function below keeps the low bits of one kind of number of the scene.
Scene CutIndices(Scene scene) {
  for (Triangle& t : scene.triangles) {
    for (std::int32_t& index : t) index &= 0xffff;
  }
  return scene;
}

Scene CutTriangles(Scene scene) {
  for (std::size_t k = 0x10000; k < scene.triangles.size(); ++k) {
    scene.triangles[k] = scene.triangles[k & 0xffff];
  }
  return scene;
}

Scene CutColumns(Scene scene) {
  for (Vertex& v : scene.vertices) v.x = std::fmod(v.x, 0x1p14);
  return scene;
}

Scene CutRows(Scene scene) {
  for (Vertex& v : scene.vertices) v.y = std::fmod(v.y, 0x1p14);
  return scene;
}

TEST(Worlds, OfSizesShowNumbersThatAreCutOff) {
  const SubjectInfo info = SnappedInfo(8);
  const auto uncut = [](Scene scene) { return scene; };
  for (const Cut& one : {Cut{"no cut", "long-lists", uncut},
                         {"no cut", "long-targets", uncut},
                         {"vertex indices", "long-lists", CutIndices},
                         {"numbers of triangles", "long-lists", CutTriangles},
                         {"columns", "long-targets", CutColumns},
                         {"rows", "long-targets", CutRows}}) {
    // The same paths as without a cut, and half a minute under sanitizers.
    if (kOneCaseIn > 1 && one.world == "long-lists" && one.what != "no cut") continue;
    FakeSubject subject(
        info, [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
          counts = exact::Coverage(one.cut(scene), info.profile, options);
        });
    CampaignOptions options;
    options.world = FindWorld(one.world);
    // Those with a cut end with the case that shows it.
    options.cases = one.what == "no cut" ? Cases(options.world->cases) : options.world->cases;
    options.shrink_budget = 0;
    const PropertyResult result =
        RunCampaign(subject, *FindProperty("CoverageEqualsTheModel"), options);
    EXPECT_EQ(result.outcome, one.what == "no cut" ? Outcome::kHolds : Outcome::kViolated)
        << one.what << " on " << one.world << ": " << result.message;
  }
}

TEST(Worlds, HaveCasesThatAreKnownByTheirNames) {
  const Case c = DrawCase(RealInfo(), ParseCaseName("triangles-7x7:117648@0"));
  EXPECT_EQ(c.origin, "triangles-7x7:117648@0");
  EXPECT_EQ(c.scene.vertices[0].x, 3);
  EXPECT_EQ(c.scene.vertices[0].y, 3);
  for (const std::string_view name : {"triangles-7x7:117649@0", "triangles-7x7:1@1"}) {
    EXPECT_THROW(DrawCase(RealInfo(), ParseCaseName(name)), InputError) << name;
  }
  EXPECT_THROW(DrawCase(SnappedInfo(0), ParseCaseName("pairs-3x3:1@0")), InputError);
}

}  // namespace
}  // namespace rasterproof::props
