#include "report/drawing.h"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

#include "pugixml.hpp"
#include "report/letters.h"

namespace rasterproof::report {
namespace {

Drawing Blank() {
  Drawing drawing;
  drawing.width = 10;
  drawing.height = 10;
  return drawing;
}

TEST(SvgTest, IsWellFormedAndNeedsNothingFromOutside) {
  Drawing drawing = Blank();
  drawing.Rectangle(1, 1, 4, 4, kBlue);
  drawing.Line({0, 0}, {9, 9}, kInk, 1.5);
  drawing.Dot({5, 5}, 2, kVermilion);
  drawing.Text({0, 9}, "a <b> & \"c\"", kInk, 10);
  const std::string svg = DrawingToSvg(drawing);
  pugi::xml_document document;
  ASSERT_TRUE(document.load_string(svg.c_str())) << svg;
  const pugi::xml_node root = document.child("svg");
  EXPECT_STREQ(root.attribute("viewBox").value(), "0 0 10 10");
  EXPECT_STREQ(root.child("text").text().get(), "a <b> & \"c\"");
  EXPECT_EQ(svg.find("href"), std::string::npos);
}

TEST(ImageTest, FillsAPolygonOfEitherOrientationAndNothingElse) {
  for (const bool reversed : {false, true}) {
    Drawing drawing = Blank();
    std::vector<Point2> outline{{2, 2}, {8, 2}, {8, 8}, {2, 8}};
    if (reversed) outline = {outline.rbegin(), outline.rend()};
    drawing.Polygon(outline, kBlue);
    io::Image image = DrawingToImage(drawing, 1);
    EXPECT_EQ(image.At(2, 2), kBlue);
    EXPECT_EQ(image.At(7, 7), kBlue);
    EXPECT_EQ(image.At(1, 5), kPaper);
    EXPECT_EQ(image.At(8, 5), kPaper);
  }
}

TEST(ImageTest, SmoothsAnEdgeThatCrossesAPixel) {
  Drawing drawing = Blank();
  drawing.Rectangle(2, 2, 5.5, 8, {0, 0, 0});
  const int grey = DrawingToImage(drawing, 1).At(5, 5)[0];
  EXPECT_GT(grey, 100);
  EXPECT_LT(grey, 155);
}

TEST(ImageTest, ALineEndsWhereItEnds) {
  Drawing drawing = Blank();
  drawing.Line({2, 5}, {8, 5}, kInk, 2);
  io::Image image = DrawingToImage(drawing, 1);
  EXPECT_EQ(image.At(2, 4), kInk);
  EXPECT_EQ(image.At(7, 5), kInk);
  EXPECT_EQ(image.At(1, 4), kPaper);
  EXPECT_EQ(image.At(8, 5), kPaper);
  EXPECT_EQ(image.At(5, 3), kPaper);
}

TEST(ImageTest, ALineOfNoLengthDrawsNothing) {
  Drawing drawing = Blank();
  drawing.Line({5, 5}, {5, 5}, kInk, 2);
  io::Image image = DrawingToImage(drawing, 1);
  EXPECT_EQ(image.At(5, 5), kPaper);
}

TEST(ImageTest, ScalesWithTheDrawing) {
  Drawing drawing = Blank();
  drawing.Dot({5, 5}, 2, kGreen);
  io::Image image = DrawingToImage(drawing, 3);
  EXPECT_EQ(image.width, 30);
  EXPECT_EQ(image.At(15, 15), kGreen);
  EXPECT_EQ(image.At(15, 22), kPaper);
}

TEST(ImageTest, ShapesBeyondTheBorderAreCut) {
  Drawing drawing = Blank();
  drawing.Rectangle(-50, -50, 50, 50, kBlue);
  drawing.Dot({-3, 5}, 5, kInk);
  drawing.Text({8, 20}, "beyond", kInk, 10);
  io::Image image = DrawingToImage(drawing, 1);
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
