#include "props/shrink/foresee.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "exact/coverage.h"
#include "io/case_file.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/shrink/shrink.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr std::uint64_t kEvaluations = 10'000;

// Whether two triangles cover a sample on their common edge where ties belong to everybody.
bool IsCoveredTwice(const Case& c) {
  Case inclusive = c;
  inclusive.profile.tie_rule.inclusive = true;
  const CoverageCounts ours = exact::Coverage(c.scene, c.profile, c.options);
  const CoverageCounts theirs = exact::Coverage(c.scene, inclusive.profile, c.options);
  for (std::size_t s = 0; s < ours.size(); ++s) {
    if (theirs.Count(s) == 2 && ours.Count(s) == 1) return true;
  }
  return false;
}

Case Failing(std::uint64_t number) {
  for (std::uint64_t index = 0;; ++index) {
    PhiloxSource bits(1, index);
    const Case c = FindDomain("triangulations")->draw(bits, testing::RealInfo(Precision::kFloat32));
    if (IsCoveredTwice(c) && number-- == 0) return c;
  }
}

// Shrinks by answers that come in rounds of `most`.
struct InRounds {
  explicit InRounds(std::size_t room) : most(room) {}

  std::optional<bool> Known(const Case& c) const {
    const auto it = known.find(io::CaseToJson({c, "", ""}));
    return it == known.end() ? std::nullopt : std::optional(it->second);
  }
  // Returns whether there was anything to ask.
  bool Round(const Case& failing) {
    std::vector<Case> asked;
    smallest = Foresee(failing,
                       {[&](const Case& c) { return Known(c); },
                        [&](const Case& c) {
                          asked.push_back(c);
                          return asked.size() < most;
                        }},
                       kEvaluations);
    for (const Case& c : asked) known[io::CaseToJson({c, "", ""})] = IsCoveredTwice(c);
    if (!asked.empty()) ++rounds;
    return !asked.empty();
  }

  std::size_t most;
  std::map<std::string, bool> known;
  Case smallest;
  int rounds = 0;
};

TEST(Foresee, AsksOneByOneJustWhatShrinkAsks) {
  const Case failing = Failing(0);
  std::map<std::string, bool> asked;
  const Case smallest = Shrink(
                            failing,
                            [&](const Case& c) {
                              const bool fails = IsCoveredTwice(c);
                              asked[io::CaseToJson({c, "", ""})] = fails;
                              return fails;
                            },
                            kEvaluations)
                            .minimal;
  InRounds one_by_one(1);
  while (one_by_one.Round(failing)) {
  }
  EXPECT_EQ(one_by_one.smallest, smallest);
  EXPECT_EQ(one_by_one.known, asked);
}

TEST(Foresee, ComesToTheSameCaseInFewRounds) {
  for (std::uint64_t number = 0; number < (kOneCaseIn > 1 ? 1 : 2); ++number) {
    const Case failing = Failing(number);
    InRounds in_rounds(250);
    while (in_rounds.Round(failing)) {
    }
    EXPECT_EQ(in_rounds.smallest, Shrink(failing, IsCoveredTwice, kEvaluations).minimal) << number;
    EXPECT_LE(in_rounds.rounds, 15) << number;
  }
}

TEST(Foresee, EndsWithinTheBudgetOfShrink) {
  const Case failing = Failing(0);
  constexpr std::uint64_t kFew = 10;
  std::size_t asked = 0;
  Foresee(failing,
          {[](const Case&) { return false; }, [&](const Case&) { return ++asked < kEvaluations; }},
          kFew);
  EXPECT_EQ(asked, 0U);  // all is known
  Foresee(failing,
          {[](const Case&) { return std::nullopt; }, [&](const Case&) { return ++asked < 100; }},
          kFew);
  EXPECT_EQ(asked, 100U);  // ten deep, and as wide as there is room
}

}  // namespace
}  // namespace rasterproof::props
