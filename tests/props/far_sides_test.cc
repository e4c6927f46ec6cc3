// Edge values of as many bits as the stated range and a large target ask for, and meshes of
// ordinary size whatever the range.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/fixed_input.h"
#include "core/scene.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

constexpr std::uint64_t kDrawnCases = 200;

template <class Holds>
int CountOfCases(std::string_view domain, const SubjectInfo& info, Holds holds) {
  int cases = 0;
  for (std::uint64_t i = 0; i < kDrawnCases; ++i) {
    PhiloxSource bits(1, i);
    cases += holds(FindDomain(domain)->draw(bits, info)) ? 1 : 0;
  }
  return cases;
}

SubjectInfo IntegerInfo(int integer_bits, int fraction_bits, bool is_signed) {
  SubjectInfo info = SnappedInfo(fraction_bits);
  info.profile.snap = {};
  info.profile.fixed = FixedInput{integer_bits, fraction_bits, is_signed, false};
  return info;
}

double EdgeValueAt(const Vertex& a, const Vertex& b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// The largest |E| of an edge at a sample of the target, in square pixels: it is at a corner.
double FarthestValue(const Case& c) {
  const std::array<double, 2> xs{0.5, c.scene.width - 0.5};
  const std::array<double, 2> ys{0.5, c.scene.height - 0.5};
  double largest = 0;
  for (const Triangle& t : c.scene.triangles) {
    const std::array<Vertex, 3> v = Corners(c.scene, t);
    for (std::size_t k = 0; k < 3; ++k) {
      for (const double x : xs) {
        for (const double y : ys) {
          largest = std::max(largest, std::fabs(EdgeValueAt(v[k], v[(k + 1) % 3], {x, y})));
        }
      }
    }
  }
  return largest;
}

TEST(FarSides, HaveValuesOf34BitsAndNeverMoreOfSigned12Point4Input) {
  // In units of 1/16 pixel, an edge value has 256 a square pixel.
  constexpr double k33Bits = 0x1p32 / 256;
  constexpr double k34Bits = 0x1p33 / 256;
  const SubjectInfo fixed = IntegerInfo(12, 4, true);
  SubjectInfo limited = SnappedInfo(4);
  limited.profile.coordinate_limit = 2048;
  for (const SubjectInfo& info : {fixed, limited}) {
    EXPECT_GE(
        CountOfCases("far-sides", info, [](const Case& c) { return FarthestValue(c) >= k33Bits; }),
        40);
    EXPECT_EQ(
        CountOfCases("far-sides", info, [](const Case& c) { return FarthestValue(c) >= k34Bits; }),
        0);
    for (const std::string_view other : {"range-ends", "target-sizes", "far-negative-corners"}) {
      EXPECT_LE(CountOfCases(other, info,
                             [](const Case& c) {
                               return std::max(c.scene.width, c.scene.height) <= 4096 &&
                                      FarthestValue(c) >= k33Bits;
                             }),
                2)
          << other;
    }
  }
}

// The figures on which the mutants of 33 and 34 bits rest.
TEST(FarSides, OfA4096By4096TargetAskFor34BitsExactly) {
  const auto at = [](double x, double y) { return Vertex{x / 16, y / 16, 0, 1}; };
  const Vertex a = at(32767, -32768);
  const Vertex b = at(-32768, 32767);
  const double largest = 256 * std::fabs(EdgeValueAt(a, b, {4095.5, 4095.5}));
  EXPECT_EQ(largest, 8'588'820'495);
  EXPECT_LT(largest, 0x1p33);
  EXPECT_GT(256 * std::fabs(EdgeValueAt(a, b, {4096.5, 4096.5})), 0x1p33);
  // In the vertices' box, and with two rows of 4096 already beyond it.
  EXPECT_LT(256 * std::fabs(EdgeValueAt(a, b, {32767.0 / 16, 32767.0 / 16})), 0x1p32);
  EXPECT_GT(256 * std::fabs(EdgeValueAt(a, b, {4095.5, 1.5})), 0x1p32);
}

TEST(FarSides, SpanTheRangeOfEveryFormatOnTargetsOfUpTo4096ASide) {
  for (const SubjectInfo& info :
       {IntegerInfo(12, 4, true), IntegerInfo(12, 4, false), IntegerInfo(16, 8, true),
        IntegerInfo(28, 4, true), SnappedInfo(8), RealInfo()}) {
    const auto& fixed = info.profile.fixed;
    const double range = std::min(info.profile.coordinate_limit, 0x1p24);
    const double span = fixed ? std::min(fixed->Span(), 2 * range) : 2 * range;
    EXPECT_GE(CountOfCases("far-sides", info,
                           [&](const Case& c) {
                             const auto [left, right] =
                                 std::ranges::minmax(c.scene.vertices, {}, &Vertex::x);
                             return right.x - left.x > 0.99 * span;
                           }),
              60);
    EXPECT_EQ(CountOfCases("far-sides", info,
                           [](const Case& c) {
                             const auto [across, length] =
                                 std::minmax(c.scene.width, c.scene.height);
                             return across <= 40 && length <= 4096;
                           }),
              static_cast<int>(kDrawnCases));
    EXPECT_GE(
        CountOfCases("far-sides", info,
                     [](const Case& c) { return std::max(c.scene.width, c.scene.height) == 4096; }),
        60);
  }
}

double HeightOf(const Scene& scene, const Triangle& t) {
  const std::array<Vertex, 3> v = Corners(scene, t);
  const auto [top, bottom] = std::ranges::minmax({v[0].y, v[1].y, v[2].y});
  return bottom - top;
}

// A wider contract takes no ordinary mesh away.
TEST(EverySize, IsOrdinaryWhateverTheRange) {
  for (const double limit : {0x1p15, 0x1p20, 0x1p30, 0x1p127}) {
    SubjectInfo info = SnappedInfo(8);
    info.profile.coordinate_limit = limit;
    const auto has_only = [](const Case& c, double least, double most) {
      return std::ranges::all_of(c.scene.triangles, [&](const Triangle& t) {
        const double height = HeightOf(c.scene, t);
        return height >= least && height <= most;
      });
    };
    const auto ordinary = [&](const Case& c) { return has_only(c, 128, 0x1p15); };
    const auto small = [&](const Case& c) { return has_only(c, 0, 64); };
    EXPECT_GE(CountOfCases("every-size", info, ordinary), 20) << limit;
    EXPECT_GE(CountOfCases("every-size", info, small), 20) << limit;
    if (limit <= 0x1p20) continue;
    EXPECT_LE(CountOfCases("covering-fans", info, ordinary), 2) << limit;
  }
}

TEST(EverySize, HasNeighboursOnBothSidesOfASwitchBySize) {
  const auto are_unequal = [](const Case& c) {
    if (c.scene.triangles.size() != 2) return false;
    const double a = HeightOf(c.scene, c.scene.triangles[0]);
    const double b = HeightOf(c.scene, c.scene.triangles[1]);
    return std::max(a, b) > 4 * std::min(a, b);
  };
  EXPECT_GE(CountOfCases("every-size", SnappedInfo(8), are_unequal), 20);
}

}  // namespace
}  // namespace rasterproof::props
