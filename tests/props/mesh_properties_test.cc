// Properties about meshes: in clip space, with shared ties, and about the place that they name.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/profile_keys.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "props/judging/freedom/thin_triangles.h"
#include "props/judging/freedom/visible_edge.h"
#include "props/properties/contract_properties.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "props/run/contract_evidence.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::uint64_t kMeshSeed = 1;

SubjectInfo ClipInfo(Contract contract, int snap_bits = Snap::kNone) {
  SubjectInfo info = RealInfo();
  info.takes_window = false;
  info.takes_clip = true;
  info.profile.contract = contract;
  info.profile.snap.bits = snap_bits;
  return info;
}

SubjectInfo SharedTies(SubjectInfo info) {
  info.profile.tie_rule = {.inclusive = true};
  info.profile.shares_edge_samples = true;
  return info;
}

bool IsInFrontOfTheEye(const Scene& scene) {
  return std::ranges::all_of(scene.vertices, [](const Vertex& v) { return v.w > 0; });
}

// Draws on its own grid and by its own rule, which its profile does not name. Behind the eye exact.
Profile OwnProfile(const Scene& scene, const Profile& stated) {
  Profile own = stated;
  own.by_target_size.clear();
  if (!stated.tie_rule.inclusive) own.tie_rule = *TieRuleFromName("bottom-right-y");
  if (stated.contract == Contract::kWatertight && (!scene.clip_space || IsInFrontOfTheEye(scene)))
    own.snap = {stated.snap.IsNone() ? 4 : stated.snap.bits, SnapRule::kFloor};
  return own;
}

CoverageCounts DrawnElsewhere(const Scene& scene, const Profile& stated,
                              const DrawOptions& options) {
  return exact::Coverage(scene, OwnProfile(scene, stated), options);
}

FakeSubject Elsewhere(const SubjectInfo& info) {
  return {info, [info](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            counts += DrawnElsewhere(scene, info.profile, options);
          }};
}

// Where all lies in front of the eye, each position is up to nine tenths of a pixel off, on each
// axis, by its bits: triangles fold and turn wherever they are small enough for it.
FakeSubject Displaced(const SubjectInfo& info) {
  return {info, [info](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            Scene moved = scene;
            moved.precision = Precision::kFloat64;
            for (Vertex& v : moved.vertices) {
              std::uint64_t bits = 0;
              for (const double x : {v.x + 0.0, v.y + 0.0, v.w + 0.0}) {
                bits = (bits ^ std::bit_cast<std::uint64_t>(x)) * 0x9E3779B97F4A7C15U;
                bits ^= bits >> 29U;
              }
              if (!IsInFrontOfTheEye(scene)) continue;
              v.x += v.w * (static_cast<double>(bits % 19) - 9) / 10;
              v.y += v.w * (static_cast<double>(bits / 19 % 19) - 9) / 10;
            }
            Profile own = info.profile;
            own.snap = {};
            counts += exact::Coverage(moved, own, options);
          }};
}

// On that grid, but each triangle is a fifth of a pixel to one side of its neighbour, by turns.
FakeSubject Cracked(const SubjectInfo& info) {
  return {info, [info](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
              Scene one = scene;
              one.triangles = {scene.triangles[t]};
              for (Vertex& v : one.vertices) v.x += (t % 2 == 0 ? 0.2 : -0.2) * v.w;
              counts += DrawnElsewhere(one, info.profile, options);
            }
          }};
}

PropertyResult Campaign(Subject& subject, std::string_view property, std::uint64_t cases) {
  CampaignOptions options;
  options.seed = kMeshSeed;
  options.cases = Cases<std::uint64_t>(cases);
  return RunCampaign(subject, *FindProperty(property), options);
}

Verdict Judged(Subject& subject, std::string_view property, const Case& c) {
  return RunCase(subject, *FindProperty(property), c);
}

// What a subject of shared ties or of clip space must be asked, and how a crack is found in it.
void ExpectSoundHoldsAndCrackedIsFound(const SubjectInfo& info) {
  bool found = false;
  for (const std::string_view property : PropertiesOf(info.profile.contract)) {
    FakeSubject sound = Elsewhere(info);
    const PropertyResult result = Campaign(sound, property, 400);
    EXPECT_EQ(result.outcome, Outcome::kHolds) << property << ": " << result.message;
    EXPECT_GT(result.cases_exercised, result.cases / 20) << property;
    if (info.profile.contract == Contract::kWatertight && info.profile.snap.IsNone()) {
      FakeSubject displaced = Displaced(info);
      const PropertyResult other = Campaign(displaced, property, 400);
      EXPECT_EQ(other.outcome, Outcome::kHolds) << property << ": " << other.message;
    }
    FakeSubject cracked = Cracked(info);
    found = found || Campaign(cracked, property, 400).outcome == Outcome::kViolated;
  }
  EXPECT_TRUE(found);
}

TEST(ClipSpaceMeshes, AreJudgedForAWatertightSubject) {
  ExpectSoundHoldsAndCrackedIsFound(ClipInfo(Contract::kWatertight));
}

TEST(ClipSpaceMeshes, AreJudgedForAWatertightSubjectThatSharesTies) {
  ExpectSoundHoldsAndCrackedIsFound(SharedTies(ClipInfo(Contract::kWatertight)));
}

TEST(ClipSpaceMeshes, AreJudgedForAWatertightSubjectOfASnappedProfile) {
  ExpectSoundHoldsAndCrackedIsFound(ClipInfo(Contract::kWatertight, 8));
}

TEST(ClipSpaceMeshes, OfClosedSurfacesAreJudgedForTheContractClosed) {
  const SubjectInfo info = ClipInfo(Contract::kClosed);
  for (const std::string_view property : PropertiesOf(Contract::kClosed)) {
    FakeSubject sound = Elsewhere(info);
    const PropertyResult result = Campaign(sound, property, 200);
    EXPECT_EQ(result.outcome, Outcome::kHolds) << property << ": " << result.message;
    FakeSubject cracked = Cracked(info);
    EXPECT_EQ(Campaign(cracked, property, 200).outcome, Outcome::kViolated) << property;
  }
}

TEST(WindowMeshes, AreJudgedWhereTiesAreShared) {
  SubjectInfo info = SharedTies(RealInfo());
  info.profile.contract = Contract::kWatertight;
  ExpectSoundHoldsAndCrackedIsFound(info);
}

// Five triangles around the middle of a target, one of whose outer corners is `corner`; the sixth,
// in which six samples lie, is left out.
Scene Cracked(Point2 corner) {
  Scene scene;
  scene.width = scene.height = 16;
  scene.vertices = {{2, 2}, {14, 2}, {corner.x, corner.y}, {2, 14}, {8, 7}, {8, 9}};
  scene.triangles = {{0, 1, 4}, {1, 2, 5}, {1, 5, 4}, {2, 3, 5}, {3, 0, 4}};
  return scene;
}

TEST(EmbeddedMeshes, SayHowManySamplesLieInCracksOfTheSceneItself) {
  const SubjectInfo info = RealInfo();
  FakeSubject sound(info,
                    [info](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                      counts += exact::Coverage(scene, info.profile, options);
                    });
  const auto gaps = [&](const Scene& scene) {
    const Verdict verdict =
        Judged(sound, "EmbeddedMeshSamplesAreCoveredOnce", {scene, info.profile, {}, ""});
    EXPECT_EQ(verdict.outcome, Outcome::kHolds) << verdict.message;
    return verdict.in_gaps;
  };
  Scene scene = Cracked({14, 14});
  // What lies beyond the outline is no gap, nor is a sample beside it where the crack opens.
  EXPECT_EQ(gaps(scene), 5U);
  EXPECT_EQ(gaps(Cracked({10, 11})), 4U);
  scene.triangles.push_back({3, 4, 5});
  EXPECT_EQ(gaps(scene), 0U);
}

// A tetrahedron around the eye, one vertex straight ahead and three behind. Seen under 90 degrees.
Case AroundTheEye(Contract contract) {
  Case c;
  c.profile = ClipInfo(contract).profile;
  c.scene.width = c.scene.height = 16;
  c.scene.clip_space = true;
  c.scene.vertices = {{8, 8, 0, 1}, {-4, 4, 0, -0.5}, {4, -8, 0, -0.5}, {-12, -8, 0, -0.5}};
  c.scene.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return c;
}

TEST(ClipSpaceMeshes, AroundTheEyeAreCoveredOnceEverywhere) {
  const Case c = AroundTheEye(Contract::kSampleExact);
  SubjectInfo info = ClipInfo(Contract::kSampleExact);
  FakeSubject sound = Elsewhere(info);
  const Verdict held = Judged(sound, "EmbeddedMeshSamplesAreCoveredOnce", c);
  EXPECT_EQ(held.outcome, Outcome::kHolds) << held.message;
  EXPECT_EQ(held.exercised, 256U);
  FakeSubject hole(info,
                   [info](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
                     counts += DrawnElsewhere(scene, info.profile, options);
                     counts.front[counts.Index(5, 6)] = counts.back[counts.Index(5, 6)] = 0;
                   });
  const Verdict verdict = Judged(hole, "EmbeddedMeshSamplesAreCoveredOnce", c);
  ASSERT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_EQ(verdict.witness->x, 5);
  EXPECT_EQ(verdict.witness->y, 6);
  EXPECT_EQ(TextOfValue(verdict.witness->observed), "covered 0 times");
}

TEST(ClipSpaceMeshes, AroundTheEyeOnAGridOfTheirOwnAreNotJudgedWhereAPieceMayTurn) {
  const Case c = AroundTheEye(Contract::kWatertight);
  FakeSubject sound = Elsewhere(ClipInfo(Contract::kWatertight));
  const Verdict verdict = Judged(sound, "EmbeddedMeshSamplesAreCoveredOnce", c);
  EXPECT_EQ(verdict.outcome, Outcome::kNotExercised) << verdict.message;
  EXPECT_EQ(verdict.not_judged, 256U);
}

// A square from centre to centre, cut along its diagonal.
Case Square(const Profile& profile) {
  Case c;
  c.profile = profile;
  c.scene.width = c.scene.height = 16;
  c.scene.vertices = {{0.5, 0.5}, {14.5, 0.5}, {14.5, 14.5}, {0.5, 14.5}};
  c.scene.triangles = {{0, 1, 2}, {0, 2, 3}};
  return c;
}

TEST(SharedTies, AreCoveredOnceAtLeastOnEdgesAndOnceAwayFromThem) {
  for (const Contract contract : {Contract::kSampleExact, Contract::kWatertight}) {
    for (const bool edge_samples : {false, true}) {
      SubjectInfo info = SnappedInfo(8);
      info.profile.contract = contract;
      info.profile.tie_rule = {.inclusive = true};
      info.profile.shares_edge_samples = edge_samples;
      const auto with_extra = [&](int x, int y, int more) {
        return FakeSubject(
            info, [=](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
              counts += exact::Coverage(scene, info.profile, options);
              std::uint32_t& count = counts.back[counts.Index(x, y)];
              count = static_cast<std::uint32_t>(static_cast<int>(count) + more);
            });
      };
      const auto outcome = [&](FakeSubject subject) {
        return Judged(subject, "EmbeddedMeshSamplesAreCoveredOnce", Square(info.profile)).outcome;
      };
      EXPECT_EQ(outcome(with_extra(7, 7, 0)), Outcome::kHolds);
      EXPECT_EQ(outcome(with_extra(7, 7, -2)), Outcome::kViolated) << "a gap on the diagonal";
      EXPECT_EQ(outcome(with_extra(11, 4, 1)), Outcome::kViolated) << "twice away from edges";
      EXPECT_EQ(outcome(with_extra(11, 4, -1)), Outcome::kViolated) << "a gap away from edges";
    }
  }
}

// Two triangles: their common edge is the diagonal; the outer edge along the top passes 0.004
// pixel above the samples of row 2.
Case BesideTheTop(const Profile& profile) {
  Case c = Square(profile);
  c.scene.vertices = {{1, 2.496}, {15, 2.496}, {15, 14}, {1, 14}};
  return c;
}

FakeSubject LosesSample(const SubjectInfo& info, int x, int y) {
  return {info, [=](const Scene& scene, const DrawOptions& options, CoverageCounts& counts) {
            counts += exact::Coverage(scene, info.profile, options);
            counts.front[counts.Index(x, y)] = counts.back[counts.Index(x, y)] = 0;
          }};
}

TEST(NamedEdges, AreTheOnesNearestToTheSample) {
  const SubjectInfo info = RealInfo(Precision::kFloat64);
  const Case c = BesideTheTop(info.profile);
  // Pixel (1, 2): 0.004 below the top edge, some 0.3 from the diagonal.
  FakeSubject top = LosesSample(info, 1, 2);
  EXPECT_NE(Judged(top, "SharedEdgeSamplesAreCoveredOnce", c).outcome, Outcome::kViolated);
  for (const std::string_view property :
       {"EmbeddedMeshSamplesAreCoveredOnce", "CoverageEqualsTheModel",
        "SignedCoverageEqualsTheWindingNumber"}) {
    const Verdict verdict = Judged(top, property, c);
    ASSERT_EQ(verdict.outcome, Outcome::kViolated) << property;
    EXPECT_EQ(verdict.witness->triangle, 0) << property;
    EXPECT_EQ(verdict.witness->edge, 2) << property << ": from vertex 0 to vertex 1";
  }
  FakeSubject diagonal = LosesSample(info, 7, 7);
  const Verdict verdict = Judged(diagonal, "SharedEdgeSamplesAreCoveredOnce", c);
  ASSERT_EQ(verdict.outcome, Outcome::kViolated);
  const auto t = static_cast<std::size_t>(verdict.witness->triangle);
  EXPECT_EQ(NearestEdge(Corners(c.scene, c.scene.triangles[t]), {7.5, 7.5}), verdict.witness->edge);
}

TEST(NamedEdges, AreTheNearestOfTheWholeMeshWhereNoTriangleAloneIsWrong) {
  SubjectInfo info = RealInfo(Precision::kFloat64);
  info.profile.contract = Contract::kWatertight;
  Case c = Square(info.profile);
  FakeSubject subject = LosesSample(info, 8, 7);
  const Verdict verdict = Judged(subject, "EmbeddedMeshSamplesAreCoveredOnce", c);
  ASSERT_EQ(verdict.outcome, Outcome::kViolated);
  EXPECT_EQ(verdict.witness->triangle, 0);
  EXPECT_EQ(verdict.witness->edge, 1);
}

TEST(VisibleEdges, AreSegmentsRaysOrNothing) {
  const auto squared = [](const Vertex& a, const Vertex& b, Point2 p) {
    return VisibleEdge(a, b).SquaredDistance(p)->ToString();
  };
  EXPECT_EQ(squared({0, 0}, {4, 0}, {2, 3}), "9");
  EXPECT_EQ(squared({0, 0}, {4, 0}, {7, 4}), "25") << "beyond its end";
  EXPECT_EQ(squared({0, 0}, {3, 3}, {1, 0}), "1/2");
  EXPECT_EQ(squared({0, 0, 0, 2}, {8, 0, 0, 2}, {7, 4}), "25");
  // From (0, 0) towards a vertex behind the eye at (-4, 0): seen on the other side, without end.
  EXPECT_EQ(squared({0, 0, 0, 1}, {4, 0, 0, -1}, {100, 3}), "9");
  EXPECT_EQ(squared({0, 0, 0, 1}, {4, 0, 0, -1}, {-4, 3}), "25");
  EXPECT_EQ(squared({4, 0, 0, 0}, {0, 0, 0, 1}, {100, 3}), "9") << "an end at infinity";
  EXPECT_TRUE(VisibleEdge({1, 2, 0, -1}, {3, 4, 0, 0}).IsEmpty());
  for (const double w : {1.0, -1.0}) {
    const VisibleEdge edge({1, 2, 0, 3}, {5, -7, 0, w});
    const double exactly = std::sqrt(edge.SquaredDistance({9, 9})->ToDouble());
    EXPECT_NEAR(edge.Distance({9, 9}), exactly, 1e-12 * exactly);
  }
}

TEST(ThinTriangles, AreThoseThatALegalChoiceCanTurn) {
  Case c;
  c.profile = ClipInfo(Contract::kWatertight).profile;
  c.scene.width = c.scene.height = 32;
  c.scene.clip_space = true;
  c.scene.vertices = {{4, 4}, {24, 4}, {4, 24}, {24, 5}};
  c.scene.triangles = {{0, 1, 2}};
  EXPECT_FALSE(ThinTriangles(PlacedCase(c), LegalReach(PlacedCase(c))).AreNear({8, 8}));
  c.scene.triangles = {{0, 1, 3}};
  EXPECT_TRUE(ThinTriangles(PlacedCase(c), LegalReach(PlacedCase(c))).AreNear({20, 4.5}));
  EXPECT_FALSE(ThinTriangles(PlacedCase(c), LegalReach(PlacedCase(c))).AreNear({20, 8}));
  c.profile.contract = Contract::kSampleExact;
  EXPECT_EQ(LegalReach(PlacedCase(c)), 0);
  EXPECT_FALSE(ThinTriangles(PlacedCase(c), LegalReach(PlacedCase(c))).AreNear({20, 4.5}));
  c.profile.snap.bits = 8;
  c.profile.freedom.snap_tolerance = 0.5;
  EXPECT_FALSE(ThinTriangles(PlacedCase(c), LegalReach(PlacedCase(c))).AreNear({20, 4.5}))
      << "a pixel is wide for 2^-8";
  // Across the eye: a wedge from (16, 16) that opens to the right, and one that hardly opens.
  c.profile = ClipInfo(Contract::kWatertight).profile;
  c.scene.vertices = {
      {16, 16, 0, 1}, {40, 20, 0, -1}, {40, -60, 0, -1}, {40, -14, 0, -1}, {40, -15, 0, -1}};
  c.scene.triangles = {{0, 1, 2}};
  EXPECT_TRUE(ThinTriangles(PlacedCase(c), LegalReach(PlacedCase(c))).AreNear({24, 16}))
      << "one of its pieces is thin";
  c.scene.triangles = {{0, 3, 4}};
  EXPECT_TRUE(ThinTriangles(PlacedCase(c), LegalReach(PlacedCase(c))).AreNear({24, 16}));
}

// A corner at 2^k is cut at 96: off by 2^(k - 48) (1 + 96 + 24) at most, and that is less than an
// eighth of the reach up to k = 38.
TEST(ThinTriangles, AreToldFromBroadOnesUpToTheRoundingOfTheirCuts) {
  Case c;
  c.profile = ClipInfo(Contract::kWatertight).profile;
  c.scene.width = c.scene.height = 32;
  c.scene.clip_space = true;
  c.scene.triangles = {{0, 1, 2}};
  const auto is_near = [&](double far) {
    c.scene.vertices = {{4, 4}, {far, 4}, {4, 24}};
    return ThinTriangles(PlacedCase(c), LegalReach(PlacedCase(c))).AreNear({8, 8});
  };
  EXPECT_FALSE(is_near(0x1p38)) << "it is broad, and is judged";
  EXPECT_TRUE(is_near(0x1p40)) << "its corners are not known to an eighth of the reach";
}

TEST(ContractProperties, AreInTheCatalogue) {
  for (const Contract contract : {Contract::kSampleExact, Contract::kWatertight, Contract::kClosed,
                                  Contract::kAtLeastModel, Contract::kAtMostModel}) {
    EXPECT_FALSE(PropertiesOf(contract).empty());
    for (const std::string_view name : PropertiesOf(contract)) {
      EXPECT_NE(FindProperty(name), nullptr) << name;
    }
  }
  EXPECT_TRUE(PropertiesOf(Contract::kNone).empty());
}

std::vector<PropertyResult> WholeRun(Subject& subject, std::uint64_t cases) {
  std::vector<PropertyResult> results;
  for (const Property& property : Catalog()) {
    CampaignOptions options;
    options.cases = cases;
    results.push_back(RunCampaign(subject, property, options));
  }
  return results;
}

ContractEvidence EvidenceOf(const SubjectInfo& info) {
  FakeSubject subject = Elsewhere(info);
  return EvidenceOfContract(info, WholeRun(subject, 32));
}

TEST(ContractEvidence, IsThereForEveryContractInBothSpaces) {
  for (const Contract contract :
       {Contract::kSampleExact, Contract::kWatertight, Contract::kClosed, Contract::kAtLeastModel,
        Contract::kAtMostModel, Contract::kNone}) {
    SubjectInfo window = RealInfo();
    window.profile.contract = contract;
    EXPECT_TRUE(EvidenceOf(window).is_exercised) << ContractName(contract);
    EXPECT_TRUE(EvidenceOf(ClipInfo(contract)).is_exercised) << ContractName(contract);
  }
  EXPECT_TRUE(EvidenceOf(SharedTies(ClipInfo(Contract::kWatertight))).is_exercised);
}

TEST(ContractEvidence, NamesTheKeyThatStandsInTheWay) {
  const auto why = [](SubjectInfo info) {
    const ContractEvidence evidence = EvidenceOf(info);
    EXPECT_FALSE(evidence.is_exercised);
    return evidence.why;
  };
  SubjectInfo closed = RealInfo();
  closed.profile.contract = Contract::kClosed;
  closed.profile.shares_edge_samples = true;
  EXPECT_EQ(why(closed),
            "no property of the profile's contract closed can be tested: its key edge_samples "
            "stands in the way");
  SubjectInfo exclusive = ClipInfo(Contract::kWatertight);
  exclusive.profile.tie_rule = {.exclusive = true};
  EXPECT_NE(why(exclusive).find("its key tie_rule stands"), std::string::npos) << why(exclusive);
  SubjectInfo crossing = ClipInfo(Contract::kWatertight);
  crossing.profile.scanline_rounding.bits = 8;
  EXPECT_NE(why(crossing).find("its key scanline_rounding stands"), std::string::npos)
      << why(crossing);
  crossing.profile.guard_band = WindowBox{0, 0, 9, 9};
  EXPECT_NE(why(crossing).find("its keys guard_band, scanline_rounding stand"), std::string::npos)
      << why(crossing);
}

// All triangles lie between samples: that none is covered says nothing.
TEST(ContractEvidence, IsNoneWhereNoTriangleReachesASample) {
  SubjectInfo info = RealInfo();
  info.profile.coordinate_limit = 0.001;
  const ContractEvidence evidence = EvidenceOf(info);
  EXPECT_FALSE(evidence.is_exercised);
  EXPECT_NE(evidence.why.find("coordinate_limit"), std::string::npos) << evidence.why;
}

TEST(ContractEvidence, IsThinBelowTheFewestTies) {
  SubjectInfo info = RealInfo();
  PropertyResult result;
  result.property = "CoverageEqualsTheModel";
  result.cases = result.exercised = result.cases_exercised = 9;
  NearEdgeCounts& near_edge = result.domains.emplace_back().near_edge;
  near_edge.samples = 100;
  near_edge.on_edge = kFewestTies - 1;
  EXPECT_EQ(EvidenceOfContract(info, {&result, 1}).thin,
            "thin: 31 samples on an edge test the contract sample-exact, fewer than 32");
  near_edge.on_edge = kFewestTies;
  EXPECT_EQ(EvidenceOfContract(info, {&result, 1}).thin, "");
  near_edge.on_edge = 0;
  result.property = "CoverageKeepsToItsSideOfTheModel";
  info.profile.contract = Contract::kAtMostModel;
  EXPECT_EQ(EvidenceOfContract(info, {&result, 1}).thin, "") << "it states no owners";
}

TEST(ContractEvidence, TellsTooFewCasesAndRefusalsFromTheProfile) {
  SubjectInfo info = RealInfo();
  EXPECT_NE(EvidenceOfContract(info, {}).why.find("raise --cases"), std::string::npos);
  PropertyResult refused;
  refused.property = "CoverageEqualsTheModel";
  refused.cases = refused.cases_refused = 9;
  EXPECT_NE(EvidenceOfContract(info, {&refused, 1}).why.find("refused every case"),
            std::string::npos);
  PropertyResult other;
  other.property = "EqualDrawsGiveEqualCounts";
  other.cases = other.exercised = other.cases_exercised = 9;
  EXPECT_FALSE(EvidenceOfContract(info, {&other, 1}).is_exercised);
}

}  // namespace
}  // namespace rasterproof::props
