#include "io/image.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

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

TEST(ImageTest, AtIsRowMajorFromTheTop) {
  Image image(3, 2, {0, 0, 0});
  image.At(2, 1) = {9, 8, 7};
  EXPECT_EQ(image.pixels.back(), (std::array<std::uint8_t, 3>{9, 8, 7}));
}

}  // namespace
}  // namespace rasterproof::io
