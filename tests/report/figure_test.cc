#include "report/figure.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "pugixml.hpp"
#include "report/letters.h"

namespace rasterproof::report {
namespace {

Figure Blank() {
  Figure figure;
  figure.width = 10;
  figure.height = 10;
  return figure;
}

TEST(SvgTest, IsWellFormedAndNeedsNothingFromOutside) {
  Figure figure = Blank();
  figure.Rectangle(1, 1, 4, 4, kBlue);
  figure.Line({0, 0}, {9, 9}, kInk, 1.5);
  figure.Dot({5, 5}, 2, kVermilion);
  figure.Text({0, 9}, "a <b> & \"c\"", kInk, 10);
  const std::string svg = FigureToSvg(figure);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str())) << svg;
  const pugi::xml_node root = document.child("svg");
  EXPECT_STREQ(root.attribute("viewBox").value(), "0 0 10 10");
  EXPECT_STREQ(root.child("text").text().get(), "a <b> & \"c\"");
  EXPECT_EQ(svg.find("href"), std::string::npos);
}

TEST(ImageTest, FillsAPolygonOfEitherOrientationAndNothingElse) {
  for (const bool reversed : {false, true}) {
    Figure figure = Blank();
    std::vector<Point2> outline{{2, 2}, {8, 2}, {8, 8}, {2, 8}};
    if (reversed) outline = {outline.rbegin(), outline.rend()};
    figure.Polygon(outline, kBlue);
    io::Image image = FigureToImage(figure, 1);
    EXPECT_EQ(image.At(2, 2), kBlue);
    EXPECT_EQ(image.At(7, 7), kBlue);
    EXPECT_EQ(image.At(1, 5), kPaper);
    EXPECT_EQ(image.At(8, 5), kPaper);
  }
}

TEST(ImageTest, SmoothsAnEdgeThatCrossesAPixel) {
  Figure figure = Blank();
  figure.Rectangle(2, 2, 5.5, 8, {0, 0, 0});
  const int grey = FigureToImage(figure, 1).At(5, 5)[0];
  EXPECT_GT(grey, 100);
  EXPECT_LT(grey, 155);
}

TEST(ImageTest, ALineEndsWhereItEnds) {
  Figure figure = Blank();
  figure.Line({2, 5}, {8, 5}, kInk, 2);
  io::Image image = FigureToImage(figure, 1);
  EXPECT_EQ(image.At(2, 4), kInk);
  EXPECT_EQ(image.At(7, 5), kInk);
  EXPECT_EQ(image.At(1, 4), kPaper);
  EXPECT_EQ(image.At(8, 5), kPaper);
  EXPECT_EQ(image.At(5, 3), kPaper);
}

TEST(ImageTest, ALineOfNoLengthDrawsNothing) {
  Figure figure = Blank();
  figure.Line({5, 5}, {5, 5}, kInk, 2);
  io::Image image = FigureToImage(figure, 1);
  EXPECT_EQ(image.At(5, 5), kPaper);
}

TEST(ImageTest, ScalesWithTheFigure) {
  Figure figure = Blank();
  figure.Dot({5, 5}, 2, kGreen);
  io::Image image = FigureToImage(figure, 3);
  EXPECT_EQ(image.width, 30);
  EXPECT_EQ(image.At(15, 15), kGreen);
  EXPECT_EQ(image.At(15, 22), kPaper);
}

TEST(ImageTest, ShapesBeyondTheBorderAreCut) {
  Figure figure = Blank();
  figure.Rectangle(-50, -50, 50, 50, kBlue);
  figure.Dot({-3, 5}, 5, kInk);
  figure.Text({8, 20}, "beyond", kInk, 10);
  io::Image image = FigureToImage(figure, 1);
  EXPECT_EQ(image.At(9, 0), kBlue);
  EXPECT_EQ(image.At(0, 5), kInk);
}

TEST(LettersTest, EveryPrintableCharacterLooksDifferent) {
  std::set<std::string> shapes;
  for (char c = ' '; c <= '~'; ++c) {
    std::string shape;
    for (int row = 0; row < kLetterHeight; ++row) {
      for (int column = 0; column < kLetterWidth; ++column) {
        shape += IsInk(c, column, row) ? '#' : '.';
      }
    }
    EXPECT_TRUE(shapes.insert(shape).second) << c;
  }
}

TEST(LettersTest, AnythingElseLooksLikeAQuestionMark) {
  for (const char c : {'\xc3', '\x07', '\x7f'}) {
    for (int row = 0; row < kLetterHeight; ++row) {
      EXPECT_EQ(IsInk(c, 2, row), IsInk('?', 2, row));
    }
  }
}

}  // namespace
}  // namespace rasterproof::report
