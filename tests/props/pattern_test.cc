// Where all wrong samples lie, of violations that no suspect explains.
#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "props/cause/cause.h"
#include "props/judging/redraw.h"
#include "props/placed_case.h"
#include "tests/props/planted_cause.h"

namespace rasterproof::props {
namespace {

constexpr int kSide = 32;

using Loses = std::function<bool(int x, int row)>;

// What is said where these samples of as many scenes, triangles of most of the target, are lost.
std::string PatternWhere(const Loses& loses, std::size_t scenes = 8) {
  const std::unique_ptr<Subject> stated = Planted({})();
  std::vector<Observation> all;
  for (std::size_t k = 0; k < scenes; ++k) {
    const double end = 2 * kSide + static_cast<double>(k);
    Case c = TrianglesOf(kSide, kSide, {{0, 0, 0, 1}, {end, 0, 0, 1}, {0, end, 0, 1}});
    c.profile = stated->Info().profile;
    Observation& o = all.emplace_back();
    o.placed = std::make_shared<const PlacedCase>(Place(c, false));
    o.check.questions.draws.push_back(CountsOf(c.scene, c.profile, c.options));
    Drawing drawing = *DrawnBy(*stated, o).front();
    CoverageCounts& counts = drawing.counts;
    for (int row = 0; row < kSide; ++row) {
      for (int x = 0; x < kSide; ++x) {
        const std::size_t at = counts.Index(x, row);
        if (loses(x, row)) counts.front[at] = counts.back[at] = 0;
      }
    }
    o.seen = {std::make_shared<const Drawing>(std::move(drawing))};
  }
  std::vector<const Observation*> wrong;
  for (const Observation& o : all) wrong.push_back(&o);
  return PatternOf(wrong, *stated);
}

TEST(PatternOf, NamesTheOneColumnOrRow) {
  EXPECT_EQ(PatternWhere([](int x, int) { return x == 5; }), "lies in column 5");
  EXPECT_EQ(PatternWhere([](int, int row) { return row == 0; }), "lies in row 0");
}

TEST(PatternOf, NamesTheSideOnWhichNothingIsRight) {
  EXPECT_EQ(PatternWhere([](int x, int) { return x >= 20; }),
            "lies from column 20 on, where nothing is right that should be covered");
  EXPECT_EQ(PatternWhere([](int, int row) { return row <= 3; }),
            "lies up to row 3, where nothing is right that should be covered");
  EXPECT_EQ(PatternWhere([](int x, int row) { return x >= 20 && row % 2 == 0; }), "");
}

TEST(PatternOf, NamesTheLargestBlocksThatAreLeftOutWhole) {
  EXPECT_EQ(PatternWhere([](int x, int row) { return x / 8 == 1 && row / 8 != 2; }),
            "lies in a block of 8 x 8 pixels that is left out whole");
  EXPECT_EQ(PatternWhere([](int x, int row) { return (x / 16 + row / 16) % 2 == 1; }),
            "lies in a block of 16 x 16 pixels that is left out whole");
}

TEST(PatternOf, SaysNothingOfScatteredSamplesOrFewScenes) {
  EXPECT_EQ(PatternWhere([](int x, int row) { return (3 * x + 5 * row) % 7 == 0; }), "");
  EXPECT_EQ(PatternWhere([](int x, int) { return x == 5; }, 7), "");
}

}  // namespace
}  // namespace rasterproof::props
