// The table of methods of values in docs/mathematics.md, and the inputs that its figures are of.
#include "tests/reference/value_witnesses.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <string_view>

#include "fmt/format.h"
#include "reference/value_figures.h"
#include "reference/value_methods.h"
#include "tests/reference/document_block.h"

namespace rasterproof::reference::witness {
namespace {

constexpr double kADigit = 0.001;  // of the figures, which are rounded down

TEST(ValueWitnesses, AreTheFiguresOfTheirMethods) {
  std::size_t figures = 0;
  for (const ValueMethod& method : ValueMethods()) {
    for (const double figure : LargestRatiosOf(method.name)) figures += std::isnan(figure) ? 0 : 1;
  }
  EXPECT_EQ(ValueWitnesses().size(), figures);
  for (const ValueWitness& witness : ValueWitnesses()) {
    const double figure = LargestRatiosOf(witness.method)[witness.is_float32 ? 0 : 1];
    const double ratio = witness.Ratio();
    EXPECT_GE(ratio, figure) << witness.method << (witness.is_float32 ? " float32" : " float64");
    EXPECT_LT(ratio, std::min(1.0, figure + kADigit)) << witness.method;
  }
}

TEST(ValueWitnesses, RefuteCorrectRoundingThatIsLowerByOnePercent) {
  for (const ValueWitness& witness : ValueWitnesses()) {
    const bool is_tight = witness.method == "correctly-rounded";
    EXPECT_EQ(witness.Ratio(0.99) > 1, is_tight) << witness.method;
  }
}

std::string BoundText(const ValueMethod& method, bool is_float) {
  if (method.ulps > 0) return fmt::format("{} ulp", method.ulps);
  const double conditions = method.ConditionsOf(is_float, 0);
  if (method.conditions_a_step > 0)
    return fmt::format("{:.5g} + {:.3g} n", conditions, method.conditions_a_step);
  return fmt::format("{:.5g}", conditions);
}

std::string KeptBy(const ValueMethod& method) {
  std::string keeps;
  if (method.equal_stay_equal) keeps += " equal";
  if (method.exact_at_vertices) keeps += " vertices";
  if (method.stays_in_hull) keeps += " hull";
  return keeps.empty() ? "-" : keeps.substr(1);
}

std::string RatioText(double ratio) {
  return std::isnan(ratio) ? "-" : fmt::format("{:.3f}", ratio);
}

std::string ValueMethodTable() {
  constexpr std::array kAbout{"the origin", "vertex 0", "each edge's start"};
  std::string table =
      "| method | computes | condition about | float32 | float64 | keeps | error / bound, float32 "
      "| "
      "float64 |\n| --- | --- | --- | --- | --- | --- | ---: | ---: |\n";
  for (const ValueMethod& method : ValueMethods()) {
    const auto [in_float, in_double] = LargestRatiosOf(method.name);
    table += fmt::format("| `{}` | {} | {} | {} | {} | {} | {} | {} |\n", method.name,
                         method.computes, kAbout[static_cast<std::size_t>(method.about)],
                         BoundText(method, true), BoundText(method, false), KeptBy(method),
                         RatioText(in_float), RatioText(in_double));
  }
  return table;
}

TEST(BoundTables, ValuesAreThoseOfTheMethods) {
  ExpectBlock("docs/mathematics.md", "values", ValueMethodTable());
}

}  // namespace
}  // namespace rasterproof::reference::witness
