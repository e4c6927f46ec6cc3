// What subjects that interpolate in a shader share: which numbers a pass gets, and where its texels
// go. The shader is a count.
#include "subjects/shaded/shaded.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "kit/rasterproof_plugin.h"

namespace rasterproof::subjects {
namespace {

constexpr std::size_t kColumns = 2;
constexpr std::size_t kPixels = 4;
constexpr std::size_t kStride = 3;
constexpr std::size_t kChannels = 6;

// A triangle of a scene with channels 0 to 5, whose numbers are 10 c + vertex.
class Shaded : public testing::Test {
 protected:
  Shaded() {
    for (std::size_t c = 0; c < kChannels; ++c) {
      for (std::size_t v = 0; v < 3; ++v) numbers_[c][v] = static_cast<double>(10 * c + v);
      channels_[c] = {"c", static_cast<std::int32_t>(c % 3), RASTERPROOF_AT_SAMPLE,
                      numbers_[c].data()};
    }
    scene_.width = scene_.height = static_cast<std::int32_t>(kColumns);
    scene_.vertices = vertices_.data();
    scene_.vertex_count = 3;
    scene_.triangles = triangle_.data();
    scene_.triangle_count = 1;
    scene_.channels = channels_.data();
    scene_.channel_count = kChannels;
    target_.samples = 1;
    target_.stride = kStride;
    target_.primitive_ids = ids_.data();
    target_.values = values_.data();
    target_.derivatives = derivatives_.data();
  }

  std::int32_t Draw() {
    return DrawInPasses(scene_, target_, 64, 1, corners_, [&](const PassKinds& kinds) {
      kinds_.push_back(kinds);
      numbers_given_.push_back(corners_[kCornerFloats + 4]);  // the first, of the second corner
      texels_.assign(4 * kShaderOutputs * kPixels, 0);
      for (std::size_t k = 0; k < texels_.size(); ++k)
        texels_[k] = static_cast<float>(1000 * kinds_.size() + k);
      for (std::size_t n = 0; n < kPixels; ++n) texels_[4 * n] = n == 3 ? 1 : 0;
      return texels_.data();
    });
  }

  static double Texel(std::size_t pass, ShaderOutput output, std::size_t n, std::size_t c) {
    return static_cast<double>(1000 * pass + 4 * (output * kPixels + n) + c);
  }

  std::vector<double> vertices_{0, 0, 0.5, 1, 2, 0, 0.5, 1, 0, 2, 0.5, 1};
  std::vector<std::int32_t> triangle_{2, 1, 0};
  std::array<std::array<double, 3>, kChannels> numbers_{};
  std::array<rasterproof_channel, kChannels> channels_{};
  rasterproof_scene scene_{};
  rasterproof_target target_{};
  std::array<std::int32_t, 2 * kStride> ids_{};
  std::array<double, 2 * kStride * kChannels> values_{};
  std::array<double, 4 * kStride * kChannels> derivatives_{};
  std::vector<float> corners_;
  std::vector<float> texels_;
  std::vector<PassKinds> kinds_;
  std::vector<float> numbers_given_;
};

TEST_F(Shaded, PassesOfFourChannelsFillTheTarget) {
  ASSERT_EQ(Draw(), 0);
  EXPECT_EQ(kinds_, (std::vector<PassKinds>{{0, 1, 2, 0}, {1, 2, 0, 0}}));
  EXPECT_EQ(numbers_given_, (std::vector<float>{1, 41}));
  for (std::size_t n = 0; n < kPixels; ++n) {
    const std::size_t at = n / kColumns * kStride + n % kColumns;
    EXPECT_EQ(ids_[at], n == 3 ? 0 : -1);
    for (std::size_t c = 0; c < kChannels; ++c) {
      const std::size_t k = kChannels * at + c;
      EXPECT_EQ(values_[k], Texel(1 + c / 4, kValue, n, c % 4));
      EXPECT_EQ(derivatives_[2 * k], Texel(1 + c / 4, kByX, n, c % 4));
      EXPECT_EQ(derivatives_[2 * k + 1], Texel(1 + c / 4, kByY, n, c % 4));
    }
  }
}

TEST_F(Shaded, APassSaysWhereEachNumberIsEvaluated) {
  channels_[1].at = RASTERPROOF_AT_CENTROID;
  channels_[3].at = RASTERPROOF_AT_CENTRE;
  ASSERT_EQ(Draw(), 0);
  EXPECT_EQ(kinds_[0],
            (PassKinds{0, 1 + 4 * RASTERPROOF_AT_CENTROID, 2, 4 * RASTERPROOF_AT_CENTRE}));
}

TEST_F(Shaded, ASceneWithoutChannelsTakesOnePass) {
  target_.values = target_.derivatives = nullptr;
  ASSERT_EQ(Draw(), 0);
  EXPECT_EQ(kinds_.size(), 1U);
}

TEST_F(Shaded, WhatTheDriverWouldClipOrRoundIsRefused) {
  vertices_[0] = 64.5;
  EXPECT_EQ(Draw(), 1);
  vertices_[0] = 0x1p-145 + 0x1p-149;  // over 64 it is no float
  EXPECT_EQ(Draw(), 1);
  vertices_[0] = 0;
  scene_.width = 65;
  EXPECT_EQ(Draw(), 1);
  scene_.width = 2;
  target_.samples = 4;
  EXPECT_EQ(Draw(), 1);
  EXPECT_TRUE(kinds_.empty());
}

}  // namespace
}  // namespace rasterproof::subjects
