#include "props/domains/hardest.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "core/profile.h"
#include "exact/edge.h"
#include "props/domains/bit_source.h"
#include "props/domains/input_lattice.h"

namespace rasterproof::props {
namespace {

std::int64_t FirstByTrying(int a, int m, int low, int high) {
  for (int i = 0; i < m; ++i) {
    if (a * i % m >= low && a * i % m <= high) return i;
  }
  return -1;
}

TEST(FirstInRange, IsTheFirstThatTryingFindsForEveryModulusUpTo19) {
  for (int m = 1; m <= 19; ++m) {
    for (int a = 0; a < m; ++a) {
      for (int low = 0; low < m; ++low) {
        for (int high = low; high < m; ++high) {
          ASSERT_EQ(static_cast<std::int64_t>(FirstInRange(a, m, low, high)),
                    FirstByTrying(a, m, low, high))
              << a << " mod " << m << " in [" << low << ", " << high << "]";
        }
      }
    }
  }
}

TEST(FirstInRange, SaysNoneWhenTheFirstLiesPastTheCapInsteadOfOverflowing) {
  const Int128 m = (Int128{1} << 72) - 93;
  EXPECT_EQ(static_cast<std::int64_t>(FirstInRange(1, m, Int128{1} << 60, Int128{1} << 60)), -1);
  EXPECT_EQ(static_cast<std::int64_t>(FirstInRange(m - 1, m, 1, 1)), -1);
}

TEST(ArgMinModulo, FindsTheSmallestResidue) {
  PhiloxSource bits(1, 0);
  for (int round = 0; round < 3000; ++round) {
    const std::int64_t m = bits.Int(1, 1000);
    const std::int64_t a = bits.Int(-1000, 1000);
    const std::int64_t c = bits.Int(-1000, 1000);
    const std::int64_t n = bits.Int(1, 100);
    const auto residue = [&](std::int64_t i) { return ((a * i + c) % m + m) % m; };
    std::int64_t least = m;
    for (std::int64_t i = 0; i < n; ++i) least = std::min(least, residue(i));
    const auto found = static_cast<std::int64_t>(ArgMinModulo(a, c, m, n));
    ASSERT_GE(found, 0);
    ASSERT_LT(found, n);
    ASSERT_EQ(residue(found), least) << a << " i + " << c << " mod " << m << ", n " << n;
  }
}

double EdgeValue(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

TEST(HardestVertex, HasTheSmallestEdgeValueOfEveryPlaceInItsRun) {
  Profile profile;
  profile.snap.bits = 4;
  const InputLattice lattice(profile, Precision::kFloat32);
  PhiloxSource bits(1, 1);
  int found = 0;
  for (int round = 0; round < 400; ++round) {
    const auto sixteenth = [&](int low, int high) {
      return std::ldexp(static_cast<double>(bits.Int(low, high)), -4);
    };
    const Point2 q{sixteenth(0, 256), sixteenth(0, 256)};
    const Point2 p{static_cast<double>(bits.Int(0, 15)) + 0.5,
                   static_cast<double>(bits.Int(0, 15)) + 0.5};
    const Point2 v{sixteenth(16, 500), sixteenth(16, 500)};
    const auto best = HardestVertex(v, q, p, lattice, +1);
    if (!best) continue;
    ++found;
    const double value = EdgeValue(*best, q, p);  // exact: few bits
    ASSERT_GT(value, 0);
    // Every x of the run gets its own best y: none is better. (Or y's, for a steep line.)
    const bool flat = std::fabs(p.y - q.y) <= std::fabs(q.x - p.x);
    const double length = flat ? best->x : best->y;
    for (double along = flat ? v.x : v.y; along <= length; along += 0x1p-4) {
      const double centre = flat ? best->y : best->x;
      for (int step = -40; step <= 40; ++step) {
        const double across = centre + step * 0x1p-4;
        const Point2 other = flat ? Point2{along, across} : Point2{across, along};
        const double other_value = EdgeValue(other, q, p);
        if (other_value > 0) {
          ASSERT_GE(other_value, value);
        }
      }
    }
  }
  EXPECT_GT(found, 40);
}

TEST(HardestVertex, IsNearerThanItsNeighboursOnTheFloatLattices) {
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    const InputLattice lattice(Profile{}, precision);
    PhiloxSource bits(1, 2);
    int found = 0;
    for (int round = 0; round < 200; ++round) {
      const auto place = [&] {
        return lattice.Round(1 + std::ldexp(static_cast<double>(bits.Bits(53)), -49));
      };
      const Point2 q{place(), place()};
      const Point2 p{static_cast<double>(bits.Int(1, 15)) + 0.5,
                     static_cast<double>(bits.Int(1, 15)) + 0.5};
      const double t = 1.5;
      const Point2 v{lattice.Round(q.x + t * (p.x - q.x)), lattice.Round(q.y + t * (p.y - q.y))};
      const int sign = bits.Chance(128) ? 1 : -1;
      const auto best = HardestVertex(v, q, p, lattice, sign);
      if (!best) continue;
      ++found;
      EXPECT_EQ(exact::EdgeSign(*best, q, p), sign);
      EXPECT_EQ(lattice.Round(best->x), best->x);
      EXPECT_EQ(lattice.Round(best->y), best->y);
      // One step against the sign reaches the line or crosses it.
      const double toward_x = sign * (p.y - q.y) > 0 ? -1 : 1;
      const Point2 beside{lattice.Move(best->x, static_cast<std::int64_t>(toward_x)), best->y};
      EXPECT_NE(exact::EdgeSign(beside, q, p), sign);
    }
    EXPECT_GT(found, 100);
  }
}

TEST(HardestPixel, HasTheSmallestEdgeValueOfThePixelsAlongTheEdge) {
  PhiloxSource bits(1, 3);
  for (int round = 0; round < 300; ++round) {
    const auto place = [&] { return std::ldexp(static_cast<double>(bits.Int(0, 64 * 256)), -8); };
    const Point2 a{place(), place()};
    const Point2 b{place(), place()};
    const auto best = HardestPixel(a, b, {0.5, 0.5}, +1);
    if (!best) continue;
    const auto value = [&](std::int64_t i, std::int64_t j) {
      return EdgeValue(a, b, {static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5});
    };
    const double least = value(best->i, best->j);
    ASSERT_GT(least, 0);
    const bool flat = std::fabs(b.y - a.y) <= std::fabs(b.x - a.x);
    for (std::int64_t i = -2; i < 67; ++i) {
      for (std::int64_t j = -2; j < 67; ++j) {
        const double along = static_cast<double>(flat ? i : j) + 0.5;
        const bool meets = along >= (flat ? std::min(a.x, b.x) : std::min(a.y, b.y)) &&
                           along <= (flat ? std::max(a.x, b.x) : std::max(a.y, b.y));
        if (meets && value(i, j) > 0) {
          ASSERT_GE(value(i, j), least);
        }
      }
    }
  }
}

TEST(HardestPixel, FindsNoneOnAnEdgeWithoutLength) {
  EXPECT_FALSE(HardestPixel({1, 1}, {1, 1}, {0.5, 0.5}, +1).has_value());
}

}  // namespace
}  // namespace rasterproof::props
