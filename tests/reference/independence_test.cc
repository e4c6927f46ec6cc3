// Tiles, threads and the scissor change nothing; the box loses nothing.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "reference/box.h"
#include "tests/reference/random_values.h"
#include "tests/reference/scenes.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

/// Triangles large and small, over and beyond the target, so that walks start at its corner and
/// off.
Scene ManyTriangles(std::uint64_t seed) {
  RandomValues random(seed);
  std::vector<Point2> points;
  for (int n = 0; n < 60; ++n) {
    const double reach = random.Integer(0, 2) == 0 ? 500 : 60;
    points.push_back({static_cast<float>(random.Uniform(-reach / 4, reach)),
                      static_cast<float>(random.Uniform(-reach / 4, reach))});
  }
  return WindowScene(53, 47, points);
}

TEST(IndependenceTest, TileSizeAndThreadCountChangeNothing) {
  const Scene scene = ManyTriangles(51);
  for (const std::string& name : WindowMethods()) {
    const CoverageCounts expected = Draw(scene, name);
    for (const int tile : {0, 1, 3, 8, 64, std::numeric_limits<int>::max()}) {
      for (const int threads : {0, 1, 2, 7, 1000}) {
        if (kOneCaseIn > 1 && tile != 8 && threads != 2) continue;
        RasterOptions options;
        options.tile = tile;
        options.threads = threads;
        EXPECT_EQ(Draw(scene, name, options), expected)
            << name << " tile " << tile << " threads " << threads;
      }
    }
  }
}

TEST(IndependenceTest, TheScissorCutsAndChangesNothingInside) {
  const Scene scene = ManyTriangles(52);
  const std::vector<PixelRect> scissors{{0, 0, 53, 47},    {10, 5, 30, 31},  {52, 46, 53, 47},
                                        {-9, -9, 20, 900}, {20, 20, 20, 30}, {30, 30, 10, 10},
                                        {60, 0, 90, 20}};
  for (const std::string& name : WindowMethods()) {
    const CoverageCounts whole = Draw(scene, name);
    for (const PixelRect& scissor : scissors) {
      RasterOptions options;
      options.scissor = scissor;
      options.tile = 8;
      const CoverageCounts cut = Draw(scene, name, options);
      for (int j = 0; j < scene.height; ++j) {
        for (int i = 0; i < scene.width; ++i) {
          const bool in = i >= scissor.x0 && i < scissor.x1 && j >= scissor.y0 && j < scissor.y1;
          const std::size_t n = cut.Index(i, j);
          ASSERT_EQ(cut.front[n], in ? whole.front[n] : 0) << name;
          ASSERT_EQ(cut.back[n], in ? whole.back[n] : 0) << name;
        }
      }
    }
  }
}

TEST(IndependenceTest, DrawingAddsToWhatIsThere) {
  const Scene scene = ManyTriangles(53);
  for (const std::string& name : WindowMethods()) {
    CoverageCounts twice = Draw(scene, name);
    const CoverageCounts once = twice;
    Rasterize(scene, *FindMethod(name), {}, twice);
    for (std::size_t n = 0; n < once.size(); ++n) ASSERT_EQ(twice.Count(n), 2 * once.Count(n));
  }
}

TEST(BoxTest, CentresAreFoundForEveryDouble) {
  constexpr double kHuge = 1e30;
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(FirstCentreFrom(2.5, 0, 8), 2);
  EXPECT_EQ(FirstCentreBeyond(2.5, 0, 8), 3);
  EXPECT_EQ(FirstCentreFrom(MoveByUlps(2.5, 1), 0, 8), 3);
  EXPECT_EQ(FirstCentreBeyond(MoveByUlps(2.5, -1), 0, 8), 2);
  EXPECT_EQ(FirstCentreFrom(-kHuge, 0, 8), 0);
  EXPECT_EQ(FirstCentreFrom(kHuge, 0, 8), 8);
  EXPECT_EQ(FirstCentreBeyond(-kHuge, 3, 8), 3);
  EXPECT_EQ(FirstCentreBeyond(kHuge, 3, 8), 8);
  EXPECT_EQ(FirstCentreFrom(kNaN, 1, 8), 1);
  EXPECT_EQ(FirstCentreBeyond(kNaN, 1, 8), 1);
  EXPECT_EQ(FirstCentreFrom(0.5, 0, 8), 0);
  EXPECT_EQ(FirstCentreBeyond(0.5, 0, 8), 1);
  EXPECT_EQ(FirstCentreBeyond(7.5, 0, 8), 8);
}

TEST(BoxTest, TheBoxHoldsExactlyTheCentresWithinTheExtent) {
  RandomValues random(54);
  for (int n = 0; n < 2000; ++n) {
    const auto coordinate = [&] {
      return MoveByUlps(random.Integer(-4, 24) * 0.5, random.Integer(-1, 1));
    };
    const std::array<Point2, 3> v{Point2{coordinate(), coordinate()},
                                  {coordinate(), coordinate()},
                                  {coordinate(), coordinate()}};
    const PixelRect box = SampleBox(v, {0, 0, 10, 10});
    const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
    const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
    for (int i = 0; i < 10; ++i) {
      EXPECT_EQ(i >= box.x0 && i < box.x1, i + 0.5 >= left && i + 0.5 <= right);
      EXPECT_EQ(i >= box.y0 && i < box.y1, i + 0.5 >= top && i + 0.5 <= bottom);
    }
  }
}

}  // namespace
}  // namespace rasterproof::reference
