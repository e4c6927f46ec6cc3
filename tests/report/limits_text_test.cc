#include "report/limits_text.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <string>

namespace rasterproof::report {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

std::string TextOf(double proved, double held, double failing) {
  BenchCliff cliff;
  cliff.proved_to = proved;
  cliff.held_to = held;
  cliff.first_failing = failing;
  return CliffText(cliff);
}

TEST(ValueText, NamesLargePowersOfTwoAndTheirNeighbours) {
  EXPECT_EQ(ValueText(4097), "4097");
  EXPECT_EQ(ValueText(94906265), "94906265");
  EXPECT_EQ(ValueText(0x1p24), "2^24");
  EXPECT_EQ(ValueText(0x1p24 + 1), "2^24 + 1");
  EXPECT_EQ(ValueText(0x1p23 - 1), "2^23 - 1");
  EXPECT_EQ(ValueText(0x1p-24), "2^-24");
  EXPECT_EQ(ValueText(0x1p53), "2^53");
}

TEST(CliffText, SaysWhatIsProvedWhatFailsAndWhatIsNeither) {
  EXPECT_EQ(TextOf(4096, 4097, 4098),
            "proved to 4096, first seen failing at 4098, not proved between");
  EXPECT_EQ(TextOf(4096, 4096, 4097), "proved to 4096, first seen failing at 4097");
  EXPECT_EQ(TextOf(4096, 4094, 4095),
            "proved to 4096, first seen failing at 4095, which contradicts the proof");
  EXPECT_EQ(TextOf(kNone, 4097, 4098),
            "nothing proved, first seen failing at 4098, seen holding at 4097");
  EXPECT_EQ(TextOf(kNone, kNone, 3),
            "nothing proved, first seen failing at 3, the least value tried");
  EXPECT_EQ(TextOf(0x1p53, 0x1p53, kNone), "proved to 2^53, seen holding to 2^53");
}

BenchResult Found() {
  BenchResult result;
  for (const char* name : {"one", "two", "three"}) {
    result.methods.emplace_back().name = name;
  }
  result.parameters.push_back({.name = "grid", .summary = "Side", .unit = "steps"});
  BenchPoint point;
  point.value = 4;
  point.asked = 3;
  point.wrong = 1;
  result.curves.push_back({0, 0, {point}});
  for (const double failing : {5.0, 7.0, 5.0}) {
    BenchCliff cliff;
    cliff.method = static_cast<std::uint32_t>(result.cliffs.size());
    cliff.first_failing = failing;
    result.cliffs.push_back(cliff);
  }
  return result;
}

TEST(LimitsToTable, SaysTheSameOfSeveralMethodsOnce) {
  const std::string table = LimitsToTable(Found());
  EXPECT_NE(table.find("grid: Side; in steps.\n"), std::string::npos) << table;
  EXPECT_NE(table.find("the least value tried: one, three\n"), std::string::npos) << table;
  EXPECT_NE(table.find("failing at 7, the least value tried: two\n"), std::string::npos) << table;
}

}  // namespace
}  // namespace rasterproof::report
