// Infer finds the model that was planted, and says so where there is none.
#include "props/infer/infer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "core/call_end.h"
#include "core/profile_keys.h"
#include "core/tie_rule.h"
#include "core/transform.h"
#include "exact/coverage.h"
#include "model/snap_scene.h"
#include "props/infer/directed.h"
#include "subjects/builtin/builtin.h"
#include "subjects/mutants/mutants.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;

// What is compared of a model: all but its name and what bounds verdicts only.
Profile ModelPart(Profile profile) {
  for (const ProfileKey& key : kProfileKeys) {
    if (key.kind != KeyKind::kModel && key.kind != KeyKind::kFreedom) key.member.copy({}, profile);
  }
  return profile;
}

void AddDrawn(CoverageCounts& counts, const CoverageCounts& more) {
  for (std::size_t k = 0; k < counts.size(); ++k) {
    counts.front[k] += more.front[k];
    counts.back[k] += more.back[k];
  }
}

// Draws as `model` does and states `stated`.
FakeSubject Follows(const Profile& model, const Profile& stated) {
  SubjectInfo info = RealInfo();
  info.profile = stated;
  return {info, [model](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            AddDrawn(counts, exact::Coverage(scene, model, options));
          }};
}

Profile Snapped(int bits, SnapRule rule, SnapForm form = SnapForm::kCoordinate, double origin = 0) {
  Profile profile;
  profile.snap = {bits, rule, form, origin};
  profile.coordinate_limit = 0x1p15;
  return profile;
}

std::string Describe(const Profile& p) {
  return std::to_string(p.snap.bits) + " bits, " + std::string(SnapRuleName(p.snap.rule)) + ", " +
         std::string(SnapFormName(p.snap.form)) + ", " + TieRuleName(p.tie_rule) + ", sample " +
         std::to_string(p.pattern.locations[0].x) + " " + std::to_string(p.pattern.locations[0].y) +
         (p.y_axis == YAxis::kUp ? ", up" : ", down");
}

// Draws of two models on triangles that no inference has seen.
int Differences(const Profile& a, const Profile& b, int cases) {
  SubjectInfo info = RealInfo();
  info.profile = a;
  info.profile.coordinate_limit = 0x1p13;
  int differences = 0;
  for (int k = 0; k < cases; ++k) {
    PhiloxSource bits(77, static_cast<std::uint64_t>(k));
    const Scene scene = OrdinaryTriangle(bits, info);
    differences += exact::Coverage(scene, a) == exact::Coverage(scene, b) ? 0 : 1;
  }
  return differences;
}

void ExpectFound(const Profile& planted) {
  SCOPED_TRACE(Describe(planted));
  FakeSubject subject = Follows(planted, planted);
  const Inference inference = Infer(subject);
  ASSERT_TRUE(inference.Fits()) << inference.message << "; nearest "
                                << Describe(inference.nearest->profile);
  EXPECT_TRUE(inference.Agrees());
  EXPECT_EQ(inference.facing, FacingReport::kAsOnScreen);
  const auto is_planted = [&](const Profile& p) { return ModelPart(p) == ModelPart(planted); };
  EXPECT_EQ(std::ranges::count_if(inference.remaining, is_planted), 1);
  // What is left beside it draws the same.
  for (const Profile& other : inference.remaining) {
    EXPECT_EQ(Differences(planted, other, 150), 0) << "remains: " << Describe(other);
  }
  ::testing::Test::RecordProperty(Describe(planted),
                                  std::to_string(inference.models) + " models, " +
                                      std::to_string(inference.experiments) + " draws, " +
                                      std::to_string(inference.remaining.size()) + " remain, " +
                                      std::to_string(inference.seconds) + " s");
}

constexpr std::array<SnapRule, 5> kRules{SnapRule::kNearestEven, SnapRule::kNearestAway,
                                         SnapRule::kHalfUp, SnapRule::kFloor, SnapRule::kTruncate};
constexpr std::array<SnapForm, 3> kForms{SnapForm::kCoordinate, SnapForm::kFloat32Difference,
                                         SnapForm::kExactDifference};
constexpr InferOptions kFewNearest{.nearest_checks = Cases(1200)};  // for what no model fits

TEST(Infer, FindsEveryRuleAndFormAtEightBits) {
  for (const SnapRule rule : kRules) {
    for (const SnapForm form : kForms) {
      ExpectFound(Snapped(8, rule, form, form == SnapForm::kCoordinate ? 0 : 0.5));
    }
  }
}

TEST(Infer, FindsEveryTieRule) {
  std::vector<TieRule> rules(kConsistentRules.begin(), kConsistentRules.end());
  rules.push_back({.inclusive = true});
  constexpr std::array<int, 3> kBits{8, 4, Snap::kNone};
  for (std::size_t k = 0; k < rules.size(); ++k) {
    Profile planted = Snapped(kBits[k % 3], SnapRule::kNearestEven);
    planted.tie_rule = rules[k];
    ExpectFound(planted);
  }
}

TEST(Infer, FindsGridsPlacesAndAxes) {
  constexpr std::array<Point2, 3> kPlaces{Point2{0.5, 0.5}, Point2{0, 0}, Point2{0.25, 0.75}};
  constexpr std::array<int, 5> kBits{0, 4, 8, 12, Snap::kNone};
  std::size_t k = 0;
  for (const int bits : kBits) {
    for (const Point2 place : kPlaces) {
      Profile planted = bits == Snap::kNone ? Profile{} : Snapped(bits, kRules[k % 5]);
      planted.coordinate_limit = 0x1p15;
      planted.pattern.locations = {place};
      planted.y_axis = k % 2 == 0 ? YAxis::kDown : YAxis::kUp;
      planted.tie_rule = kConsistentRules[(3 * k) % 8];
      ExpectFound(planted);
      ++k;
    }
  }
}

TEST(Infer, FindsDifferencesFromAnotherPlace) {
  Profile planted = Snapped(8, SnapRule::kTruncate, SnapForm::kExactDifference, 0.25);
  planted.pattern.locations = {{0.25, 0.75}};
  ExpectFound(planted);
}

// On whole pixels about the centre no integer is a grid point: every place seems to be another one.
TEST(Infer, FindsGridsThatHoldNoInteger) {
  for (const SnapRule rule : kRules) {
    for (const Point2 place : {Point2{0.5, 0.5}, Point2{0, 0}, Point2{0.25, 0.75}}) {
      Profile planted = Snapped(0, rule, SnapForm::kExactDifference, 0.5);
      planted.pattern.locations = {place};
      ExpectFound(planted);
    }
  }
}

TEST(Infer, FindsSeveralSamplesAPixel) {
  Profile planted = Snapped(8, SnapRule::kNearestEven);
  planted.pattern.locations = {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}};
  ExpectFound(planted);
}

TEST(Infer, FindsTheBuiltInSubjectsAsTheyStateThemselves) {
  for (const std::string_view name : {"i64-snap8", "i32-snap4", "spans-exact", "hom-exact"}) {
    const std::unique_ptr<Subject> subject = subjects::MakeBuiltin(name);
    const Inference inference = Infer(*subject);
    ASSERT_TRUE(inference.Fits()) << name << ": " << inference.message;
    EXPECT_TRUE(inference.Agrees()) << name;
    EXPECT_EQ(ModelPart(inference.remaining.front()), ModelPart(subject->Info().profile)) << name;
  }
}

const StatementVerdict* Find(const Inference& inference, std::string_view statement) {
  for (const StatementVerdict& verdict : inference.statements) {
    if (verdict.statement == statement) return &verdict;
  }
  return nullptr;
}

TEST(Infer, ContradictsAnUntrueStatementWithACase) {
  const Profile model = Snapped(4, SnapRule::kNearestEven);
  const Profile stated = Snapped(8, SnapRule::kNearestEven);
  FakeSubject subject = Follows(model, stated);
  const Inference inference = Infer(subject);
  ASSERT_TRUE(inference.Fits()) << inference.message;
  EXPECT_FALSE(inference.Agrees());
  ASSERT_NE(Find(inference, "subpixel bits"), nullptr);
  EXPECT_FALSE(Find(inference, "subpixel bits")->agrees);
  EXPECT_EQ(Find(inference, "subpixel bits")->found, "4");
  EXPECT_TRUE(Find(inference, "tie rule")->agrees);
  ASSERT_TRUE(inference.against_stated.has_value());
  const Scene& scene = inference.against_stated->scene;
  EXPECT_NE(exact::Coverage(scene, model), exact::Coverage(scene, stated));
}

TEST(Infer, FreedomAllowsWhatItSaysAndNoMore) {
  Profile stated = Snapped(8, SnapRule::kNearestEven);
  stated.freedom = {.snap_tolerance = 0.6, .ties = TieOwnership::kAxisAligned};
  Profile away = Snapped(8, SnapRule::kNearestAway);
  away.tie_rule = kConsistentRules[5];
  FakeSubject legal = Follows(away, stated);
  EXPECT_TRUE(Infer(legal).Agrees());
  FakeSubject floor = Follows(Snapped(8, SnapRule::kFloor), stated);
  EXPECT_FALSE(Infer(floor).Agrees()) << "up to a whole step is more than 0.6";
  stated.freedom.snap_tolerance = 1;
  FakeSubject tolerated = Follows(Snapped(8, SnapRule::kFloor), stated);
  EXPECT_TRUE(Infer(tolerated).Agrees());
}

TEST(Infer, AContractOfNoneIsObservedOnly) {
  Profile stated = Snapped(8, SnapRule::kNearestEven);
  stated.contract = Contract::kNone;
  FakeSubject subject = Follows(Snapped(4, SnapRule::kFloor), stated);
  EXPECT_TRUE(Infer(subject).Agrees());
}

TEST(Infer, ToldReversedFacings) {
  const Profile model = Snapped(8, SnapRule::kNearestEven);
  SubjectInfo info = RealInfo();
  info.profile = model;
  FakeSubject subject(
      info, [model](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        CoverageCounts drawn = exact::Coverage(scene, model, options);
        std::swap(drawn.front, drawn.back);
        AddDrawn(counts, drawn);
      });
  const Inference inference = Infer(subject);
  ASSERT_TRUE(inference.Fits()) << inference.message;
  EXPECT_EQ(inference.facing, FacingReport::kReversed);
  EXPECT_FALSE(inference.Agrees());
}

// Wrong facings are no model's, but the samples have one.
TEST(Infer, FindsTheModelOfSamplesWhoseFacingsAreGuessed) {
  const Profile model = Snapped(8, SnapRule::kFloor);
  SubjectInfo info = RealInfo();
  info.profile = model;
  FakeSubject subject(
      info, [model](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        const CoverageCounts drawn = exact::Coverage(scene, model, options);
        // On whole pixels a triangle can face the other way, or none.
        const Scene coarse = SnapScene(scene, {Snapped(0, SnapRule::kNearestEven), scene});
        const std::array<Vertex, 3> v = Corners(coarse, coarse.triangles[0]);
        const int facing = exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])});
        for (std::size_t k = 0; k < drawn.size(); ++k) {
          (facing >= 0 ? counts.front : counts.back)[k] += drawn.Count(k);
        }
      });
  const Inference inference = Infer(subject);
  ASSERT_TRUE(inference.Fits()) << inference.message;
  EXPECT_EQ(inference.facing, FacingReport::kNotTold);
  EXPECT_NE(inference.message.find("facings"), std::string::npos);
  EXPECT_TRUE(inference.Agrees());
}

TEST(Infer, TakesClipSpaceAndCountsWithoutFacings) {
  const Profile model = Snapped(8, SnapRule::kHalfUp);
  SubjectInfo info = RealInfo();
  info.profile = model;
  info.takes_window = false;
  info.takes_clip = true;
  info.coverage = CoverageKind::kCounts;
  int window_scenes = 0;
  FakeSubject subject(info,
                      [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                        window_scenes += scene.clip_space ? 0 : 1;
                        const CoverageCounts drawn = exact::Coverage(scene, model, options);
                        for (std::size_t k = 0; k < drawn.size(); ++k)
                          counts.front[k] += drawn.Count(k);
                      });
  const Inference inference = Infer(subject);
  ASSERT_TRUE(inference.Fits()) << inference.message;
  EXPECT_EQ(window_scenes, 0);
  EXPECT_EQ(inference.facing, FacingReport::kNotTold);
  EXPECT_EQ(ModelPart(inference.remaining.front()), ModelPart(model));
  EXPECT_TRUE(inference.Agrees());
}

// Top-left in one tile, bottom-right in the next, as a checkerboard.
FakeSubject FlipsItsRuleByTile(const Profile& profile) {
  SubjectInfo info = RealInfo();
  info.profile = profile;
  return {info, [profile](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            Profile other = profile;
            other.tie_rule = {-1, -1, false, false};
            const CoverageCounts one = exact::Coverage(scene, profile, options);
            const CoverageCounts two = exact::Coverage(scene, other, options);
            for (int row = 0; row < scene.height; ++row) {
              for (int x = 0; x < scene.width; ++x) {
                const std::size_t k = counts.Index(x, row);
                const CoverageCounts& from = (x / 8 + row / 8) % 2 == 0 ? one : two;
                counts.front[k] += from.front[k];
                counts.back[k] += from.back[k];
              }
            }
          }};
}

TEST(Infer, NoModelFitsARuleThatFlipsByTile) {
  FakeSubject subject = FlipsItsRuleByTile(Snapped(8, SnapRule::kNearestEven));
  const Inference inference = Infer(subject, kFewNearest);
  EXPECT_TRUE(!inference.Fits() && !inference.message.empty()) << inference.message;
  ASSERT_TRUE(inference.nearest.has_value());
  const NearestModel& nearest = *inference.nearest;
  EXPECT_EQ(nearest.profile.snap.bits, 8) << Describe(nearest.profile);
  EXPECT_GT(nearest.wrong_samples, 0U);
  EXPECT_LT(nearest.wrong_samples * 20, nearest.samples);
  EXPECT_LT(nearest.wrong_experiments, nearest.experiments);
  ASSERT_TRUE(inference.witness.has_value());
  const Case& witness = *inference.witness;
  EXPECT_EQ(witness.scene.triangles.size(), 1U);
  CoverageCounts counts(witness.scene.width, witness.scene.height);
  DrawOnto(subject, witness.scene, {}, counts);
  EXPECT_NE(counts, exact::Coverage(witness.scene, nearest.profile));
}

TEST(Infer, NoModelFitsASubjectThatThrows) {
  FakeSubject throwing(RealInfo(), [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw std::runtime_error("out of order");
  });
  const Inference broken = Infer(throwing);
  EXPECT_FALSE(broken.Fits());
  EXPECT_NE(broken.message.find("out of order"), std::string::npos);
  EXPECT_TRUE(broken.witness.has_value());
}

// Breaks off at the n-th draw.
FakeSubject EndsAt(int n, void (*end)(), int& draws) {
  const Profile model = Snapped(8, SnapRule::kHalfUp);
  SubjectInfo info = RealInfo();
  info.profile = model;
  return {info,
          [=, &draws](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            if (++draws == n) end();
            AddDrawn(counts, exact::Coverage(scene, model, options));
          }};
}

TEST(Infer, AsksASubjectThatBrokeOffNoMoreAndSaysHowItEnded) {
  for (const int n : {1, 3, 20, 100}) {
    int draws = 0;
    FakeSubject subject = EndsAt(n, [] { BreakDown("it crashed"); }, draws);
    const Inference inference = Infer(subject);
    EXPECT_EQ(draws, n);
    EXPECT_EQ(inference.experiments, static_cast<std::uint64_t>(n));
    EXPECT_EQ(inference.message, "the subject stopped: it crashed");
    EXPECT_FALSE(inference.Fits());
    EXPECT_FALSE(inference.is_inconclusive);
    EXPECT_TRUE(inference.witness.has_value());
    EXPECT_FALSE(inference.against_stated.has_value());
  }
}

TEST(Infer, IsInconclusiveWhereTheSubjectIsTooSlow) {
  int draws = 0;
  FakeSubject subject = EndsAt(20, [] { throw SubjectStop(Stop::kTooSlow, "a day"); }, draws);
  const Inference inference = Infer(subject);
  EXPECT_EQ(draws, 20);
  EXPECT_TRUE(inference.is_inconclusive);
  EXPECT_NE(inference.message.find("a day"), std::string::npos) << inference.message;
  EXPECT_FALSE(inference.witness.has_value());
}

// 28.4 in 32 bits: products of differences hold where coordinates stay below 1024.
TEST(Infer, FindsTheModelOfASubjectThatTakesLittleRoom) {
  for (const double limit : {1023.9375, 600.0, 300.0, 140.0, 66.0}) {
    Profile planted = Snapped(4, SnapRule::kHalfUp);
    planted.coordinate_limit = limit;
    planted.tie_rule = *TieRuleFromName("bottom-right");
    planted.pattern.locations = {{0.5625, 0.25}};
    double farthest = 0;
    FakeSubject subject(
        Follows(planted, planted).Info(),
        [&](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
          for (const Vertex& v : scene.vertices)
            farthest = std::max({farthest, std::abs(v.x), std::abs(v.y)});
          AddDrawn(counts, exact::Coverage(scene, planted, options));
        });
    const Inference inference = Infer(subject);
    ASSERT_TRUE(inference.Fits()) << limit << ": " << inference.message;
    EXPECT_TRUE(inference.Agrees()) << limit;
    EXPECT_LE(farthest, limit);
    const auto is_planted = [&](const Profile& p) { return ModelPart(p) == ModelPart(planted); };
    EXPECT_EQ(std::ranges::count_if(inference.remaining, is_planted), 1) << limit;
  }
}

TEST(Infer, SaysWhatItLookedForWhereFinerPlacesHaveNoRoom) {
  Profile planted = Snapped(8, SnapRule::kNearestEven);
  planted.coordinate_limit = 140;
  planted.pattern.locations = {{0.5 + 1.0 / 256, 0.5}};
  FakeSubject as_stated = Follows(planted, planted);
  EXPECT_TRUE(Infer(as_stated).Fits());
  Profile centred = planted;
  centred.pattern.locations = {{0.5, 0.5}};
  FakeSubject subject = Follows(planted, centred);
  const Inference inference = Infer(subject, kFewNearest);
  EXPECT_FALSE(inference.Fits());
  EXPECT_NE(inference.message.find("multiples of 1/32 pixel"), std::string::npos)
      << inference.message;
}

TEST(Infer, IsInconclusiveWhereThereIsNoRoomForTheCoarsestPlaces) {
  Profile planted = Snapped(4, SnapRule::kHalfUp);
  planted.coordinate_limit = 65;
  FakeSubject subject = Follows(planted, planted);
  const Inference inference = Infer(subject);
  EXPECT_TRUE(inference.is_inconclusive);
  EXPECT_NE(inference.message.find("up to 66"), std::string::npos) << inference.message;
}

TEST(Infer, IsTheSameEveryTime) {
  FakeSubject subject = Follows(Snapped(8, SnapRule::kHalfUp), Snapped(8, SnapRule::kHalfUp));
  const Inference once = Infer(subject);
  const Inference twice = Infer(subject);
  EXPECT_EQ(once.experiments, twice.experiments);
  EXPECT_EQ(once.remaining, twice.remaining);
}

TEST(Infer, TakesATransformAsStated) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant("legal:transform-quotients");
  const Inference inference = Infer(*subject, {.checks = 60});
  EXPECT_TRUE(inference.Agrees()) << inference.message;
  EXPECT_FALSE(inference.remaining.empty());
}

// Rounded down to 1/256 pixel, a crossing is that of samples 1/256 pixel farther right, whose ties
// fall the other way.
TEST(Infer, SaysNothingOfRoundedCrossings) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant("legal:scanline-floor");
  EXPECT_TRUE(Infer(*subject, {.checks = 60}).is_inconclusive);
}

// What tells 12 bits from 10 is drawn on neither grid.
TEST(Infer, NamesThePlantedModelOfASubjectThatIsWrongNowAndThen) {
  if (kOneCaseIn > 1) return;  // the code of NoModelFitsARuleThatFlipsByTile, over more models
  Profile model = Snapped(12, SnapRule::kFloor);
  model.tie_rule = *TieRuleFromName("bottom-right");
  FakeSubject subject(
      RealInfo(), [model](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        CoverageCounts drawn = exact::Coverage(scene, model, options);
        if (!scene.vertices.empty() && scene.vertices[0].y < 1) drawn.front[0] = drawn.back[0] = 0;
        AddDrawn(counts, drawn);
      });
  const Inference inference = Infer(subject);
  EXPECT_FALSE(inference.Fits());
  ASSERT_TRUE(inference.nearest);
  EXPECT_EQ(inference.nearest->profile.snap, model.snap);
  EXPECT_EQ(inference.nearest->profile.tie_rule, model.tie_rule);
  EXPECT_GT(inference.nearest->wrong_samples, 0U);
  EXPECT_GT(inference.nearest->experiments, 1100U);
  EXPECT_TRUE(inference.witness);
}

TEST(Infer, FindsTheModelOfASubjectThatRefusesSomeScenes) {
  const Profile model = Snapped(4, SnapRule::kNearestEven);
  FakeSubject subject(
      RealInfo(), [model](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        if (!scene.vertices.empty() && scene.vertices[0].x < 0) {
          throw SubjectStop(Stop::kRefused, "no");
        }
        AddDrawn(counts, exact::Coverage(scene, model, options));
      });
  const Inference inference = Infer(subject);
  ASSERT_TRUE(inference.Fits()) << inference.message;
  EXPECT_EQ(inference.remaining.front().snap, model.snap);
}

}  // namespace
}  // namespace rasterproof::props
