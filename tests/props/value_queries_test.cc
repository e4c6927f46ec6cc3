// What is asked of values, and what the estimates that decide most of them may miss.
#include "props/judging/values/value_queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "exact/values.h"
#include "props/judging/values/value_channels.h"
#include "props/judging/values/value_estimates.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using Random = std::mt19937_64;

double Uniform(Random& random, double low, double high) {
  return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
}

// Corners on the target and off it, w of either sign and of many sizes.
RayCorners DrawCorners(Random& random) {
  RayCorners v;
  for (RayCorner& corner : v) {
    const double size = std::ldexp(1.0, static_cast<int>(random() % 40) - 20);
    corner.w = static_cast<float>(random() % 8 == 0 ? -size : size);
    corner.x = static_cast<float>(Uniform(random, -30, 60) * corner.w);
    corner.y = static_cast<float>(Uniform(random, -30, 60) * corner.w);
  }
  if (random() % 4 == 0) v[2] = {v[0].x + v[1].x, v[0].y + v[1].y, v[0].w + v[1].w * 1.25};
  return v;
}

double OffBy(double estimate, const exact::Rational& exact) {
  return (exact::Rational(estimate) - exact).Abs().ToDoubleUp();
}

TEST(ValueEstimate, StaysWithinItsErrorTimesTheCondition) {
  Random random(1);
  double worst = 0;
  for (int k = 0; k < Cases(4000); ++k) {
    const RayCorners v = DrawCorners(random);
    const Point2 p{Uniform(random, -10, 40), Uniform(random, -10, 40)};
    const std::array<double, 3> a{Uniform(random, -1, 1), 1e6, Uniform(random, 0, 1e-3)};
    const exact::HomogeneousTriangle corners{
        {{v[0].x, v[0].y, v[0].w}, {v[1].x, v[1].y, v[1].w}, {v[2].x, v[2].y, v[2].w}}};
    const exact::Interpolant interpolant(corners, p);
    for (const Interpolation by :
         {Interpolation::kLinear, Interpolation::kPerspective, Interpolation::kInverseW}) {
      const auto exact = interpolant.Derivatives(by, exact::ToAttribute(a));
      const ValueEstimate e = EstimateValue(v, by, a, p);
      if (!exact || !std::isfinite(e.condition) || e.condition * 0x1p-40 > 1e300) continue;
      // Where the denominator itself is not known, neither is anything else.
      const double largest = std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
      if (e.condition > 0x1p40 * largest) continue;
      worst = std::max(worst, OffBy(e.value, exact->value) / (kEstimateError * e.condition));
      worst = std::max(worst, OffBy(e.derivatives[0], exact->dx) /
                                  (kEstimateError * e.derivative_conditions[0]));
      worst = std::max(worst, OffBy(e.derivatives[1], exact->dy) /
                                  (kEstimateError * e.derivative_conditions[1]));
    }
  }
  EXPECT_LE(worst, 1);
  EXPECT_GT(worst, 0x1p-10) << "the margin is far wider than it need be";
}

TEST(ValueEstimate, WeightsOfAPowerAreThoseOfItsPlane) {
  const RayCorners v{{{0, 0, 1}, {32, 0, 2}, {0, 64, 4}}};  // at (0, 0), (16, 0), (0, 16)
  const Point2 p{4, 8};
  const auto share = [&](int power, std::size_t i) {
    const std::array<double, 3> w = WeightsOfPower(v, power, p);
    return w[i] / (w[0] + w[1] + w[2]);
  };
  // On the screen 1/4, 1/4, 1/2; in perspective divided by w: 1/4, 1/8, 1/8 of their sum.
  EXPECT_EQ(share(1, 0), 0.25);
  EXPECT_EQ(share(1, 2), 0.5);
  EXPECT_EQ(share(0, 0), 0.5);
  EXPECT_EQ(share(0, 1), 0.25);
  EXPECT_EQ(share(-1, 2), (0.5 / 16) / (0.25 + 0.25 / 4 + 0.5 / 16));
}

TEST(ValueChannels, AreTheScenesOwnIfItHasAny) {
  Scene scene;
  scene.vertices = {{0, 0}, {1, 0}, {0, 1}};
  ValueRule rule;
  EXPECT_TRUE(std::ranges::none_of(ChannelsFor(scene, rule), [](const Channel& channel) {
    return channel.interpolation != Interpolation::kPerspective ||
           channel.at != EvaluatedAt::kSample;
  })) << "what the rule does not state is not asked for";
  rule.flat = rule.linear = rule.inverse_w = rule.centres = true;
  for (const Channel& channel : ChannelsFor(scene, rule)) {
    const bool has_numbers = channel.interpolation != Interpolation::kInverseW;
    EXPECT_EQ(channel.values.size(), has_numbers ? 3U : 0U) << channel.name;
    for (const double x : channel.values)
      EXPECT_EQ(x, static_cast<double>(static_cast<float>(x))) << channel.name;
  }
  scene.channels = {{"u", Interpolation::kLinear, EvaluatedAt::kSample, {1, 2, 3}}};
  EXPECT_EQ(ChannelsFor(scene, rule), scene.channels);
}

}  // namespace
}  // namespace rasterproof::props
