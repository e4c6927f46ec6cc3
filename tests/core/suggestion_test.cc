// What a message says of a name that nobody knows.
#include "core/suggestion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

namespace rasterproof {
namespace {

const std::vector<std::string> kNames{"check", "certify", "vulkan", "webgpu", "tie_rule", "gl"};

TEST(Suggestion, ANearNameIsMeantAndAFarOneIsNot) {
  EXPECT_EQ(Suggestion("chek", kNames), "did you mean check? ");
  EXPECT_EQ(Suggestion("Vulcan", kNames), "did you mean vulkan? ");
  EXPECT_EQ(Suggestion("tie-rule", kNames), "did you mean tie_rule? ");
  EXPECT_EQ(Suggestion("explain", kNames), "");
  EXPECT_EQ(Suggestion("ab", kNames), "") << "as far from gl as from anything";
  EXPECT_EQ(Suggestion("", kNames), "");
  EXPECT_EQ(Suggestion(std::string(1'000'000, 'c'), kNames), "");
  EXPECT_EQ(Suggestion("check", std::vector<std::string>{}), "");
}

TEST(Suggestion, NamesStandOnOneLineOrOnLinesOfEightyColumns) {
  EXPECT_EQ(ListedNames(kNames), " check, certify, vulkan, webgpu, tie_rule, gl");
  const std::vector<std::string> many(48, "f32-direct:canonical");
  std::istringstream lines(ListedNames(many));
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "") << "the list begins on a separate line";
  std::ptrdiff_t named = 0;
  while (std::getline(lines, line)) {
    EXPECT_LE(line.size(), 80U) << line;
    named += std::ranges::count(line, ':');
  }
  EXPECT_EQ(named, 48);
}

}  // namespace
}  // namespace rasterproof
