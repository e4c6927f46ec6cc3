// A rasterizer that never draws one side, and states so, is held to it; and nothing else of it is
// held against it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/coverage.h"
#include "core/draw_options.h"
#include "core/profile.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "exact/placed_scene.h"
#include "legal/alone.h"
#include "props/infer/infer.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/property_domains.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::uint64_t kCullSeed = 1;

SubjectInfo Stating(SubjectInfo info, Cull culls) {
  info.profile.culls = culls;
  return info;
}

// The triangles that do not show the side, by a model that culls nothing.
std::vector<Triangle> Kept(const Scene& scene, const Profile& model, Cull side) {
  Profile both = model;
  both.culls = Cull::kNone;
  const exact::PlacedScene placed(scene, both);
  std::vector<Triangle> kept;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    const bool shows = placed.facings[t] == (side == Cull::kFront ? 1 : -1);
    if (side == Cull::kNone || !shows) kept.push_back(scene.triangles[t]);
  }
  return kept;
}

// What the oracle draws of a list from which the side's triangles were taken. `really`: the side.
FakeSubject Draws(const SubjectInfo& info, const Profile& model, Cull really) {
  return {info, [model, really, kind = info.coverage](
                    const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            Profile both = model;
            both.culls = Cull::kNone;
            Scene drawn = scene;
            drawn.triangles = Kept(scene, model, really);
            if (exact::WhyNotDecided({drawn, both})) return;
            const CoverageCounts more = exact::Coverage(drawn, both, options);
            for (std::size_t k = 0; k < counts.size(); ++k) {
              const bool tells = kind == CoverageKind::kFacingCounts;
              counts.front[k] += tells ? more.front[k] : more.Count(k);
              counts.back[k] += tells ? more.back[k] : 0;
              if (kind == CoverageKind::kMask) counts.front[k] = counts.front[k] != 0 ? 1 : 0;
            }
          }};
}

struct Culling {
  std::string what;
  SubjectInfo info;
  Profile model;  ///< one that the profile allows
};

Culling Of(std::string what, const SubjectInfo& info) {
  return {std::move(what), info, info.profile};
}

// Profiles of every contract and freedom, and subjects of several kinds.
std::vector<Culling> Cullings() {
  std::vector<Culling> all;
  all.push_back(Of("eight bits, backs", Stating(SnappedInfo(8), Cull::kBack)));
  all.push_back(Of("real, fronts", Stating(RealInfo(), Cull::kFront)));
  SubjectInfo info = Stating(SnappedInfo(4), Cull::kFront);
  info.profile.y_axis = YAxis::kUp;
  info.coverage = CoverageKind::kCounts;
  all.push_back(Of("y up, counts", info));
  info = Stating(SnappedInfo(8), Cull::kBack);
  info.coverage = CoverageKind::kMask;
  all.push_back(Of("mask", info));
  info = Stating(RealInfo(), Cull::kBack);
  info.takes_window = false;
  info.takes_clip = true;
  all.push_back(Of("clip space", info));
  info = Stating(SnappedInfo(8), Cull::kBack);
  info.profile.max_primitive_extent = MaxPrimitiveExtent{64, 32};
  info.profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
  all.push_back(Of("extent", info));
  for (const Contract contract : {Contract::kWatertight, Contract::kClosed, Contract::kAtLeastModel,
                                  Contract::kAtMostModel}) {
    info = Stating(SnappedInfo(8), Cull::kBack);
    info.profile.contract = contract;
    all.push_back(Of("a contract", info));
    info = Stating(RealInfo(), Cull::kFront);
    info.profile.contract = contract;
    info.takes_clip = true;
    all.push_back(Of("a contract, real", info));
  }
  // Legal sets, drawn by one of their models: floor, and bottom-right.
  for (const std::string_view set : {"d3d11", "vulkan", "webgpu"}) {
    info = Stating(SnappedInfo(8), Cull::kBack);
    info.profile = *PresetProfile(set);
    info.profile.name = "culls";
    info.profile.front_face = FrontFace::kPositiveArea;
    info.profile.culls = Cull::kBack;
    info.profile.guard_band.reset();
    Culling culling = Of(std::string(set), info);
    culling.model = SnappedInfo(8).profile;
    if (set != "d3d11") {
      culling.model.snap.rule = SnapRule::kFloor;
      culling.model.tie_rule = kConsistentRules[3];
    }
    all.push_back(culling);
  }
  for (const std::string_view preset : {"d3d12-conservative-1", "gdal-all-touched"}) {
    info = SnappedInfo(8);
    info.profile = *PresetProfile(preset);
    info.profile.name = "culls";
    info.profile.culls = Cull::kBack;
    all.push_back(Of(std::string(preset), info));
  }
  return all;
}

TEST(Culls, HoldsInEveryPropertyWhereItIsStated) {
  for (const Culling& culling : Cullings()) {
    FakeSubject subject = Draws(culling.info, culling.model, culling.info.profile.culls);
    int exercised = 0;
    for (const Property& property : Catalog()) {
      if (DomainsFor(culling.info, property).empty()) continue;
      for (std::uint64_t i = 0; i < Cases<std::uint64_t>(24); ++i) {
        const Case c = DrawCase(culling.info, property, kCullSeed, i);
        const Verdict verdict = RunCase(subject, property, c);
        ASSERT_NE(verdict.outcome, Outcome::kViolated)
            << culling.what << ", " << property.name << ", case " << i << ": " << verdict.message;
        exercised += verdict.outcome == Outcome::kHolds ? 1 : 0;
      }
    }
    EXPECT_GT(exercised, 0) << culling.what;
  }
}

bool IsFound(FakeSubject subject, const std::string& property) {
  CampaignOptions options;
  options.seed = kCullSeed;
  options.cases = 100;
  options.shrink_budget = 20;
  return RunCampaign(subject, *FindProperty(property), options).outcome == Outcome::kViolated;
}

// The property that speaks of single triangles under the profile.
std::string JudgeOf(const Profile& profile) {
  if (profile.contract == Contract::kSquares) return "SquaresOutsideTheMayRegionStayFree";
  if (profile.contract == Contract::kWatertight) return "EmbeddedMeshSamplesAreCoveredOnce";
  if (profile.contract != Contract::kSampleExact) return "CoverageKeepsToItsSideOfTheModel";
  return HasOneModel(profile) ? "CoverageEqualsTheModel" : "OneLegalModelExplainsTheMesh";
}

TEST(Culls, IsViolatedByWhatDrawsTheSideAllTheSame) {
  for (const Culling& culling : Cullings()) {
    const Profile& stated = culling.info.profile;
    if (stated.contract == Contract::kClosed) continue;  // its surfaces are not closed any more
    std::string judge = JudgeOf(stated);
    if (!culling.info.takes_window) judge = "ClipSpaceCoverageEqualsTheModel";
    EXPECT_TRUE(IsFound(Draws(culling.info, culling.model, Cull::kNone), judge)) << culling.what;
    const Cull other = stated.culls == Cull::kFront ? Cull::kBack : Cull::kFront;
    EXPECT_TRUE(IsFound(Draws(culling.info, culling.model, other), judge)) << culling.what;
  }
}

TEST(Culls, IsViolatedWhereItIsNotStated) {
  for (const Cull side : {Cull::kFront, Cull::kBack}) {
    const SubjectInfo info = SnappedInfo(8);
    EXPECT_TRUE(IsFound(Draws(info, info.profile, side), "CoverageEqualsTheModel"));
    EXPECT_TRUE(IsFound(Draws(info, info.profile, side), "ReversalSwapsFacing"));
  }
}

// Its area as given and its area on the grid of whole pixels have opposite signs.
TEST(Culls, GoesByTheFacingAfterTheSnap) {
  Scene scene;
  scene.width = scene.height = 8;
  scene.vertices = {{0, 0}, {4, 4.4375}, {8, 8.75}};
  scene.triangles = {{0, 1, 2}};
  Profile profile;
  const int given = exact::PlacedScene(scene, profile).facings[0];
  profile.snap = {0};
  const int snapped = exact::PlacedScene(scene, profile).facings[0];
  ASSERT_EQ(given, -snapped);
  for (const Cull side : {Cull::kFront, Cull::kBack}) {
    profile.culls = side;
    const exact::PlacedScene placed(scene, profile);
    const bool culled = snapped == (side == Cull::kFront ? 1 : -1);
    EXPECT_EQ(placed.culled.size(), culled ? 1U : 0U);
    EXPECT_EQ(placed.facings[0], culled ? 0 : snapped);
  }
}

// A draw that asks for the other side to be culled leaves nothing; each decider agrees.
TEST(Culls, CombinesWithWhatADrawAsksFor) {
  Scene scene;
  scene.width = scene.height = 4;
  scene.vertices = {{0, 0}, {4, 0}, {0, 4}};
  scene.triangles = {{0, 1, 2}, {0, 2, 1}};
  for (const exact::Decider decider : {exact::Decider::kFast, exact::Decider::kIntegers}) {
    for (const YAxis axis : {YAxis::kDown, YAxis::kUp}) {
      Profile profile;
      profile.y_axis = axis;
      const CoverageCounts both = exact::Coverage(scene, profile, {}, decider);
      ASSERT_NE(both, CoverageCounts(4, 4));
      profile.culls = Cull::kBack;
      CoverageCounts fronts = both;
      fronts.back.assign(fronts.back.size(), 0);
      EXPECT_EQ(exact::Coverage(scene, profile, {}, decider), fronts);
      DrawOptions options;
      options.cull = Cull::kBack;
      EXPECT_EQ(exact::Coverage(scene, profile, options, decider), fronts);
      options.cull = Cull::kFront;
      const CoverageCounts none(4, 4);
      EXPECT_EQ(exact::Coverage(scene, profile, options, decider), none);
    }
  }
}

// By itself: of one model, of a legal set, and of a margin that the contract allows.
TEST(Culls, LeavesNothingThatATriangleMayCover) {
  Scene scene;
  scene.width = scene.height = 4;
  scene.vertices = {{0, 0}, {4, 0}, {0, 4}};
  scene.triangles = {{0, 1, 2}, {0, 2, 1}};
  Profile set = *PresetProfile("vulkan");
  set.front_face = FrontFace::kPositiveArea;
  set.guard_band.reset();
  Profile at_least;
  at_least.contract = Contract::kAtLeastModel;
  for (Profile profile : {Profile{}, set, at_least}) {
    profile.culls = Cull::kBack;
    const auto decided = legal::DecideAlone(scene, profile);
    const std::size_t back = exact::PlacedScene(scene, Profile{}).facings[0] < 0 ? 0 : 1;
    EXPECT_TRUE(decided[back].must.empty() && decided[back].may.empty());
    EXPECT_FALSE(decided[1 - back].must.empty());
  }
}

TEST(Culls, IsFoundByInfer) {
  for (const YAxis axis : {YAxis::kDown, YAxis::kUp}) {
    for (const Cull side : {Cull::kFront, Cull::kBack}) {
      for (const CoverageKind kind : {CoverageKind::kFacingCounts, CoverageKind::kCounts}) {
        SubjectInfo info = SnappedInfo(4);
        info.coverage = kind;
        Profile model = info.profile;
        model.y_axis = axis;
        FakeSubject subject = Draws(info, model, side);
        const Inference inference = Infer(subject, {.checks = 60});
        ASSERT_TRUE(inference.Fits()) << inference.message;
        EXPECT_FALSE(inference.Agrees());
        for (const Profile& found : inference.remaining) {
          EXPECT_EQ(found.culls, side);
          EXPECT_EQ(found.y_axis, axis);
          EXPECT_EQ(found.snap.bits, 4);
        }
      }
    }
  }
}

// Draws no triangle in a box of `least` pixels or less while it culls.
FakeSubject LosesTinyWhileItCulls(double least) {
  const SubjectInfo info = SnappedInfo(8);
  return {info, [profile = info.profile, least](const Scene& scene, const DrawOptions& options,
                                                CoverageCounts& counts) {
            Scene drawn = scene;
            std::erase_if(drawn.triangles, [&](const Triangle& t) {
              const auto v = Corners(scene, t);
              const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
              const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
              return options.cull != Cull::kNone && right - left <= least && bottom - top <= least;
            });
            counts += exact::Coverage(drawn, profile, options);
          }};
}

TEST(Culling, OfTrianglesUnderAPixelIsAskedFor) {
  const Property& property = *FindProperty("CullingRemovesOneFacing");
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CampaignOptions options;
    options.cases = 1000;
    options.seed = seed;
    FakeSubject tiny = LosesTinyWhileItCulls(0x1p-3);
    EXPECT_EQ(RunCampaign(tiny, property, options).outcome, Outcome::kViolated) << seed;
    options.cases = 300;
    FakeSubject none = LosesTinyWhileItCulls(-1);
    EXPECT_EQ(RunCampaign(none, property, options).outcome, Outcome::kHolds) << seed;
  }
}

TEST(Culls, AgreesWithInferWhereItIsStated) {
  const SubjectInfo info = Stating(SnappedInfo(8), Cull::kBack);
  FakeSubject subject = Draws(info, info.profile, Cull::kBack);
  const Inference inference = Infer(subject, {.checks = 60});
  EXPECT_TRUE(inference.Fits()) << inference.message;
  EXPECT_TRUE(inference.Agrees());
  FakeSubject draws_both = Draws(info, info.profile, Cull::kNone);
  const Inference other = Infer(draws_both, {.checks = 60});
  EXPECT_TRUE(other.Fits()) << other.message;
  EXPECT_FALSE(other.Agrees());
}

}  // namespace
}  // namespace rasterproof::props
