#include "lab/sweep/sweep_delta.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include "core/error.h"
#include "lab/sweep/sweep_blame.h"
#include "lab/sweep/sweep_builds.h"

namespace rasterproof::lab {
namespace {

using Numbers = std::vector<int>;

Numbers MinimalOfNeeded(const std::set<int>& needed, int count, int* tests = nullptr) {
  Numbers all;
  for (int k = 0; k < count; ++k) all.push_back(k);
  return MinimalPart<int>(all, [&](const Numbers& part) {
    if (tests != nullptr) ++*tests;
    return std::ranges::includes(part, needed);
  });
}

TEST(MinimalPart, IsWhatTheTestNeedsWhateverItIs) {
  for (unsigned bits = 1; bits < 256; ++bits) {
    std::set<int> needed;
    for (int k = 0; k < 8; ++k) {
      if ((bits >> k & 1U) != 0) needed.insert(k);
    }
    EXPECT_EQ(MinimalOfNeeded(needed, 8), Numbers(needed.begin(), needed.end())) << bits;
  }
}

TEST(MinimalPart, LosesNoItemThatAloneFailsOfEitherCause) {
  const Numbers part = MinimalPart<int>({1, 2, 3, 4, 5}, [](const Numbers& p) {
    return std::ranges::includes(p, Numbers{1, 4}) || std::ranges::includes(p, Numbers{2, 3, 5});
  });
  EXPECT_TRUE(part == (Numbers{1, 4}) || part == (Numbers{2, 3, 5}));
}

TEST(MinimalPart, OfOneAmongManyTakesFewTests) {
  int tests = 0;
  EXPECT_EQ(MinimalOfNeeded({77}, 128, &tests), Numbers{77});
  EXPECT_LE(tests, 2 * 7 + 2);
}

TEST(SweepBuilds, ShareNoAxisInAPair) {
  for (const SweepBuild& pair : PairsOf(SingleBuilds())) {
    const std::set<std::string> axes(pair.axes.begin(), pair.axes.end());
    EXPECT_EQ(axes.size(), pair.axes.size()) << BuildName(pair.choices);
  }
}

TEST(SweepBuilds, AreNamedByTheFlagsThatCount) {
  const Choices choices{{Choice::Kind::kFlag, "-O3"}, {Choice::Kind::kFlag, "-march=x86-64-v3"}};
  EXPECT_EQ(BuildName(choices), "gcc -ffp-contract=off -O3 -march=x86-64-v3");
  EXPECT_EQ(ChoicesText(choices), "-O3 -march=x86-64-v3");
}

TEST(MakeExchangeable, MakesSymbolsGlobalAndTakesThemOutOfGroups) {
  const ExchangeableAssembly made = MakeExchangeable(
      "\t.section\t.text._Zf,\"axG\",@progbits,_Zf,comdat\n"
      "\t.weak\t_Zf  # -- Begin\n\t.type\t_Zf, @function\n_Zf:\n"
      "\t.weak\t_Zalias\n\t.set\t_Zalias,_Zf\n"
      "\t.global\tour\n\t.type\tour, %function\nour:\n"  // as for aarch64
      "\t.type\t.Llabel, @object\n"
      "\t.type\tinner, @function\ninner:\n"
      "\t.local\tzeros\n\t.comm\tzeros,4,4\n\t.type\tzeros, @object\n",
      /*with_local_functions=*/true);
  EXPECT_EQ(made.functions, (std::vector<std::string>{"_Zf", "our", "inner"}));
  EXPECT_EQ(made.objects, std::vector<std::string>{"_Zalias"});
  EXPECT_EQ(made.was_local, (std::vector<std::string>{"inner", "zeros"}));
  EXPECT_NE(made.text.find("\t.section\t.text._Zf,\"ax\",@progbits\n"), std::string::npos);
  EXPECT_NE(made.text.find("\t.globl\t_Zf\n"), std::string::npos);
  EXPECT_NE(made.text.find("\t.globl\tinner\n"), std::string::npos);
  EXPECT_EQ(made.text.find(".local"), std::string::npos);
}

TEST(BuildFrom, WritesOutWhatACompilerDoesByItself) {
  const auto name = [](const char* words, const char* cflags) {
    return BuildName(BuildFrom(words, cflags).choices);
  };
  const std::string gcc = "gcc -march=x86-64 ";
  EXPECT_EQ(name("g++ -O3", "-std=c++20"), gcc + "-O3 -ffp-contract=fast");
  EXPECT_EQ(name("gcc -O3 -std=gnu11", ""), gcc + "-O3 -std=gnu11 -ffp-contract=fast");
  EXPECT_EQ(name("gcc -O3", "-std=c11"), gcc + "-O3 -ffp-contract=off");
  EXPECT_EQ(name("gcc", "-O1 -ffp-contract=on -O2"), gcc + "-O2 -ffp-contract=on");
  EXPECT_EQ(name("gcc", ""), gcc + "-O0 -ffp-contract=fast");
  EXPECT_EQ(name("clang++ -Os", "-std=c11"), "clang -march=x86-64 -Os -ffp-contract=on");
  // In C gcc does not, in C++ it does.
  EXPECT_THROW(name("gcc -O3 -ansi", "-std=gnu11"), InputError);
  EXPECT_EQ(name("gcc -O3 -ansi -ffp-contract=off", ""), gcc + "-O3 -ansi -ffp-contract=off");
  EXPECT_EQ(name("gcc -O3", "-ansi -std=gnu11"), gcc + "-O3 -ffp-contract=fast");
}

// As `gcc -mfma -S` and `clang -mfma -S` of float p = a * b; p + c do.
TEST(BuildFrom, ContractsWhereUnsafeMathematicsIsAllowed) {
  const auto contracts = [](const char* words, const char* cflags) {
    return BuildName(BuildFrom(words, cflags).choices).ends_with("-ffp-contract=fast");
  };
  for (const char* compiler : {"gcc ", "clang "}) {
    for (const char* words : {"-O2 -ffast-math", "-O2 -funsafe-math-optimizations", "-Ofast"}) {
      EXPECT_TRUE(contracts((std::string(compiler) + words).c_str(), "-std=c11")) << words;
      EXPECT_TRUE(contracts(compiler, (std::string("-std=c11 ") + words).c_str())) << words;
    }
    EXPECT_FALSE(
        contracts((std::string(compiler) + "-O2 -fno-fast-math").c_str(), "-std=c11 -ffast-math"));
    EXPECT_FALSE(contracts((std::string(compiler) + "-O2").c_str(), "-std=c11 -Ofast"));
    EXPECT_FALSE(contracts((std::string(compiler) + "-Ofast").c_str(), "-std=c11 -fno-fast-math"));
  }
}

}  // namespace
}  // namespace rasterproof::lab
