// Planted bugs are found, legal variants pass, and both are what they say.
#include "subjects/mutants/mutants.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <memory>
#include <set>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/coverage.h"
#include "lab/selftest/selftest.h"
#include "props/cause/cause.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/mutants/mutant.h"
#include "tests/share.h"
#include "tests/subjects/conformance_baseline.h"

namespace rasterproof {
namespace subjects::mutants {

extern const MutantTable* const kAllMutantTables[];
extern const std::size_t kNumberOfMutantTables;

}  // namespace subjects::mutants

namespace {

using subjects::MutantInfo;
using subjects::Mutants;

TEST(Mutants, HaveNamesOfTheirOwnUnderWhichTheyAreMade) {
  std::set<std::string> names;
  for (const MutantInfo& mutant : Mutants()) {
    EXPECT_TRUE(names.insert(mutant.name).second) << mutant.name;
    EXPECT_TRUE(mutant.name.starts_with(mutant.legal ? "legal:" : "mutant:")) << mutant.name;
    EXPECT_FALSE(mutant.change.empty()) << mutant.name;
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(mutant.name);
    EXPECT_EQ(subject->Info().name, mutant.name);
    EXPECT_EQ(subject->Info().summary, mutant.change);
    EXPECT_TRUE(subject->Info().proofs.empty()) << mutant.name;
    EXPECT_FALSE(subject->Info().states_exact) << mutant.name;
  }
  EXPECT_EQ(subjects::MakeMutant("mutant:none-such"), nullptr);
}

TEST(Mutants, AreInTablesThatHavePlacesOfTheirOwn) {
  using namespace subjects::mutants;
  std::set<std::pair<MutantKind, int>> places;
  for (std::size_t k = 0; k < kNumberOfMutantTables; ++k) {
    const MutantTable& table = *kAllMutantTables[k];
    EXPECT_TRUE(places.emplace(table.kind, table.place).second) << table.rows().front().name;
  }
}

TEST(Mutants, HaveCausesThatTheDocumentHas) {
  const std::vector<std::string_view> names = props::CauseNames();
  for (const MutantInfo& mutant : Mutants()) {
    EXPECT_TRUE(!mutant.legal || mutant.causes.empty()) << mutant.name;
    std::istringstream causes(mutant.causes);
    for (std::string cause; std::getline(causes, cause, '|');)
      EXPECT_EQ(std::ranges::count(names, cause), 1) << mutant.name << ": " << cause;
  }
}

// A share that holds a mutant of most stages; selftest runs all of them.
TEST(Mutants, AreFoundByTheCatalogueInASample) {
  constexpr std::size_t kEvery = kOneCaseIn > 1 ? 97 : 11;
  std::size_t number = 0;
  for (const MutantInfo& mutant : Mutants()) {
    if (mutant.legal || number++ % kEvery != 0) continue;
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(mutant.name);
    const lab::Hunt hunt =
        lab::HuntBug(*subject, {.cases = 600, .shrink_budget = 50}, mutant.killers);
    EXPECT_TRUE(hunt.violation.has_value()) << mutant.name << " survives " << hunt.cases;
  }
}

TEST(Mutants, ThatNoClauseForbidsAreFoundByTheirKillersAlone) {
  for (const char* name : {"mutant:vulkan-fragments-sum-off", "mutant:vulkan-depth-off",
                           "mutant:vulkan-fragments-depth-alone-off"}) {
    const auto mutant = std::ranges::find(Mutants(), name, &MutantInfo::name);
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(name);
    const props::CampaignOptions few{.cases = 16, .shrink_budget = 50};
    EXPECT_TRUE(lab::HuntBug(*subject, few, mutant->killers).violation) << name;
    EXPECT_FALSE(lab::HuntBug(*subject, few).violation) << name;
  }
}

TEST(Mutants, OfFloatingPointModesAreFoundThereAndNowhereElse) {
  std::size_t found = 0;
  for (const MutantInfo& mutant : Mutants()) {
    if (!mutant.name.starts_with("mutant:mode-")) continue;
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(mutant.name);
    const lab::Hunt hunt = lab::HuntBug(*subject, {.cases = 600, .shrink_budget = 50});
    ASSERT_TRUE(hunt.violation.has_value()) << mutant.name << " survives " << hunt.cases;
    EXPECT_EQ(hunt.violation->property, "EnvironmentKeepsCoverage") << mutant.name;
    ++found;
  }
  EXPECT_EQ(found, 3U);
}

struct Twins {
  std::string_view mutant;
  const char* variant;  ///< that the law allows
};

// Under legal sets, where no single model says what is drawn, and of what is shown of fragments.
TEST(Mutants, OfLegalSetsAreFoundByTheirKillersAndTheirTwinsHold) {
  for (const auto& [name, variant] : {
           Twins{"mutant:vulkan-kept-by-pixels", "legal:vulkan-kept-by-all"},
           Twins{"mutant:vulkan-kept-by-indices", "legal:vulkan-farthest-mask"},
           Twins{"mutant:d3d11-kept-by-sixteenths", "legal:d3d11-farthest"},
           Twins{"mutant:vulkan-snap-by-turns", "legal:d3d11-snap-by-turns"},
           Twins{"mutant:vulkan-kept-by-sixteenths", "legal:vulkan-kept-by-all"},
           Twins{"mutant:gl-kept-by-sixteenths", "legal:gl-4-bits-floor"},
           Twins{"mutant:vulkan-kept-by-pixels", "legal:vulkan-4-bits"},
           Twins{"mutant:fragments-of-given", "legal:fragments-snapped-area"},
           Twins{"mutant:fragments-of-snapped", "legal:fragments-given-area"},
           Twins{"mutant:fragments-of-neither", "legal:fragments-unstated-by-triangle"},
           Twins{"mutant:fragments-barycentrics-alone-rotated", "legal:fragments-snapped-sum"},
           Twins{"mutant:fragments-small-areas", "legal:fragments-given-one-less"},
           Twins{"mutant:fragments-late-vertices-deep", "legal:fragments-unstated-given"},
           Twins{"mutant:fragments-depth-alone-flat", "legal:fragments-snapped-area"},
           Twins{"mutant:fragments-depth-alone-of-given", "legal:fragments-unstated-snapped"},
           Twins{"mutant:vulkan-fragments-depth-alone-off", "legal:gl-fragments-unstated"},
           Twins{"mutant:vulkan-fragments-depth-alone-off", "legal:vulkan-fragments-unstated"},
           Twins{"mutant:vulkan-fragments-sum-off", "legal:vulkan-fragments-snapped"},
           Twins{"mutant:vulkan-depth-off", "legal:vulkan-fragments-snapped"},
       }) {
    const auto mutant = std::ranges::find(Mutants(), name, &MutantInfo::name);
    ASSERT_NE(mutant, Mutants().end()) << name;
    EXPECT_FALSE(mutant->killers.empty()) << name;
    for (const std::string& killer : mutant->killers) {
      const props::Property* property = props::FindProperty(killer);
      for (std::uint64_t seed = 1; seed <= Cases(3U); ++seed) {
        const auto outcome_of = [&](std::string_view subject, std::uint64_t cases) {
          return props::RunCampaign(*subjects::MakeMutant(subject), *property,
                                    {.seed = seed, .cases = cases})
              .outcome;
        };
        EXPECT_EQ(outcome_of(name, 300), Outcome::kViolated) << killer << name << seed;
        EXPECT_EQ(outcome_of(variant, Cases(300U)), Outcome::kHolds) << killer << variant << seed;
      }
    }
  }
}

// Two cases of each property; selftest runs hundreds.
TEST(LegalVariants, KeepTheirProfilesInASample) {
  const std::uint64_t cases = RunsMore() ? 6 : Cases<std::uint64_t>(2);
  constexpr std::size_t kEvery = kOneCaseIn > 1 ? 2 * kOneCaseIn : 1;
  std::size_t number = 0;
  for (const MutantInfo& variant : Mutants()) {
    if (!variant.legal || number++ % kEvery != 0) continue;
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(variant.name);
    const lab::Hunt hunt = lab::HuntBug(*subject, {.seed = 11, .cases = cases});
    EXPECT_FALSE(hunt.violation.has_value())
        << variant.name << ": " << hunt.violation->property << ", " << hunt.violation->message;
    EXPECT_GT(hunt.exercised, 0U) << variant.name;
  }
}

// At least ten use their freedom, six of them with a twin that breaks the law once.
TEST(LegalVariants, UseWhatFreedomThereIs) {
  int free = 0, ruled = 0, clip = 0, unstated = 0;
  std::set<CoverageKind> kinds;
  for (const MutantInfo& variant : Mutants()) {
    const SubjectInfo info = subjects::MakeMutant(variant.name)->Info();
    const bool is_unstated =
        info.profile.contract == Contract::kWatertight && info.profile.snap.IsNone();
    if (!variant.legal || (info.profile.freedom.IsNone() && !is_unstated)) continue;
    ++free;
    kinds.insert(info.coverage);
    ruled += info.profile.freedom.ties != TieOwnership::kStated ? 1 : 0;
    clip += info.takes_clip ? 1 : 0;
    unstated += is_unstated ? 1 : 0;
  }
  EXPECT_GE(free, 10);
  EXPECT_GE(ruled, 2);
  EXPECT_GE(clip, 2);
  EXPECT_GE(unstated, 2);
  EXPECT_EQ(kinds.size(), 5U);
}

TEST(Hunt, CountsTheCasesOfEveryPropertyAndEndsWithTheFirstViolation) {
  const std::unique_ptr<Subject> subject = subjects::MakeMutant("mutant:tile-seams");
  std::uint64_t reported = 0;
  const lab::Hunt hunt =
      lab::HuntBug(*subject, {.cases = 100, .progress = [&](std::uint64_t n) { reported = n; }});
  ASSERT_TRUE(hunt.violation.has_value());
  EXPECT_GT(reported, 0U);
  EXPECT_LT(hunt.cases, 100U * 50);
  EXPECT_LE(hunt.violation->counterexample->value.scene.triangles.size(), 2U);
}

TEST(Selftest, SaysWhatSurvivesAndWhatIsNotLegal) {
  lab::HuntResult survivor{{"mutant:shy", "it hides", "", "", false, false}, 1, {}};
  lab::HuntResult wronged{{"legal:wronged", "it is judged", "", "", true, false}, 1, {}};
  EXPECT_FALSE(survivor.AsItShould());
  EXPECT_TRUE(wronged.AsItShould());
  wronged.hunt.violation.emplace();
  wronged.hunt.violation->property = "SomeProperty";
  EXPECT_FALSE(wronged.AsItShould());
  const std::string text = lab::SelftestText({survivor, wronged}, 10, 0);
  EXPECT_NE(text.find("| shy | it hides | **survived** |"), std::string::npos) << text;
  EXPECT_NE(text.find("0 of 1 killed"), std::string::npos) << text;
  EXPECT_NE(text.find("legal:wronged under seed 1 violates SomeProperty"), std::string::npos)
      << text;
}

// The baseline is sound: what is right passes it.
TEST(ConformanceBaseline, PassesSoundRasterizers) {
  for (const char* name : {"legal:ties-top-left", "legal:samples-four", "legal:y-up",
                           "legal:real-exact", "legal:clip-exact"}) {
    EXPECT_EQ(CtsLike(*subjects::MakeMutant(name)), Baseline::kPasses) << name;
    EXPECT_EQ(PiglitLike(*subjects::MakeMutant(name)), Baseline::kPasses) << name;
  }
}

TEST(ConformanceBaseline, FindsWhatIsGrosslyWrong) {
  EXPECT_EQ(CtsLike(*subjects::MakeMutant("mutant:sample-corner")), Baseline::kFails);
  EXPECT_EQ(PiglitLike(*subjects::MakeMutant("mutant:ties-per-tile")), Baseline::kFails);
  EXPECT_EQ(PiglitLike(*subjects::MakeMutant("mutant:ties-inclusive")), Baseline::kSkips);
}

// The table of the two beside the catalogue, whose shares README.md and docs/selftest.md quote. Of
// every mutant in scripts/test_more; a sample has other shares, of which neither is none or all.
TEST(ConformanceBaseline, IsCountedOverAllMutants) {
  int number = 0, mutants = 0, by_cts = 0, by_piglit = 0, skipped = 0;
  const int every = kOneCaseIn > 1 ? 4 * kOneCaseIn : RunsMore() ? 1 : 8;
  for (const MutantInfo& mutant : Mutants()) {
    const std::unique_ptr<Subject> subject = subjects::MakeMutant(mutant.name);
    const Contract contract = subject->Info().profile.contract;
    // They ask about points, and would find fault with what is right of squares.
    if (mutant.legal || contract == Contract::kNone || contract == Contract::kSquares) continue;
    if (number++ % every != 0) continue;
    ++mutants;
    const Baseline cts = CtsLike(*subject);
    const Baseline piglit = PiglitLike(*subjects::MakeMutant(mutant.name));
    by_cts += cts == Baseline::kFails ? 1 : 0;
    by_piglit += piglit == Baseline::kFails ? 1 : 0;
    skipped += piglit == Baseline::kSkips ? 1 : 0;
    const auto word = [](Baseline b) {
      return b == Baseline::kFails ? "fails" : b == Baseline::kPasses ? "passes" : "skips";
    };
    std::printf("| %s | %s | %s |\n", mutant.name.c_str(), word(cts), word(piglit));
  }
  std::printf("of %d mutants that draw: CTS-like %d, Piglit-like %d (skips %d)\n", mutants, by_cts,
              by_piglit, skipped);
  std::ifstream file("README.md");
  const std::string readme{std::istreambuf_iterator<char>(file), {}};
  const auto percent = [&](int n) { return std::to_string((100 * n + mutants / 2) / mutants); };
  const std::string find = "find " + percent(by_cts) + " % and " + percent(by_piglit) + " %;";
  if (kOneCaseIn == 1) {
    EXPECT_GT(std::min(by_cts, by_piglit), 0);
    EXPECT_LT(std::max(by_cts, by_piglit), mutants);
  }
  if (mutants != number) return;
  EXPECT_NE(readme.find(find), std::string::npos)
      << "README.md and docs/selftest.md should say: " << find;
}

}  // namespace
}  // namespace rasterproof
