#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/ulp.h"
#include "tests/props/faulty_subjects.h"
#include "tests/props/rapidcheck_bridge.h"

namespace rasterproof::props {
namespace {

using testing::ModelProperty;
using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::array<std::string_view, 4> kRapidCheckDomains{"uniform-subpixel", "near-edge",
                                                             "fans", "snap-ties"};

TEST(RapidCheck, HoldsForASoundSubject) {
  auto subject = testing::Sound(RealInfo());
  const PropertyResult result =
      CheckWithRapidCheck(subject, ModelProperty(kRapidCheckDomains), 1, 60);
  EXPECT_EQ(result.outcome, Outcome::kHolds) << result.message;
  EXPECT_EQ(result.cases, 60U);
  EXPECT_GT(result.NearEdge().on_edge, 0U);
}

TEST(RapidCheck, FindsAndShrinksWhatTheCampaignFinds) {
  const auto expect_found = [](FakeSubject subject, std::uint64_t cases) {
    const PropertyResult result =
        CheckWithRapidCheck(subject, ModelProperty(kRapidCheckDomains), 1, cases);
    ASSERT_EQ(result.outcome, Outcome::kViolated);
    ASSERT_TRUE(result.counterexample.has_value());
    EXPECT_EQ(result.counterexample->verdict.outcome, Outcome::kViolated);
    EXPECT_EQ(result.counterexample->value.scene.triangles.size(), 1U);
    EXPECT_LE(result.counterexample->value.scene.vertices.size(), 3U);
    EXPECT_EQ(result.counterexample->value.scene.width * result.counterexample->value.scene.height,
              1);
    const PropertyResult campaign =
        RunCampaign(subject, ModelProperty(kRapidCheckDomains), {.cases = cases, .progress = {}});
    EXPECT_EQ(campaign.outcome, Outcome::kViolated);
  };
  expect_found(testing::DropsLastColumn(RealInfo()), 60);
  expect_found(testing::Inclusive(RealInfo()), 60);
  expect_found(testing::Inclusive(SnappedInfo(8)), 60);
  expect_found(testing::Throwing(RealInfo()), 60);
}

TEST(RapidCheck, TakesItsCasesFromTheSeedAloneNotFromTheEnvironment) {
  auto subject = testing::Inclusive(RealInfo());
  const PropertyResult once =
      CheckWithRapidCheck(subject, ModelProperty(kRapidCheckDomains), 5, 60);
  ASSERT_EQ(setenv("RC_PARAMS", "seed=99 max_success=1", 1), 0);
  const PropertyResult twice =
      CheckWithRapidCheck(subject, ModelProperty(kRapidCheckDomains), 5, 60);
  unsetenv("RC_PARAMS");
  EXPECT_EQ(once.cases, twice.cases);
  EXPECT_EQ(once.counterexample->failing_case, "");  // what RapidCheck draws has no name
  EXPECT_EQ(once.counterexample->value, twice.counterexample->value);
}

TEST(RapidCheck, StopsShrinkingAtItsBudget) {
  std::uint64_t draws = 0;
  FakeSubject subject(RealInfo(), [&](const Scene&, const DrawOptions&, CoverageCounts& counts) {
    ++draws;
    counts.front[0] += 7;
  });
  const PropertyResult result =
      CheckWithRapidCheck(subject, ModelProperty(kRapidCheckDomains), 1, 10, /*shrink_budget=*/5);
  EXPECT_EQ(result.outcome, Outcome::kViolated);
  EXPECT_LE(draws, 1 + 5 + 1U);  // the failure, the budget, the last word on the counterexample
}

TEST(RapidCheck, GivesNothingToASubjectThatTakesNoneOfTheDomains) {
  auto subject = testing::Sound(RealInfo());
  constexpr std::array<std::string_view, 1> kClip{"mixed-w"};
  EXPECT_EQ(CheckWithRapidCheck(subject, ModelProperty(kClip)).outcome, Outcome::kNotApplicable);
}

TEST(HardFloats, ReachZerosSubnormalsEndsAndHalfPixelsInBothPrecisions) {
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    const rc::Gen<double> floats = HardFloats(precision);
    const bool single = precision == Precision::kFloat32;
    const double least_normal = single ? 0x1p-126 : 0x1p-1022;
    const double large = single ? 0x1p127 : 0x1p1023;
    int zeros = 0, negative_zeros = 0, subnormals = 0, ends = 0, half_pixels = 0;
    for (std::uint64_t i = 0; i < 700; ++i) {
      const rc::Shrinkable<double> drawn = floats(rc::Random(i), 10);
      const double x = drawn.value();
      ASSERT_TRUE(std::isfinite(x));
      ASSERT_TRUE(!single || IsFloat32(x));
      zeros += x == 0 ? 1 : 0;
      negative_zeros += x == 0 && std::signbit(x) ? 1 : 0;
      subnormals += x != 0 && std::fabs(x) < least_normal ? 1 : 0;
      ends += std::fabs(x) >= large ? 1 : 0;
      half_pixels += std::fabs(x) < 100 && std::fabs(std::fmod(x, 1)) == 0.5 ? 1 : 0;
      for (auto shrinks = drawn.shrinks();;) {
        const auto next = shrinks.next();
        if (!next) break;
        ASSERT_TRUE(!single || IsFloat32(next->value()));
      }
    }
    EXPECT_GT(zeros, 50);
    EXPECT_GT(negative_zeros, 20);
    EXPECT_GT(subnormals, 50);
    EXPECT_GT(ends, 50);
    EXPECT_GT(half_pixels, 5);
  }
}

}  // namespace
}  // namespace rasterproof::props
