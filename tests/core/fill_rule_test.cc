#include "core/fill_rule.h"

#include <set>
#include <string>

#include "gtest/gtest.h"

namespace rasterproof {
namespace {

TEST(FillRuleTest, EightConsistentRulesHaveNamesThatReadBack) {
  std::set<std::string> names;
  for (const bool y_first : {false, true}) {
    for (const std::int8_t x : {std::int8_t{+1}, std::int8_t{-1}}) {
      for (const std::int8_t y : {std::int8_t{+1}, std::int8_t{-1}}) {
        const FillRule rule{x, y, y_first, false};
        const std::string name = FillRuleName(rule);
        names.insert(name);
        EXPECT_EQ(FillRuleFromName(name), rule);
      }
    }
  }
  EXPECT_EQ(names.size(), 8U);
}

TEST(FillRuleTest, TopLeftShiftsTheSampleRightFirstAndThenDown) {
  EXPECT_EQ(FillRuleName(kTopLeft), "top-left");
  EXPECT_EQ(kTopLeft.sign_x, +1);
  EXPECT_EQ(kTopLeft.sign_y, +1);
  EXPECT_FALSE(kTopLeft.y_first);
}

TEST(FillRuleTest, UnknownNamesGiveNothing) {
  EXPECT_EQ(FillRuleFromName("left-top"), std::nullopt);
  EXPECT_EQ(FillRuleFromName(""), std::nullopt);
}

}  // namespace
}  // namespace rasterproof
