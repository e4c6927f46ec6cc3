// Every published statement is put to the test under its precondition, and those that are not true
// as written are shown to fail at a concrete configuration.
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>
#include <string_view>

#include "tests/share.h"
#include "tests/statements/statement.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kSeed = 1;
constexpr int kConfigurations = Cases(400);

TEST(Statements, HoldUnderTheirPreconditions) {
  for (const Statement& statement : Statements()) {
    const StatementTally tally = statement.check(kSeed, kConfigurations);
    EXPECT_EQ(tally.held, tally.met) << statement.id << ": " << statement.text;
  }
}

TEST(Statements, MeetTheirPreconditionsOftenEnough) {
  for (const Statement& statement : Statements()) {
    const StatementTally tally = statement.check(kSeed, kConfigurations);
    EXPECT_GE(tally.met * 10, tally.drawn)
        << statement.id << " met its precondition in only " << tally.met << " of " << tally.drawn;
  }
}

TEST(Statements, FailAsWrittenAtTheirCounterexamples) {
  for (const Statement& statement : Statements()) {
    if (statement.fails_as_written == nullptr) continue;
    EXPECT_TRUE(statement.fails_as_written()) << statement.id << ": " << statement.counterexample;
  }
}

TEST(Statements, CarryACounterexampleUnlessTheyAreTrueOrOnlyImprecise) {
  for (const Statement& statement : Statements()) {
    const bool has_one = statement.fails_as_written != nullptr;
    EXPECT_EQ(has_one, !statement.counterexample.empty()) << statement.id;
    EXPECT_EQ(statement.verdict == Truth::kTrue, statement.holds.empty()) << statement.id;
    if (statement.verdict == Truth::kTrue) {
      EXPECT_FALSE(has_one) << statement.id;
    }
    if (statement.verdict != Truth::kTrue && statement.verdict != Truth::kImprecise) {
      EXPECT_TRUE(has_one) << statement.id;
    }
  }
}

TEST(Statements, HaveUniqueIdentifiers) {
  std::set<std::string_view> ids;
  for (const Statement& statement : Statements()) {
    EXPECT_TRUE(ids.insert(statement.id).second) << statement.id;
  }
}

// 45 were listed before the first line of code; the rest were found while reading again.
TEST(Statements, CoverEveryOneListed) {
  std::set<std::string_view> ids;
  for (const Statement& statement : Statements()) ids.insert(statement.id);
  const auto contains_all = [&](const std::string& family, int last) {
    for (int k = 1; k <= last; ++k) {
      EXPECT_TRUE(ids.contains(family + std::to_string(k))) << family << k;
    }
  };
  contains_all("H", 12);
  contains_all("C", 17);
  contains_all("E", 12);
  contains_all("W", 16);
  EXPECT_EQ(ids.size(), 57U);
}

// The line of the document's table that begins with the identifier.
std::string RowOf(const std::string& document, std::string_view id) {
  const std::string start = "\n| " + std::string(id) + " |";
  const std::size_t begin = document.find(start);
  if (begin == std::string::npos) return "";
  return document.substr(begin + 1, document.find('\n', begin + 1) - begin - 1);
}

TEST(Statements, AreListedInTheDocumentWithTheirVerdicts) {
  std::ifstream file("docs/mathematics.md");
  const std::string document{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(document.empty());
  for (const Statement& statement : Statements()) {
    const std::string row = RowOf(document, statement.id);
    EXPECT_NE(row.find(" | " + std::string(TruthName(statement.verdict)) + " | "),
              std::string::npos)
        << statement.id << ": " << row;
  }
}

}  // namespace
}  // namespace rasterproof::props
