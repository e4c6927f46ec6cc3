#include "report/text.h"

#include <gtest/gtest.h>

#include <string>

namespace rasterproof::report {
namespace {

TEST(CleanTextTest, KeepsWellFormedText) {
  const std::string text = "pixel centre, caf\u00e9, \u2264 1 \U0001F600\n\t";
  EXPECT_EQ(CleanText(text), text);
}

TEST(CleanTextTest, ShowsForbiddenCharactersByTheirBytes) {
  EXPECT_EQ(CleanText("a\x1b[0m"), "a\\x1b[0m");
  EXPECT_EQ(CleanText(std::string("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(CleanText("\x7f\xef\xbf\xbf"), "\\x7f\\xef\\xbf\\xbf");
  EXPECT_EQ(CleanText("\xc2\x85"), "\\xc2\\x85");
}

TEST(CleanTextTest, ShowsBytesThatAreNoUtf8) {
  EXPECT_EQ(CleanText("\xff"), "\\xff");
  EXPECT_EQ(CleanText("\xc3("), "\\xc3(");
  EXPECT_EQ(CleanText("\xe2\x82"), "\\xe2\\x82");
  EXPECT_EQ(CleanText("\xc0\xaf"), "\\xc0\\xaf");           // overlong
  EXPECT_EQ(CleanText("\xed\xa0\x80"), "\\xed\\xa0\\x80");  // a surrogate
  EXPECT_EQ(CleanText("\xf4\x90\x80\x80"), "\\xf4\\x90\\x80\\x80");
}

TEST(EscapedTest, LeavesNoMarkup) {
  EXPECT_EQ(Escaped("<a href=\"x\">'&'</a>"),
            "&lt;a href=&quot;x&quot;&gt;&#39;&amp;&#39;&lt;/a&gt;");
}

TEST(GroupedTest, SeparatesThousands) {
  EXPECT_EQ(Grouped(0), "0");
  EXPECT_EQ(Grouped(999), "999");
  EXPECT_EQ(Grouped(1000), "1\u202f000");
  EXPECT_EQ(Grouped(18446744073709551615U),
            "18\u202f446\u202f744\u202f073\u202f709\u202f551\u202f615");
}

}  // namespace
}  // namespace rasterproof::report
