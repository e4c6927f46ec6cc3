// Exact coverage as a library, where float32 arithmetic goes astray: in a caller's environment, and
// in the depths of slivers.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stdexcept>
#include <tuple>
#include <vector>

#include "core/float_environment.h"
#include "library/rasterize.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

constexpr std::array kEverySet{InstructionSet::kScalar, InstructionSet::kSse4,
                               InstructionSet::kAvx2, InstructionSet::kAvx512,
                               InstructionSet::kNeon};
constexpr float kInfinity = std::numeric_limits<float>::infinity();

struct Triangles {
  std::vector<float> positions = {};
  std::vector<std::uint32_t> indices = {};

  RasterMesh Mesh() const { return {positions, indices}; }
  void AddVertex(float x, float y, float z) {
    indices.push_back(static_cast<std::uint32_t>(positions.size() / 3));
    positions.insert(positions.end(), {x, y, z});
  }
};

using Spans = std::vector<std::tuple<std::uint32_t, bool, int, int, int>>;

Spans SpansOf(const Triangles& triangles, int side, InstructionSet set) {
  Spans spans;
  Rasterize(
      triangles.Mesh(), side, side,
      [&](const RasterSpan& s) { spans.emplace_back(s.triangle, s.is_front, s.y, s.x0, s.x1); },
      set);
  return spans;
}

// Corners on half pixels, and in place of zeros numbers of 2^-149 to 2^-60: edges that pass a
// centre by as little.
Triangles TinyTriangles(int count) {
  Triangles triangles;
  reference::RandomValues random(1);
  const auto coordinate = [&] {
    const int halves = random.Integer(-3, 4);
    if (halves > 0) return static_cast<float>(halves) * 0.5F;
    return random.LogUniform<float>(-149, -60);
  };
  for (int i = 0; i < 3 * count; ++i) {
    const float x = coordinate();
    const float y = coordinate();
    triangles.AddVertex(x, y, 0);
  }
  return triangles;
}

TEST(RasterizeFloats, CoverageDoesNotDependOnTheCallersEnvironment) {
  const Triangles triangles = TinyTriangles(Cases(100000));
  using Environment = FloatEnvironment;
  const auto honest = Environment::Current();
  for (const InstructionSet set : kEverySet) {
    if (!IsSupported(set)) continue;
    const Spans expected = SpansOf(triangles, 4, set);
    ASSERT_FALSE(expected.empty());
    for (const auto bits :
         {Environment::kFlushToZero, Environment::kDenormalsAreZero,
          Environment::kFlushToZero | Environment::kDenormalsAreZero, Environment::kDownward,
          Environment::kUpward, Environment::kTowardZero}) {
      FloatEnvironment::Set(honest | bits);
      const Spans spans = SpansOf(triangles, 4, set);
      const auto after = FloatEnvironment::Current();
      FloatEnvironment::Set(honest);
      EXPECT_EQ(after, honest | bits);
      const auto differ = std::ranges::mismatch(spans, expected);
      EXPECT_TRUE(spans == expected)
          << "set " << static_cast<int>(set) << ", bits " << std::hex << bits << ", "
          << spans.size() << " spans, not " << expected.size() << ", from triangle "
          << (differ.in2 == expected.end() ? 0 : std::get<0>(*differ.in2));
    }
  }
}

TEST(RasterizeFloats, TheCallersEnvironmentComesBackIfACallbackThrows) {
  const Triangles triangle{.positions = {0, 0, 0, 9, 0, 0, 0, 9, 0}, .indices = {0, 1, 2}};
  const auto honest = FloatEnvironment::Current();
  const auto astray = honest | FloatEnvironment::kTowardZero;
  FloatEnvironment::Set(astray);
  EXPECT_THROW(Rasterize(triangle.Mesh(), 9, 9,
                         [](const RasterSpan&) { throw std::domain_error("enough"); }),
               std::domain_error);
  const auto after = FloatEnvironment::Current();
  FloatEnvironment::Set(honest);
  EXPECT_EQ(after, astray);
}

std::vector<float> DepthsOf(const RasterMesh& mesh, int side, InstructionSet set) {
  const auto pixels = static_cast<std::size_t>(side) * static_cast<std::size_t>(side);
  std::vector<float> depths(pixels, kInfinity);
  Rasterize(mesh,
            {.output = RasterOutput::kDepths,
             .width = side,
             .height = side,
             .pitch = static_cast<std::size_t>(side) * sizeof(float),
             .memory = std::as_writable_bytes(std::span(depths))},
            set);
  return depths;
}

// Three corners near a line through a centre, whose area float32 may round to any sign, or to none.
Triangles RandomSliver(reference::RandomValues& random) {
  Triangles sliver;
  const double x = random.Integer(0, 7) + 0.5;
  const double y = random.Integer(0, 7) + 0.5;
  const double dx = random.Uniform(-8, 8);
  const double dy = random.Uniform(-8, 8);
  for (int k = 0; k < 3; ++k) {
    const double at = random.Uniform(-1, 1);
    sliver.AddVertex(static_cast<float>(x + at * dx), static_cast<float>(y + at * dy),
                     static_cast<float>(random.Uniform(-1, 1)));
  }
  return sliver;
}

TEST(RasterizeFloats, DepthsOfCoveredPixelsLieBetweenTheVertices) {
  constexpr int kSide = 8;
  for (const InstructionSet set : kEverySet) {
    if (!IsSupported(set)) continue;
    reference::RandomValues random(2);
    int covered = 0;
    int outside = 0;
    const int slivers = Cases(300000);
    for (int i = 0; i < slivers; ++i) {
      const Triangles sliver = RandomSliver(random);
      const Spans spans = SpansOf(sliver, kSide, set);
      if (spans.empty()) continue;
      const auto z = {sliver.positions[2], sliver.positions[5], sliver.positions[8]};
      const std::vector<float> depths = DepthsOf(sliver.Mesh(), kSide, set);
      for (const auto& [triangle, is_front, y, x0, x1] : spans) {
        for (int column = x0; column < x1; ++column) {
          const float depth = depths[static_cast<std::size_t>(y * kSide + column)];
          ++covered;
          outside += !(std::min(z) <= depth && depth <= std::max(z)) ? 1 : 0;
        }
      }
    }
    EXPECT_GT(covered, slivers / 10000);
    EXPECT_EQ(outside, 0) << "of " << covered << " pixels, set " << static_cast<int>(set);
  }
}

// Of an area that float32 rounds to zero the plane is NaN: then the nearest of the vertices counts.
TEST(RasterizeFloats, APlaneThatIsNotANumberGivesTheLeastZ) {
  const std::array<float, 9> positions{-0x1.766938p+2F, 0x1.63c5acp+2F,  3,
                                       0x1.07349cp+3F,  -0x1.69e0dep+2F, 2,
                                       0x1.165198p+2F,  -0x1.48772ap+1F, 4};
  const std::array<std::uint32_t, 3> indices{0, 1, 2};
  for (const InstructionSet set : kEverySet) {
    if (!IsSupported(set)) continue;
    const std::vector<float> depths = DepthsOf({positions, indices}, 1, set);
    EXPECT_EQ(depths.front(), 2) << static_cast<int>(set);
  }
}

TEST(RasterizeFloats, AZThatIsNotFiniteLeavesTheDepthsAsTheyAre) {
  const std::array<std::uint32_t, 3> indices{0, 1, 2};
  for (const InstructionSet set : kEverySet) {
    if (!IsSupported(set)) continue;
    for (const float bad : {NAN, kInfinity, -kInfinity}) {
      for (std::size_t corner = 0; corner < 3; ++corner) {
        std::array<float, 9> positions{0, 0, 1, 40, 0, 1, 0, 40, 1};
        positions[3 * corner + 2] = bad;
        EXPECT_EQ(DepthsOf({positions, indices}, 4, set), std::vector<float>(16, kInfinity))
            << bad << " at corner " << corner << ", set " << static_cast<int>(set);
      }
    }
  }
}

}  // namespace
}  // namespace rasterproof
