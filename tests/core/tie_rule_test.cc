#include "core/tie_rule.h"

#include <set>
#include <string>

#include "gtest/gtest.h"

namespace rasterproof {
namespace {

TEST(TieRuleTest, EightConsistentRulesHaveNamesThatReadBack) {
  std::set<std::string> names;
  for (const bool y_first : {false, true}) {
    for (const std::int8_t x : {std::int8_t{+1}, std::int8_t{-1}}) {
      for (const std::int8_t y : {std::int8_t{+1}, std::int8_t{-1}}) {
        const TieRule rule{x, y, y_first, false};
        const std::string name = TieRuleName(rule);
        names.insert(name);
        EXPECT_EQ(TieRuleFromName(name), rule);
      }
    }
  }
  EXPECT_EQ(names.size(), 8U);
}

TEST(TieRuleTest, TopLeftShiftsTheSampleRightFirstAndThenDown) {
  EXPECT_EQ(TieRuleName(kTopLeft), "top-left");
  EXPECT_EQ(kTopLeft.sign_x, +1);
  EXPECT_EQ(kTopLeft.sign_y, +1);
  EXPECT_FALSE(kTopLeft.y_first);
}

TEST(TieRuleTest, UnknownNamesGiveNothing) {
  EXPECT_EQ(TieRuleFromName("left-top"), std::nullopt);
  EXPECT_EQ(TieRuleFromName(""), std::nullopt);
}

}  // namespace
}  // namespace rasterproof
