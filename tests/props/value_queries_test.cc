// What is asked of values, and what the estimates that decide most of them may miss.
#include "props/judging/values/value_queries.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <string>

#include "core/value_rule.h"
#include "exact/values.h"
#include "props/judging/values/value_channels.h"
#include "props/judging/values/value_estimates.h"
#include "reference/value_methods.h"
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

// Who states no error is held to one that no form in use exceeds: the methods of
// reference/value_methods.h, on triangles where forms differ most.
constexpr double kRoundoff = 0x1p-24;

// Ordinary, thin, far away, and with one corner far away, by the size of the first vertex's place.
reference::ValueTask<float> DrawTask(Random& random, bool in_clip_space) {
  reference::ValueTask<float> task;
  const double offset = random() % 3 == 0 ? Uniform(random, 0, 4096) : 0;
  const double side = std::ldexp(1.0, static_cast<int>(random() % 12));
  for (std::size_t i = 0; i < 3; ++i) {
    const double size = i == 0 && random() % 2 == 0 ? 1024 : side;
    const double w = in_clip_space ? std::ldexp(1.0, static_cast<int>(random() % 12) - 6) : 1;
    task.v[i].w = static_cast<float>(in_clip_space ? w * Uniform(random, 1, 2) : 1);
    task.v[i].x = static_cast<float>((offset + Uniform(random, -size, size)) * task.v[i].w);
    task.v[i].y = static_cast<float>((offset + Uniform(random, -size, size)) * task.v[i].w);
    task.a[i] = static_cast<float>(random() % 4 == 0 ? 1e6 - Uniform(random, 0, 1)
                                                     : Uniform(random, -1, 1));
  }
  if (random() % 4 == 0) {  // all but on the line of the first two
    task.v[2].x = (task.v[0].x + task.v[1].x) / 2 + 0x1p-10F;
    task.v[2].y = (task.v[0].y + task.v[1].y) / 2;
    task.v[2].w = (task.v[0].w + task.v[1].w) / 2;
  }
  task.x = static_cast<float>(std::floor(offset + Uniform(random, 0, 16)) + 0.5);
  task.y = static_cast<float>(std::floor(offset + Uniform(random, 0, 16)) + 0.5);
  return task;
}

// The error over what is allowed; 0 where nothing is said.
double ShareOf(const reference::ValueMethod& method, const reference::ValueTask<float>& task) {
  RayCorners v;
  exact::HomogeneousTriangle corners;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = {task.v[i].x, task.v[i].y, task.v[i].w};
    corners[i] = {v[i].x, v[i].y, v[i].w};
  }
  const Point2 p{task.x, task.y};
  const std::array<double, 3> a{task.a[0], task.a[1], task.a[2]};
  const UsualConditions usual = UsualConditionsOf(v, Interpolation::kPerspective, a, p);
  const double share = kUsualConditions * kRoundoff * usual.denominator;
  if (!(share < 0.5)) return 0;
  const auto value =
      exact::Interpolant(corners, p).Value(Interpolation::kPerspective, exact::ToAttribute(a));
  if (!value) return 0;
  const double shown = method.float32(task);
  if (!std::isfinite(shown)) return std::numeric_limits<double>::infinity();
  const double off = (exact::Rational(shown) - *value).Abs().ToDoubleUp();
  return off / (kUsualConditions * kRoundoff * usual.value / (1 - share));
}

TEST(UsualConditions, AreNotExceededByAnyFormInUse) {
  int methods = 0;
  for (const reference::ValueMethod& method : reference::ValueMethods()) {
    const bool is_plain =
        method.target == reference::ValueTarget::kValue && method.conditions[0] <= kUsualConditions;
    if (!is_plain) continue;  // estimates of 1/w, steps and differences state their own
    ++methods;
    Random random(1);
    double worst = 0;
    for (int k = 0; k < Cases(4000); ++k) {
      const bool in_clip_space = method.space == reference::ValueSpace::kClip && k % 2 == 0;
      worst = std::max(worst, ShareOf(method, DrawTask(random, in_clip_space)));
    }
    std::printf("[ MEASURED ] %-24s error / allowed %.4f\n", std::string(method.name).c_str(),
                worst);
    EXPECT_LE(worst, 1) << method.name;
    EXPECT_GT(worst, 0x1p-12) << method.name << ": nothing was put to the test";
  }
  EXPECT_GE(methods, 8);
}

}  // namespace
}  // namespace rasterproof::props
