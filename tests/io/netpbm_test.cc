#include "io/netpbm.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.h"
#include "gtest/gtest.h"

namespace rasterproof::io {
namespace {

std::string Refusal(std::string_view bytes, int width, int height) {
  try {
    DecodeNetpbm(bytes, "seen.pgm", width, height);
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

using Values = std::vector<std::uint16_t>;

TEST(NetpbmTest, TextAndBytesOfOnePictureAreTheSame) {
  const Values expected{0, 1, 2, 255, 7, 9};
  EXPECT_EQ(DecodeNetpbm("P2 3 2 255 0 1 2\n255 7 9\n", "", 3, 2).values, expected);
  EXPECT_EQ(DecodeNetpbm("P2\n# a comment\n3 2\n255\n0 1 2 255 7 9", "", 3, 2).values, expected);
  EXPECT_EQ(DecodeNetpbm(std::string("P5\n3 2\n255\n\0\1\2\xff\7\11", 17), "", 3, 2).values,
            expected);
}

TEST(NetpbmTest, SixteenBitsHaveTheHighByteFirst) {
  const Levels levels = DecodeNetpbm(std::string("P5 2 1 65535 \1\2\0\3", 17), "", 2, 1);
  EXPECT_EQ(levels.values, (Values{0x102, 3}));
  EXPECT_EQ(levels.greatest, 65535U);
}

TEST(NetpbmTest, ColoursComeThreeToAPixel) {
  const Levels levels = DecodeNetpbm("P6 2 1 255\nabcdef", "", 2, 1);
  EXPECT_EQ(levels.channels, 3);
  EXPECT_EQ(levels.values, (Values{'a', 'b', 'c', 'd', 'e', 'f'}));
  EXPECT_EQ(DecodeNetpbm("P3 1 1 9 1 2 3", "", 1, 1).values, (Values{1, 2, 3}));
}

// A pixel whose byte is a blank belongs to the picture, not to the header.
TEST(NetpbmTest, OneBlankPartsHeaderAndPixels) {
  EXPECT_EQ(DecodeNetpbm("P5 2 1 255\n\n ", "", 2, 1).values, (Values{'\n', ' '}));
}

TEST(NetpbmTest, WhatIsEncodedDecodesToTheSameLevels) {
  const std::vector<std::uint32_t> few{0, 255, 10};
  const std::string bytes = EncodePgm(3, 1, few, "out.pgm");
  EXPECT_EQ(bytes.size(), std::string_view("P5\n3 1\n255\n").size() + 3);
  EXPECT_EQ(DecodeNetpbm(bytes, "", 3, 1).values, (Values{0, 255, 10}));
  const std::vector<std::uint32_t> many{0, 256, 65535};
  EXPECT_EQ(DecodeNetpbm(EncodePgm(3, 1, many, "out.pgm"), "", 3, 1).values,
            (Values{0, 256, 65535}));
  EXPECT_THROW(EncodePgm(1, 1, std::array{65536U}, "out.pgm"), InputError);
}

TEST(NetpbmTest, TheEndingNamesTheForm) {
  Image image(1, 1, {7, 7, 7});
  EXPECT_EQ(EncodeFor("a.pgm", image), "P5\n1 1\n255\n\7");
  EXPECT_EQ(EncodeFor("a.ppm", image), "P6\n1 1\n255\n\7\7\7");
  EXPECT_TRUE(EncodeFor("a.png", image).starts_with("\x89PNG"));
  EXPECT_TRUE(EncodeFor("-", image).starts_with("\x89PNG"));
  image.At(0, 0) = {7, 7, 8};
  EXPECT_THROW(EncodeFor("a.pgm", image), InputError);
}

TEST(NetpbmTest, AFaultIsNamedWithItsPlace) {
  EXPECT_NE(Refusal("P4 1 1 x", 1, 1).find("P4"), std::string::npos);
  EXPECT_EQ(Refusal("P5 65000 65000 255 ", 4, 4),
            "seen.pgm: the picture has 65000 x 65000 pixels, the target 4 x 4; give a picture of "
            "the scene's target");
  EXPECT_NE(Refusal("P5 2", 2, 1).find("no height"), std::string::npos);
  EXPECT_NE(Refusal("P5 99999999999 1 255 ", 2, 1).find("no width"), std::string::npos);
  EXPECT_NE(Refusal("P5 2 1 65536 ab", 2, 1).find("65536"), std::string::npos);
  EXPECT_NE(Refusal("P5 2 1 0 ab", 2, 1).find("greatest level is 0"), std::string::npos);
  EXPECT_NE(Refusal("P5 2 1 255 a", 2, 1).find("1 bytes of pixels"), std::string::npos);
  EXPECT_NE(Refusal("P5 2 1 255 abc", 2, 1).find("after the last row"), std::string::npos);
  EXPECT_NE(Refusal("P2 2 1 9 1 10 ", 2, 1).find("column 1 row 0: the level 10"),
            std::string::npos);
  EXPECT_NE(Refusal("P2 2 2 9 1 2 3 x", 2, 2).find("column 1 row 1"), std::string::npos);
  EXPECT_NE(Refusal("P2 2 2 9 1 2 3", 2, 2).find("ends before"), std::string::npos);
}

}  // namespace
}  // namespace rasterproof::io
