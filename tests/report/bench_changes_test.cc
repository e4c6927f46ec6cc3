#include "report/bench_changes.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>

#include "report/bench_json.h"
#include "tests/report/sample_bench.h"

namespace rasterproof::report {
namespace {

BenchRow& RowOf(BenchResult& result, std::uint32_t family, std::uint32_t method) {
  for (BenchRow& row : result.rows) {
    if (row.family == family && row.method == method) return row;
  }
  ADD_FAILURE() << "no such row";
  return result.rows.front();
}

void Scale(Interval& interval, double by) {
  interval = {interval.low * by, interval.median * by, interval.high * by};
}

TEST(BenchChanges, FindsNoneBetweenARunAndItself) {
  EXPECT_TRUE(BenchChanges(SampleBench(), SampleBench()).empty());
}

TEST(BenchChanges, TellsWhatLiesBeyondBothIntervals) {
  const BenchResult before = SampleBench();
  BenchResult now = before;
  Scale(RowOf(now, 0, 2).ratio, 1.019);  // its intervals reach 1 % either way
  EXPECT_TRUE(BenchChanges(before, now).empty());
  Scale(RowOf(now, 0, 2).ratio, 1.2);
  const auto changes = BenchChanges(before, now);
  ASSERT_EQ(changes.size(), 1U);
  EXPECT_EQ(changes[0].kind, BenchChangeKind::kSlower);
  EXPECT_EQ(changes[0].method, now.methods[2].name);
  EXPECT_EQ(BenchChanges(now, before).front().kind, BenchChangeKind::kFaster);
}

// Of a recorded run: any method that becomes slower by a fifth is found, and it alone.
TEST(BenchChanges, FindsEveryMethodThatBecomesSlowerByAFifth) {
  const std::string record = BenchToJson(SampleBench());
  const BenchResult before = ParseBench(record, "before.json");
  std::size_t slowed = 0;
  for (std::size_t k = 0; k < before.rows.size(); ++k) {
    const BenchFamily& family = before.families[before.rows[k].family];
    if (before.rows[k].method == family.baseline || before.rows[k].method == family.twin) continue;
    BenchResult now = ParseBench(record, "now.json");
    Scale(now.rows[k].ratio, 1.2);
    const auto changes = BenchChanges(before, ParseBench(BenchToJson(now), "now.json"));
    ASSERT_EQ(changes.size(), 1U) << k;
    EXPECT_EQ(changes[0].kind, BenchChangeKind::kSlower);
    EXPECT_EQ(changes[0].method, before.methods[before.rows[k].method].name);
    ++slowed;
  }
  EXPECT_GT(slowed, 10U);
}

TEST(BenchChanges, ForgivesWhatTheBaselineDoesToItself) {
  const BenchResult before = SampleBench();
  BenchResult now = before;
  Scale(RowOf(now, 0, 2).ratio, 1.2);
  RowOf(now, 0, 1).ratio.high = 1.3;  // the twin
  EXPECT_TRUE(BenchChanges(before, now).empty());
}

TEST(BenchChanges, CountsWrongPairsOfTheSameTriangles) {
  const BenchResult before = SampleBench();
  BenchResult now = before;
  RowOf(now, 1, 2).real.missing += 5;
  ASSERT_EQ(BenchChanges(before, now).size(), 1U);
  EXPECT_EQ(BenchChanges(before, now).front().kind, BenchChangeKind::kMoreWrong);
  RowOf(now, 1, 2).boundary_pairs += 1;
  EXPECT_TRUE(BenchChanges(before, now).empty());
}

TEST(BenchChanges, ComparesNoFamilyOfAnotherSeed) {
  const BenchResult before = SampleBench();
  BenchResult now = before;
  now.setting.seed = 3;
  Scale(RowOf(now, 0, 2).ratio, 9);
  EXPECT_TRUE(BenchChanges(before, now).empty());
  EXPECT_NE(BenchChangesText(before, now).find("0 rows compared"), std::string::npos);
}

}  // namespace
}  // namespace rasterproof::report
