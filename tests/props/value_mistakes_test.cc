// Mistakes of values: each is named where it was planted, and nowhere else.
#include "props/cause/value_mistakes.h"

#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <string_view>

#include "core/subject.h"
#include "props/cause/evidence.h"
#include "props/property.h"
#include "subjects/mutants/mutants.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr double kSeconds = 800;  // what is found may not depend on the clock

ValueMistake FindIn(const std::string& subject, std::string_view property) {
  const std::unique_ptr<Subject> made = subjects::MakeMutant(subject);
  return FindValueMistake(*made, {FindProperty(property), {}}, kSeconds);
}

bool IsOneOf(const std::string& name, const std::string& names) {
  return ("|" + names + "|").find("|" + name + "|") != std::string::npos;
}

struct Planted {
  std::string_view bug;
  std::string_view property;
  std::string_view cause;
};

class Named : public ::testing::TestWithParam<Planted> {};

TEST_P(Named, IsWhatWasPlanted) {
  const Planted& planted = GetParam();
  const ValueMistake found = FindIn("mutant:" + std::string(planted.bug), planted.property);
  EXPECT_EQ(found.name, planted.cause) << (found.what.empty() ? "" : found.what.front());
  EXPECT_GT(found.wrong, 0U);
}

constexpr std::string_view kValues = "ValuesStayWithinTheirError";
constexpr std::string_view kSlopes = "DerivativesStayWithinTheirError";
constexpr std::string_view kClipDepths = "ClipDepthsStayWithinTheirError";
constexpr std::string_view kFormats = "DepthsAreOfTheirFormat";

INSTANTIATE_TEST_SUITE_P(
    ValueMistakes, Named,
    ::testing::Values(Planted{"values-dx-doubled", kSlopes, "wrong-derivative"},
                      Planted{"values-dy-negated", kSlopes, "wrong-derivative"},
                      Planted{"values-dx-dy-swapped", kSlopes, "wrong-derivative"},
                      Planted{"values-dx-of-affine-plane", kSlopes, "wrong-derivative"},
                      Planted{"values-dx-not-of-w", kSlopes, "wrong-derivative"},
                      Planted{"values-dx-by-difference", kSlopes, "wrong-derivative"},
                      Planted{"values-difference-central", kSlopes, "wrong-derivative"},
                      Planted{"values-quad-across", kSlopes, "wrong-derivative"},
                      Planted{"values-quads-misplaced", kSlopes, "wrong-derivative"},
                      Planted{"values-depth-cut", kFormats, "depth-rounding"},
                      Planted{"values-clamped", kValues, "clamped-values"},
                      Planted{"values-behind-the-eye", kValues, "weights-by-w"},
                      Planted{"values-w-for-inverse-w", kValues, "wrong-quantity"},
                      Planted{"values-depth-of-w", kClipDepths, "wrong-quantity"},
                      Planted{"values-depth-remapped", kClipDepths, "depth-range"},
                      Planted{"values-depth-truncated", kFormats, "depth-rounding"},
                      Planted{"values-depth-power-of-two", kFormats, "depth-rounding"},
                      Planted{"values-depth-16-bits", kFormats, "depth-rounding"}));

// Sound rasterizers, of unusual forms and statements, have no mistake; and no other bug has one
// that is not its own. Sanitized, a share of the questions is of all three.
TEST(ValueMistakes, AccuseNobodyElse) {
  int asked = 0;
  int number = 0;
  for (const subjects::MutantInfo& info : subjects::Mutants()) {
    if (info.name.find(":values-") == std::string::npos) continue;
    for (const std::string_view property : {kSlopes, kClipDepths, kFormats}) {
      if (number++ % kOneCaseIn != 0) continue;
      const ValueMistake found = FindIn(info.name, property);
      asked += found.numbers != 0 ? 1 : 0;
      if (info.legal) {
        EXPECT_EQ(found.name, "") << info.name << ' ' << property;
        EXPECT_EQ(found.wrong, 0U) << info.name << ' ' << property;
      } else if (!found.name.empty()) {
        EXPECT_TRUE(IsOneOf(found.name, info.causes))
            << info.name << " is told as " << found.name << ": " << found.what.front();
      }
    }
  }
  EXPECT_GT(asked, 100 / kOneCaseIn);
}

}  // namespace
}  // namespace rasterproof::props
