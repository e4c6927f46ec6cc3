#include "props/run/own_transform.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "core/transform.h"
#include "gtest/gtest.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"
#include "subjects/mutants/mutants.h"
#include "tests/props/planted_subjects.h"

namespace rasterproof::props {
namespace {

PropertyResult Campaign(const std::string& subject, const char* property, std::uint64_t cases) {
  const std::unique_ptr<Subject> made = subjects::MakeMutant(subject);
  CampaignOptions options;
  options.cases = cases;
  return RunCampaign(*made, *FindProperty(property), options);
}

TEST(OwnTransform, IsJudgedByItsOperations) {
  for (const char* const variant : {"quotients", "multiply-add", "fused", "add-multiply"}) {
    const auto result =
        Campaign("legal:transform-" + std::string(variant), "CoverageEqualsTheModel", 400);
    EXPECT_EQ(result.outcome, Outcome::kHolds) << variant << ": " << result.message;
    EXPECT_GT(result.near_edge.on_edge, 0U) << variant;
  }
}

TEST(OwnTransform, AnotherRoundingIsFoundAndShrunk) {
  const auto result = Campaign("mutant:transform-reciprocal", "CoverageEqualsTheModel", 1000);
  ASSERT_EQ(result.outcome, Outcome::kViolated);
  const Scene& scene = result.counterexample->scene;
  EXPECT_TRUE(scene.clip_space);
  EXPECT_EQ(scene.triangles.size(), 1U);
}

TEST(OwnTransform, PropertiesThatMoveVerticesDoNotApply) {
  const auto result =
      Campaign("legal:transform-multiply-add", "IntegerTranslationMovesCoverage", 20);
  EXPECT_NE(result.outcome, Outcome::kViolated) << result.message;
}

// What shares a place in the window shares it in clip space, or meshes would come apart.
TEST(OwnTransform, VerticesOfOnePlaceStayTogether) {
  const SubjectInfo info = subjects::MakeMutant("legal:transform-add-multiply")->Info();
  int shared = 0;
  for (std::uint64_t index = 0; index < 50; ++index) {
    PhiloxSource bits(1, index);
    const Case window = FindDomain("fans")->draw(bits, AsSeenByRecipes(info));
    const Case clip = PutBehindTransform(window, info, bits);
    ASSERT_EQ(clip.scene.vertices.size(), window.scene.vertices.size());
    std::map<std::array<double, 2>, Vertex> clip_of;
    for (std::size_t k = 0; k < window.scene.vertices.size(); ++k) {
      const Vertex& v = window.scene.vertices[k];
      const auto [found, is_new] = clip_of.try_emplace({v.x, v.y}, clip.scene.vertices[k]);
      EXPECT_EQ(found->second.x, clip.scene.vertices[k].x);
      EXPECT_EQ(found->second.w, clip.scene.vertices[k].w);
      if (!is_new) ++shared;
    }
  }
  EXPECT_GT(shared, 0);
}

}  // namespace
}  // namespace rasterproof::props
