#include "props/shrink/shrink.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "core/ulp.h"
#include "exact/coverage.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/shrink/cost.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;

Case Draw(std::string_view domain, std::uint64_t index, Precision precision = Precision::kFloat32) {
  PhiloxSource bits(1, index);
  return FindDomain(domain)->draw(bits, RealInfo(precision));
}

CoverageCounts Covered(const Case& c) { return exact::Coverage(c.scene, c.profile, c.options); }

bool CoversAnything(const Case& c) {
  const CoverageCounts counts = Covered(c);
  for (std::size_t s = 0; s < counts.size(); ++s) {
    if (counts.Count(s) != 0) return true;
  }
  return false;
}

TEST(Shrink, LeavesOneTriangleOverOnePixelWhereThatIsEnough) {
  for (const std::string_view domain :
       {"triangulations", "fans", "uniform-subpixel", "long-rows"}) {
    std::uint64_t index = 0;
    while (!CoversAnything(Draw(domain, index))) ++index;
    const Shrunk shrunk = Shrink(Draw(domain, index), CoversAnything);
    EXPECT_TRUE(CoversAnything(shrunk.minimal)) << domain;
    EXPECT_EQ(shrunk.minimal.scene.triangles.size(), 1U) << domain;
    EXPECT_EQ(shrunk.minimal.scene.vertices.size(), 3U) << domain;
    EXPECT_EQ(shrunk.minimal.scene.width, 1) << domain;
    EXPECT_EQ(shrunk.minimal.scene.height, 1) << domain;
    EXPECT_EQ(shrunk.minimal.options, DrawOptions{}) << domain;
    for (const Vertex& v : shrunk.minimal.scene.vertices) {
      EXPECT_LE(CoordinateCost(v.x), 1 + 4 + 2U) << v.x;  // one significant bit, near 1
      EXPECT_LE(CoordinateCost(v.y), 1 + 4 + 2U) << v.y;
    }
    EXPECT_LE(shrunk.evaluations, 500U) << domain;
  }
}

TEST(Shrink, KeepsTheNumberOfEachVertexThatIsLeft) {
  Case c = Draw("fans", 0);
  const auto number = [](const Vertex& v) { return 3 * v.x + v.y; };
  c.scene.channels = {{.name = "u"}, {.name = "w", .interpolation = Interpolation::kInverseW}};
  for (const Vertex& v : c.scene.vertices) c.scene.channels[0].values.push_back(number(v));
  const std::size_t vertices = c.scene.vertices.size();
  const Case minimal =
      Shrink(c, [&](const Case& tried) {
        const std::vector<double>& values = tried.scene.channels[0].values;
        return tried.scene.channels[1].values.empty() && !tried.scene.triangles.empty() &&
               std::ranges::equal(tried.scene.vertices, values, [&](const Vertex& v, double value) {
                 return number(v) == value;
               });
      }).minimal;
  EXPECT_EQ(minimal.scene.triangles.size(), 1U);
  EXPECT_LT(minimal.scene.vertices.size(), vertices);
}

TEST(Shrink, KeepsTheTwoTrianglesOfASharedEdgeIfBothAreNeeded) {
  // Under the inclusive rule a sample on the common edge is covered twice.
  const auto covered_twice = [](const Case& c) {
    Case inclusive = c;
    inclusive.profile.tie_rule.inclusive = true;
    const CoverageCounts ours = Covered(c), theirs = Covered(inclusive);
    for (std::size_t s = 0; s < ours.size(); ++s) {
      if (theirs.Count(s) == 2 && ours.Count(s) == 1) return true;
    }
    return false;
  };
  std::uint64_t index = 0;
  while (!covered_twice(Draw("triangulations", index))) ++index;
  const Shrunk shrunk = Shrink(Draw("triangulations", index), covered_twice);
  EXPECT_TRUE(covered_twice(shrunk.minimal));
  EXPECT_EQ(shrunk.minimal.scene.triangles.size(), 2U);
  EXPECT_LE(shrunk.minimal.scene.vertices.size(), 4U);
  EXPECT_EQ(shrunk.minimal.scene.width * shrunk.minimal.scene.height, 1);
}

TEST(Shrink, KeepsTheOptionThatTheFailureNeedsAndDropsTheOthers) {
  Case c = Draw("uniform-subpixel", 0);
  c.options.tile = 8;
  c.options.threads = 3;
  c.options.cull = Cull::kBack;
  const Shrunk shrunk = Shrink(c, [](const Case& k) { return k.options.tile == 8; });
  EXPECT_EQ(shrunk.minimal.options, (DrawOptions{.scissor = {}, .tile = 8}));
  EXPECT_TRUE(shrunk.minimal.scene.triangles.empty());
}

TEST(Shrink, TurnsNanIntoNumbersWhereTheFailureAllows) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  Case c;
  c.scene.vertices = {{kNan, kNan}, {1, 0}, {0, 1}};
  c.scene.triangles = {{0, 1, 2}};
  const Shrunk shrunk = Shrink(c, [](const Case& k) {
    return !k.scene.vertices.empty() && std::isnan(k.scene.vertices[0].x);
  });
  ASSERT_EQ(shrunk.minimal.scene.vertices.size(), 1U);
  EXPECT_TRUE(std::isnan(shrunk.minimal.scene.vertices[0].x));
  EXPECT_EQ(shrunk.minimal.scene.vertices[0].y, 0);
}

TEST(Shrink, NeedsNoBudgetToEndAndObeysOneItIsGiven) {
  const auto always = [](const Case&) { return true; };
  for (const Domain& domain : Domains()) {
    if (domain.clip) continue;
    const Case c = Draw(domain.name, 3);
    const Shrunk shrunk = Shrink(c, always, std::numeric_limits<std::uint64_t>::max());
    EXPECT_TRUE(shrunk.minimal.scene.triangles.empty()) << domain.name;
    EXPECT_EQ(shrunk.minimal.scene.width, 1) << domain.name;
    std::uint64_t calls = 0;
    const auto counted = [&](const Case& k) { return ++calls, !k.scene.triangles.empty(); };
    EXPECT_LE(Shrink(c, counted, 10).evaluations, 10U);
    EXPECT_LE(calls, 10U);
  }
}

TEST(Shrink, EvaluatesOnlyWhatIsStrictlySimplerThanWhatFailedLast) {
  const Case c = Draw("fans", 2);
  Cost last = CostOf(c);
  Shrink(c, [&](const Case& k) {
    EXPECT_LT(CostOf(k), last);
    last = CostOf(k);
    return true;
  });
  EXPECT_LT(last, CostOf(c));
}

TEST(Shrink, EndsWhereItIsNotSaidWhetherACandidateFails) {
  const Case c = Draw("fans", 2);
  std::uint64_t calls = 0;
  const auto said_twice = [&](const Case&) -> std::optional<bool> {
    if (++calls > 2) return std::nullopt;
    return true;
  };
  EXPECT_EQ(Shrink(c, said_twice).evaluations, 3U);
  EXPECT_EQ(calls, 3U);
}

TEST(Shrink, LeavesACaseAloneThatFailsOnlyAsItIs) {
  const Case c = Draw("near-edge", 5);
  const Shrunk shrunk = Shrink(c, [](const Case&) { return false; });
  EXPECT_EQ(shrunk.minimal, c);
  EXPECT_GT(shrunk.evaluations, 0U);
}

TEST(Shrink, CropsTheLeftOnlyWhereVerticesMoveExactly) {
  Case c;
  c.scene.width = 4;
  c.scene.vertices = {{2, 0}, {4, 0}, {2, 2}};
  c.scene.triangles = {{0, 1, 2}};
  EXPECT_EQ(Shrink(c, CoversAnything).minimal.scene.width, 1);
  // 2^-30 less a pixel is no float32, 2^-60 less a pixel no float64: nothing moves.
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    c.scene.precision = precision;
    c.scene.vertices[1].y = precision == Precision::kFloat32 ? 0x1p-30 : 0x1p-60;
    c.scene.vertices[2].x = c.scene.vertices[1].y;
    int cropped = 0;
    for (const Case& k : ShrinkCandidates(c)) {
      if (k.scene.width == c.scene.width) continue;
      ++cropped;
      EXPECT_EQ(k.scene.vertices, c.scene.vertices);  // on the right only
    }
    EXPECT_GT(cropped, 0);
  }
}

TEST(ShrinkCandidates, AreValidAndStrictlySimpler) {
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    for (const Domain& domain : Domains()) {
      if (domain.clip) continue;
      for (std::uint64_t i = 0; i < Cases(3U); ++i) {
        const Case c = Draw(domain.name, i, precision);
        for (const Case& k : ShrinkCandidates(c)) {
          ASSERT_LT(CostOf(k), CostOf(c)) << domain.name;
          ASSERT_GE(k.scene.width, 1);
          ASSERT_GE(k.scene.height, 1);
          ASSERT_EQ(k.profile, c.profile);
          ASSERT_EQ(k.scene.precision, c.scene.precision);
          for (const Triangle& t : k.scene.triangles) {
            for (const std::int32_t index : t) {
              ASSERT_TRUE(index >= 0 && index < static_cast<std::int32_t>(k.scene.vertices.size()));
            }
          }
          for (const Vertex& v : k.scene.vertices) {
            ASSERT_EQ(v.w, 1);
            if (k.scene.precision == Precision::kFloat32) {
              ASSERT_TRUE(IsFloat32(v.x) && IsFloat32(v.y)) << v.x << " " << v.y;
            }
          }
        }
      }
    }
  }
}

TEST(ShrinkCandidates, StartWithTheBoldest) {
  const Case c = Draw("triangulations", 0);
  const std::vector<Case> candidates = ShrinkCandidates(c);
  ASSERT_GT(candidates.size(), 10U);
  EXPECT_TRUE(candidates.front().scene.triangles.empty());
}

TEST(CoordinateCost, RanksNumbersAsAReaderWould) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double ascending[] = {
      0.0, -0.0,  1.0,       2.0,        3.0,
      0.1, 1e300, kInfinity, -kInfinity, std::numeric_limits<double>::quiet_NaN()};
  EXPECT_LT(CoordinateCost(1.0), CoordinateCost(-1.0));
  for (std::size_t i = 1; i < std::size(ascending); ++i) {
    EXPECT_LT(CoordinateCost(ascending[i - 1]), CoordinateCost(ascending[i])) << ascending[i];
  }
}

}  // namespace
}  // namespace rasterproof::props
