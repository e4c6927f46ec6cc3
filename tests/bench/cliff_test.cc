#include "bench/cliff.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "bench/contender.h"
#include "core/rasterizer.h"
#include "reference/exactness.h"
#include "reference/method.h"

namespace rasterproof::bench {
namespace {

std::optional<BenchCliff> CliffOf(Contender& contender, std::string_view parameter) {
  static JudgedCases cases;
  return FindCliff(*DrawerOf(contender), *FindParameter(parameter), cases);
}

std::optional<BenchCliff> CliffOf(std::string_view method, std::string_view parameter) {
  return CliffOf(*MakeMethodContender(*reference::FindMethod(method)), parameter);
}

TEST(FindCliff, OfTheDirectFormIsWhereItsProductsNeedMoreThan24Bits) {
  const auto cliff = CliffOf("f32-direct", "grid-8");
  ASSERT_TRUE(cliff);
  // 4097^2 is odd, and collapses with 4097^2 - 1: a box of 4098 steps is the least that has both.
  EXPECT_EQ(cliff->first_failing, 4098);
  EXPECT_EQ(cliff->held_to, 4097);
  ASSERT_TRUE(cliff->scene);
}

TEST(FindCliff, OfAnExactMethodIsNone) {
  const auto cliff = CliffOf("spans-exact", "grid-8");
  ASSERT_TRUE(cliff);
  EXPECT_TRUE(std::isnan(cliff->first_failing));
  EXPECT_EQ(cliff->held_to, 0x1p53);
}

}  // namespace
}  // namespace rasterproof::bench
