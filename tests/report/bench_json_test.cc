#include "report/bench_json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "core/error.h"
#include "report/bench_text.h"
#include "tests/report/sample_bench.h"

namespace rasterproof::report {
namespace {

std::string WithChanged(std::string_view from, std::string_view to) {
  std::string text = BenchToJson(SampleBench());
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

std::string FaultOf(const std::string& text) {
  try {
    ParseBench(text, "bench.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(BenchJson, ReadsBackWhatIsWritten) {
  const std::string text = BenchToJson(SampleBench());
  EXPECT_EQ(BenchToJson(ParseBench(text, "bench.json")), text);
}

TEST(BenchJson, ReadsEveryPart) {
  const BenchResult written = SampleBench();
  const BenchResult read = ParseBench(BenchToJson(written), "bench.json");
  EXPECT_EQ(read.methods.size(), written.methods.size());
  EXPECT_EQ(read.methods[5], written.methods[5]);
  EXPECT_EQ(read.rows[1].real.worst, written.rows[1].real.worst);
  EXPECT_NEAR(read.rows[3].time.high / written.rows[3].time.high, 1, 1e-5);  // six digits
  EXPECT_FALSE(read.rows[6].is_judged);
  EXPECT_EQ(read.setting.seed, written.setting.seed);
  EXPECT_EQ(read.cliffs[0].scene, written.cliffs[0].scene);
  EXPECT_EQ(read.rows[4].own.missing, written.rows[4].own.missing);  // snapped: by its own model
  EXPECT_EQ(read.rows[0].own.worst, written.rows[0].own.worst);
  EXPECT_EQ(read.curves[0].points[2].value, 4096.0);
  EXPECT_EQ(read.curves[0].points[2].wrong, 12U);
  EXPECT_EQ(read.curves[0].points[2].displacement, 0.25);
  EXPECT_EQ(read.curves[1].points[0].time.median, 8e-9);
  EXPECT_EQ(read.fingerprints[0].png, written.fingerprints[0].png);
}

TEST(BenchJson, WhatWasMeasuredIsToldWithTheDigitsOfItsFile) {
  BenchResult result = SampleBench();
  result.rows[3].time.high = 0.51349999;  // 0.513 as it is, 0.514 as the file tells it
  EXPECT_EQ(AsRecorded(result).rows[3].time.high, 0.5135);
}

TEST(BenchJson, TellsTraitsAndLoadAndReadsFilesWithoutThem) {
  BenchResult result = SampleBench();
  EXPECT_TRUE(std::isnan(ParseBench(BenchToJson(result), "old.json").setting.load_before));
  EXPECT_EQ(ParseBench(BenchToJson(result), "old.json").methods[0].traversal, "");
  result.methods[0].traversal = "spans";
  result.methods[0].arithmetic = "f64-direct";
  result.methods[0].space = "window";
  result.methods[0].march = "x86-64-v3";
  result.setting.load_before = 0.25;
  result.setting.load_after = 0.5;
  const BenchResult read = ParseBench(BenchToJson(result), "new.json");
  EXPECT_EQ(read.methods[0], result.methods[0]);
  EXPECT_EQ(read.setting.load_before, 0.25);
  EXPECT_EQ(read.setting.load_after, 0.5);
  EXPECT_NE(BenchToTable(read).find("0.25 at the start, 0.50 at the end"), std::string::npos);
}

TEST(BenchJson, FaultsNamePlaceAndRemedy) {
  for (const auto& [text, words] : {
           std::pair<std::string, std::string>{"{}", "rasterproof bench --json"},
           {"[]", "bench.json"},
           {WithChanged("\"rasterproof_bench\": 3", "\"rasterproof_bench\": 2"),
            "measure again with rasterproof bench --json"},
           {WithChanged("\"family\":\"small\"", "\"family\":\"smal\""), "rows[0].family"},
           {WithChanged("\"baseline\": \"f32-incremental\"", "\"baseline\": \"f32\""),
            "families[0].baseline"},
           {WithChanged("\"clock\": \"processor\"", "\"clock\": \"sun\""), "methods[0].clock"},
           {WithChanged("\"parameter\":\"steps\"", "\"parameter\":\"step\""),
            "curves[0].parameter"},
           {WithChanged("[[2,1000,0,0,2e-08]", "[[2,1000,0,0]"), "curves[0].points[0]"},
           {WithChanged("\"missing\":5", "\"missing\":-5"), "rows[0].real.missing"},
           {WithChanged("\"ratio\":[0.99,1,", "\"ratio\":[1.5,1,"),
            "rows[0].ratio: is no interval"},
           {WithChanged("\"wall_seconds\"", "\"elapsed\""), "rows[0]"},
           {WithChanged("\"seed\": \"1", "\"seed\": \"x1"), "below 2^64"},
       }) {
    EXPECT_NE(FaultOf(text).find(words), std::string::npos) << words << ": " << FaultOf(text);
  }
}

}  // namespace
}  // namespace rasterproof::report
