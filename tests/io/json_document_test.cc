#include "io/json_document.h"

#include <string_view>

#include "gtest/gtest.h"

namespace rasterproof::io {
namespace {

bool IsSame(std::string_view a, std::string_view b) {
  const JsonDocument first(a, "a");
  const JsonDocument second(b, "b");
  return first.root().Get("v").IsSameAs(second.root().Get("v"));
}

TEST(JsonDocument, AValueIsTheSameWhereverItStands) {
  EXPECT_TRUE(IsSame(R"({"v": {"a": [1, "x"], "b": null}})",
                     R"({"before": [1, 2], "v": {"a":[1,"\u0078"],"b":null}, "after": 3})"));
}

TEST(JsonDocument, AValueDiffersByWhatItHolds) {
  const std::string_view v = R"({"v": {"a": [1, [2]], "b": ""}})";
  for (const std::string_view other :
       {R"({"v": {"a": [1, [3]], "b": ""}})", R"({"v": {"c": [1, [2]], "b": ""}})",
        R"({"v": {"a": [1, 2, []], "b": ""}})", R"({"v": {"a": [1, [2]], "b": null}})",
        R"({"v": {"a": ["1", [2]], "b": ""}})", R"({"v": {"a": [1, [2]]}})"}) {
    EXPECT_FALSE(IsSame(v, other)) << other;
    EXPECT_FALSE(IsSame(other, v)) << other;
  }
}

}  // namespace
}  // namespace rasterproof::io
