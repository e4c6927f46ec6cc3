// The transform against its second definition: every division, viewport, precision and flip.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/scene.h"
#include "core/transform.h"
#include "model/transform.h"
#include "tests/model/hard_numbers.h"
#include "tests/model/second_definition.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

constexpr std::size_t kStride = 11 * kOneCaseIn;  // of numerators, for each denominator
constexpr int kSizes[] = {1, 2, 3, 11, 1000, kMaxTargetSide - 1, kMaxTargetSide};

std::vector<Transform> AllTransforms() {
  std::vector<Transform> all;
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    for (const Division division : {Division::kQuotient, Division::kReciprocal}) {
      for (const ViewportForm viewport : {ViewportForm::kNone, ViewportForm::kMultiplyAdd,
                                          ViewportForm::kFused, ViewportForm::kAddMultiply}) {
        for (const bool flips : {false, true})
          all.push_back({precision, division, viewport, flips});
      }
    }
  }
  return all;
}

void ExpectPlaced(const Vertex& clip, const Transform& transform, int width, int height) {
  const Vertex window = ToWindow(clip, transform, width, height);
  const auto is_same = [&](double given, int size, bool is_y, double placed) {
    return second::IsSame(second::InWindow(given, clip, transform, size, is_y), placed);
  };
  ASSERT_TRUE(is_same(clip.x, width, false, window.x) && is_same(clip.y, height, true, window.y))
      << std::hexfloat << clip.x << " " << clip.y << " " << clip.w << " to " << window.x << " "
      << window.y << ", " << static_cast<int>(transform.division) << ", "
      << static_cast<int>(transform.viewport) << ", on " << width << " x " << height
      << (transform.precision == Precision::kFloat32 ? ", float32" : ", float64")
      << (transform.flips_y ? ", flipped" : "");
  ASSERT_EQ(window.z, clip.z);
  ASSERT_EQ(window.w, 1);
}

// Numbers whose quotients, reciprocals and sums are near ties, end, or are not exact.
std::vector<double> Numerators() {
  std::vector<double> all = second::EndsOfTheRange();
  for (const double x : {1.0 / 3, 0.1, 5.0, 7.0, 41.0, 49.0, 1 - 0x1.70eep-9, 0x1.cp-25, 1000.25}) {
    for (const double beside : second::AndNeighbours(x)) {
      all.push_back(beside);
      all.push_back(-beside);
    }
  }
  return all;
}

std::vector<double> Denominators() {
  std::vector<double> all;
  for (const double w : {1.0, 3.0, 7.0, 41.0, 49.0, 0.1, 0x1p-1074, 0x1p-1022, 0x1p-149, 0x1p-126,
                         0x1p-20, 0x1p24, 0x1p126, 0x1p127, 0x1p1023}) {
    for (const double beside : second::AndNeighbours(w)) {
      if (beside > 0) all.push_back(beside);
    }
  }
  return all;
}

TEST(TransformByRationals, IsToWindowOperationByOperation) {
  const std::vector<double> numerators = Numerators();
  const std::vector<double> denominators = Denominators();
  for (const Transform& transform : AllTransforms()) {
    std::size_t turn = 0;  // sizes and y go round, so that every pair meets in some other place
    for (const double w : denominators) {
      for (std::size_t k = turn % kStride; k < numerators.size(); k += kStride) {
        const double y = numerators[(k * 7 + turn) % numerators.size()];
        const int width = kSizes[turn % std::size(kSizes)];
        const int height = kSizes[(turn / 3) % std::size(kSizes)];
        ++turn;
        ExpectPlaced({numerators[k], y, 0.25, w}, transform, width, height);
        if (HasFatalFailure()) return;
      }
    }
  }
}

// Places on tiles of UTM size, and beside them, for steps that binary fractions have and have not.
TEST(TransformByRationals, IsToWindowOfAMap) {
  const std::vector<double> ends = second::EndsOfTheRange();
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    for (const Division division : {Division::kQuotient, Division::kReciprocal}) {
      for (const double step : {0.1, 0.25, 1.0 / 3, 10.0, 30.0}) {
        const Transform map{.precision = precision,
                            .division = division,
                            .map = MapGrid{872512, 6114970, step, -step}};
        for (int k = -4; k < 700; k += static_cast<int>(kOneCaseIn)) {
          const std::vector<double> xs = second::AndNeighbours(872512 + (k + 0.5) * step);
          const std::vector<double> ys = second::AndNeighbours(6114970 - (k + 0.5) * step);
          for (std::size_t i = 0; i < xs.size(); ++i)
            ExpectPlaced({xs[i], ys[ys.size() - 1 - i], 2, 1}, map, 512, 512);
        }
        for (std::size_t i = 0; i < ends.size(); ++i)
          ExpectPlaced({ends[i], ends[ends.size() - 1 - i], 0, -1}, map, 8, 8);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(TransformByRationals, IsToWindowWhereThereIsNoPlace) {
  constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
  const std::vector<double> all{0.0, -0.0, 1.0, -1.0, HUGE_VAL, -HUGE_VAL, kNaN};
  for (const Transform& transform : AllTransforms()) {
    for (const double x : all) {
      for (const double y : all) {
        for (const double w : all) {
          ExpectPlaced({x, y, -3, w}, transform, 8, 6);
          if (HasFatalFailure()) return;
        }
      }
    }
  }
}

}  // namespace
}  // namespace rasterproof
