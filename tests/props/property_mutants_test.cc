// Every property finds a bug by itself: a mutant for each, by its own verdict.
//
// `rasterproof selftest` asks the other way round: whether any property finds the mutant.
#include <gtest/gtest.h>

#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/mutants/mutants.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

TEST(PropertyMutants, ThereIsOneForEveryProperty) {
  std::set<std::string_view> properties;
  for (const subjects::MutantInfo& mutant : subjects::Mutants())
    properties.insert(mutant.killers.begin(), mutant.killers.end());
  for (const Property& property : Catalog()) {
    EXPECT_TRUE(properties.contains(property.name))
        << property.name << " kills no mutant: name it in the row of one that it finds";
  }
}

void ExpectKill(const std::string& mutant, const std::string& killer) {
  constexpr std::uint64_t kSeed = 1;
  constexpr std::uint64_t kCases = 400;
  const Property* property = FindProperty(killer);
  ASSERT_NE(property, nullptr) << killer << ", " << mutant;
  const std::unique_ptr<Subject> subject = subjects::MakeMutant(mutant);
  Verdict verdict;
  for (std::uint64_t i = 0; i < kCases && verdict.outcome != Outcome::kViolated; ++i)
    verdict = RunCase(*subject, *property, DrawCase(subject->Info(), *property, kSeed, i));
  ASSERT_EQ(verdict.outcome, Outcome::kViolated) << killer << " lets " << mutant << " through";
  EXPECT_FALSE(verdict.message.empty()) << killer;
  EXPECT_GT(verdict.exercised, 0U) << killer;
  ASSERT_TRUE(verdict.witness.has_value()) << killer;
  EXPECT_FALSE(verdict.witness->observed.empty()) << killer;
  EXPECT_FALSE(verdict.witness->expected.empty()) << killer;
}

TEST(PropertyMutants, EachIsFoundByItsPropertyAloneWithAWitness) {
  std::size_t row = 0;
  for (const subjects::MutantInfo& mutant : subjects::Mutants()) {
    for (const std::string& killer : mutant.killers) {
      if (row++ % (kOneCaseIn > 1 ? 4 : 1) == 0) ExpectKill(mutant.name, killer);
    }
  }
}

}  // namespace
}  // namespace rasterproof::props
