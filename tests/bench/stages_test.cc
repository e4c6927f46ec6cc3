#include "bench/stages.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numbers>
#include <string>
#include <vector>

#include "core/bench_result.h"
#include "exact/rational.h"
#include "tests/share.h"

namespace rasterproof::bench {
namespace {

const std::vector<InexactStages>& OneByOne() {
  static const std::vector<InexactStages> stages{
      {.transform = true}, {.clip = true}, {.divide = true}, {.snap_bits = 8}, {.coverage = true}};
  return stages;
}

TEST(TorusFrame, HasNoRowTimesAPlaceThatRoundsAndIsCutByTheNearPlane) {
  const FrameInput frame = TorusFrame(4);
  std::size_t behind = 0;
  for (const auto& place : frame.places) {
    for (const auto& row : frame.matrix) {
      exact::Rational sum = row[3];
      for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_EQ(static_cast<double>(static_cast<float>(row[k])), row[k]);
        EXPECT_EQ(static_cast<double>(static_cast<float>(place[k])), place[k]);
        sum += exact::Rational(row[k]) * place[k];
      }
      const double rounded = row[0] * place[0] + row[1] * place[1] + row[2] * place[2] + row[3];
      EXPECT_EQ(sum, exact::Rational(rounded));
      if (&row == &frame.matrix[2] && sum < exact::Rational(frame.near_w)) ++behind;
    }
  }
  EXPECT_GT(behind, frame.places.size() / 64);
  EXPECT_LT(behind, frame.places.size() / 2);
}

// Triangles with an edge through pixel centres, (x + 3 k, y + k), from a corner between the doubles
// to one behind the near plane. Their transform multiplies by 1 and adds 0.
FrameInput Grazing() {
  FrameInput frame;
  frame.width = frame.height = 512;
  frame.near_w = 0.375;
  frame.matrix = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  for (int i = 0; i < 40; ++i) {
    const double x = 10.5 + 7 * i;
    const double y = 20.5 + 5 * i;
    frame.places.push_back({9 * x + 3, 9 * y + 1, 9});
    frame.places.push_back({(x + 180 + 3 * i) / 4, (y + 60 + i) / 4, 0.25});
    frame.places.push_back({x + 20, y + 90, 1});
    frame.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  return frame;
}

BenchStage Judged(const FrameInput& frame, const InexactStages& inexact,
                  exact::Decider decider = exact::Decider::kFast) {
  return JudgeStages(frame, std::array{inexact}, decider)[0];
}

TEST(JudgeStages, FindsNothingWrongWhereEveryStageIsExact) {
  for (const FrameInput& frame : {TorusFrame(kOneCaseIn > 1 ? 32 : 8), Grazing()}) {
    const BenchStage exact = Judged(frame, {});
    EXPECT_EQ(exact.wrong, 0U);
    EXPECT_EQ(exact.displacement, 0);
    EXPECT_GT(exact.asked, 30'000U);
  }
}

TEST(JudgeStages, FindsNothingWrongWithATransformThatDoesNotRound) {
  EXPECT_EQ(Judged(Grazing(), {.transform = true}).wrong, 0U);
  EXPECT_GT(Judged(TorusFrame(4), {.transform = true}).wrong, 0U);
}

// Both halves of a square by both diagonals, either way round: all edges pass through centres.
TEST(JudgeStages, FindsNothingWrongWhereNoStageRounds) {
  FrameInput frame;
  frame.width = frame.height = 24;
  frame.near_w = 0.5;
  frame.matrix = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};
  frame.places = {{2.5, 2.5, 1}, {18.5, 2.5, 1}, {18.5, 18.5, 1}, {2.5, 18.5, 1}};
  frame.triangles = {{0, 1, 2}, {0, 2, 1}, {0, 2, 3}, {0, 3, 2},
                     {0, 1, 3}, {0, 3, 1}, {1, 2, 3}, {1, 3, 2}};
  for (const BenchStage& stage : JudgeStages(frame, OneByOne())) EXPECT_EQ(stage.wrong, 0U);
}

TEST(JudgeStages, SeesEveryStageThatRounds) {
  const FrameInput grazing = Grazing();
  const auto stages = JudgeStages(
      grazing, std::vector<InexactStages>{{.clip = true}, {.divide = true}, {.coverage = true}});
  for (const BenchStage& stage : stages) {
    EXPECT_GT(stage.wrong, 0U);
    // Some roundings of a coordinate of 1024 pixels.
    EXPECT_LT(stage.displacement, 0x1p-10);
  }
}

// The exact frame decides in front of the near plane by the plane of the triangle, the snapped one
// by the corners that clipping makes.
TEST(JudgeStages, MovesASnappedEdgeByAtMostHalfTheDiagonalOfACell) {
  for (const int bits : {4, 8, 16}) {
    const double reach = std::ldexp(std::numbers::sqrt2 / 2, -bits);
    EXPECT_LE(Judged(Grazing(), {.snap_bits = bits}).displacement, reach + 1e-12);
    const BenchStage snapped = Judged(TorusFrame(8), {.snap_bits = bits});
    EXPECT_LE(snapped.displacement, reach + 1e-12);
    if (bits == 16) continue;
    EXPECT_GT(snapped.displacement, reach / 2);
    EXPECT_GT(snapped.wrong, 100U);
  }
}

TEST(JudgeStages, IsTheSameByASecondDecider) {
  for (const FrameInput& frame : {TorusFrame(kOneCaseIn > 1 ? 128 : 16), Grazing()}) {
    for (const InexactStages& inexact : OneByOne()) {
      const BenchStage first = Judged(frame, inexact);
      const BenchStage second = Judged(frame, inexact, exact::Decider::kCgal);
      EXPECT_EQ(first.asked, second.asked);
      EXPECT_EQ(first.wrong, second.wrong);
      EXPECT_EQ(first.displacement, second.displacement);
    }
  }
}

TEST(RunStages, TellsWhatEachStageMoves) {
  BenchResult result;
  RunStages(4, result);
  std::map<std::string, std::uint64_t> wrong;
  for (const BenchStage& stage : result.stages) {
    wrong[stage.name] = stage.wrong;
    EXPECT_EQ(stage.asked, 780'899U);
  }
  EXPECT_EQ(wrong,
            (std::map<std::string, std::uint64_t>{
                {"transform", 6}, {"clip", 0}, {"divide", 6}, {"snap", 321}, {"coverage", 0}}));
}

}  // namespace
}  // namespace rasterproof::bench
