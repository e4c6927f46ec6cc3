// Freedom that turns triangles: what is fixed is so in every legal model, what is not is not
// judged, and bugs beside it are found all the same.
#include "props/judging/freedom/free_choices.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "props/domains/domain.h"
#include "props/judging/freedom/outline.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

SubjectInfo FreeInfo(int bits, double tolerance) {
  SubjectInfo info = testing::SnappedInfo(bits);
  info.profile.freedom.snap_tolerance = tolerance;
  return info;
}

// Grid points up from 0.42 of a step: legal within 0.6 of one.
double UpFrom42(double x, double step) {
  const double below = std::floor(x / step) * step;
  return x - below >= 0.42 * step ? below + step : below;
}

// Where the subject puts a vertex of the triangle with these indices (their sum).
using Place = std::function<Point2(Point2 at, std::int32_t indices)>;

// Draws what `place` makes of each triangle, as counts of the kind that it states.
FakeSubject Placing(const SubjectInfo& info, Place place) {
  Profile placed = info.profile;
  placed.snap = {};
  placed.freedom = {};
  return {info, [placed, place = std::move(place), kind = info.coverage](
                    const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            for (const Triangle& t : scene.triangles) {
              Scene one = scene;
              one.precision = Precision::kFloat64;
              one.triangles = {t};
              for (Vertex& v : one.vertices) {
                const Point2 p = place(WindowPoint(v), t[0] + t[1] + t[2]);
                v = {p.x, p.y, 0, 1};
              }
              counts += exact::Coverage(one, placed, options);
            }
            HideFacings(kind, counts);
          }};
}

Place UpFrom42Of(double step) {
  return [step](Point2 at, std::int32_t) {
    return Point2{UpFrom42(at.x, step), UpFrom42(at.y, step)};
  };
}

// Two sides of a sliver that this rounding turns over.
Scene ClosedSliver() {
  Scene scene;
  scene.width = 16;
  scene.height = 2;
  scene.vertices = {{0, 0.5}, {16, 0.5}, {0x1p+3, 0x1.00ep-1}};
  scene.triangles = {{0, 1, 2}, {0, 2, 1}};
  return scene;
}

// Three rows of triangles, the middle one a step high: this rounding folds it.
Scene FoldedRow() {
  Scene scene;
  scene.width = 16;
  scene.height = 16;
  scene.vertices = {{0, 0},  {16, 0}, {0, 0x1.0feep+3}, {16, 0x1.100ep+3}, {0x1.1p+3, 0x1.0ff2p+3},
                    {0, 16}, {16, 16}};
  scene.triangles = {{0, 1, 3}, {0, 3, 2}, {2, 3, 4}, {2, 4, 5}, {4, 3, 6}, {4, 6, 5}};
  return scene;
}

Verdict Judged(std::string_view property, Subject& subject, const Scene& scene) {
  return RunCase(subject, *FindProperty(property), {scene, subject.Info().profile, {}, ""});
}

TEST(FreeChoices, CountsOfTheModelHoldInClipSpaceWhereSnappingTurnsTheTriangle) {
  SubjectInfo info;
  info.profile = *PresetProfile("gl-canonical");
  info.coverage = CoverageKind::kCounts;
  info.takes_clip = true;
  Scene scene;
  scene.width = 16;
  scene.height = 2;
  scene.clip_space = true;
  scene.vertices = {{0, 0.5, 0, 1}, {16, 0x1.0147aep-1, 0, 1}, {8, 0x1.00c49cp-1, 0, 1}};
  scene.triangles = {{0, 1, 2}};
  FakeSubject subject(
      info, [info](const Scene& drawn, const DrawOptions& options, CoverageCounts& counts) {
        const CoverageCounts model = exact::Coverage(drawn, info.profile, options);
        for (std::size_t k = 0; k < model.size(); ++k) counts.front[k] += model.Count(k);
      });
  const Verdict verdict = Judged("ClipSpaceCoverageEqualsTheModel", subject, scene);
  EXPECT_EQ(verdict.outcome, Outcome::kHolds) << verdict.message;
}

TEST(FreeChoices, AClosedMeshThatALegalChoiceTurnsIsNotJudgedWithoutFacings) {
  SubjectInfo info = FreeInfo(8, 0.6);
  info.coverage = CoverageKind::kCounts;
  FakeSubject subject = Placing(info, UpFrom42Of(0x1p-8));
  const Scene scene = ClosedSliver();
  EXPECT_EQ(Judged("OneLegalModelExplainsTheMesh", subject, scene).outcome, Outcome::kHolds);
  const Verdict verdict = Judged("ClosedMeshCancels", subject, scene);
  EXPECT_EQ(verdict.outcome, Outcome::kNotExercised) << verdict.message;
  EXPECT_GT(verdict.not_judged, 0U);
}

TEST(FreeChoices, AClosedMeshThatALegalChoiceTurnsIsJudgedByTheFacingsThatTheSubjectTells) {
  FakeSubject sound = Placing(FreeInfo(8, 0.6), UpFrom42Of(0x1p-8));
  const Verdict holds = Judged("ClosedMeshCancels", sound, ClosedSliver());
  EXPECT_EQ(holds.outcome, Outcome::kHolds) << holds.message;
  EXPECT_EQ(holds.not_judged, 0U);
  FakeSubject one_sided = Placing(FreeInfo(8, 0.6), [](Point2 at, std::int32_t indices) {
    const double nearest = std::round(at.y * 256) / 256;
    return Point2{at.x, indices == 3 ? UpFrom42(at.y, 0x1p-8) : nearest};
  });
  Scene unindexed = ClosedSliver();
  for (std::size_t k = 0; k < 3; ++k) unindexed.vertices.push_back(unindexed.vertices[k]);
  unindexed.triangles[1] = {3, 5, 4};
  EXPECT_EQ(Judged("ClosedMeshCancels", one_sided, unindexed).outcome, Outcome::kViolated);
}

constexpr std::array<std::string_view, 3> kMeshProperties{"EmbeddedMeshSamplesAreCoveredOnce",
                                                          "SharedEdgeSamplesAreCoveredOnce",
                                                          "NeighboursAreClippedAlike"};

TEST(FreeChoices, ALegalFoldIsNotCoveredTooOften) {
  FakeSubject subject = Placing(FreeInfo(8, 0.6), UpFrom42Of(0x1p-8));
  for (const std::string_view property : kMeshProperties) {
    EXPECT_NE(Judged(property, subject, FoldedRow()).outcome, Outcome::kViolated) << property;
  }
  const Verdict verdict = Judged(kMeshProperties[0], subject, FoldedRow());
  EXPECT_EQ(verdict.outcome, Outcome::kHolds);
  EXPECT_GT(verdict.not_judged, 0U);
  EXPECT_GT(verdict.exercised, 100U);
  EXPECT_EQ(Judged("OneLegalModelExplainsTheMesh", subject, FoldedRow()).outcome, Outcome::kHolds);
}

TEST(FreeChoices, AFoldOnAGridOfItsOwnIsNotCoveredTooOften) {
  SubjectInfo info = testing::RealInfo();
  info.profile.contract = Contract::kWatertight;
  for (const double step : {0x1p-8, 0x1p-2, 1.0}) {
    FakeSubject subject = Placing(info, UpFrom42Of(step));
    for (const std::string_view property : kMeshProperties) {
      const Verdict verdict = Judged(property, subject, FoldedRow());
      EXPECT_NE(verdict.outcome, Outcome::kViolated) << property << ", steps of " << step;
    }
    const Verdict verdict = Judged(kMeshProperties[0], subject, FoldedRow());
    EXPECT_GT(verdict.not_judged, 0U);
    EXPECT_GT(verdict.exercised, 50U);
  }
}

// The vertex between the rows goes another legal way for one of the triangles that turn.
TEST(FreeChoices, ACrackAmongTurningTrianglesIsFoundJointly) {
  FakeSubject cracked = Placing(FreeInfo(8, 0.6), [](Point2 at, std::int32_t indices) {
    if (indices == 2 + 3 + 4) return Point2{UpFrom42(at.x, 0x1p-8), std::floor(at.y * 256) / 256};
    return Point2{UpFrom42(at.x, 0x1p-8), UpFrom42(at.y, 0x1p-8)};
  });
  const Verdict verdict = Judged("OneLegalModelExplainsTheMesh", cracked, FoldedRow());
  EXPECT_EQ(verdict.outcome, Outcome::kViolated);
}

// A mesh that turns in one place is judged in all others, whatever the contract.
TEST(FreeChoices, ACrackBesideTurningTrianglesIsFoundByTheMeshProperties) {
  SubjectInfo watertight = testing::RealInfo();
  watertight.profile.contract = Contract::kWatertight;
  for (const SubjectInfo& info : {FreeInfo(8, 0.6), watertight}) {
    Scene scene = FoldedRow();
    // A square where nothing turns.
    scene.width = 32;
    for (const Point2 p : {Point2{19, 2}, {30, 2}, {30, 13}, {19, 13}}) {
      scene.vertices.push_back({p.x, p.y});
    }
    scene.triangles.push_back({7, 8, 9});
    scene.triangles.push_back({7, 9, 10});
    FakeSubject sound = Placing(info, UpFrom42Of(0x1p-8));
    const Verdict holds = Judged(kMeshProperties[0], sound, scene);
    EXPECT_EQ(holds.outcome, Outcome::kHolds) << holds.message;
    FakeSubject cracked = Placing(info, [](Point2 at, std::int32_t indices) {
      Point2 p{UpFrom42(at.x, 0x1p-8), UpFrom42(at.y, 0x1p-8)};
      if (indices == 7 + 8 + 9 && at.x == 30 && at.y == 13) p.y -= 2;
      return p;
    });
    EXPECT_EQ(Judged(kMeshProperties[0], cracked, scene).outcome, Outcome::kViolated);
  }
}

// Every choice of legal grid points for the three corners of a triangle.
std::vector<std::array<Point2, 3>> EveryChoice(const std::array<Vertex, 3>& v, const Snap& snap,
                                               double tolerance) {
  std::array<std::vector<Point2>, 3> points;
  for (std::size_t k = 0; k < 3; ++k) {
    for (const double x : GridPointsWithin(v[k].x, snap, tolerance)) {
      for (const double y : GridPointsWithin(v[k].y, snap, tolerance)) points[k].push_back({x, y});
    }
  }
  std::vector<std::array<Point2, 3>> choices;
  for (const Point2 a : points[0]) {
    for (const Point2 b : points[1]) {
      for (const Point2 p : points[2]) choices.push_back({a, b, p});
    }
  }
  return choices;
}

// Exactly: a triangle is open iff two legal choices differ in the sign of its area, and a sample
// that some choice covers with an open triangle is one that it can cover.
TEST(FreeChoices, ATriangleIsOpenIffTwoChoicesFaceDifferently) {
  const SubjectInfo info = FreeInfo(4, 0.6);
  int open_ones = 0, fixed_ones = 0, covered = 0;
  for (std::uint64_t index = 0; index < 60; ++index) {
    PhiloxSource bits(5, index);
    const Case c = FindDomain("folds")->draw(bits, info);
    for (const Triangle& t : c.scene.triangles) {
      Case one = c;
      one.scene.triangles = {t};
      const OpenTriangles open{PlacedCase(one)};
      std::set<int> facings;
      const auto choices = EveryChoice(Corners(c.scene, t), c.profile.snap, 0.6);
      for (const auto& v : choices) facings.insert(exact::Facing(v));
      ASSERT_EQ(facings.size() > 1, !open.IsEmpty()) << "case " << index;
      (open.IsEmpty() ? fixed_ones : open_ones) += 1;
      if (open.IsEmpty()) continue;
      for (int row = 0; row < c.scene.height; ++row) {
        for (int x = 0; x < c.scene.width; ++x) {
          const Point2 p{x + 0.5, row + 0.5};
          if (open.CanCover(p)) continue;
          for (const auto& v : choices) {
            ASSERT_FALSE(exact::Facing(v) != 0 && exact::Covers(v, p, c.profile.tie_rule));
          }
          ++covered;
        }
      }
    }
  }
  EXPECT_GT(open_ones, 60);
  EXPECT_GT(fixed_ones, 60);
  EXPECT_GT(covered, 1000);
}

// The margin is 2^-46 of 32: a sample 2^-39 farther away than a corner's places is judged.
TEST(FreeChoices, ASampleJustBeyondTheReachOfAnOpenTriangleIsJudged) {
  Case c;
  c.profile = FreeInfo(8, 0.6).profile;
  c.scene = ClosedSliver();
  c.scene.triangles.resize(1);
  const PlacedCase placed(c);
  const OpenTriangles open(placed);
  ASSERT_EQ(open.size(), 1U);
  const auto places = LegalPlacesOf(placed, c.scene.triangles[0]);
  double reach = 0;
  for (const auto& [low, high] : *places)
    reach = std::max(reach, std::hypot(high.x - low.x, high.y - low.y) / 2);
  const auto& [low, high] = (*places)[0];
  const Point2 corner{(low.x + high.x) / 2, (low.y + high.y) / 2};
  EXPECT_TRUE(open.CanCover({corner.x - reach, corner.y}));
  EXPECT_FALSE(open.CanCover({corner.x - reach - 0x1p-39, corner.y}));
}

// What the margin leaves room for, by the bounds that its comment names: the direct form, and a
// walk of 176 steps.
TEST(Outline, SparesWhatDirectFormsAndShortWalksMoveAndNothingFarther) {
  Case c;
  c.profile = *PresetProfile("real");
  c.scene.width = c.scene.height = 16;
  c.scene.vertices = {{0, 0}, {16, 0}, {0, 16}};
  c.scene.triangles = {{0, 1, 2}};
  const Outline outline{PlacedCase(c)};
  constexpr double kUnit = 0x1p-24;
  const double direct = 3 * std::sqrt(2.0) * kUnit * (16 + 16);
  EXPECT_TRUE(outline.IsNear({8, -(33.0 / 32 * direct + WalkMargin(176))}));
  EXPECT_GT(33.0 / 32 * direct + WalkMargin(178), kOutlineMargin);
  constexpr double kMargin = 0x1p-10 + 16 * 0x1p-18;
  EXPECT_TRUE(outline.IsNear({8, -kMargin}));
  EXPECT_FALSE(outline.IsNear({8, -kMargin - 0x1p-40}));
  EXPECT_TRUE(outline.IsNear({8, kMargin}));
  EXPECT_FALSE(outline.IsNear({5, 5}));
}

// A watertight subject that walks in float32 is not failed where its outline went, and what lies
// farther inside is judged. For a sample-exact one with legal grid points it is a pixel.
TEST(Outline, OfMovedSparesTheLongestWalkInTheTargetAndNothingFarther) {
  Case c;
  c.profile = *PresetProfile("real");
  c.profile.contract = Contract::kWatertight;
  c.scene.width = 16384;
  c.scene.height = 4096;
  c.scene.vertices = {{0, 0}, {16384, 0}, {0, 4096}};
  c.scene.triangles = {{0, 1, 2}};
  constexpr double kRounded = 16384 * kOutlineMarginPerCoordinate;
  const double margin = 1 + kRounded + WalkMargin(16384 + 4096);
  const Outline moved = Outline::OfMoved(PlacedCase(c), 0);
  EXPECT_TRUE(moved.IsNear({64, margin}));
  EXPECT_FALSE(moved.IsNear({64, margin + 0x1p-20}));
  c.profile.contract = Contract::kSampleExact;
  const Outline stated = Outline::OfMoved(PlacedCase(c), 0);
  EXPECT_TRUE(stated.IsNear({64, 1 + kRounded}));
  EXPECT_FALSE(stated.IsNear({64, 1 + kRounded + 0x1p-20}));
}

// The displacement of an edge x = 0 after a walk towards it, for steps dY whose roundings agree.
TEST(Outline, FloatWalksGoFartherThanAPixelAndNotBeyondTheirMargin) {
  constexpr int kSteps = 16384;
  double farthest = 0;
  for (int n = 0; n < 512; ++n) {
    const float step = 1 + static_cast<float>(n) * 0x1p-9F + (0x1p-11F - 0x1p-23F);
    float e = -step * kSteps;
    const double start = std::fabs(double{e} + double{step} * kSteps) / double{step};
    for (int k = 0; k < kSteps; ++k) e += step;
    const double displaced = std::fabs(double{e}) / double{step};
    EXPECT_LE(displaced, 33.0 / 32 * start + WalkMargin(kSteps));
    farthest = std::max(farthest, displaced);
  }
  EXPECT_GT(farthest, 1) << "a pixel is not enough";
}

TEST(FreeChoices, OneModelLeavesNothingOpen) {
  for (std::uint64_t index = 0; index < 20; ++index) {
    PhiloxSource bits(5, index);
    const Case c = FindDomain("folds")->draw(bits, testing::SnappedInfo(4));
    EXPECT_TRUE(OpenTriangles(PlacedCase(c)).IsEmpty());
  }
}

TEST(FreeChoices, ATriangleThatOnlySomeModelsDropIsOpen) {
  Case c;
  c.profile = FreeInfo(8, 0.6).profile;
  c.profile.max_primitive_extent = MaxPrimitiveExtent{8, 8};
  c.scene.vertices = {{0, 0}, {8 + 0x1p-9, 0}, {0, 6}};
  c.scene.triangles = {{0, 1, 2}};
  EXPECT_EQ(OpenTriangles(PlacedCase(c)).size(), 1U);
  c.scene.vertices[1].x = 7.5;
  EXPECT_TRUE(OpenTriangles(PlacedCase(c)).IsEmpty());
  c.scene.vertices[1].x = 8.5;
  EXPECT_TRUE(OpenTriangles(PlacedCase(c)).IsEmpty());
}

TEST(FreeChoices, ClipSpaceIsOpenBesideItsQuotients) {
  Case c;
  c.profile = FreeInfo(8, 0.6).profile;
  c.scene.clip_space = true;
  c.scene.vertices = {{0, 1, 0, 2}, {32, 1, 0, 2}, {24, 0x1.81500p+0, 0, 3}};
  c.scene.triangles = {{0, 1, 2}};
  EXPECT_EQ(OpenTriangles(PlacedCase(c)).size(), 1U);
  c.profile.freedom = {};
  EXPECT_TRUE(OpenTriangles(PlacedCase(c)).IsEmpty());
  c.scene.vertices[2].y = 30;
  c.profile.freedom.snap_tolerance = 0.6;
  EXPECT_TRUE(OpenTriangles(PlacedCase(c)).IsEmpty());
}

// What a domain is for: half of its cases have something that turns, and something that does not.
TEST(FreeChoices, FoldsHaveTrianglesThatTurnAndOthers) {
  for (const char* const name : {"folds", "closed-folds"}) {
    for (const SubjectInfo& info : {FreeInfo(8, 0.6), FreeInfo(4, 1.0), FreeInfo(0, 1.0)}) {
      int turning = 0;
      for (std::uint64_t index = 0; index < 100; ++index) {
        PhiloxSource bits(2, index);
        const Case c = FindDomain(name)->draw(bits, info);
        const std::size_t open = OpenTriangles(PlacedCase(c)).size();
        turning += open > 0 && open < c.scene.triangles.size() ? 1 : 0;
      }
      EXPECT_GT(turning, 50) << name << ", " << info.profile.snap.bits << " bits";
    }
  }
}

TEST(FreeChoices, ClipSpaceAndManyTrianglesAreSearchedJointly) {
  SubjectInfo info = FreeInfo(8, 0.6);
  info.takes_clip = true;
  FakeSubject subject = Placing(info, UpFrom42Of(0x1p-8));
  Scene clip = FoldedRow();
  clip.clip_space = true;
  const Verdict in_clip_space = Judged("OneLegalModelExplainsTheMesh", subject, clip);
  EXPECT_EQ(in_clip_space.outcome, Outcome::kHolds) << in_clip_space.message;
  EXPECT_EQ(in_clip_space.not_judged, 0U);
  Scene many = FoldedRow();
  while (many.triangles.size() <= 32) many.triangles.push_back(many.triangles[0]);
  const Verdict of_many = Judged("OneLegalModelExplainsTheMesh", subject, many);
  EXPECT_EQ(of_many.outcome, Outcome::kHolds) << of_many.message;
  EXPECT_EQ(of_many.not_judged, 0U);
}

// Draws what is infinite as if it were far away.
FakeSubject ClampsInfinity(const SubjectInfo& info) {
  return Placing(info, [](Point2 at, std::int32_t) {
    return Point2{std::clamp(at.x, -8.0, 8.0), std::clamp(at.y, -8.0, 8.0)};
  });
}

Scene WithCorner(double x) {
  Scene scene;
  scene.width = scene.height = 8;
  scene.vertices = {{0, 0}, {x, 0}, {0, 8}};
  scene.triangles = {{0, 1, 2}, {0, 1, 2}};  // each with a bad triangle of another kind
  return scene;
}

TEST(InfiniteVertices, AreJudgedWhereTheProfileSaysWhatTheyCover) {
  const Scene scene = WithCorner(HUGE_VAL);
  for (const std::string_view property :
       {"NonFiniteTrianglesCoverNothing", "BadTrianglesPoisonNoOthers"}) {
    for (const std::string_view preset : kPresetProfiles) {
      SubjectInfo info;
      info.profile = *PresetProfile(preset);
      FakeSubject open = ClampsInfinity(info);
      const Scene judged = property == "BadTrianglesPoisonNoOthers" ? WithCorner(8) : scene;
      EXPECT_EQ(Judged(property, open, judged).outcome == Outcome::kViolated, preset == "real")
          << property << " under " << preset;
      info.profile.name = "stated";
      info.profile.infinite_vertex = InfiniteVertex::kNothing;
      FakeSubject stated = ClampsInfinity(info);
      EXPECT_EQ(Judged(property, stated, judged).outcome, Outcome::kViolated) << property;
    }
  }
}

TEST(InfiniteVertices, LeaveNaNJudged) {
  SubjectInfo info;
  info.profile = *PresetProfile("vulkan-canonical");
  FakeSubject takes_nan = Placing(info, [](Point2 at, std::int32_t) {
    return Point2{std::isnan(at.x) ? 8 : at.x, std::isnan(at.y) ? 8 : at.y};
  });
  const Scene scene = WithCorner(std::nan(""));
  EXPECT_EQ(Judged("NonFiniteTrianglesCoverNothing", takes_nan, scene).outcome, Outcome::kViolated);
  EXPECT_EQ(Judged("BadTrianglesPoisonNoOthers", takes_nan, WithCorner(8)).outcome,
            Outcome::kViolated);
}

}  // namespace
}  // namespace rasterproof::props
