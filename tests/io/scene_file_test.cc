#include "io/scene_file.h"

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>

#include "gtest/gtest.h"

namespace rasterproof::io {
namespace {

// The format has one NaN: sign and payload are not part of a scene.
std::uint64_t Bits(double x) {
  return std::bit_cast<std::uint64_t>(std::isnan(x) ? std::numeric_limits<double>::quiet_NaN() : x);
}

void ExpectSameBits(const Scene& a, const Scene& b) {
  EXPECT_EQ(a.name, b.name);
  EXPECT_EQ(a.width, b.width);
  EXPECT_EQ(a.height, b.height);
  EXPECT_EQ(a.precision, b.precision);
  EXPECT_EQ(a.clip_space, b.clip_space);
  EXPECT_EQ(a.triangles, b.triangles);
  ASSERT_EQ(a.vertices.size(), b.vertices.size());
  for (std::size_t k = 0; k < a.vertices.size(); ++k) {
    const Vertex& v = a.vertices[k];
    const Vertex& w = b.vertices[k];
    ASSERT_EQ(Bits(v.x), Bits(w.x)) << k;
    ASSERT_EQ(Bits(v.y), Bits(w.y)) << k;
    ASSERT_EQ(Bits(v.z), Bits(w.z)) << k;
    ASSERT_EQ(Bits(v.w), Bits(w.w)) << k;
  }
}

double RandomCoordinate(std::mt19937_64& random, Precision precision) {
  const std::uint64_t bits = random();
  return precision == Precision::kFloat32 ? std::bit_cast<float>(static_cast<std::uint32_t>(bits))
                                          : std::bit_cast<double>(bits);
}

TEST(SceneFileTest, WhatIsWrittenReadsBackBitForBit) {
  std::mt19937_64 random(1);
  for (int k = 0; k < 300; ++k) {
    Scene scene;
    scene.name = "random \"" + std::to_string(k) + "\"\n\xC3\xA9";
    scene.width = 1 + static_cast<int>(random() % 4000);
    scene.height = 1 + static_cast<int>(random() % 4000);
    scene.precision = k % 2 == 0 ? Precision::kFloat32 : Precision::kFloat64;
    scene.clip_space = k % 4 < 2;
    for (int v = 0; v < 20; ++v) {
      const auto next = [&] { return RandomCoordinate(random, scene.precision); };
      Vertex vertex{next(), next(), 0, 1};
      if (random() % 2 == 0) vertex.z = random() % 2 == 0 ? -0.0 : next();
      if (scene.clip_space) vertex.w = next();
      scene.vertices.push_back(vertex);
      scene.triangles.push_back({v, static_cast<std::int32_t>(random() % 20) % (v + 1), 0});
    }
    ExpectSameBits(ParseScene(SceneToJson(scene), "written"), scene);
  }
}

TEST(SceneFileTest, ExtremesReadBackBitForBit) {
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    const bool single = precision == Precision::kFloat32;
    const double greatest =
        single ? double{std::numeric_limits<float>::max()} : std::numeric_limits<double>::max();
    const double least = single ? 0x1p-149 : 0x1p-1074;
    Scene scene;
    scene.width = kMaxTargetSide;
    scene.precision = precision;
    for (const double x : {0.0, -0.0, least, -least, greatest, -greatest, HUGE_VAL, -HUGE_VAL,
                           std::numeric_limits<double>::quiet_NaN()}) {
      scene.vertices.push_back({x, -x, 0, 1});
      scene.vertices.push_back({-x, x, x, 1});
    }
    ExpectSameBits(ParseScene(SceneToJson(scene), "written"), scene);
  }
}

TEST(SceneFileTest, ANameIsWrittenWithoutControlCharacters) {
  Scene scene;
  scene.width = scene.height = 1;
  for (const std::string name : {"W\xc3\xbcrfel",
                                 "a\x1b[31m\x7f\xc2\x9b"
                                 "1m"}) {
    scene.name = name;
    const std::string json = SceneToJson(scene);
    EXPECT_EQ(json.find('\x1b'), json.npos);
    EXPECT_EQ(json.find('\x7f'), json.npos);
    EXPECT_EQ(json.find("\xc2\x9b"), json.npos);
    EXPECT_EQ(ParseScene(json, "test").name, name);
  }
}

TEST(SceneFileTest, ASceneWithoutTrianglesIsAScene) {
  const Scene empty;
  ExpectSameBits(ParseScene(SceneToJson(empty), "written"), empty);
}

TEST(SceneFileTest, KeysComeInAnyOrderAndNameAndPrecisionMayBeLeftOut) {
  const Scene scene = ParseScene(
      R"({"triangles": [[0, 1, 2]], "vertices": [[0, 1], [2.5, -0, 3], ["nan", 1e-60]],
          "height": 3, "width": 4, "rasterproof_scene": 1})",
      "text");
  EXPECT_EQ(scene.width, 4);
  EXPECT_EQ(scene.height, 3);
  EXPECT_EQ(scene.precision, Precision::kFloat32);
  EXPECT_FALSE(scene.clip_space);
  EXPECT_EQ(scene.vertices[1], (Vertex{2.5, -0.0, 3, 1}));
  EXPECT_TRUE(std::signbit(scene.vertices[1].y));
  EXPECT_TRUE(std::isnan(scene.vertices[2].x));
  EXPECT_EQ(Bits(scene.vertices[2].y), Bits(0.0));
}

TEST(SceneFileTest, PrecisionAfterTheVerticesStillDecidesTheirRounding) {
  const char* const text = R"({"rasterproof_scene": 1, "width": 1, "height": 1,
      "vertices": [[0.1, 1e300]], "triangles": [], "precision": "float64"})";
  const Scene scene = ParseScene(text, "text");
  EXPECT_EQ(scene.vertices[0].x, 0.1);
  EXPECT_EQ(scene.vertices[0].y, 1e300);
}

TEST(SceneFileTest, NumbersAreRoundedOnceFromTheirText) {
  const Scene scene = ParseScene(R"({"rasterproof_scene": 1, "width": 1, "height": 1,
      "vertices": [[1.00000005960464477539062500000000001, 9007199791611905],
                   [18446744073709551617, -9223372036854775809]], "triangles": []})",
                                 "text");
  EXPECT_EQ(scene.vertices[0].x, 1 + 0x1p-23);
  EXPECT_EQ(scene.vertices[0].y, 0x1.000002p53);
  EXPECT_EQ(scene.vertices[1].x, 0x1p64);
  EXPECT_EQ(scene.vertices[1].y, -0x1p63);
}

TEST(SceneFileTest, FourCoordinatesAreClipSpace) {
  const Scene scene = ParseScene(R"({"rasterproof_scene": 1, "width": 1, "height": 1,
      "vertices": [[1, 2, 3, -4], [1, 2, 3, "-0x0p0"]], "triangles": []})",
                                 "text");
  EXPECT_TRUE(scene.clip_space);
  EXPECT_EQ(scene.vertices[0], (Vertex{1, 2, 3, -4}));
  EXPECT_TRUE(std::signbit(scene.vertices[1].w));
}

}  // namespace
}  // namespace rasterproof::io
