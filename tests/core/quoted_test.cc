// What a message shows of somebody else's words.
#include "core/quoted.h"

#include <gtest/gtest.h>

#include <string>

namespace rasterproof {
namespace {

TEST(Quoted, ShowsEveryByteInPrintableLetters) {
  EXPECT_EQ(Printable("a ~"), "a ~");
  EXPECT_EQ(Printable(std::string("\0\x1b\x7f\xff\n", 5)), "\\x00\\x1b\\x7f\\xff\\x0a");
  EXPECT_EQ(Quoted(""), "\"\"");
}

TEST(Quoted, CutsBehindTheMostBytesAndSaysSo) {
  EXPECT_EQ(Quoted("abc", 3), "\"abc\"");
  EXPECT_EQ(Quoted("abcd", 3), "\"abc...\"");
}

TEST(Quoted, ANameIsShownAsItIsUnlessItHasControlCharacters) {
  for (const std::string name : {"", "bunny 2", "W\xc3\xbcrfel", "\xe2\x82\xac"}) {
    EXPECT_EQ(ShownName(name), name);
  }
  EXPECT_EQ(ShownName("a\x1b[31m"), "a\\x1b[31m");
  EXPECT_EQ(ShownName("a\nb"), "a\\x0ab");
  EXPECT_EQ(ShownName("\x7f"), "\\x7f");
  EXPECT_EQ(ShownName("\xc2\x9b"
                      "1m"),
            "\\xc2\\x9b1m");
}

}  // namespace
}  // namespace rasterproof
