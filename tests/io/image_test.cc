#include "io/image.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "core/error.h"
#include "gtest/gtest.h"

namespace rasterproof::io {
namespace {

TEST(ImageTest, WhatIsEncodedDecodesToTheSamePixels) {
  std::mt19937 random(3);
  for (const auto& [width, height] : {std::array{1, 1}, std::array{7, 3}, std::array{130, 65}}) {
    Image image(width, height);
    for (auto& pixel : image.pixels) {
      for (auto& channel : pixel) channel = static_cast<std::uint8_t>(random());
    }
    const std::string bytes = EncodePng(image);
    png_image header{};
    header.version = PNG_IMAGE_VERSION;
    ASSERT_NE(png_image_begin_read_from_memory(&header, bytes.data(), bytes.size()), 0);
    ASSERT_EQ(header.width, static_cast<unsigned>(width));
    ASSERT_EQ(header.height, static_cast<unsigned>(height));
    header.format = PNG_FORMAT_RGB;
    std::vector<std::array<std::uint8_t, 3>> pixels(image.pixels.size());
    ASSERT_NE(png_image_finish_read(&header, nullptr, pixels.data(), 0, nullptr), 0);
    EXPECT_EQ(pixels, image.pixels);
  }
}

TEST(ImageTest, AnImageOfFewColoursDecodesToThem) {
  constexpr int kSide = 64;
  const std::array<std::array<std::uint8_t, 3>, 3> colours{{{1, 2, 3}, {250, 0, 9}, {7, 77, 177}}};
  std::mt19937 random(4);
  std::vector<std::uint8_t> indices(kSide * kSide);
  for (auto& index : indices) index = static_cast<std::uint8_t>(random() % 3);
  const std::string bytes = EncodePalettePng(kSide, kSide, indices, colours);
  EXPECT_LT(bytes.size(), std::size_t{kSide} * kSide / 2);
  const Image image = DecodePng(bytes, "few.png", kSide, kSide);
  for (std::size_t k = 0; k < indices.size(); ++k) {
    ASSERT_EQ(image.pixels[k], colours[indices[k]]) << k;
  }
}

TEST(ImageTest, AtIsRowMajorFromTheTop) {
  Image image(3, 2, {0, 0, 0});
  image.At(2, 1) = {9, 8, 7};
  EXPECT_EQ(image.pixels.back(), (std::array<std::uint8_t, 3>{9, 8, 7}));
}

// 59 bytes whose header says 65000 x 65000 pixels: 12 GiB, if they were made.
TEST(ImageTest, APictureOfAnotherSizeIsRefusedByItsHeader) {
  std::string bytes = EncodePng(Image(1, 1));
  ASSERT_EQ(bytes.substr(12, 4), "IHDR");
  bytes.replace(16, 17, std::string("\0\0\xfd\xe8\0\0\xfd\xe8\x08\x02\0\0\0\x2d\x35\x4e\x5d", 17));
  try {
    DecodePng(bytes, "seen.png", 4, 4);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "seen.png: the picture has 65000 x 65000 pixels, the target 4 x 4; give a picture "
                 "of the scene's target");
  }
}

}  // namespace
}  // namespace rasterproof::io
