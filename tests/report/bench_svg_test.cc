// The picture of error against run time: places by the data, intervals where there are some.
#include "report/bench_svg.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/bench_decision.h"
#include "report/bench_text.h"
#include "tests/report/sample_bench.h"

namespace rasterproof::report {
namespace {

// The sample's first family, with a method of the user's at each ratio, drawn in so many rounds.
BenchResult WithOwn(const std::vector<double>& ratios, std::size_t rounds) {
  BenchResult result = SampleBench();
  const BenchRow sample = result.rows.front();
  for (const double ratio : ratios) {
    BenchMethod method = result.methods.front();
    method.name = "mine at " + std::to_string(static_cast<int>(ratio));
    method.kind = "yours";
    method.is_users = true;
    BenchRow row = sample;
    row.family = 0;
    row.method = static_cast<std::uint32_t>(result.methods.size());
    row.ratio = {0.9 * ratio, ratio, 1.1 * ratio};
    row.seconds.assign(rounds, 1e-5 * ratio);
    result.methods.push_back(method);
    result.rows.push_back(row);
  }
  return result;
}

// Of the point whose title begins so.
double XOf(const pugi::xml_document& svg, std::string_view name) {
  for (const pugi::xpath_node found : svg.select_nodes("//g[title]")) {
    const std::string title = found.node().child("title").text().as_string();
    if (!title.starts_with(name)) continue;
    const std::string place = found.node().attribute("transform").as_string();
    return std::stod(place.substr(std::string("translate(").size()));
  }
  ADD_FAILURE() << "no point of " << name;
  return 0;
}

TEST(BenchSvg, PutsEachMethodAtItsRatioAndNamesTheUsers) {
  const std::string text = BenchToSvg(WithOwn({5, 50, 500}, 9));
  pugi::xml_document svg;
  ASSERT_TRUE(svg.load_string(text.c_str()));
  const double first = XOf(svg, "mine at 5 (yours)");
  const double second = XOf(svg, "mine at 50 (yours)");
  const double third = XOf(svg, "mine at 500 (yours)");
  EXPECT_GT(second - first, 20);
  EXPECT_NEAR(third - second, second - first, 0.2);  // a decade each
  for (const char* name : {"mine at 5", "mine at 50", "mine at 500"}) {
    EXPECT_NE(text.find(std::string(name) + ": "), std::string::npos) << name;
  }
  EXPECT_NE(text.find(">1000</text>"), std::string::npos);
}

TEST(BenchSvg, ShowsNoIntervalOfFewerThanSixRounds) {
  for (const auto& [rounds, words] :
       {std::pair<std::size_t, std::string>{3, "5 (3 rounds)"}, {6, "5 [4.5, 5.5]"}}) {
    const BenchResult result = WithOwn({5}, rounds);
    EXPECT_NE(BenchToSvg(result).find(words), std::string::npos) << rounds;
    EXPECT_NE(BenchToTable(result).find(words), std::string::npos) << rounds;
    EXPECT_EQ(HasInterval(result.rows.back()), rounds == 6);
  }
}

}  // namespace
}  // namespace rasterproof::report
