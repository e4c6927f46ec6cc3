#include "bench/paired.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <map>
#include <random>
#include <set>
#include <utility>
#include <vector>

namespace rasterproof::bench {
namespace {

TEST(RoundOrder, DrawsEveryMethodOnce) {
  for (const std::size_t count : {1U, 2U, 5U, 8U}) {
    for (std::size_t round = 0; round < 2 * count; ++round) {
      const std::vector<std::size_t> order = RoundOrder(count, round);
      const std::set<std::size_t> all(order.begin(), order.end());
      EXPECT_EQ(all.size(), count);
      EXPECT_EQ(*all.rbegin(), count - 1);
    }
  }
}

TEST(RoundOrder, LetsEveryMethodFollowEveryOtherEquallyOften) {
  for (const std::size_t count : {4U, 5U, 7U, 8U}) {
    std::map<std::pair<std::size_t, std::size_t>, int> follows;
    for (std::size_t round = 0; round < 2 * count; ++round) {
      const std::vector<std::size_t> order = RoundOrder(count, round);
      for (std::size_t k = 1; k < count; ++k) ++follows[{order[k - 1], order[k]}];
    }
    EXPECT_EQ(follows.size(), count * (count - 1)) << count;
    for (const auto& [pair, times] : follows) EXPECT_EQ(times, 2) << count;
  }
}

TEST(MedianInterval, HoldsTheMedianAndCutsOffWhatTheSignTestAllows) {
  // 6 values: the whole range holds the median with 96.9 %. 12: the 3rd to the 10th with 96.1 %.
  EXPECT_EQ(MedianInterval({3, 1, 2, 6, 5, 4}), (Interval{1, 3.5, 6}));
  std::vector<double> twelve;
  for (int i = 1; i <= 12; ++i) twelve.push_back(i);
  EXPECT_EQ(MedianInterval(twelve), (Interval{3, 6.5, 10}));
  EXPECT_EQ(MedianInterval({7}), (Interval{7, 7, 7}));
}

TEST(RatioInterval, HoldsTheTrueRatioAsOftenAsItSays) {
  // Skewed noise, the same distribution on both sides: the median ratio is 1.
  std::mt19937_64 random(1);
  std::exponential_distribution<double> noise(3);
  int held = 0;
  constexpr int kComparisons = 2000;
  for (int k = 0; k < kComparisons; ++k) {
    std::vector<double> a;
    std::vector<double> b;
    for (int round = 0; round < 12; ++round) {
      a.push_back(1 + noise(random));
      b.push_back(1 + noise(random));
    }
    const Interval ratio = RatioInterval(a, b);
    held += ratio.low <= 1 && ratio.high >= 1 ? 1 : 0;
  }
  // 96.1 % by the binomial distribution; four standard deviations are 1.7 %.
  EXPECT_GE(held, 0.944 * kComparisons);
  EXPECT_LE(held, 0.978 * kComparisons);
}

}  // namespace
}  // namespace rasterproof::bench
