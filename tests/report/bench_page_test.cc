#include "report/bench_page.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "report/bench_decision.h"
#include "report/bench_json.h"
#include "report/bench_page_parts.h"
#include "report/page.h"
#include "tests/report/sample_bench.h"
#include "tests/report/sample_results.h"

namespace rasterproof::report {
namespace {

bool Says(std::string_view text, std::string_view what) {
  return text.find(what) != std::string_view::npos;
}

// The sample's first family without its crowd: two methods, nothing wrong, twice as fast as each
// other.
struct TwoMethods {
  BenchResult bench = SampleBench();
  BenchRow* fast = nullptr;
  BenchRow* slow = nullptr;

  TwoMethods() {
    bench.rows = {bench.rows[2], bench.rows[3]};  // f32-direct 0.3, kernel-exact 0.5
    bench.families.resize(1);
    bench.left_out.clear();
    fast = &bench.rows[0];
    slow = &bench.rows[1];
    fast->real = fast->own = {};
  }

  std::string Chosen(Need need) const {
    const std::optional<Decision> decision = Decide(bench, 0, need);
    return decision ? bench.methods[decision->row->method].name : "none";
  }
};

TEST(BenchDecision, IsTheCheapestThatMeetsTheNeed) {
  const TwoMethods two;
  EXPECT_EQ(two.Chosen(Need::kProvedZero), "kernel-exact");
  EXPECT_EQ(two.Chosen(Need::kZeroOfN), "f32-direct");
  const std::optional<Decision> proved = Decide(two.bench, 0, Need::kProvedZero);
  EXPECT_NEAR(proved->ratio, 5.0 / 3, 1e-9);
  EXPECT_FALSE(proved->is_tied_with_fastest);
  EXPECT_TRUE(proved->tied.empty());
}

TEST(BenchDecision, OfTiedMethodsTheLeastErrorIsNamed) {
  TwoMethods two;
  two.slow->ratio = {0.302, 0.31, 0.32};  // the fast one's: 0.297 to 0.303
  EXPECT_EQ(two.Chosen(Need::kAnything), "kernel-exact");
  const std::optional<Decision> decision = Decide(two.bench, 0, Need::kAnything);
  ASSERT_EQ(decision->tied.size(), 1U);
  EXPECT_EQ(decision->tied[0], two.fast);
  EXPECT_TRUE(decision->is_tied_with_fastest);
  two.slow->ratio.low = 0.3031;  // just apart
  EXPECT_EQ(two.Chosen(Need::kAnything), "f32-direct");
  EXPECT_TRUE(Decide(two.bench, 0, Need::kAnything)->tied.empty());
  // A number below 1 would say that the named one is faster than the fastest.
  two.slow->ratio = {0.302, 0.31, 0.32};
  two.slow->time.median = two.fast->time.median * 0.9;
  EXPECT_GE(Decide(two.bench, 0, Need::kAnything)->ratio, 1);
}

TEST(BenchDecision, PastItsLimitAMethodStatesNothing) {
  TwoMethods two;
  BenchMethod& fast = two.bench.methods[two.fast->method];
  fast.coordinate_limit = two.bench.families[0].largest_coordinate;
  EXPECT_EQ(two.Chosen(Need::kAnything), "f32-direct");
  fast.coordinate_limit = two.bench.families[0].largest_coordinate - 1;
  EXPECT_EQ(two.Chosen(Need::kAnything), "kernel-exact");
  two.bench.methods[two.slow->method].coordinate_limit = 0;
  EXPECT_EQ(two.Chosen(Need::kProvedZero), "none");
}

TEST(BenchDecision, OnePercentWrongIsTooMuch) {
  TwoMethods two;
  two.fast->real.missing = two.fast->real.beside_edges = 99;  // of 10,000 pairs
  EXPECT_EQ(two.Chosen(Need::kAnything), "f32-direct");
  EXPECT_EQ(two.Chosen(Need::kZeroOfN), "kernel-exact");
  two.fast->real.missing = two.fast->real.beside_edges = 100;
  EXPECT_EQ(two.Chosen(Need::kAnything), "kernel-exact");
  two.fast->real.beside_edges = 0;  // all of them farther from an edge
  EXPECT_EQ(two.Chosen(Need::kAnything), "f32-direct");
  EXPECT_EQ(two.Chosen(Need::kZeroOfN), "kernel-exact");
}

TEST(BenchDecision, EachNeedAsksForItsOwnError) {
  TwoMethods two;
  two.fast->leaks.gaps = 1;
  EXPECT_EQ(two.Chosen(Need::kNoLeaks), "kernel-exact");
  EXPECT_EQ(two.Chosen(Need::kMilliPixel), "f32-direct");
  two.fast->real.displacement = 0x1p-10;
  EXPECT_EQ(two.Chosen(Need::kMilliPixel), "f32-direct");
  two.fast->real.displacement = 0.001;
  EXPECT_EQ(two.Chosen(Need::kMilliPixel), "kernel-exact");
  two.fast->real.displacement = 0;
  two.fast->real.lost = 16;
  EXPECT_EQ(two.Chosen(Need::kMilliPixel), "kernel-exact");
}

TEST(BenchDecision, ProvedByItsOwnModelIsNotProvedByRealGeometry) {
  const BenchResult bench = SampleBench();
  const BenchRow& snapped = bench.rows[4];
  EXPECT_EQ(ErrorOf(bench, snapped, ErrorKind::kOwn).lane, ErrorLane::kProved);
  EXPECT_EQ(ErrorOf(bench, snapped, ErrorKind::kReal).lane, ErrorLane::kNone);
}

TEST(BenchDecision, ABaselineMeasuredAgainIsNoRival) {
  BenchResult bench = SampleBench();
  bench.rows[1].ratio = {0.01, 0.01, 0.01};
  const std::optional<Decision> decision = Decide(bench, 0, Need::kAnything);
  EXPECT_NE(decision->row, &bench.rows[1]);
}

TEST(BenchDecision, TheFrontierIsOfTheErrorAskedFor) {
  TwoMethods two;
  two.fast->real.missing = 5;
  EXPECT_EQ(Frontier(two.bench, 0, kCommonSink, ErrorKind::kReal).size(), 2U);
  // By leaks the slow one is proved, so that it stays beside the fast one's 0 of N.
  const auto by_leaks = Frontier(two.bench, 0, kCommonSink, ErrorKind::kLeaks);
  EXPECT_EQ(by_leaks.front(), two.fast);
  two.bench.families[0].shared_pairs = 0;
  EXPECT_TRUE(Frontier(two.bench, 0, kCommonSink, ErrorKind::kLeaks).empty());
}

TEST(BenchPage, StandsBeforeTheVerdicts) {
  Page page;
  page.certificates = {SampleCertificate()};
  const std::string without = PageToHtml(page);
  EXPECT_FALSE(Says(without, "id=\"which\""));
  EXPECT_FALSE(Says(without, "id=\"bench-data\""));
  page.bench = SampleBench();
  EXPECT_FALSE(Says(PageToHtml(page), "id=\"advice\""));  // a record without traits: no claims
  page.bench->methods[2].traversal = "box loop";
  page.bench->methods[2].arithmetic = "f32-direct";
  page.bench->methods[2].vertex_bytes = 32;
  page.bench->methods[3].traversal = "spans";
  page.bench->methods[3].arithmetic = "exact";
  page.bench->methods[3].vertex_bytes = 12;
  page.bench->methods[2].space = page.bench->methods[3].space = "window";
  const std::string html = PageToHtml(page);
  EXPECT_TRUE(Says(html, "a scalar textbook loop, not a kernel"));
  std::size_t before = 0;
  for (const std::string_view anchor : {"which", "yours", "advice", "pareto", "families", "limits",
                                        "fingerprints", "worst", "stages", "verdicts"}) {
    const std::size_t at = html.find("<section id=\"" + std::string(anchor) + "\">");
    ASSERT_NE(at, std::string::npos) << anchor;
    EXPECT_GT(at, before) << anchor;
    before = at;
  }
  EXPECT_TRUE(Says(html, "Coverage that is proved right takes"));
  EXPECT_TRUE(Says(html, "a processor, 2 processors"));
}

TEST(BenchPage, SaysWhoseAMethodIs) {
  BenchResult bench = SampleBench();
  EXPECT_TRUE(Says(BenchSections(bench, "out"), "<span class=\"yours\">yours</span>"));
  bench.methods[5].is_users = false;
  EXPECT_TRUE(Says(BenchSections(bench, "out"), "This record holds none of yours"));
}

TEST(BenchPage, WhatWasNotJudgedIsNotZero) {
  BenchResult bench = SampleBench();
  bench.rows = {bench.rows[5]};  // the user's alone
  bench.rows[0].is_judged = false;
  bench.rows[0].real = {};
  bench.rows[0].leaks = {};
  const std::string html = BenchSections(bench, "out");
  EXPECT_TRUE(Says(html, "1 in the drawing</td><td class=\"number\">–</td><td class=\"number\">–"));
}

TEST(BenchPage, EveryWorstCaseHasItsFileAndCommand) {
  const BenchResult bench = SampleBench();
  const std::string html = BenchSections(bench, "my/out");
  const std::vector<BenchCase> cases = BenchCases(bench);
  ASSERT_FALSE(cases.empty());
  for (const BenchCase& one : cases) EXPECT_TRUE(Says(html, "my/out/" + one.file)) << one.file;
  EXPECT_EQ(cases[0].scene.vertices[1].x, 9.25);
  EXPECT_EQ(cases[0].scene.precision, Precision::kFloat64);  // 1.1 is no float32
}

TEST(BenchPage, HoldsTheRecordAndNamesEndNoScript) {
  BenchResult bench = SampleBench();
  bench.methods[5].name = "</script><b>";
  const std::string html = BenchSections(bench, "out");
  EXPECT_TRUE(Says(html, "id=\"bench-data\">" + BenchToJson(bench) + "</script>"));
  EXPECT_FALSE(Says(html, "</script><b>"));
}

TEST(BenchPage, LabelsOfValuesCoverNoOther) {
  BenchResult bench;
  bench.value_families.emplace_back();
  for (const char* method : {"one", "two", "three"}) {
    ValueBenchRow& row = bench.value_rows.emplace_back();
    row.method = method;
    row.shows = "value";
    row.ns = 1;
    row.ulps = 4;
  }
  const std::string html = ValueParts(bench);
  std::set<std::string> rows;
  for (std::size_t at = html.find("<text x"); at != std::string::npos;
       at = html.find("<text x", at + 1)) {
    const std::size_t y = html.find(" y=", at);
    rows.insert(html.substr(y, html.find(' ', y + 1) - y));
  }
  EXPECT_EQ(rows.size(), 4U) << html;  // three labels, and what the axes are
}

TEST(BenchPage, SaysWhyAUsersSubjectIsLeftOut) {
  BenchResult bench = SampleBench();
  std::erase_if(bench.rows, [](const BenchRow& row) { return row.method == 5; });
  bench.left_out.push_back({0, 5, "it was killed by signal <11>"});
  const std::string table = UsersTable(bench);
  EXPECT_TRUE(Says(table, "left out: it was killed by signal &lt;11&gt;")) << table;
}

}  // namespace
}  // namespace rasterproof::report
