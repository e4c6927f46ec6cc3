#include "bench/errors.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "bench/exact_triangles.h"
#include "core/profile.h"
#include "exact/coverage.h"
#include "model/segment_distance.h"
#include "reference/method.h"

namespace rasterproof::bench {
namespace {

// Draws by the oracle, with errors to order.
class Draughtsman final : public Contender {
 public:
  using Error = std::function<void(std::size_t triangle, const PixelRect& area,
                                   std::vector<std::uint8_t>& box)>;
  explicit Draughtsman(Error error = {}) : error_(std::move(error)) { method_.name = "drawn"; }
  void SnapTo(int bits) { model_.snap.bits = bits; }

  std::optional<std::string> WhyNot(const FamilyInput& /*family*/) const override { return {}; }
  void Load(const FamilyInput& family) override { exact_.emplace(family.scene, model_); }
  DrawTime Draw() override { return {}; }
  bool MoveDrawn(CoverageCounts& /*to*/) override { return false; }
  void DrawAlone(std::size_t triangle, const PixelRect& area,
                 std::vector<std::uint8_t>& box) override {
    exact_->Cover(triangle, area, box);
    if (error_) error_(triangle, area, box);
  }
  std::uint64_t LeftBehind() override { return outside; }

  std::uint64_t outside = 0;

 private:
  Error error_;
  std::optional<ExactTriangles> exact_;
};

// Two triangles of a square from (2, 2) to (18, 18), their diagonal through pixel centres.
FamilyInput Square() {
  Scene scene;
  scene.name = "square";
  scene.width = scene.height = 20;
  scene.vertices = {{2, 2}, {18, 2}, {18, 18}, {2, 18}};
  scene.triangles = {{0, 2, 1}, {0, 3, 2}};
  return FamilyOf(std::move(scene), "A square");
}

Judgement JudgementOf(Draughtsman& drawn, const FamilyInput& family) {
  drawn.Load(family);
  const JudgedTriangles judged(family.scene, 1'000'000);
  CoverageJudge judge(family, judged);
  return judge.Of(drawn);
}

std::uint8_t& At(std::vector<std::uint8_t>& box, const PixelRect& area, int x, int y) {
  return box[static_cast<std::size_t>((y - area.y0) * (area.x1 - area.x0) + x - area.x0)];
}

// A corner behind the eye: the divided corners' box is not where the triangle is seen.
TEST(ExactTriangles, AreWholeWhereACornerLiesBehindTheEye) {
  Scene scene;
  scene.width = scene.height = 64;
  scene.clip_space = true;
  scene.vertices = {{8, 8, 0, 1}, {8, 40, 0, 1}, {-40, -24, 0, -1}};
  scene.triangles = {{0, 1, 2}};
  const PixelRect area = JudgedArea(scene, 0);
  EXPECT_EQ(area, (PixelRect{0, 0, 64, 64}));
  ExactTriangles exact(scene, Profile{});
  std::vector<std::uint8_t> covered;
  exact.Cover(0, area, covered);
  std::size_t beyond = 0;  // the box of the divided corners, whose third is (40, 24)
  for (int y = 0; y < 64; ++y) {
    for (int x = 0; x < 64; ++x) {
      const bool is_covered = At(covered, area, x, y) != 0;
      EXPECT_EQ(is_covered, exact.Covers(0, x, y)) << x << ", " << y;
      beyond += is_covered && (x < 8 || y >= 40 || y < 8) ? 1 : 0;
    }
  }
  EXPECT_GT(beyond, 100U);
  // Seen are the edge between the first two corners and two rays to the left of them.
  const SeenEdges edges = exact.EdgesOf(0);
  EXPECT_EQ(DistanceFrom(edges, {10, 24}), 2);
  EXPECT_EQ(DistanceFrom(edges, {0, 4}), 0);
  EXPECT_NEAR(DistanceFrom(edges, {40, 24}), 32, 1e-9);
}

TEST(SegmentDistance, IsThatOfTheNearestPointOfTheClosedSegment) {
  EXPECT_EQ(SegmentDistance({0, 0}, {4, 0}, {2, 3}), 3);
  EXPECT_EQ(SegmentDistance({0, 0}, {4, 0}, {7, 4}), 5);
  EXPECT_EQ(SegmentDistance({0, 0}, {4, 0}, {-3, 4}), 5);
  EXPECT_EQ(SegmentDistance({1, 1}, {1, 1}, {4, 5}), 5);
  // On the segment, though its products round.
  EXPECT_EQ(SegmentDistance({0.1, 0.3}, {0.1 + 0x1p-4 * 3, 0.3 + 0x1p-4 * 5},
                            {0.1 + 0x1p-4 * 3, 0.3 + 0x1p-4 * 5}),
            0);
}

TEST(CoverageJudge, FindsNothingWrongWithTheOracle) {
  Draughtsman exact;
  const Judgement found = JudgementOf(exact, Square());
  EXPECT_EQ(found.real.Wrong(), 0U);
  EXPECT_EQ(found.leaks.Sum(), 0U);
  EXPECT_FALSE(found.real.worst);
}

TEST(CoverageJudge, TellsHowFarAWrongSampleLiesFromTheBoundary) {
  Draughtsman one([](std::size_t triangle, const PixelRect& area, std::vector<std::uint8_t>& box) {
    if (triangle == 0)
      At(box, area, 15, 5) = 0;  // 3.5 below the upper side, 2.5 from the right one
  });
  const Judgement found = JudgementOf(one, Square());
  EXPECT_EQ(found.real.missing, 1U);
  EXPECT_EQ(found.real.unexpected, 0U);
  EXPECT_DOUBLE_EQ(found.real.displacement, 2.5);
  ASSERT_TRUE(found.real.worst);
  EXPECT_EQ(*found.real.worst, (BenchWitness{0, {{{2, 2}, {18, 18}, {18, 2}}}, 15, 5, 2.5}));
  EXPECT_TRUE(std::isnan(found.real.displacement_999));
}

TEST(CoverageJudge, CallsATriangleLostThatNothingIsDrawnOf) {
  Draughtsman loses([](std::size_t triangle, const PixelRect&, std::vector<std::uint8_t>& box) {
    if (triangle == 1) box.assign(box.size(), 0);
  });
  const Judgement found = JudgementOf(loses, Square());
  EXPECT_EQ(found.real.lost, found.real.missing);
  EXPECT_GT(found.real.lost, 100U);
  EXPECT_EQ(found.real.displacement, 0);
}

TEST(CoverageJudge, TellsGapsFromOverlapsAndNeitherFromAMovedEdge) {
  // The diagonal's sample of column 6 belongs to one of the two.
  const auto change = [](bool in_first, bool in_second) {
    return Draughtsman(
        [=](std::size_t triangle, const PixelRect& area, std::vector<std::uint8_t>& box) {
          At(box, area, 6, 6) = (triangle == 0 ? in_first : in_second) ? 1 : 0;
        });
  };
  Draughtsman gap = change(false, false);
  EXPECT_EQ(JudgementOf(gap, Square()).leaks.gaps, 1U);
  EXPECT_EQ(JudgementOf(gap, Square()).leaks.overlaps, 0U);
  Draughtsman overlap = change(true, true);
  EXPECT_EQ(JudgementOf(overlap, Square()).leaks.overlaps, 1U);
  EXPECT_EQ(JudgementOf(overlap, Square()).leaks.gaps, 0U);
  for (const bool first : {false, true}) {
    Draughtsman moved = change(first, !first);
    EXPECT_EQ(JudgementOf(moved, Square()).leaks.Sum(), 0U);
  }
}

TEST(CoverageJudge, HoldsASnappedMethodToItsOwnModelApart) {
  FamilyInput family = Square();
  family.scene.vertices[0] = {2.4, 2.9};
  Draughtsman snapped;
  snapped.SnapTo(0);
  const Judgement found = JudgementOf(snapped, family);
  EXPECT_EQ(found.own.Wrong(), 0U);
  EXPECT_EQ(found.leaks.Sum(), 0U);
  EXPECT_GT(found.real.Wrong(), 0U);
  EXPECT_LE(found.real.displacement, std::hypot(0.4, 0.1));
}

TEST(CoverageJudge, CountsWhatIsDrawnFarOutside) {
  Draughtsman wild;
  wild.outside = 3;
  EXPECT_EQ(JudgementOf(wild, Square()).real.unexpected, 3U);
}

TEST(JudgedTriangles, AreAllOfASmallFamilyAndBlocksOfALargeOne) {
  const FamilyInput ties = MakeFamily(FamilyKinds()[7], FamilySize::kQuick, 1);
  EXPECT_EQ(JudgedTriangles(ties.scene, std::uint64_t{1} << 40).indices().size(),
            ties.scene.triangles.size());
  const JudgedTriangles some(ties.scene, 100'000);
  EXPECT_LT(some.indices().size(), ties.scene.triangles.size() / 4);
  EXPECT_GE(some.indices().size(), 64U);
  EXPECT_EQ(some.indices()[63], 63U);
}

TEST(Describe, CountsTheSamplesOfASquareByHand) {
  const FamilyInput family = Square();
  const JudgedTriangles judged(family.scene, 1'000'000);
  const BenchFamily described = Describe(family, judged);
  EXPECT_EQ(described.triangles, 2U);
  EXPECT_EQ(described.covered, 256U);
  EXPECT_EQ(described.judged_covered, 256U);
  // The sixteen samples on the diagonal, of both triangles; the next lie 0.7 pixels beside it.
  EXPECT_EQ(described.distances.pairs[0], 32U);
  // On the diagonal and a step beyond either end; beside it, 0.71 pixels away, 17 each way.
  EXPECT_EQ(described.shared_pairs, 18U + 2 * 17U);
  EXPECT_EQ(described.largest_coordinate, 18);
}

}  // namespace
}  // namespace rasterproof::bench
