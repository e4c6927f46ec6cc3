// What a profile states beyond snap and rule is judged where it is stated, and reached.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/call_end.h"
#include "core/drawing.h"
#include "exact/coverage.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "props/domains/domain.h"
#include "props/domains/input_lattice.h"
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
using testing::Sound;

constexpr std::uint64_t kKeysSeed = 1;

SubjectInfo FixedInfo(const FixedInput& fixed, int snap_bits = Snap::kNone) {
  SubjectInfo info = SnappedInfo(snap_bits);
  info.profile.snap.bits = snap_bits;
  info.profile.fixed = fixed;
  return info;
}

std::vector<SubjectInfo> FixedInfos() {
  return {FixedInfo({12, 4, true, false}),    FixedInfo({12, 4, true, true}, 2),
          FixedInfo({9, 8, false, false}, 8), FixedInfo({5, 0, true, true}),
          FixedInfo({24, 8, true, false}),    FixedInfo({1, 16, false, false}, 4)};
}

Verdict Told(Subject& subject, std::string_view property, const Case& c) {
  return RunCase(subject, *FindProperty(property), c);
}

Case CaseOf(const Profile& profile, std::vector<Vertex> vertices, std::vector<Triangle> triangles,
            int side = 8) {
  Case c;
  c.profile = profile;
  c.scene.width = side;
  c.scene.height = side;
  c.scene.vertices = std::move(vertices);
  c.scene.triangles = std::move(triangles);
  return c;
}

FakeSubject WithRule(const SubjectInfo& info, const TieRule& rule) {
  return testing::WithProfile(info, [rule](Profile& profile) { profile.tie_rule = rule; });
}

TEST(FixedPointInput, IsGivenItsIntegersByEveryDomain) {
  for (const SubjectInfo& info : FixedInfos()) {
    for (const Domain& domain : Domains()) {
      if (!Suits(domain, info)) continue;
      for (std::uint64_t i = 0; i < 40; ++i) {
        PhiloxSource bits(kKeysSeed, i);
        const Case c = domain.draw(bits, info);
        EXPECT_TRUE(Takes(info, c.scene))
            << domain.name << " " << info.profile.fixed->integer_bits << ", case " << i;
        if (!domain.beyond_limits) {
          EXPECT_TRUE(WithinLimits(c.scene, info.profile)) << domain.name << ", case " << i;
        }
      }
    }
  }
}

TEST(FixedPointInput, HasALatticeWithTwoEnds) {
  Profile profile;
  profile.fixed = FixedInput{12, 4, true, false};
  const InputLattice lattice(profile, Precision::kFloat32);
  EXPECT_EQ(lattice.lowest(), -2048);
  EXPECT_EQ(lattice.limit(), 2048 - 0x1p-4);
  EXPECT_EQ(lattice.Step(3), 0x1p-4);
  EXPECT_EQ(lattice.Step(0), 0x1p-4);
  EXPECT_EQ(lattice.Move(2047, 15), 2048 - 0x1p-4);
  EXPECT_EQ(lattice.Round(1e30), 2048 - 0x1p-4);
  EXPECT_EQ(lattice.Round(-1e30), -2048);
  EXPECT_EQ(lattice.RoundToFloat(1e30), static_cast<double>(1e30F));
  EXPECT_EQ(lattice.GridBits(512), 4);
  profile.snap = {2, SnapRule::kFloor};
  EXPECT_EQ(InputLattice(profile, Precision::kFloat32).limit(), 2047.75);
  profile.coordinate_limit = 1000.1;
  EXPECT_EQ(InputLattice(profile, Precision::kFloat32).lowest(), -1000);
  profile.fixed->is_signed = false;
  EXPECT_EQ(InputLattice(profile, Precision::kFloat32).lowest(), 0);
}

TEST(FixedPointInput, IsDrawnAtBothEndsOfItsRange) {
  const SubjectInfo info = FixedInfo({12, 4, true, false});
  int at_least = 0, at_most = 0;
  for (std::uint64_t i = 0; i < 60; ++i) {
    PhiloxSource bits(kKeysSeed, i);
    for (const Vertex& v : FindDomain("range-ends")->draw(bits, info).scene.vertices) {
      at_least += v.x == info.profile.fixed->Least() ? 1 : 0;
      at_most += v.x == info.profile.fixed->Largest() ? 1 : 0;
    }
  }
  EXPECT_GT(at_least, 10);
  EXPECT_GT(at_most, 10);
}

TEST(FixedPointInput, SoundSubjectsHoldInEveryProperty) {
  for (const SubjectInfo& info : FixedInfos()) {
    FakeSubject subject = Sound(info);
    for (const Property& property : Catalog()) {
      if (DomainsFor(info, property).empty()) continue;
      for (std::uint64_t i = 0; i < Cases<std::uint64_t>(30); ++i) {
        const Verdict verdict = RunCase(subject, property, DrawCase(info, property, kKeysSeed, i));
        ASSERT_NE(verdict.outcome, Outcome::kViolated)
            << property.name << ", case " << i << ": " << verdict.message;
      }
    }
  }
}

// The share of a domain's cases in which both things happen is not zero.
struct Sides {
  int one = 0;
  int other = 0;
};

template <class Test>
Sides SidesOf(std::string_view domain, const SubjectInfo& info, const Test& is_one) {
  Sides sides;
  EXPECT_TRUE(Suits(*FindDomain(domain), info));
  EXPECT_FALSE(Suits(*FindDomain(domain), SnappedInfo(8)));
  for (std::uint64_t i = 0; i < 80; ++i) {
    PhiloxSource bits(kKeysSeed, i);
    ++(is_one(FindDomain(domain)->draw(bits, info)) ? sides.one : sides.other);
  }
  return sides;
}

TEST(WrappedCoordinates, LieBeyondTheRange) {
  const SubjectInfo info = FixedInfo({11, 4, true, true});
  const Sides sides = SidesOf("wrapped-coordinates", info,
                              [&](const Case& c) { return IsUnwrapped(c.scene, info.profile); });
  EXPECT_GT(sides.other, 40);
}

TEST(PrimitiveExtentEnds, LieOnBothSidesOfTheLargestExtent) {
  SubjectInfo info = FixedInfo({12, 4, true, false});
  info.profile.max_primitive_extent = MaxPrimitiveExtent{64, 32};
  int exactly = 0, a_step_over = 0;
  SidesOf("primitive-extent-ends", info, [&](const Case& c) {
    for (const Triangle& t : c.scene.triangles) {
      const std::array<Vertex, 3> v = Corners(c.scene, t);
      const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
      exactly += right - left == 64 ? 1 : 0;
      a_step_over += right - left == 64 + 0x1p-4 ? 1 : 0;
    }
    return true;
  });
  EXPECT_GT(exactly, 5);
  EXPECT_GT(a_step_over, 5);
}

TEST(GuardBandEnds, LieOnBothSidesOfTheRectangle) {
  SubjectInfo info = SnappedInfo(8);
  info.profile.guard_band = WindowBox{-100, -100, 200, 200};
  const Sides sides = SidesOf("guard-band-ends", info, [&](const Case& c) {
    return IsUnclipped(c.scene, {info.profile, c.scene});
  });
  EXPECT_GT(sides.one, 3);
  EXPECT_GT(sides.other, 20);
}

TEST(TargetSizeEnds, LieOnBothSidesOfTheLargestTarget) {
  SubjectInfo info = SnappedInfo(8);
  info.profile.by_target_size = {{.max_width = 64, .max_height = 64, .snap = {4}}};
  const Sides sides = SidesOf("target-size-ends", info, [&](const Case& c) {
    return TargetProfile(c.profile, c.scene).snap.bits == 4;
  });
  EXPECT_GT(sides.one, 20);
  EXPECT_GT(sides.other, 10);
}

// Two triangles that share an edge far beyond the rectangle.
Case FarNeighbours(const Profile& profile) {
  return CaseOf(profile, {{-2, -2, 0, 1}, {300, 300, 0, 1}, {-2, 300, 0, 1}, {300, -2, 0, 1}},
                {{0, 1, 2}, {1, 0, 3}});
}

TEST(GuardBand, SkipsSamplesAndStillJudgesMeshes) {
  SubjectInfo info = SnappedInfo(8);
  info.profile.guard_band = WindowBox{-100, -100, 100, 100};
  FakeSubject moved(info,
                    [](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                      Scene clipped = scene;
                      for (Vertex& v : clipped.vertices) v.y += v.x > 100 ? 0.5 : 0;
                      counts = exact::Coverage(clipped, SnappedInfo(8).profile, options);
                    });
  const Case far = FarNeighbours(info.profile);
  EXPECT_EQ(Told(moved, "CoverageEqualsTheModel", far).outcome, Outcome::kNotExercised);
  EXPECT_EQ(Told(moved, "SharedEdgeSamplesAreCoveredOnce", far).outcome, Outcome::kHolds);
  EXPECT_EQ(Told(moved, "SignedCoverageEqualsTheWindingNumber", far).outcome, Outcome::kHolds);
  FakeSubject torn(
      info, [](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        for (const Triangle& t : scene.triangles) {
          Scene one = scene;
          one.triangles = {t};
          for (Vertex& v : one.vertices) v.y += v.x > 100 && t[0] == 0 ? 60 : 0;
          const CoverageCounts drawn = exact::Coverage(one, SnappedInfo(8).profile, options);
          for (std::size_t k = 0; k < counts.size(); ++k) {
            counts.front[k] += drawn.front[k];
            counts.back[k] += drawn.back[k];
          }
        }
      });
  EXPECT_EQ(Told(torn, "SharedEdgeSamplesAreCoveredOnce", far).outcome, Outcome::kViolated);
  EXPECT_EQ(Told(torn, "SignedCoverageEqualsTheWindingNumber", far).outcome, Outcome::kViolated);
}

TEST(Targets, AreJudgedEachByItsOwnModel) {
  SubjectInfo info = SnappedInfo(8);
  info.profile.by_target_size = {{.max_width = 9, .max_height = 9, .snap = {0, SnapRule::kFloor}}};
  FakeSubject sound = Sound(info);
  const TargetProfile always_small(info.profile, 1, 1);
  FakeSubject wrong(
      info, [always_small](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
        counts = exact::Coverage(scene, always_small, options);
      });
  Case c = CaseOf(info.profile, {{0.375, 0, 0, 1}, {9, 0, 0, 1}, {0.375, 9, 0, 1}}, {{0, 1, 2}}, 9);
  EXPECT_EQ(Told(sound, "CoverageEqualsTheModel", c).outcome, Outcome::kHolds);
  EXPECT_EQ(Told(wrong, "CoverageEqualsTheModel", c).outcome, Outcome::kHolds);
  for (const std::string_view property :
       {"TargetWidthKeepsCoverage", "TargetHeightKeepsCoverage"}) {
    EXPECT_EQ(Told(sound, property, c).outcome, Outcome::kNotExercised) << property;
  }
  c.scene.vertices[0].x = c.scene.vertices[2].x = 0.75;
  c.scene.width = 10;
  EXPECT_EQ(Told(sound, "CoverageEqualsTheModel", c).outcome, Outcome::kHolds);
  EXPECT_EQ(Told(wrong, "CoverageEqualsTheModel", c).outcome, Outcome::kViolated);
}

TEST(Targets, GrowWhereYGrows) {
  for (const YAxis y_axis : {YAxis::kDown, YAxis::kUp}) {
    SubjectInfo info = SnappedInfo(8);
    info.profile.y_axis = y_axis;
    FakeSubject sound = Sound(info);
    const Case c = CaseOf(info.profile, {{0, 0, 0, 1}, {9, 0, 0, 1}, {0, 5, 0, 1}}, {{0, 1, 2}}, 9);
    EXPECT_EQ(Told(sound, "TargetHeightKeepsCoverage", c).outcome, Outcome::kHolds);
  }
}

TEST(EdgeSamples, AsksForOneOwnerAtLeast) {
  SubjectInfo info = SnappedInfo(8);
  info.profile.shares_edge_samples = true;
  // A square from centre to centre, cut along its diagonal.
  const Case square =
      CaseOf(info.profile, {{0.5, 0.5, 0, 1}, {6.5, 0.5, 0, 1}, {6.5, 6.5, 0, 1}, {0.5, 6.5, 0, 1}},
             {{0, 1, 2}, {0, 2, 3}});
  FakeSubject twice = WithRule(info, {.inclusive = true});
  FakeSubject once = Sound(info);
  FakeSubject never = WithRule(info, {.exclusive = true});
  for (const std::string_view property :
       {"CoverageEqualsTheModel", "SharedEdgeSamplesAreCoveredOnce",
        "EmbeddedMeshSamplesAreCoveredOnce"}) {
    EXPECT_EQ(Told(twice, property, square).outcome, Outcome::kHolds) << property;
    EXPECT_EQ(Told(once, property, square).outcome, Outcome::kHolds) << property;
    EXPECT_EQ(Told(never, property, square).outcome, Outcome::kViolated) << property;
  }
  EXPECT_EQ(Told(twice, "SignedCoverageEqualsTheWindingNumber", square).outcome,
            Outcome::kNotApplicable);
  EXPECT_EQ(Told(twice, "VertexRotationKeepsCoverage", square).outcome, Outcome::kNotApplicable);
}

TEST(DegenerateTriangles, LeftUnspecifiedMayCoverTheirEdgesAlone) {
  SubjectInfo info = SnappedInfo(8);
  const auto draws_lines = [](const Scene& scene, const DrawOptions& options,
                              CoverageCounts& counts) {
    counts = exact::Coverage(scene, SnappedInfo(8).profile, options);
    for (const Triangle& t : scene.triangles) {
      if (t[0] == t[1]) ++counts.front[0];
    }
  };
  const std::vector<Vertex> corners{{0.5, 0.5, 0, 1}, {6, 0, 0, 1}, {0, 6, 0, 1}};
  FakeSubject subject(info, draws_lines);
  Case c = CaseOf(info.profile, corners, {{0, 0, 1}, {0, 1, 2}});
  for (const std::string_view property :
       {"CoverageEqualsTheModel", "DegenerateTrianglesCoverNothing"}) {
    EXPECT_EQ(Told(subject, property, c).outcome, Outcome::kViolated) << property;
  }
  c.profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
  EXPECT_EQ(Told(subject, "CoverageEqualsTheModel", c).outcome, Outcome::kHolds);
  EXPECT_EQ(Told(subject, "DegenerateTrianglesCoverNothing", c).outcome, Outcome::kNotApplicable);
  c.scene.vertices[0].x = 0.75;  // its edge passes the sample by
  EXPECT_EQ(Told(subject, "CoverageEqualsTheModel", c).outcome, Outcome::kViolated);
  // The others are judged with them.
  c.scene.vertices[2].y = 5;
  FakeSubject off(info, [](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
    counts = exact::Coverage(scene, SnappedInfo(0).profile, options);
    counts.front[9] += 1;
  });
  const Verdict verdict = Told(off, "CoverageEqualsTheModel", c);
  ASSERT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_EQ(verdict.witness->triangle, 0) << "alone it covers sample 9, too";
}

TEST(DegenerateTriangles, LeftUnspecifiedIsNoLeaveToCrashNorAboutWhatIsNotFinite) {
  SubjectInfo info = SnappedInfo(8);
  info.profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
  FakeSubject crashing(info, [](const Scene& scene, const DrawOptions&, CoverageCounts&) {
    for (const Triangle& t : scene.triangles) {
      if (t[0] == t[1]) BreakDown("it died");
    }
  });
  Case c = CaseOf(info.profile, {{0, 0, 0, 1}, {6, 0, 0, 1}, {0, 6, 0, 1}}, {{0, 0, 1}});
  EXPECT_EQ(Told(crashing, "DrawStaysInsideItsTarget", c).outcome, Outcome::kViolated);
  c.scene.vertices[0].x = std::nan("");
  FakeSubject sound =
      testing::WithProfile(info, [](Profile& drawn) { drawn = SnappedInfo(8).profile; });
  EXPECT_EQ(Told(sound, "CoverageEqualsTheModel", c).outcome, Outcome::kNotExercised);
}

TEST(MaxPrimitiveExtent, IsVerifiedBothWays) {
  SubjectInfo info = FixedInfo({12, 4, true, false});
  info.profile.max_primitive_extent = MaxPrimitiveExtent{64, 32};
  const auto violated = [&](std::optional<MaxPrimitiveExtent> real) {
    FakeSubject subject = testing::WithProfile(
        info, [real](Profile& profile) { profile.max_primitive_extent = real; });
    CampaignOptions options;
    options.seed = kKeysSeed;
    options.cases = kDefaultCases;
    const Property& property = *FindProperty("CoverageEqualsTheModel");
    return RunCampaign(subject, property, options).outcome == Outcome::kViolated;
  };
  EXPECT_FALSE(violated(MaxPrimitiveExtent{64, 32}));
  EXPECT_TRUE(violated(std::nullopt));
  EXPECT_TRUE(violated(MaxPrimitiveExtent{64 + 0x1p-4, 32}));
  EXPECT_TRUE(violated(MaxPrimitiveExtent{64, 32 - 0x1p-4}));
}

TEST(Infer, KeepsToTheIntegersAndTheLimitThatAreStated) {
  SubjectInfo info = FixedInfo({12, 4, true, false}, 2);
  info.profile.snap.rule = SnapRule::kFloor;
  info.profile.coordinate_limit = 1030;
  FakeSubject subject = Sound(info);
  bool within_limits = true;
  subject.on_call = [&](std::span<const DrawJob> jobs) {
    for (const DrawJob& job : jobs) within_limits &= WithinLimits(SceneOf(job), info.profile);
  };
  const Inference inference = Infer(subject, {.checks = 60});
  EXPECT_TRUE(inference.Fits()) << inference.message;
  EXPECT_TRUE(inference.Agrees());
  EXPECT_TRUE(within_limits);
}

TEST(Infer, NamesTheExclusiveRule) {
  SubjectInfo info = SnappedInfo(8);
  FakeSubject subject = WithRule(info, {.exclusive = true});
  const Inference inference = Infer(subject, {.checks = 60});
  ASSERT_TRUE(inference.Fits()) << inference.message;
  EXPECT_FALSE(inference.Agrees());
  for (const Profile& profile : inference.remaining) {
    EXPECT_TRUE(profile.tie_rule.exclusive);
  }
}

TEST(Infer, IsInconclusiveWhereThereIsTooLittleRoom) {
  std::vector<SubjectInfo> infos{FixedInfo({7, 4, true, false}), SnappedInfo(8), SnappedInfo(8),
                                 SnappedInfo(8), SnappedInfo(8)};
  infos[1].profile.coordinate_limit = 65;
  infos[2].profile.max_primitive_extent = MaxPrimitiveExtent{63, 31};
  infos[3].profile.guard_band = WindowBox{-512, -512, 65, 512};
  infos[4].profile.by_target_size = {{.max_width = 40, .max_height = 20, .snap = {4}}};
  for (const SubjectInfo& info : infos) {
    FakeSubject subject = Sound(info);
    const Inference inference = Infer(subject, {});
    EXPECT_TRUE(inference.is_inconclusive);
    EXPECT_FALSE(inference.Fits());
    EXPECT_FALSE(inference.message.empty());
    EXPECT_EQ(inference.experiments, 0U);
  }
}

TEST(MaxTarget, IsKeptByEveryDomain) {
  SubjectInfo info = SnappedInfo(4);
  info.profile.max_target = {12, 9};
  int at_the_limit = 0;
  for (const Domain& domain : Domains()) {
    if (!Suits(domain, info)) continue;
    for (std::uint64_t i = 0; i < 40; ++i) {
      PhiloxSource bits(kKeysSeed, i);
      const Case c = domain.draw(bits, info);
      EXPECT_LE(c.scene.width, 12) << domain.name << ", case " << i;
      EXPECT_LE(c.scene.height, 9) << domain.name << ", case " << i;
      at_the_limit += c.scene.width == 12 && c.scene.height == 9 ? 1 : 0;
    }
  }
  EXPECT_GT(at_the_limit, 100);
}

TEST(MaxTarget, IsNeverExceededByADrawThatAPropertyAsksFor) {
  SubjectInfo info = FixedInfo({12, 4, true, false});
  info.profile.max_target = {14, 10};
  FakeSubject subject = Sound(info);
  std::size_t drawn = 0;
  std::size_t larger = 0;
  subject.on_call = [&](std::span<const DrawJob> jobs) {
    drawn += jobs.size();
    for (const DrawJob& job : jobs) {
      larger += info.profile.max_target.Holds(job.scene->width, job.scene->height) ? 0 : 1;
    }
  };
  for (const char* name : {"TargetWidthKeepsCoverage", "TargetHeightKeepsCoverage",
                           "DrawStaysInsideItsTarget", "IntegerTranslationMovesCoverage",
                           "TilesDrawnApartEqualTheWhole", "LongListDrawsLikeItsEnd"}) {
    RunCampaign(subject, *FindProperty(name), {.cases = 100});
  }
  EXPECT_GT(drawn, 400U);
  EXPECT_EQ(larger, 0U);
}

// The model, but for columns from one number on and rows from another, which it never draws.
FakeSubject EndsAt(const SubjectInfo& info, int column, int row) {
  return {info, [profile = info.profile, column, row](
                    const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            const PixelRect all{0, 0, scene.width, scene.height};
            const PixelRect asked = options.scissor.value_or(all);
            DrawOptions cut = options;
            cut.scissor = {asked.x0, asked.y0, std::min(asked.x1, column), std::min(asked.y1, row)};
            counts += exact::Coverage(scene, profile, cut);
          }};
}

// Registers that are too small by one column or row are found, however large the target is; those
// that hold it, and are wrong beyond, are not blamed.
TEST(MaxTarget, IsHeldToItsLastColumnAndRow) {
  for (const LargestTarget most : {LargestTarget{12, 9}, {64, 128}, {2048, 1024}}) {
    SubjectInfo info = SnappedInfo(4);
    info.profile.max_target = most;
    const auto outcome = [&](int column, int row, std::string_view property) {
      FakeSubject subject = EndsAt(info, column, row);
      return RunCampaign(subject, *FindProperty(property),
                         {.seed = kKeysSeed, .cases = kDefaultCases, .shrink_budget = 10})
          .outcome;
    };
    constexpr std::string_view kModel = "CoverageEqualsTheModel";
    EXPECT_EQ(outcome(most.width - 1, most.height, kModel), Outcome::kViolated) << most.width;
    EXPECT_EQ(outcome(most.width, most.height - 1, kModel), Outcome::kViolated) << most.height;
    for (const std::string_view property : {kModel, std::string_view("TargetWidthKeepsCoverage"),
                                            std::string_view("TargetHeightKeepsCoverage")}) {
      EXPECT_NE(outcome(most.width, most.height, property), Outcome::kViolated) << most.width;
    }
  }
}

TEST(MaxTarget, LeavesLargerOnesUnjudged) {
  SubjectInfo info = SnappedInfo(4);
  FakeSubject subject = testing::DropsLastColumn(info);
  const std::vector<Vertex> corners = {{0, 0}, {0, 64}, {64, 0}};
  Case c = CaseOf(info.profile, corners, {{0, 1, 2}}, 8);
  EXPECT_EQ(Told(subject, "CoverageEqualsTheModel", c).outcome, Outcome::kViolated);
  c.profile.max_target = {8, 8};
  EXPECT_EQ(Told(subject, "CoverageEqualsTheModel", c).outcome, Outcome::kViolated);
  c.profile.max_target = {8, 7};
  EXPECT_EQ(Told(subject, "CoverageEqualsTheModel", c).outcome, Outcome::kNotExercised);
}

TEST(Infer, DoesNotStrikeOutWhatSharingAllows) {
  SubjectInfo info = SnappedInfo(4);
  info.profile.shares_edge_samples = true;
  info.profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
  FakeSubject subject = WithRule(info, {.inclusive = true});
  const Inference inference = Infer(subject, {.checks = 60});
  EXPECT_TRUE(inference.Fits()) << inference.message;
  EXPECT_TRUE(inference.Agrees());
}

}  // namespace
}  // namespace rasterproof::props
