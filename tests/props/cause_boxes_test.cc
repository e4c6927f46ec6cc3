// Boxes that lose pixels are named by their end and their axis, and sound ones are not accused.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "tests/props/planted_cause.h"

namespace rasterproof::props {
namespace {

using subjects::mutants::FixedStages;
using subjects::mutants::GridPoint;
using subjects::mutants::GridTriangle;

// A square of two triangles, and one larger than the target: every side of a box matters.
std::vector<Case> Squares() {
  const auto at = [](double x, double y) { return Vertex{x, y, 0, 1}; };
  constexpr double kLeast = 1.25, kMost = 9.75;
  return {TrianglesOf(12, 12,
                      {at(kLeast, kLeast), at(kMost, kLeast), at(kLeast, kMost), at(kMost, kMost),
                       at(kLeast, kMost), at(kMost, kLeast)}),
          TrianglesOf(12, 12, {at(-4, -4), at(32, -4), at(-4, 32)})};
}

// The least and the largest coordinate of a triangle along an axis, in 1/256 pixel, and the size of
// the target there. Rows as the rasterizer counts them: from the bottom where y is up.
struct Span {
  std::int64_t least, most;
  int size;
};
int FloorOf(std::int64_t at) { return static_cast<int>(at >> 8); }
int CeilOf(std::int64_t at) { return -FloorOf(-at); }

// Where a loop begins, and the pixel before which it ends.
using Loop = std::pair<int, int> (*)(const Span&);

FixedStages Looping(Loop along_x, Loop along_y, YAxis y_axis = YAxis::kDown) {
  FixedStages stages;
  stages.profile.y_axis = y_axis;
  const bool y_up = y_axis == YAxis::kUp;
  stages.box = [=](PixelRect& box, const GridTriangle& t, const Scene& scene) {
    const auto [left, right] = std::ranges::minmax(t.v, {}, &GridPoint::x);
    const auto [top, bottom] = std::ranges::minmax(t.v, {}, &GridPoint::y);
    std::tie(box.x0, box.x1) = along_x({left.x, right.x, scene.width});
    const auto [first, end] =
        along_y(y_up ? Span{-bottom.y, -top.y, scene.height} : Span{top.y, bottom.y, scene.height});
    box.y0 = y_up ? scene.height - end : first;
    box.y1 = y_up ? scene.height - first : end;
  };
  return stages;
}

std::pair<int, int> Sound(const Span& s) { return {FloorOf(s.least), FloorOf(s.most) + 1}; }
std::pair<int, int> SoundToCeil(const Span& s) { return {FloorOf(s.least), CeilOf(s.most)}; }
std::pair<int, int> SoundAndCut(const Span& s) {
  return {std::max(0, FloorOf(s.least)), std::min(s.size, FloorOf(s.most) + 1)};
}
std::pair<int, int> EndsEarly(const Span& s) { return {FloorOf(s.least), FloorOf(s.most)}; }
std::pair<int, int> EndsEarlyByCeil(const Span& s) {
  return {FloorOf(s.least), CeilOf(s.most) - 1};
}
std::pair<int, int> EndsEarlyAndCut(const Span& s) {
  return {std::max(0, FloorOf(s.least)), std::min(s.size - 1, FloorOf(s.most))};
}
std::pair<int, int> BeginsLate(const Span& s) { return {CeilOf(s.least), CeilOf(s.most)}; }
std::pair<int, int> LosesBoth(const Span& s) { return {CeilOf(s.least), FloorOf(s.most)}; }

struct WrongBox {
  Loop along_x, along_y;
  YAxis y_axis;
  std::string_view what;
};

class BoxCause : public ::testing::TestWithParam<WrongBox> {};

TEST_P(BoxCause, IsNamedByItsEndAndItsAxis) {
  const WrongBox& wrong = GetParam();
  const Causes found =
      ExplainPlanted(Looping(wrong.along_x, wrong.along_y, wrong.y_axis), {Squares()});
  ASSERT_EQ(found.all.size(), 1U);
  const Cause& cause = found.all.front();
  EXPECT_EQ(cause.kind, CauseKind::kModel);
  EXPECT_EQ(cause.name, "bounding-box");
  EXPECT_EQ(cause.what, std::vector<std::string>{std::string(wrong.what)});
  EXPECT_FALSE(cause.rests_on_few);
}

INSTANTIATE_TEST_SUITE_P(
    Cause, BoxCause,
    ::testing::Values(
        WrongBox{EndsEarly, Sound, YAxis::kDown,
                 "ends a triangle's box before floor of the largest x"},
        WrongBox{SoundToCeil, EndsEarly, YAxis::kDown,
                 "ends a triangle's box before floor of the largest y"},
        WrongBox{EndsEarly, EndsEarly, YAxis::kDown,
                 "ends a triangle's box before floor of the largest x and y"},
        WrongBox{Sound, EndsEarly, YAxis::kUp,
                 "ends a triangle's box before floor of the largest y"},
        WrongBox{EndsEarlyByCeil, Sound, YAxis::kDown,
                 "ends a triangle's box before ceil of the largest x less 1"},
        WrongBox{EndsEarlyAndCut, SoundAndCut, YAxis::kDown,
                 "ends a triangle's box before floor of the largest x, cut to the target's last "
                 "pixel"},
        WrongBox{BeginsLate, Sound, YAxis::kDown, "begins a triangle's box at ceil of the least x"},
        WrongBox{Sound, BeginsLate, YAxis::kDown, "begins a triangle's box at ceil of the least y"},
        WrongBox{BeginsLate, BeginsLate, YAxis::kDown,
                 "begins a triangle's box at ceil of the least x and y"},
        WrongBox{LosesBoth, LosesBoth, YAxis::kDown,
                 "begins a triangle's box at ceil of the least x and y and ends it before floor of "
                 "the largest x and y"}));

TEST(BoxCause, OfASoundBoxIsNotTheBox) {
  for (const Loop loop : {Sound, SoundToCeil, SoundAndCut}) {
    const Causes exact = ExplainPlanted(Looping(loop, loop), {Squares()});
    ASSERT_EQ(exact.all.size(), 1U);
    EXPECT_EQ(exact.wrong, 0U);
    EXPECT_TRUE(exact.all.front().name.empty()) << exact.all.front().name;
  }
  FixedStages stages = Looping(Sound, SoundToCeil);
  stages.owns = [](const auto& edge, const auto&, const auto&) {
    return edge.owns || edge.a.y == edge.b.y;
  };
  const Causes tie =
      ExplainPlanted(stages, {{TrianglesOf(8, 8, {{1, 5.5, 0, 1}, {6, 5.5, 0, 1}, {3, 1, 0, 1}})}});
  ASSERT_EQ(tie.all.size(), 1U);
  EXPECT_EQ(tie.all.front().name, "tie-rule");
}

}  // namespace
}  // namespace rasterproof::props
