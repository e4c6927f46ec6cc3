#include "report/bench_plot.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

#include "tests/report/json.h"

namespace rasterproof::report {
namespace {

using nlohmann::json;

BenchRow Row(const std::string& family, const std::string& subject, double ratio,
             std::uint64_t wrong) {
  BenchRow row;
  row.family = family;
  row.subject = subject;
  row.arithmetic = subject == "exact" ? "exact" : subject == "quick" ? "fixed point" : "float32";
  row.triangles = 4;
  row.box_pixels = 2000000;
  row.least_seconds = ratio;
  row.median_seconds = 1.5 * ratio;
  row.ratio = ratio;
  row.against_real = {4000000, 500000, wrong, wrong, 0, 0};
  return row;
}

// The baseline is dominated by `exact`, which is cheaper and never wrong; `quick` is the cheapest.
BenchResult Sample() {
  BenchResult result;
  result.baseline = "f32-incremental";
  result.repetitions = 7;
  result.seed = 1;
  result.rows = {Row("large", "f32-incremental", 1, 20), Row("large", "textbook", 1.25, 1000),
                 Row("large", "exact", 0.5, 0), Row("large", "quick", 0.25, 40),
                 Row("needles", "textbook", 2, 0)};
  return result;
}

json Points() { return ParseJson(BenchPlotSpec(Sample()))["data"]["values"]; }

TEST(BenchTableTest, SortsEachFamilyByItsTime) {
  const std::string table = BenchToTable(Sample());
  EXPECT_LT(table.find("large: 4 triangles"), table.find("needles: 4 triangles"));
  EXPECT_LT(table.find("quick"), table.find("exact"));
  EXPECT_LT(table.find("exact"), table.find("f32-incremental  "));
  EXPECT_NE(table.find("1.250 ( 1.875)"), std::string::npos) << table;
}

TEST(BenchJsonTest, HasRatiosAndCountsButNoTimes) {
  const json result = ParseJson(BenchToJson(Sample()));
  EXPECT_EQ(result["baseline"], "f32-incremental");
  ASSERT_EQ(result["rows"].size(), 5U);
  const json& row = result["rows"][1];
  EXPECT_DOUBLE_EQ(row["ratio_median"], 1.875);
  EXPECT_DOUBLE_EQ(row["against_real"]["wrong_per_million_box_pixels"], 500);
  EXPECT_DOUBLE_EQ(row["against_real"]["wrong_per_million_covered"], 2000);
  EXPECT_FALSE(row.contains("seconds"));
}

TEST(BenchPlotTest, TheFrontIsWhatNothingBeatsInBoth) {
  for (const json& point : Points()) {
    const bool expected =
        point["family"] == "needles" || point["subject"] == "exact" || point["subject"] == "quick";
    EXPECT_EQ(point["front"], expected) << testing::PrintToString(point);
  }
}

TEST(BenchPlotTest, NamesTheNaiveMethodTheBaselineAndTheFront) {
  for (const json& point : Points()) {
    EXPECT_EQ(point["label"], point["subject"]) << testing::PrintToString(point);
  }
  BenchResult result = Sample();
  result.rows.push_back(Row("large", "f64-direct", 2, 3));
  const json points = ParseJson(BenchPlotSpec(result))["data"]["values"];
  const auto found = std::ranges::find_if(
      points, [](const json& point) { return point["subject"] == "f64-direct"; });
  ASSERT_NE(found, points.end());
  EXPECT_EQ((*found)["label"], "");
}

TEST(BenchPlotTest, DrawsTheNaiveMethodOnTopOfTheOthers) {
  EXPECT_EQ(Points()[3]["subject"], "textbook");
  EXPECT_EQ(Points()[4]["subject"], "textbook");
}

TEST(BenchPlotTest, ColoursPointsByTheirArithmetic) {
  std::map<std::string, std::string> arithmetic;
  for (const json& point : Points()) arithmetic[point["subject"]] = point["arithmetic"];
  EXPECT_EQ(arithmetic["textbook"], "textbook");
  EXPECT_EQ(arithmetic["f32-incremental"], "float32");
  EXPECT_EQ(arithmetic["exact"], "exact");
  EXPECT_EQ(arithmetic["quick"], "fixed point") << "as it states; no name tells";
}

TEST(BenchPlotTest, BringsItsDataWithIt) {
  const json spec = ParseJson(BenchPlotSpec(Sample()));
  EXPECT_EQ(spec["data"]["values"].size(), 5U);
  EXPECT_FALSE(spec["data"].contains("url"));
  EXPECT_EQ(spec["facet"]["sort"], (json{"large", "needles"}));
}

TEST(BenchPlotTest, AnEmptyResultIsStillATableAndASpecification) {
  EXPECT_FALSE(BenchToTable(BenchResult{}).empty());
  EXPECT_TRUE(ParseJson(BenchPlotSpec(BenchResult{}))["data"]["values"].empty());
  EXPECT_TRUE(ParseJson(BenchToJson(BenchResult{}))["rows"].empty());
}

}  // namespace
}  // namespace rasterproof::report
