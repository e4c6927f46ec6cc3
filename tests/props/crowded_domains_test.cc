// Domains of many triangles, of ends of numbers and of hardest rays: each has what it is for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <optional>
#include <set>
#include <string_view>
#include <vector>

#include "core/coverage.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/domains/hardest_ray.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

using testing::RealInfo;
using testing::SnappedInfo;

Case Draw(std::string_view domain, const SubjectInfo& info, std::uint64_t index) {
  PhiloxSource bits(1, index);
  return FindDomain(domain)->draw(bits, info);
}

// Whether what a change makes of the scene covers other samples, as a mask shows them.
template <class Change>
bool ShowsInMask(const Case& c, const Change& change) {
  Case changed = c;
  change(changed.scene);
  const CoverageCounts a = exact::Coverage(c.scene, c.profile);
  const CoverageCounts b = exact::Coverage(changed.scene, c.profile);
  for (std::size_t k = 0; k < a.front.size(); ++k) {
    if ((a.front[k] + a.back[k] != 0) != (b.front[k] + b.back[k] != 0)) return true;
  }
  return false;
}

TEST(ManyTriangles, ShowNumbersCutToEightToSixteenBits) {
  std::array<int, 17> of_triangles{};
  std::array<int, 17> of_vertices{};
  int longest = 0;
  constexpr std::size_t kStep = kOneCaseIn > 1 ? 8 : 1;
  for (std::uint64_t i = 0; i < 300; ++i) {
    const Case c = Draw("many-triangles", SnappedInfo(8), i);
    const std::size_t count = c.scene.triangles.size();
    longest += count > 0x10000 ? 1 : 0;
    for (std::size_t cut = 8; cut <= 16; cut += kStep) {
      const std::size_t mask = (std::size_t{1} << cut) - 1;
      of_triangles[cut] += count > mask + 1 && ShowsInMask(c, [&](Scene& scene) {
                             const std::vector<Triangle> all = scene.triangles;
                             for (std::size_t t = 0; t < count; ++t)
                               scene.triangles[t] = all[t & mask];
                           });
      of_vertices[cut] += c.scene.vertices.size() > mask + 1 && ShowsInMask(c, [&](Scene& scene) {
                            for (Triangle& t : scene.triangles) {
                              for (std::int32_t& v : t) v &= static_cast<std::int32_t>(mask);
                            }
                          });
    }
  }
  for (std::size_t cut = 8; cut <= 16; cut += kStep) {
    EXPECT_GT(of_triangles[cut], 1) << cut << " bits";
    EXPECT_GT(of_vertices[cut], 1) << cut << " bits";
  }
  // They take as long as hundreds of others.
  EXPECT_GT(longest, 2);
  EXPECT_LT(longest, 20);
}

// A triangle whose vertices' numbers agree with the one before but for high bits.
TEST(ManyTriangles, ReturnToASlotOfACacheWithAnotherTag) {
  int returns = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Case c = Draw("many-triangles", SnappedInfo(8), i);
    const std::int32_t apart = c.scene.triangles[1][0] - c.scene.triangles[0][0];
    returns += apart >= 256 && (apart & (apart - 1)) == 0 ? 1 : 0;
  }
  EXPECT_GT(returns, 10);
}

TEST(Crowds, HaveAllRemaindersOfTheNumbersOfLanes) {
  for (const std::size_t lanes : {4U, 8U, 16U}) {
    std::set<std::size_t> remainders;
    for (std::uint64_t i = 0; i < 100; ++i) {
      remainders.insert(Draw("crowds", RealInfo(), i).scene.triangles.size() % lanes);
    }
    EXPECT_GE(remainders.size(), 4U);
    EXPECT_TRUE(remainders.contains(0));
    EXPECT_TRUE(remainders.contains(1));
    EXPECT_TRUE(remainders.contains(lanes - 1));
  }
}

TEST(EveryLane, HasOneTriangleInTheFirstAndTheLastLaneOfFullAndPartialVectors) {
  std::array<int, 33> shown_in{};  // by the place in the list
  int alone = 0;
  for (std::uint64_t i = 0; i < 400; ++i) {
    const Case c = Draw("every-lane", SnappedInfo(8), i);
    const std::size_t count = c.scene.triangles.size();
    const auto first = Corners(c.scene, c.scene.triangles[0]);
    for (std::size_t t = 0; t < count && t < shown_in.size(); ++t) {
      const auto v = Corners(c.scene, c.scene.triangles[t]);
      const double x = v[0].x - first[0].x;
      const double y = v[0].y - first[0].y;
      const bool is_flat = v[1].x == v[2].x && v[1].y == v[2].y;
      if (!is_flat && t != 0) {
        EXPECT_EQ(v[1].x - x, first[1].x) << i;
        EXPECT_EQ(v[1].y - y, first[1].y) << i;
      }
      const bool shows = ShowsInMask(c, [&](Scene& scene) {
        scene.triangles.erase(scene.triangles.begin() + static_cast<std::ptrdiff_t>(t));
      });
      shown_in[t] += shows ? 1 : 0;
      alone += shows && t + 1 == count && count % 16 == 1 && count > 1 ? 1 : 0;
    }
  }
  for (const std::size_t lane : {0U, 3U, 4U, 7U, 8U, 15U, 16U, 31U, 32U}) {
    EXPECT_GT(shown_in[lane], 9) << lane;
  }
  EXPECT_GT(alone, 30);
}

// The largest magnitude of an edge value at a sample of the target, or of the area, in units.
double LargestValue(const Case& c, double unit) {
  double largest = 0;
  for (const Triangle& t : c.scene.triangles) {
    const auto v = Corners(c.scene, t);
    const double area =
        (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);
    largest = std::max(largest, std::fabs(area) / unit / unit);
  }
  return largest;
}

TEST(AccumulatorEnds, ComeNextToPowersOfTwo) {
  const double unit = 0x1p-8;
  for (const double end : {0x1p15, 0x1p16, 0x1p23, 0x1p24, 0x1p31, 0x1p32}) {
    int below = 0;
    int beyond = 0;
    for (std::uint64_t i = 0; i < 1500; ++i) {
      const double value = LargestValue(Draw("accumulator-ends", SnappedInfo(8), i), unit);
      below += value > end * 0.96 && value < end ? 1 : 0;
      beyond += value >= end && value < end * 1.04 ? 1 : 0;
    }
    EXPECT_GT(below, 10) << end;
    EXPECT_GT(beyond, 10) << end;
  }
}

// A filter that trusts the sign of its rounded value, and the bound that underflows with it.
int SignWithoutGuard(Point2 a, Point2 b, Point2 p) {
  const double left = (p.x - a.x) * (b.y - a.y);
  const double right = (p.y - a.y) * (b.x - a.x);
  const double value = left - right;
  const double bound = 0x1p-51 * (std::fabs(left) + std::fabs(right));
  if (std::fabs(value) >= bound) return (value > 0) - (value < 0);
  return exact::EdgeSign(a, b, p);
}

TEST(UnderflowingProducts, TellAFloat64FilterWithoutAGuard) {
  int wrong = 0;
  for (std::uint64_t i = 0; i < 100; ++i) {
    const Case c = Draw("underflowing-products", RealInfo(Precision::kFloat64), i);
    for (const Triangle& t : c.scene.triangles) {
      const auto v = Corners(c.scene, t);
      for (std::size_t k = 0; k < 3; ++k) {
        const Point2 a = WindowPoint(v[k]);
        const Point2 b = WindowPoint(v[(k + 1) % 3]);
        for (int place = 0; place < c.scene.width * c.scene.height; ++place) {
          const Point2 p = c.profile.pattern.At(place % c.scene.width, place / c.scene.width);
          wrong += SignWithoutGuard(a, b, p) != exact::EdgeSign(a, b, p) ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(wrong, 10);
}

TEST(NearRectangles, AreSomeAndAreNotOthers) {
  int rectangles = 0;
  int right_angle_alone = 0;
  int kites = 0;
  int small = 0;
  constexpr std::uint64_t kCases = 300;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const Case c = Draw("near-rectangles", SnappedInfo(8), i);
    for (std::size_t k = 0; k + 4 <= c.scene.vertices.size(); k += 4) {
      const auto at = [&](std::size_t n) { return WindowPoint(c.scene.vertices[k + n % 4]); };
      const auto side = [&](std::size_t n) {
        return Point2{at(n + 1).x - at(n).x, at(n + 1).y - at(n).y};
      };
      const auto is_right = [&](std::size_t n) {  // at corner n + 1
        return side(n).x * side(n + 1).x + side(n).y * side(n + 1).y == 0;
      };
      const auto square = [&](std::size_t n) {
        return side(n).x * side(n).x + side(n).y * side(n).y;
      };
      const int right = is_right(0) + is_right(1) + is_right(2) + is_right(3);
      rectangles += right == 4 ? 1 : 0;
      right_angle_alone += right >= 1 && right < 4 ? 1 : 0;
      kites += square(0) == square(3) && square(1) == square(2) && right < 4 ? 1 : 0;
      small += square(0) < 1 && square(1) < 1 ? 1 : 0;
    }
  }
  EXPECT_GT(rectangles, 20);
  EXPECT_GT(right_angle_alone, 20);
  EXPECT_GT(kites, 20);
  EXPECT_GT(small, 20);
}

TEST(NonFiniteDepths, LeavePlacesAlone) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Case c = Draw("non-finite-depths", RealInfo(), i);
    for (const Vertex& v : c.scene.vertices) {
      EXPECT_TRUE(std::isfinite(v.x) && std::isfinite(v.y) && v.w == 1);
    }
  }
}

SubjectInfo ClipInfo(Precision precision) {
  SubjectInfo info = RealInfo(precision);
  info.takes_window = false;
  info.takes_clip = true;
  return info;
}

TEST(OneVertexBehind, IsBehindAndTheOthersAreInFront) {
  for (std::uint64_t i = 0; i < 60; ++i) {
    const Case c = Draw("one-vertex-behind", ClipInfo(Precision::kFloat32), i);
    for (const Triangle& t : c.scene.triangles) {
      const auto v = Corners(c.scene, t);
      EXPECT_EQ(std::ranges::count_if(v, [](const Vertex& p) { return p.w < 0; }), 1);
      EXPECT_EQ(std::ranges::count_if(v, [](const Vertex& p) { return p.w > 0; }), 2);
    }
  }
}

// Twice the six products of the determinant's terms bound what rounding in float32 can hide.
TEST(HardestRays, AreNearerThanARoundingOfTheirProducts) {
  for (const int bits : {23, 44}) {
    int hardest = 0;
    constexpr std::uint64_t kDraws = 400;
    for (std::uint64_t i = 0; i < kDraws; ++i) {
      PhiloxSource source(7, i);
      const Point2 sample{0.5 + static_cast<double>(i % 24), 0.5 + static_cast<double>(i % 7)};
      const HardRays rays = DrawHardestRays(source, sample, bits);
      const Int128 value = ValueOfRays(sample, rays);
      // A sample is 256 (x, y, 1) = 128 (odd, odd, 2): no value is smaller than 128, and few have
      // more in common. The products are 2^40 and more.
      hardest += value <= 128 * 64 && value >= -128 * 64 ? 1 : 0;
      EXPECT_NE(value, 0);
      for (const Ray& ray : {rays.a, rays.b}) {
        for (const std::int64_t x : {ray.x, ray.y, ray.w}) {
          EXPECT_LT(std::abs(x), std::int64_t{1} << bits);
        }
      }
    }
    EXPECT_GT(hardest, 300) << bits;
  }
}

TEST(HardestRays, FindAVertexOfAValueNearAGuess) {
  const Ray normal{3, -5, 7};
  for (const std::int64_t value : {-3, -1, 1, 2, 11}) {
    const Ray guess{4, -2, 5};
    const std::optional<Ray> found = RayOfValue(normal, value, guess, 16);
    ASSERT_TRUE(found.has_value());
    EXPECT_EQ(3 * found->x - 5 * found->y + 7 * found->w, value);
    // The guess's value is off by 57 - value, 7 steps of the normal's length at most.
    EXPECT_LE(std::abs(found->x - guess.x), 9);
    EXPECT_LE(std::abs(found->y - guess.y), 9);
    EXPECT_LE(std::abs(found->w - guess.w), 9);
  }
  EXPECT_FALSE(RayOfValue({2, 4, 6}, 3, {0, 0, 1}, 16).has_value());
  EXPECT_EQ(RayOfValue({0, 0, 5}, 10, {3, 4, 0}, 16), (Ray{3, 4, 2}));
  EXPECT_FALSE(RayOfValue({1, 0, 0}, 1 << 20, {0, 0, 1}, 16).has_value());
}

}  // namespace
}  // namespace rasterproof::props
