// The table itself: names that others rely on, and what each row says of itself.
#include <gtest/gtest.h>

#include <limits>
#include <set>
#include <string>

#include "reference/method.h"

namespace rasterproof::reference {
namespace {

TEST(MethodTableTest, EveryNamedMethodIsThereOnce) {
  std::set<std::string> names;
  for (const Method& method : Methods()) {
    EXPECT_TRUE(names.emplace(method.name).second) << method.name;
    EXPECT_EQ(method.info.name, method.name);
    EXPECT_FALSE(method.summary.empty());
    EXPECT_NE(method.draw, nullptr);
  }
  for (const char* const name :
       {"textbook", "f32-direct", "f32-direct-fma", "f32-kahan", "f32-affine", "f32-affine-fma",
        "f32-incremental", "f32-incremental-row", "f32-incremental-16",
        "f32-incremental-compensated", "f32-index", "f32-index-fma", "f64-direct", "f64-kahan",
        "f64-incremental", "i64-snap8", "i32-snap4", "filtered-exact", "spans-exact"}) {
    ASSERT_NE(FindMethod(name), nullptr) << name;
    EXPECT_NE(FindMethod(name)->edges, nullptr) << name;
  }
  EXPECT_EQ(FindMethod("f32"), nullptr);
}

TEST(MethodTableTest, FormatsProfilesAndClaimsFollowFromTheName) {
  for (const Method& method : Methods()) {
    if (!method.info.takes_window) continue;
    const std::string name(method.name);
    const bool is_float32 = name.starts_with("f32") || name == "textbook";
    const bool is_float = is_float32 || name.starts_with("f64");
    const bool is_integer = name.starts_with("i");
    EXPECT_EQ(method.info.input, is_float32 ? Precision::kFloat32 : Precision::kFloat64) << name;
    EXPECT_EQ(method.exact, !is_float) << name;
    EXPECT_EQ(method.can_be_canonical, is_float) << name;
    EXPECT_EQ(method.canonical_edges != nullptr, is_float) << name;
    EXPECT_EQ(method.info.profile.snap.IsNone(), !is_integer) << name;
    EXPECT_FALSE(method.info.profile.fill_rule.inclusive) << name;
  }
  EXPECT_EQ(FindMethod("i64-snap8")->info.profile.snap, (Snap{8, SnapRule::kNearestEven}));
  EXPECT_EQ(FindMethod("i32-snap4")->info.profile.snap, (Snap{4, SnapRule::kNearestEven}));
  EXPECT_EQ(FindMethod("i32-snap4")->info.profile.coordinate_limit, 1440);
  EXPECT_EQ(FindMethod("spans-exact")->info.profile.coordinate_limit,
            std::numeric_limits<double>::max());
}

}  // namespace
}  // namespace rasterproof::reference
