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

}  // namespace
}  // namespace rasterproof
