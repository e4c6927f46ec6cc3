#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <string_view>

#include "core/compared_numbers.h"
#include "pugixml.hpp"
#include "report/explanation_numbers.h"
#include "report/figure.h"
#include "report/palette.h"
#include "report/picture.h"

namespace rasterproof::report {
namespace {

// A 4 x 3 target with a count of 1 everywhere; the subject left out one sample, drew one twice, and
// saw one from behind.
Explanation Sample() {
  Explanation explanation;
  explanation.scene.width = 4;
  explanation.scene.height = 3;
  explanation.scene.vertices = {{0.5, 0.5}, {3.5, 0.5}, {0.5, 2.5}};
  explanation.scene.triangles = {{0, 2, 1}};
  explanation.expected = CoverageCounts(4, 3);
  std::ranges::fill(explanation.expected.front, 1U);
  explanation.observed = explanation.expected;
  CoverageCounts& observed = explanation.observed;
  observed.front[observed.Index(1, 1)] = 0;
  observed.front[observed.Index(2, 1)] = 2;
  std::swap(observed.front[observed.Index(3, 2)], observed.back[observed.Index(3, 2)]);
  explanation.view = {0, 0, 4, 3};
  explanation.focus_x = 1;
  explanation.focus_y = 1;
  explanation.triangles = {0};
  explanation.edge_values = {"triangle 0, edge v1-v2: E = -3/65536"};
  explanation.headline = "3 of 12 samples differ";
  explanation.replay = "rasterproof explain case.json";
  return explanation;
}

std::size_t Count(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) {
    ++count;
  }
  return count;
}

bool Holds(const io::Image& image, Colour colour) {
  return std::ranges::find(image.pixels, colour) != image.pixels.end();
}

TEST(ExplanationTextTest, ShowsExpectedActualAndDifferenceSideBySide) {
  EXPECT_EQ(
      ExplanationToText(Sample(), false),
      "3 of 12 samples differ\n"
      "   columns 0 to 3, rows 0 to 2\n"
      "   expected       actual         difference\n"
      " 0 1 1 1 1        1 1 1 1        . . . .\n"
      " 1 1[1]1 1        1[.]2 1        .[-]+ .\n"
      " 2 1 1 1 1        1 1 1 1        . . . !\n"
      "counts: . none, 1 to 9, # more   difference: . right  - missing  + unexpected  ! facing"
      "   [ ] the pixel in question\n"
      "triangle 0, edge v1-v2: E = -3/65536\n"
      "replay: rasterproof explain case.json\n");
}

TEST(ExplanationTextTest, ShowsOnePanelWhereCoverageIsRight) {
  Explanation explanation = Sample();
  explanation.observed = explanation.expected;
  EXPECT_EQ(ExplanationToText(explanation, false),
            "3 of 12 samples differ\n"
            "   columns 0 to 3, rows 0 to 2\n"
            "   coverage, as expected\n"
            " 0 1 1 1 1\n"
            " 1 1[1]1 1\n"
            " 2 1 1 1 1\n"
            "counts: . none, 1 to 9, # more   [ ] the pixel in question\n"
            "triangle 0, edge v1-v2: E = -3/65536\n"
            "replay: rasterproof explain case.json\n");
  const std::string svg = ExplanationToSvg(explanation);
  EXPECT_EQ(svg.find("difference"), std::string::npos);
  EXPECT_NE(svg.find("as expected"), std::string::npos);
}

// Three samples hold numbers: one is right, one below what is allowed, one no number.
Explanation OfNumbers() {
  Explanation explanation = Sample();
  explanation.observed = explanation.expected;
  explanation.pattern = *StandardPattern(1);
  ComparedNumbers numbers;
  numbers.what = "channel \"u\", linear";
  numbers.list = {{1, 1, 0, 0.25, 0.5, 0.125, -2},
                  {0, 0, 0, 0, 0, 0.125, 0},
                  {2, 1, 0, std::numeric_limits<double>::quiet_NaN(), 1, 0.125,
                   std::numeric_limits<double>::quiet_NaN()}};
  explanation.numbers = std::make_shared<const ComparedNumbers>(numbers);
  explanation.edge_values = NumberLines(numbers);
  return explanation;
}

TEST(ExplanationTextTest, ShowsNumbersBesideTheExactOnes) {
  EXPECT_EQ(ExplanationToText(OfNumbers(), false),
            "3 of 12 samples differ\n"
            "   columns 0 to 3, rows 0 to 2\n"
            "   exact          shown          difference\n"
            " 0 0              0              .\n"
            " 1  [5]9           [2]?           [-]?\n"
            " 2\n"
            "numbers: 0 to 9 from 0 to 1, < below, > above, ? none   difference: . within what is "
            "allowed  - below  + above   [ ] the pixel in question\n"
            "channel \"u\", linear: shown 0.25 (0x1p-2), exact 0.5 (0x1p-1), allowed 0.125\n"
            "off by 2 times what is allowed, at pixel (1, 1), sample 0\n"
            "of 3 samples of the triangle around it 2 are off by more\n"
            "replay: rasterproof explain case.json\n");
}

TEST(ExplanationImageTest, NumbersHaveColoursThatDifferInLightness) {
  const Explanation explanation = OfNumbers();
  const NumberScale scale = ScaleOf(*explanation.numbers);
  const auto lightness = [](Colour c) { return 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2]; };
  double last = -1;
  for (const double x : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    const double light = lightness(NumberColour(scale, x));
    EXPECT_GT(light, last + 20) << x;
    last = light;
  }
  EXPECT_EQ(NumberCharacter(scale, -0.1), '<');
  EXPECT_EQ(NumberCharacter(scale, 1.1), '>');
  EXPECT_NE(OffColour(-2), OffColour(2));
  EXPECT_EQ(OffColour(1), OffColour(0)) << "within what is allowed";
  const io::Image image = ExplanationToImage(explanation);
  EXPECT_TRUE(Holds(image, NumberColour(scale, 0.5)));
  EXPECT_TRUE(Holds(image, NumberColour(scale, 0.25)));
  EXPECT_TRUE(Holds(image, OffColour(-2)));
  EXPECT_TRUE(Holds(image, kYellow)) << "the sample that failed is marked";
  EXPECT_NE(ExplanationToSvg(explanation).find(">-2.0<"), std::string::npos);
}

TEST(ExplanationTextTest, EqualNumbersHaveAScale) {
  ComparedNumbers numbers;
  numbers.is_in_ulps = true;
  numbers.list = {{0, 0, 0, 65533, 65534, 0, -1}, {1, 0, 0, 65534, 65534, 0, 0}};
  const NumberScale scale = ScaleOf(numbers);
  EXPECT_EQ(NumberCharacter(scale, 65533), '<');
  EXPECT_EQ(UnitsText(numbers, -1), "1 ulp, where none is allowed");
}

TEST(ExplanationTextTest, UsesColourOnlyIfAsked) {
  EXPECT_EQ(ExplanationToText(Sample(), false).find('\x1b'), std::string::npos);
  EXPECT_NE(ExplanationToText(Sample(), true).find("\x1b["), std::string::npos);
}

TEST(ExplanationTextTest, NoBytesOfACaseReachTheTerminalAsControls) {
  Explanation explanation = Sample();
  explanation.headline = "\x1b[2J gone";
  explanation.replay = "\x07";
  const std::string text = ExplanationToText(explanation, false);
  EXPECT_EQ(text.find('\x1b'), std::string::npos);
  EXPECT_EQ(text.find('\x07'), std::string::npos);
}

TEST(ExplanationTextTest, CountsOverTheSamplesOfAPixel) {
  Explanation explanation = Sample();
  explanation.expected = CoverageCounts(4, 3, 4);
  std::ranges::fill(explanation.expected.back, 3U);
  explanation.observed = explanation.expected;
  explanation.observed.back[explanation.observed.Index(2, 0, 3)] = 0;
  explanation.pattern.locations = {{0.25, 0.25}, {0.75, 0.25}, {0.25, 0.75}, {0.75, 0.75}};
  const std::string text = ExplanationToText(explanation, false);
  EXPECT_NE(text.find(" 0 # # # #        # # 9 #        . . - ."), std::string::npos) << text;
  EXPECT_NE(text.find("(over 4 samples)"), std::string::npos);
}

TEST(ExplanationTextTest, AHugeViewIsCutAroundTheFocus) {
  Explanation explanation = Sample();
  explanation.expected = CoverageCounts(2000, 1000);
  explanation.observed = explanation.expected;
  explanation.observed.front[explanation.observed.Index(1999, 999)] = 1;
  explanation.view = {0, 0, 2000, 1000};
  explanation.focus_x = 1999;
  explanation.focus_y = 999;
  const std::string text = ExplanationToText(explanation, false);
  EXPECT_NE(text.find("columns 1960 to 1999, rows 960 to 999"), std::string::npos) << text;
  EXPECT_NE(text.find("[+"), std::string::npos);
}

TEST(ExplanationTextTest, AViewOutsideTheTargetIsMovedIntoIt) {
  Explanation explanation = Sample();
  explanation.view = {-7, 50, -2, 90};
  explanation.focus_x = -1;
  explanation.focus_y = -1;
  EXPECT_NE(ExplanationToText(explanation, false).find("columns 0 to 3, rows 0 to 2"),
            std::string::npos);
}

TEST(ExplanationSvgTest, IsWellFormedAndShowsEachErrorLoudly) {
  const std::string svg = ExplanationToSvg(Sample());
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str()));
  EXPECT_EQ(Count(svg, "<polygon"), 3U * 12U + 6U);  // pixels and the legend
  EXPECT_NE(svg.find("fill=\"#d55e00\""), std::string::npos);
  EXPECT_NE(svg.find("fill=\"#0072b2\""), std::string::npos);
  EXPECT_NE(svg.find("fill=\"#cc79a7\""), std::string::npos);
  EXPECT_NE(svg.find("E = -3/65536"), std::string::npos);
}

TEST(ExplanationTextTest, ATriangleMuchLargerThanTheViewIsMeasured) {
  Explanation explanation = Sample();
  explanation.scene.vertices = {{-1000, 1, 0, 1}, {1047576, 1, 0, 1}, {3, 13, 0, 1}};
  explanation.scene.triangles = {{0, 1, 2}};
  explanation.triangles = {0};
  const std::string line = "triangle 0 is 1,048,576 x 12 pixels; shown: columns 0..3, rows 0..2\n";
  EXPECT_NE(ExplanationToText(explanation, false).find(line), std::string::npos);
  explanation.scene.vertices = {{0, 0, 0, 1}, {8, 0, 0, 1}, {0, 6, 0, 1}};  // twice the view
  EXPECT_EQ(ExplanationToText(explanation, false).find("; shown:"), std::string::npos);
  explanation.scene.vertices[2].y = 6.5;
  EXPECT_NE(ExplanationToText(explanation, false).find("8 x 6.5 pixels"), std::string::npos);
  explanation.scene.vertices[1].x = std::numeric_limits<double>::max();
  explanation.scene.vertices[2].x = -std::numeric_limits<double>::max();
  EXPECT_NE(ExplanationToText(explanation, false).find("over 1e308 x 6.5"), std::string::npos);
}

TEST(ExplanationSvgTest, ALargeTriangleIsShownAsAWholeTooWithTheTargetInIt) {
  Explanation explanation = Sample();
  explanation.scene.vertices = {{0, 0, 0, 1}, {4000, 0, 0, 1}, {0, 3000, 0, 1}};
  explanation.scene.triangles = {{0, 1, 2}};
  explanation.triangles = {0};
  const std::string svg = ExplanationToSvg(explanation);
  EXPECT_EQ(Count(svg, "<polygon"), 3U * 12U + 6U + 1U);
  EXPECT_NE(svg.find("the whole triangle; grey: the target"), std::string::npos);
  EXPECT_EQ(svg.find("scaled apart"), std::string::npos);
  explanation.scene.vertices[2].y = 3;
  EXPECT_NE(ExplanationToSvg(explanation).find("scaled apart"), std::string::npos);
}

TEST(ExplanationSvgTest, StaysFiniteAndInsideForTrianglesOfAnySize) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Explanation explanation = Sample();
  explanation.scene.vertices = {{1e30, -1e30}, {-1e30, 1e30},  {1e-30, 1e308},
                                {-1e308, 2},   {kInfinity, 0}, {0, -kInfinity}};
  explanation.scene.triangles = {{0, 1, 2}, {2, 3, 0}, {0, 1, 4}, {5, 4, 1}, {0, 0, 0}};
  explanation.triangles = {0, 1, 2, 3, 4, -1, 99};
  const std::string svg = ExplanationToSvg(explanation);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str()));
  const double width = document.child("svg").attribute("width").as_double();
  for (const pugi::xml_node line : document.child("svg").children("line")) {
    EXPECT_GE(line.attribute("x1").as_double(), 0);
    EXPECT_LE(line.attribute("x2").as_double(), width);
  }
}

TEST(ExplanationSvgTest, KeepsTheLegendOfASmallPictureInside) {
  Explanation small = Sample();
  small.view = {0, 0, 1, 1};
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(ExplanationToSvg(small).c_str()));
  const pugi::xml_node svg = document.child("svg");
  for (const pugi::xml_node text : svg.children("text")) {
    const std::string_view shown = text.text().as_string();
    const double advance = kAdvance * text.attribute("font-size").as_double();
    EXPECT_LE(text.attribute("x").as_double() + advance * static_cast<double>(shown.size()),
              svg.attribute("width").as_double())
        << shown;
  }
}

TEST(ExplanationSvgTest, DrawsNoOutlineOfATriangleBehindTheEye) {
  Explanation explanation = Sample();
  explanation.scene.clip_space = true;
  const std::size_t in_front = Count(ExplanationToSvg(explanation), "<line");
  explanation.scene.vertices[0].w = -1;
  EXPECT_LT(Count(ExplanationToSvg(explanation), "<line"), in_front);
}

TEST(ExplanationSvgTest, AnUpwardAxisTurnsSamplesAndTrianglesOver) {
  Explanation down = Sample();
  down.pattern.locations = {{0.5, 0.25}};
  Explanation up = Sample();
  up.pattern.locations = {{0.5, 0.75}};
  up.y_axis = YAxis::kUp;
  for (Vertex& v : up.scene.vertices) v.y = up.scene.height - v.y;
  EXPECT_TRUE(ExplanationToSvg(up) == ExplanationToSvg(down));
  up.y_axis = YAxis::kDown;
  EXPECT_FALSE(ExplanationToSvg(up) == ExplanationToSvg(down));
}

TEST(ExplanationImageTest, ShowsTheSameColours) {
  const io::Image image = ExplanationToImage(Sample());
  EXPECT_GT(image.width, 640);
  for (const Colour colour : {kVermilion, kBlue, kPurple, kCovered, kCoveredTwice, kInk, kYellow}) {
    EXPECT_TRUE(Holds(image, colour));
  }
}

TEST(ExplanationImageTest, MutesWhatIsRight) {
  Explanation explanation = Sample();
  explanation.observed = explanation.expected;
  const std::string svg = ExplanationToSvg(explanation);
  EXPECT_EQ(Count(svg, "#d55e00"), 1U);  // the legend
  EXPECT_EQ(Count(svg, "#0072b2"), 1U);
}

}  // namespace
}  // namespace rasterproof::report
