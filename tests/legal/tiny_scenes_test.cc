// Flat and thin triangles on tiny targets: every door to the law against a search through all legal
// models.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "core/profile.h"
#include "core/scene.h"
#include "exact/placed_scene.h"
#include "io/profile_json.h"
#include "kit/rasterproof_oracle.h"
#include "legal/allowed.h"
#include "legal/decided.h"
#include "legal/joint.h"
#include "props/property.h"
#include "tests/legal/all_models.h"
#include "tests/share.h"

namespace rasterproof::legal {
namespace {

using testing::Draws;
using testing::ExplainsCounts;
using testing::IsJudgedAlike;
using testing::IsLegalBySearch;
using testing::Model;
using testing::NumbersBySearch;

// ---- the doors ----------------------------------------------------------------------------------

bool IsLegalByJoint(const Scene& scene, const Profile& profile, const CoverageCounts& counts) {
  Observed observed;
  observed.together = &counts;
  return JudgeJointly(scene, {profile, scene}, observed).legality == Legality::kLegal;
}

bool HoldsByCheck(const Scene& scene, const Profile& profile, const CoverageCounts& counts) {
  SubjectInfo info;
  info.input = Precision::kFloat64;
  info.profile = profile;
  info.coverage = CoverageKind::kCounts;
  const props::Description subject{info, nullptr, nullptr};
  const props::Property& property = *props::FindProperty("OneLegalModelExplainsTheMesh");
  const props::PlacedCase c =
      props::Place({scene, profile, {}, ""}, property.gate.judges_degenerates);
  const props::Checks asked = property.ask(c, subject);
  Answers answers;
  Drawing drawing;
  drawing.counts = counts;
  answers.draws.push_back(std::make_shared<const Drawing>(std::move(drawing)));
  return asked.checks.back().judge(answers).outcome != Outcome::kViolated;  // of one call
}

class OracleInC {
 public:
  OracleInC(const Scene& scene, const Profile& profile) {
    const std::string text = io::WholeProfileLine(profile);
    EXPECT_EQ(rasterproof_oracle_open(text.c_str(), &profile_), RASTERPROOF_ORACLE_OK)
        << rasterproof_oracle_message();
    for (const Vertex& v : scene.vertices) xyzw_.insert(xyzw_.end(), {v.x, v.y, v.z, v.w});
    for (const Triangle& t : scene.triangles)
      triangles_.insert(triangles_.end(), {t[0], t[1], t[2]});
    scene_.width = scene.width;
    scene_.height = scene.height;
    scene_.vertices = xyzw_.data();
    scene_.vertex_count = scene.vertices.size();
    scene_.triangles = triangles_.data();
    scene_.triangle_count = scene.triangles.size();
  }
  OracleInC(const OracleInC&) = delete;
  OracleInC& operator=(const OracleInC&) = delete;
  ~OracleInC() { rasterproof_oracle_close(profile_); }

  bool IsLegal(const CoverageCounts& counts) const {
    std::int32_t verdict = -1;
    EXPECT_EQ(rasterproof_oracle_judge(profile_, &scene_, counts.front.data(), counts.size(), 0,
                                       &verdict),
              RASTERPROOF_ORACLE_OK)
        << rasterproof_oracle_message();
    return verdict == RASTERPROOF_ORACLE_LEGAL;
  }

 private:
  rasterproof_oracle_profile* profile_ = nullptr;
  std::vector<double> xyzw_;
  std::vector<std::int32_t> triangles_;
  rasterproof_oracle_scene scene_{};
};

// ---- the search ---------------------------------------------------------------------------------

bool IsLegalBySearch(const Scene& scene, const Profile& profile, const CoverageCounts& counts) {
  return IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
    return ExplainsCounts(scene, profile, rule, model, counts);
  });
}

int ScenesToTry() { return RunsMore() ? 10000 : Cases(1500); }

TEST(TinyScenes, HaveTheCountsOfAllTheirModels) {
  Draws draws(71);
  int open = 0;
  for (int n = 0; n < ScenesToTry(); ++n) {
    const Scene scene = draws.AThinScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene)) continue;
    const Decided decided = DecidedSamples(scene, {profile, scene});
    for (std::size_t s = 0; s < decided.counts.size(); ++s) {
      ASSERT_EQ(decided.counts[s], NumbersBySearch(scene, profile, s))
          << "scene " << n << ", sample " << s;
      open += decided.IsDecided(s) ? 0 : 1;
    }
  }
  EXPECT_GT(open, ScenesToTry() / 4);
}

TEST(TinyScenes, AreLegalByEveryDoorExactlyIfSomeModelExplainsThem) {
  Draws draws(72);
  int legal = 0;
  int not_legal = 0;
  for (int n = 0; n < ScenesToTry(); ++n) {
    const Scene scene = draws.AThinScene();
    const Profile profile = draws.AProfile();
    if (!IsJudgedAlike(scene)) continue;
    const CoverageCounts counts =
        n % 2 == 0 ? draws.AMixture(scene, profile) : draws.ANearMiss(scene, profile);
    const bool expected = IsLegalBySearch(scene, profile, counts);
    ASSERT_EQ(IsLegalByJoint(scene, profile, counts), expected) << "scene " << n;
    ASSERT_EQ(HoldsByCheck(scene, profile, counts), expected) << "scene " << n;
    ASSERT_EQ(OracleInC(scene, profile).IsLegal(counts), expected) << "scene " << n;
    if (expected) {
      const Allowed allowed(exact::PlacedScene(scene, profile), {CoverageKind::kCounts});
      ASSERT_EQ(allowed.why_not(), "");
      ASSERT_TRUE(allowed.AllowsAll(counts)) << "scene " << n;
    }
    ++(expected ? legal : not_legal);
  }
  EXPECT_GT(legal, ScenesToTry() / 8);
  EXPECT_GT(not_legal, ScenesToTry() / 8);
}

// ---- one model, where flat triangles are left open ----------------------------------------------

TEST(Allowed, OfAFlatTriangleIsItsClosedSegmentOrNothing) {
  Scene scene;
  scene.width = scene.height = 8;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{0, 0}, {4, 4}, {8, 8}};
  scene.triangles = {{0, 1, 2}};
  Profile profile = *PresetProfile("gl-canonical");
  profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
  const Allowed allowed(exact::PlacedScene(scene, profile));
  for (int row = 0; row < 8; ++row) {
    for (int x = 0; x < 8; ++x) {
      CoverageCounts drawn(8, 8);
      const std::size_t k = drawn.Index(x, row);
      EXPECT_TRUE(allowed.Allows(drawn, k)) << "nothing at " << x << ", " << row;
      drawn.back[k] = 1;
      EXPECT_EQ(allowed.Allows(drawn, k), x == row) << "once at " << x << ", " << row;
      drawn.front[k] = 1;
      EXPECT_EQ(allowed.Allows(drawn, k), false) << "twice at " << x << ", " << row;
    }
  }
}

}  // namespace
}  // namespace rasterproof::legal
