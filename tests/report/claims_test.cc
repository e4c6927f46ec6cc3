#include "report/claims.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "core/bench_result.h"
#include "report/bench_json.h"

namespace rasterproof::report {
namespace {

constexpr ClaimSide kSpans{"spans", "exact"};
constexpr ClaimSide kDoubles{"spans", "f64"};

Claim Said(const ClaimSide& a, const ClaimSide& b, std::optional<Trait> differs = {},
           std::string_view about = "Doubles") {
  return {"id", about, a, b, differs};
}

TEST(Claims, NoneIsAtFaultAndEachHasAnIdOfItsOwn) {
  std::set<std::string_view> ids;
  std::size_t textbook = 0;
  for (const Claim& claim : Claims()) {
    EXPECT_EQ(FaultOf(claim), "") << claim.id;
    EXPECT_TRUE(ids.insert(claim.id).second) << claim.id;
    textbook += claim.differs ? 0U : 1U;
  }
  EXPECT_GT(textbook, 0U);
  EXPECT_LT(textbook, ids.size() / 2);
}

TEST(Claims, AreRefusedIfTheirMethodsDifferInTwoThings) {
  EXPECT_EQ(FaultOf(Said(kDoubles, kSpans, Trait::kArithmetic)), "");
  ClaimSide other = kDoubles;
  other.traversal = "tiles";
  EXPECT_EQ(FaultOf(Said(other, kSpans, Trait::kArithmetic)), "its methods differ in 2 things");
  other = kDoubles;
  other.vertex_bytes = 32;
  EXPECT_EQ(FaultOf(Said(other, kSpans, Trait::kArithmetic)), "its methods differ in 2 things");
}

TEST(Claims, AreRefusedIfTheirMethodsDifferInNothingOrInAnotherThing) {
  EXPECT_EQ(FaultOf(Said(kSpans, kSpans, Trait::kArithmetic)), "its methods do not differ");
  EXPECT_EQ(FaultOf(Said(kDoubles, kSpans, Trait::kTraversal)),
            "its methods differ in another thing");
}

TEST(Claims, CompareArithmeticInTheMaskSink) {
  ClaimSide a = kDoubles;
  ClaimSide b = kSpans;
  a.sink = b.sink = "facing";
  EXPECT_NE(FaultOf(Said(a, b, Trait::kArithmetic)), "");
}

TEST(Claims, OfATextbookLoopSaySo) {
  const ClaimSide loop{"box loop", "f64-direct", "compiler", "facing", "window", 32};
  ClaimSide kernel = kSpans;
  kernel.sink = "facing";
  EXPECT_NE(FaultOf(Said(loop, kernel)), "");
  EXPECT_EQ(FaultOf(Said(loop, kernel, {}, "Doubles as a scalar textbook loop, not a kernel")), "");
  EXPECT_NE(FaultOf(Said(kDoubles, kSpans, {}, "a scalar textbook loop, not a kernel")), "");
}

BenchMethod Method(std::string_view name, const ClaimSide& side) {
  BenchMethod method;
  method.name = name;
  method.target = "avx2";
  method.traversal = side.traversal;
  method.arithmetic = side.arithmetic;
  method.sink = side.sink;
  method.space = side.space;
  method.vertex_bytes = side.vertex_bytes;
  method.model = "real";
  return method;
}

// Rounds of about this many seconds: with the machine's ups and downs, which both share.
void AddRow(BenchResult& result, std::uint32_t family, std::uint32_t method, double seconds) {
  BenchRow row;
  row.family = family;
  row.method = method;
  for (const double noise : {1.0, 1.1, 1.4, 0.9, 1.05, 2.0, 1.01}) {
    row.seconds.push_back(noise * seconds);
  }
  row.is_judged = true;
  row.real.missing = method == 0 ? 3 : 0;
  row.real.displacement = method == 0 ? 0.25 : 0;
  result.rows.push_back(row);
}

// The doubles take 5, the exact kernel 3, and the floor is 1.
BenchResult Measured() {
  BenchResult result;
  result.methods = {Method("doubles", kDoubles), Method("exact", kSpans),
                    Method("floor", {"known spans", "none"}), Method("again", kSpans)};
  result.families.resize(1);
  result.families[0].name = "px5";
  result.families[0].triangles = 1;
  result.families[0].baseline = result.families[0].twin = 3;
  for (const std::uint32_t method : {0U, 1U, 2U}) {
    AddRow(result, 0, method, method == 0 ? 5 : method == 1 ? 3 : 1);
  }
  return result;
}

const Claim kDoublesBesideExact = Said(kDoubles, kSpans, Trait::kArithmetic);

TEST(ClaimFigures, AreOfTimesLessTheFloorPairedWithinRounds) {
  const ClaimFigure figure = FigureOf(kDoublesBesideExact, Measured());
  ASSERT_EQ(figure.cells.size(), 1U);
  EXPECT_NEAR(figure.cells[0].ratio->low, 2, 1e-9);
  EXPECT_NEAR(figure.cells[0].ratio->high, 2, 1e-9);
  EXPECT_FALSE(figure.cells[0].Overlaps());
  EXPECT_EQ(figure.sentence,
            "Doubles: `doubles avx2` takes 2 [2, 2] (`px5`) times as long as `exact avx2`; they "
            "differ in arithmetic. `doubles avx2` was wrong in 1 of 1 families, by up to 0.25 "
            "pixel, `exact avx2` never seen wrong.");
}

TEST(ClaimFigures, SayWhereTheTwoAreNotToldApart) {
  BenchResult result = Measured();
  result.rows[0].seconds = {3, 3.2, 4.3, 2.6, 3.2, 6, 3.0};  // the exact one's: 3, 3.3, 4.2, 2.7
  const ClaimFigure figure = FigureOf(kDoublesBesideExact, result);
  EXPECT_TRUE(figure.cells[0].Overlaps());
  EXPECT_NE(figure.sentence.find("overlap in 1 of 1 families"), std::string::npos);
  result.rows[1].seconds = result.rows[2].seconds;  // costs what storing costs
  EXPECT_FALSE(FigureOf(kDoublesBesideExact, result).cells[0].ratio);
  EXPECT_NE(FigureOf(kDoublesBesideExact, result)
                .sentence.find("`doubles avx2` beside `exact avx2`; at the floor in 1 of 1"),
            std::string::npos);
}

TEST(ClaimFigures, AreNotMeasuredWithoutTheRowsOrByMethodsThatDifferInMore) {
  for (const std::uint32_t missing : {0U, 1U, 2U}) {
    BenchResult result = Measured();
    result.rows.erase(result.rows.begin() + missing);
    EXPECT_EQ(FigureOf(kDoublesBesideExact, result).sentence, "Doubles: not measured.") << missing;
  }
  BenchResult result = Measured();
  result.methods[0].vertex_bytes = 24;
  EXPECT_EQ(FigureOf(kDoublesBesideExact, result).times, "not measured");
  result = Measured();
  result.methods[0].target = "compiler";
  EXPECT_EQ(FigureOf(kDoublesBesideExact, result).times, "not measured");
}

// The threads' curve of a run has the library, by the machine's widest set whatever was asked for.
TEST(ClaimFigures, AreOfTheSetThatDrawsFamilies) {
  BenchResult result = Measured();
  result.methods.push_back(Method("library", kSpans));
  result.methods.back().target = "avx512";
  EXPECT_EQ(FigureOf(kDoublesBesideExact, result).cells.size(), 1U);
}

TEST(ClaimFigures, ATextbookLoopIsComparedByItsWholeTime) {
  const ClaimSide loop{"box loop", "f64-direct", "compiler", "mask", "window", 32};
  BenchResult result = Measured();
  result.methods[0] = Method("loop", loop);
  result.methods[0].target = "compiler";
  const Claim claim = Said(loop, kSpans, {}, "Doubles as a scalar textbook loop, not a kernel");
  const ClaimFigure figure = FigureOf(claim, result);
  ASSERT_EQ(figure.cells.size(), 1U);
  EXPECT_NEAR(figure.cells[0].ratio->median, 5.0 / 3, 1e-9);
  EXPECT_NE(
      figure.sentence.find("they differ in traversal, arithmetic, vectors, bytes of a vertex: "
                           "not like for like"),
      std::string::npos)
      << figure.sentence;
}

TEST(ClaimFigures, AreInTheFile) {
  EXPECT_NE(BenchToJson(Measured()).find("\"sentence\": \"Use doubles: `doubles avx2` takes 2 "),
            std::string::npos);
}

}  // namespace
}  // namespace rasterproof::report
