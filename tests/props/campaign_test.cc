#include "props/run/campaign.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_name.h"
#include "props/domains/domain.h"
#include "props/run/case_order.h"
#include "props/run/case_places.h"
#include "props/run/conclude.h"
#include "props/run/property_domains.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::CoverageIsTheModels;
using testing::ModelProperty;
using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::array<std::string_view, 6> kCampaignDomains{
    "uniform-subpixel", "near-edge", "fans", "snap-ties", "ulp-extremes", "target-sizes"};

PropertyResult Campaign(Subject& subject, std::uint64_t cases,
                        std::span<const std::string_view> domains = kCampaignDomains) {
  CampaignOptions options;
  options.cases = cases;
  return RunCampaign(subject, ModelProperty(domains), options);
}

TEST(Campaign, HoldsForASoundSubjectAndSaysWhatItDid) {
  auto subject = testing::Sound(RealInfo());
  const PropertyResult result = Campaign(subject, 120);
  EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
  EXPECT_EQ(result.property, "CoverageIsTheModels");
  EXPECT_EQ(result.subject, "fake");
  EXPECT_EQ(result.cases, 120U);
  EXPECT_EQ(result.cases_exercised, 120U);
  EXPECT_GT(result.exercised, 120U);
  EXPECT_GT(result.NearEdge().on_edge, 0U);
  EXPECT_GT(result.NearEdge().within_1, 0U);
  EXPECT_FALSE(result.counterexample.has_value());
}

struct FoundWithin {
  std::string_view bug;
  FakeSubject subject;
  std::uint64_t cases;  ///< within which it must be found
};

std::vector<FoundWithin> AllPlantedBugs() {
  const SubjectInfo real = RealInfo();
  const SubjectInfo snapped = SnappedInfo(8);
  const auto rule = [](SnapRule r) { return [r](Profile& p) { p.snap.rule = r; }; };
  return {
      {"drops the last column", testing::DropsLastColumn(real), 30},
      {"inclusive edges", testing::Inclusive(real), 30},
      {"inclusive edges, snapped", testing::Inclusive(snapped), 30},
      {"bottom-left rule", testing::WithProfile(real, [](Profile& p) { p.tie_rule.sign_y = -1; }),
       120},
      {"sample off by 1/256",
       testing::WithProfile(snapped,
                            [](Profile& p) { p.pattern.locations = {{129 / 256.0, 0.5}}; }),
       60},
      {"truncating snap", testing::WithProfile(snapped, rule(SnapRule::kTruncate)), 120},
      {"half-up snap", testing::WithProfile(snapped, rule(SnapRule::kHalfUp)), 300},
      {"12 subpixel bits in place of real",
       testing::WithProfile(real, [](Profile& p) { p.snap.bits = 12; }), 60},
      {"float32 edge functions", testing::NaiveFloat32(real), 120},
      {"float64 edge functions", testing::NaiveFloat64(real), 300},
      {"loses triangles of 2048 pixels", testing::LosesLarge(real, 2048), 300},
      {"throws left of the target", testing::Throwing(real), 30},
  };
}

TEST(Campaign, FindsAndShrinksEveryPlantedBug) {
  for (FoundWithin& planted : AllPlantedBugs()) {
    const PropertyResult result = Campaign(planted.subject, planted.cases);
    ASSERT_EQ(result.outcome, Outcome::kViolated) << planted.bug;
    ASSERT_TRUE(result.counterexample.has_value());
    const Counterexample& found = *result.counterexample;
    RecordProperty(std::string("case of ") + std::string(planted.bug), found.failing_case);
    EXPECT_EQ(found.verdict.outcome, Outcome::kViolated) << planted.bug;
    EXPECT_EQ(found.value.scene.triangles.size(), 1U) << planted.bug;
    EXPECT_LE(found.value.scene.vertices.size(), 3U) << planted.bug;
    EXPECT_FALSE(result.message.empty());
    // The case that failed comes again from its name alone, and fails again.
    const Case again = DrawCase(planted.subject.Info(), ParseCaseName(found.failing_case));
    EXPECT_EQ(RunCase(planted.subject, ModelProperty(kCampaignDomains), again).outcome,
              Outcome::kViolated)
        << planted.bug;
    EXPECT_EQ(again.origin, found.value.origin);
    EXPECT_EQ(again.origin, found.failing_case);
    const Case last = DrawCase(planted.subject.Info(), ModelProperty(kCampaignDomains),
                               kDefaultSeed, result.cases - 1);
    EXPECT_EQ(last.origin, found.failing_case);
  }
}

TEST(Campaign, IsTheSameEveryTimeAndInShards) {
  auto subject = testing::Inclusive(RealInfo());
  const PropertyResult once = Campaign(subject, 100);
  const PropertyResult twice = Campaign(subject, 100);
  EXPECT_EQ(once.counterexample->failing_case, twice.counterexample->failing_case);
  EXPECT_EQ(once.counterexample->value, twice.counterexample->value);
  EXPECT_EQ(once.exercised, twice.exercised);
  CampaignOptions shard;
  shard.first_case = once.cases - 1;
  shard.cases = 1;
  const PropertyResult alone = RunCampaign(subject, ModelProperty(kCampaignDomains), shard);
  EXPECT_EQ(alone.outcome, Outcome::kViolated);
  EXPECT_EQ(alone.counterexample->failing_case, once.counterexample->failing_case);
  EXPECT_EQ(alone.counterexample->value, once.counterexample->value);
}

// The case number i of those that are not chosen ones.
Case DrawnUnder5(const SubjectInfo& info, std::uint64_t i) {
  const CaseOrder order(info, ModelProperty(kCampaignDomains), 5);
  std::uint64_t number = 0;
  for (std::uint64_t drawn = 0;; ++number) {
    if (order.Name(number).seed == 5 && drawn++ == i) break;
  }
  return DrawCase(info, ModelProperty(kCampaignDomains), 5, number);
}

TEST(Campaign, DrawsCaseIFromDomainIModuloTheirNumberByPhiloxOfItsNumberAndIndex) {
  const SubjectInfo info = RealInfo();
  for (std::uint64_t i = 0; i < 12; ++i) {
    const Domain& domain = *FindDomain(kCampaignDomains[i % kCampaignDomains.size()]);
    const std::uint64_t index =
        FirstIndex(ModelProperty(kCampaignDomains).name) + i / kCampaignDomains.size();
    PhiloxSource bits(5, index, domain.number);
    const Case drawn = DrawnUnder5(info, i);
    EXPECT_EQ(drawn.scene.vertices, domain.draw(bits, info).scene.vertices);
    EXPECT_EQ(drawn.scene.name, domain.name);
    EXPECT_EQ(drawn.origin, ToText({std::string(domain.name), index, 5}));
  }
}

TEST(Campaign, ContainsASubjectThatThrows) {
  auto subject = testing::Throwing(RealInfo());
  const PropertyResult result = Campaign(subject, 100);
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_NE(result.message.find("negative column"), std::string::npos) << result.message;
  FakeSubject odd(RealInfo(), [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw 7;  // NOLINT: what a plugin may do
  });
  EXPECT_EQ(Campaign(odd, 1).outcome, Outcome::kViolated);
  FakeSubject choosy(RealInfo(), [](const Scene&, const DrawOptions&, CoverageCounts&) {
    throw InputError("scene", "not for me", "send another");
  });
  const PropertyResult refused = Campaign(choosy, 5);
  EXPECT_EQ(refused.outcome, Outcome::kNotApplicable);
  EXPECT_NE(refused.message.find("not for me"), std::string::npos);
}

TEST(Campaign, ThatExercisesNothingIsNoPass) {
  auto subject = testing::Sound(RealInfo());
  Property property = ModelProperty(kCampaignDomains);
  property.ask = [](const PlacedCase&, const Description&) { return Checks{}; };
  const PropertyResult idle = RunCampaign(subject, property, {.cases = 20});
  EXPECT_EQ(idle.outcome, Outcome::kNotExercised);
  EXPECT_EQ(idle.cases, 20U);
  EXPECT_EQ(idle.cases_exercised, 0U);
  EXPECT_FALSE(idle.message.empty());
  EXPECT_EQ(RunCampaign(subject, property, {.cases = 0}).outcome, Outcome::kNotExercised);
  constexpr static ProfileRule kNever{[](const Profile&) { return false; }, "", "no such contract"};
  property.gate.rules = {&kNever, 1};
  const PropertyResult inapplicable = RunCampaign(subject, property, {.cases = 20});
  EXPECT_EQ(inapplicable.outcome, Outcome::kNotApplicable);
  EXPECT_EQ(inapplicable.message, "no such contract");
  EXPECT_EQ(inapplicable.cases, 0U);  // none was drawn for nothing
}

int blamings = 0;  // a property's functions hold no state

TEST(Campaign, BlamesOnceOnTheSmallestCase) {
  auto subject = testing::DropsLastColumn(RealInfo());
  Property property = ModelProperty(kCampaignDomains);
  property.blame = [](const PlacedCase&, const Verdict&, const Description&) {
    ++blamings;
    return Checks{};
  };
  blamings = 0;
  const PropertyResult result = RunCampaign(subject, property, {.cases = 30});
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_EQ(blamings, 1);
}

// A run whose cases the test gives.
class GivenRun {
 public:
  explicit GivenRun(Property property, SubjectInfo info = RealInfo())
      : info_(std::move(info)),
        property_(std::move(property)),
        result_(NothingRun(info_, property_, 1)) {}

  void Add(const Case& c, const Verdict& verdict) { AddCase(0, c, verdict, result_); }
  void operator+=(const GivenRun& next) { result_ += next.result_; }
  const PropertyResult& Concluded() {
    Conclude(info_, property_, result_);
    return result_;
  }
  // Whether it holds, after so many of the case; else what it says.
  std::string After(int times, const Case& c) {
    for (int i = 0; i < times; ++i) Add(c, Verdict::Held(1));
    return Concluded().outcome == Outcome::kHolds ? "holds" : result_.message;
  }
  void Decide(const TierCounts& tiers) { result_.tiers += tiers; }

 private:
  SubjectInfo info_;
  Property property_;
  PropertyResult result_;
};

TEST(Campaign, WithADeadNearEdgeDomainIsNoPass) {
  constexpr std::array<std::string_view, 1> kNearEdge{"near-edge"};
  GivenRun run(ModelProperty(kNearEdge));
  Case far;  // its edges pass no sample within a quarter of a pixel
  far.scene.width = far.scene.height = 4;
  far.scene.vertices = {{0.25, -99}, {0.25, 99}, {-99, 0}};
  far.scene.triangles = {{0, 1, 2}};
  for (int i = 0; i < 3; ++i) run.Add(far, Verdict::Held(1));
  EXPECT_EQ(run.Concluded().outcome, Outcome::kHolds);  // three cases say nothing
  run.Add(far, Verdict::Held(1));
  EXPECT_EQ(run.Concluded().outcome, Outcome::kNotExercised);
  EXPECT_NE(run.Concluded().message.find("near-edge"), std::string::npos);
  far.scene.vertices[0].x = far.scene.vertices[1].x = 0.5;
  run.Add(far, Verdict::Held(1));
  EXPECT_EQ(run.Concluded().outcome, Outcome::kHolds);
}

Case HalfOnSamples() {
  Case c;
  c.scene.width = c.scene.height = 4;
  c.scene.vertices = {{0.5, 0.5}, {3.25, 0.5}, {0.75, 3.25}};
  c.scene.triangles = {{0, 1, 2}};
  return c;
}

// Both facings, and a sample an ulp off an edge.
Case BesideSamples() {
  Case c;
  c.scene.width = c.scene.height = 4;
  c.scene.vertices = {{0.5 + 0x1p-24, -99}, {0.5 + 0x1p-24, 99}, {-99, 0}};
  c.scene.triangles = {{0, 1, 2}, {0, 2, 1}};
  return c;
}

TEST(Campaign, WithoutATieIsNoPassWhereItsDomainsHaveTies) {
  constexpr std::array<std::string_view, 1> kTies{"axis-aligned"};
  GivenRun run(ModelProperty(kTies));
  EXPECT_EQ(run.After(99, BesideSamples()), "holds");  // few cases
  EXPECT_EQ(run.After(1, BesideSamples()),
            "no case has a sample on an edge, and 100 are of domains that can reach it; run more "
            "cases, or correct the domain");
  EXPECT_EQ(run.Concluded().outcome, Outcome::kInconclusive);
  EXPECT_EQ(run.After(1, HalfOnSamples()), "holds");
  constexpr std::array<std::string_view, 1> kNone{"caps"};
  EXPECT_EQ(GivenRun(ModelProperty(kNone)).After(100, BesideSamples()), "holds");
}

TEST(Campaign, OfOneFacingIsNoPassWhereItsDomainsHaveBoth) {
  constexpr std::array<std::string_view, 1> kBoth{"axis-aligned"};
  GivenRun run(ModelProperty(kBoth));
  EXPECT_NE(run.After(100, HalfOnSamples()).find("no case has a triangle of "), std::string::npos);
  EXPECT_EQ(run.After(1, BesideSamples()), "holds");
}

TEST(Campaign, WithoutAClipIsNoPassWhereItsDomainsClip) {
  constexpr std::array<std::string_view, 1> kClip{"mixed-w"};
  SubjectInfo info = RealInfo();
  info.takes_clip = true;
  GivenRun run(ModelProperty(kClip), info);
  Case inside = HalfOnSamples();
  inside.scene.clip_space = true;
  EXPECT_NE(run.After(100, inside).find("off the target or with w <= 0"), std::string::npos);
  inside.scene.vertices[0].w = -1;
  EXPECT_EQ(run.After(1, inside), "holds");
}

TEST(Campaign, WithoutTheExactTierIsNoPassWhereItsDomainsTakeIt) {
  constexpr std::array<std::string_view, 1> kExact{"rounded-differences"};
  GivenRun run(ModelProperty(kExact));
  EXPECT_NE(run.After(100, BesideSamples()).find("exact tier"), std::string::npos);
  run.Decide({.exact = 1});
  EXPECT_EQ(run.After(1, BesideSamples()), "holds");
  EXPECT_EQ(GivenRun(ModelProperty(kExact), SnappedInfo(8)).After(100, BesideSamples()), "holds");
}

TEST(CasePlaces, AreSeenInTheScene) {
  const auto of = [](std::vector<Vertex> vertices) {
    Case c = HalfOnSamples();
    c.scene.vertices = std::move(vertices);
    std::string seen;
    const CasePlaces places = EvidenceOfCase(c).places;
    for (std::size_t p = 0; p < places.size(); ++p) seen += places[p] ? '1' : '0';
    return seen;
  };
  EXPECT_EQ(of({{0.25, 0.5}, {3.25, 0.5}, {0.75, 3.25}}), "1000000010");
  EXPECT_EQ(of({{0.5, 0.25}, {0.5, 3.25}, {3.25, 0.75}}), "0100000100");
  EXPECT_EQ(of({{0.25, 0.25}, {3.25, 3.25}, {3.25, 0.75}}), "0010000100");
  EXPECT_EQ(of({{0.5, 0.5}, {3.25, 0.75}, {0.75, 3.25}}), "0010100010");  // the corner is on edges
  EXPECT_EQ(of({{0.25, 0.375}, {2.25, 0.375}, {3.25, 0.375}}), "0000010000");
  EXPECT_EQ(of({{-3, -1}, {-1, -3}, {-1.25, -1}}), "0000001010");
  Case shared = HalfOnSamples();
  shared.scene.vertices = {{0.25, 0.5}, {3.25, 0.5}, {0.75, 3.25}, {0.75, -1.25}};
  shared.scene.triangles = {{0, 1, 2}, {1, 0, 3}};
  const CasePlaces places = EvidenceOfCase(shared).places;
  EXPECT_TRUE(places[IndexOf(CasePlace::kTieOnSharedEdge)]);
  EXPECT_FALSE(places[IndexOf(CasePlace::kFlatTriangle)]);
}

TEST(CasePlaces, ThatWereRefusedThroughoutAreInconclusive) {
  GivenRun run(ModelProperty(kCampaignDomains));
  Case elsewhere = HalfOnSamples();
  for (Vertex& v : elsewhere.scene.vertices) v.y += 0.125;
  for (int i = 0; i < 100; ++i) run.Add(elsewhere, Verdict::Held(1));
  for (std::uint64_t i = 1; i < kFewestCasesAtAPlace; ++i) {
    run.Add(HalfOnSamples(), Verdict::Refused("odd"));
  }
  EXPECT_EQ(run.Concluded().outcome, Outcome::kHolds);  // few
  GivenRun next(ModelProperty(kCampaignDomains));
  next.Add(HalfOnSamples(), Verdict::Refused("odd"));
  run += next;
  EXPECT_EQ(run.Concluded().outcome, Outcome::kInconclusive);
  EXPECT_NE(run.Concluded().message.find("refuses all 16 cases with a sample on a horizontal edge"),
            std::string::npos)
      << run.Concluded().message;
  run.Add(HalfOnSamples(), Verdict::Held(1));
  EXPECT_EQ(run.Concluded().outcome, Outcome::kHolds);  // one of them was drawn
}

TEST(Campaign, LeavesOutDomainsThatTheSubjectCannotTakeAndSaysSo) {
  auto subject = testing::Sound(RealInfo());
  constexpr std::array<std::string_view, 2> kMixed{"mixed-w", "near-edge"};
  const PropertyResult mixed = Campaign(subject, 10, kMixed);
  EXPECT_EQ(mixed.outcome, Outcome::kHolds);
  EXPECT_NE(mixed.message.find("mixed-w"), std::string::npos);
  constexpr std::array<std::string_view, 1> kClipOnly{"mixed-w"};
  EXPECT_EQ(Campaign(subject, 10, kClipOnly).outcome, Outcome::kNotApplicable);
  EXPECT_THROW(DrawCase(subject.Info(), ModelProperty(kClipOnly), 1, 0), InputError);
}

TEST(Campaign, StopsWhenItsTimeIsUpAndReportsProgress) {
  auto subject = testing::Sound(RealInfo());
  std::vector<std::uint64_t> reported;
  CampaignOptions options;
  options.cases = 40;
  options.progress = [&](std::uint64_t done) { reported.push_back(done); };
  RunCampaign(subject, ModelProperty(kCampaignDomains), options);
  EXPECT_EQ(reported, (std::vector<std::uint64_t>{16, 32}));
  options.cases = std::uint64_t{1} << 60;
  options.seconds = 1e-9;
  EXPECT_LE(RunCampaign(subject, ModelProperty(kCampaignDomains), options).cases, 1U);
}

}  // namespace
}  // namespace rasterproof::props
