#include "io/base64.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>

namespace rasterproof::io {
namespace {

TEST(Base64, IsThatOfTheRfc) {
  for (const auto& [bytes, text] :
       {std::pair("", ""), {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"\xff\xfe", "//4="}}) {
    EXPECT_EQ(ToBase64(bytes), text);
    EXPECT_EQ(FromBase64(text), bytes);
  }
  EXPECT_EQ(FromBase64("Zm8"), "fo") << "padding may be left out";
  EXPECT_EQ(FromBase64("Zm8-"), std::nullopt) << "no digit of this alphabet";
  EXPECT_EQ(FromBase64("Z=8="), std::nullopt) << "padding stands at the end";
}

}  // namespace
}  // namespace rasterproof::io
