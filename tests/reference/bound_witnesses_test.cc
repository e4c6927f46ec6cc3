// How tight every bound is: the witnesses, and the table of docs/mathematics.md that is made of
// them. RASTERPROOF_TABLES=1 prints the table's lines (scripts/bound_tables).
#include "tests/reference/bound_witnesses.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <string_view>

#include "core/ulp.h"
#include "exact/rational.h"
#include "fmt/format.h"
#include "reference/barycentrics.h"
#include "reference/bounds.h"
#include "reference/homogeneous.h"
#include "tests/reference/document_block.h"

namespace rasterproof::reference::witness {
namespace {

/// name=0x1.8p+0; of a witness of unnamed numbers the number alone.
std::string NumberText(std::string_view name, double x) {
  return fmt::format("{}{}{}", name, name.empty() ? "" : "=",
                     x == 0 ? "0" : fmt::format("{:a}", x));
}

/// The witness's inputs, for a reader of a failure.
std::string NumbersText(const BoundWitness& witness) {
  std::istringstream names{std::string(witness.names)};
  std::string numbers;
  for (const double x : witness.numbers) {
    std::string name;
    names >> name;
    numbers += (numbers.empty() ? "" : ", ") + NumberText(name, x);
  }
  return numbers;
}

TEST(BoundWitnesses, StayWithinTheirBoundsAndAreNumbersOfTheirFormat) {
  for (const BoundWitness& witness : BoundWitnesses()) {
    const ErrorAndBound found = witness.evaluate(witness.numbers);
    EXPECT_LE(found.error, found.bound) << witness.bound << ": " << NumbersText(witness);
    EXPECT_GT(found.error.Sign(), 0) << witness.bound;
    for (const double x : witness.numbers) {
      EXPECT_TRUE(std::isfinite(x) && (!witness.is_float32 || IsFloat32(x))) << witness.bound;
    }
  }
}

TEST(BoundWitnesses, RefuteATightBoundThatIsLowerByOnePercent) {
  for (const BoundWitness& witness : BoundWitnesses()) {
    const bool is_loose =
        witness.constant == "kDeterminantErrorMultiplier" || witness.bound.starts_with("crossing");
    EXPECT_EQ(witness.IsTight(), !is_loose) << witness.bound << ": " << witness.Ratio();
  }
}

/// Rounded down, or a ratio that is next to 1 would read as 1.
std::string RatioText(double ratio) { return fmt::format("{:.4f}", std::floor(ratio * 1e4) / 1e4); }

std::string TightnessTable() {
  std::string table =
      "| bound | constant | largest error / bound known |\n"
      "| --- | --- | ---: |\n";
  for (const BoundWitness& witness : BoundWitnesses()) {
    table += fmt::format("| {} | `{}` | {} |\n", witness.bound, witness.constant,
                         RatioText(witness.Ratio()));
  }
  return table;
}

/// A constant is at least whole + units u: a double next to `whole` may not be able to say so.
template <class T>
void ExpectAtLeast(std::string_view name, double constant, double whole, double units) {
  EXPECT_GE(exact::Rational(constant),
            exact::Rational(whole) + exact::Rational(units) * rounding_epsilon<T>())
      << name << ", 2^-" << std::numeric_limits<T>::digits;
}

template <class T>
void ExpectConstantsAsProved() {
  ExpectAtLeast<T>("direct", kDirectEdgeErrorMultiplier<T>, 3, 8);
  ExpectAtLeast<T>("direct, fused", kDirectFmaEdgeErrorMultiplier<T>, 3, 8);
  ExpectAtLeast<T>("Kahan's", kKahanEdgeErrorMultiplier<T>, 2, 7);
  ExpectAtLeast<T>("Kahan's, of E", kKahanEdgeRelError<T> / rounding_epsilon<T>(), 2, 1);
  ExpectAtLeast<T>("affine, line", kAffineLineErrorMultiplier<T>, 4, 7);
  ExpectAtLeast<T>("affine, constant", kAffineConstantErrorMultiplier<T>, 3, 4);
  ExpectAtLeast<T>("affine, fused, line", kAffineFmaLineErrorMultiplier<T>, 3, 4);
  ExpectAtLeast<T>("affine, fused, constant", kAffineFmaConstantErrorMultiplier<T>, 4, 7);
  ExpectAtLeast<T>("homogeneous", kHomogeneousErrorMultiplier<T>, 5, 11);
  ExpectAtLeast<T>("sum of quotients", kNormalizedSumErrorMultiplier<T>, 2.75, 4);
  ExpectAtLeast<T>("distance", kEdgeDistanceErrorMultiplier<T>, 3, 4);
}

TEST(BoundConstants, AreNotRoundedBelowWhatTheScriptsProve) {
  ExpectConstantsAsProved<float>();
  ExpectConstantsAsProved<double>();
}

TEST(BoundTables, TightnessIsThatOfTheWitnesses) {
  ExpectBlock("docs/mathematics.md", "tightness", TightnessTable());
}

}  // namespace
}  // namespace rasterproof::reference::witness
