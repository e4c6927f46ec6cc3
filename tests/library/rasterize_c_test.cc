// The interface in C: from C99, from C++11, and what it refuses.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

#include "library/rasterproof_rasterize.h"
#include "tests/library/rasterize_languages.h"

namespace rasterproof {
namespace {

TEST(RasterizeInC, DoesFromC99WhatItSays) { EXPECT_EQ(rasterproof_calls_of_c99(), 0); }
TEST(RasterizeInC, DoesFromCxx11WhatItSays) { EXPECT_EQ(rasterproof_calls_of_cxx11(), 0); }

struct BadCallInC {
  std::string message;
  std::function<void(rasterproof_raster_mesh&, rasterproof_raster_target&)> spoil;
};

constexpr std::array<float, 9> kPositions{-9, -9, 0, 90, 0, 0, 0, 90, 0};
constexpr std::array<std::uint32_t, 3> kIndices{0, 1, 2};
constexpr rasterproof_raster_mesh kMesh{kPositions.data(), 3, kIndices.data(), 1,
                                        RASTERPROOF_RASTER_WINDOW};

TEST(RasterizeInC, RefusesBadInputByNameAndDrawsNothing) {
  const std::vector<BadCallInC> bad_calls{
      {"mesh.positions: null", [](auto& mesh, auto&) { mesh.positions = nullptr; }},
      {"mesh.vertex_count: too many", [](auto& mesh, auto&) { mesh.vertex_count = SIZE_MAX / 2; }},
      {"mesh.indices: null", [](auto& mesh, auto&) { mesh.indices = nullptr; }},
      {"mesh.triangle_count: too", [](auto& mesh, auto&) { mesh.triangle_count = SIZE_MAX / 3; }},
      {"mesh.indices[0]: 0, and", [](auto& mesh, auto&) { mesh.vertex_count = 0; }},
      {"target.output: there is no", [](auto&, auto& target) { target.output = 8; }},
      {"target.output: there is no",  // 258 is no byte
       [](auto&, auto& target) { target.output = 258; }},
      {"target.width: -5 pixels", [](auto&, auto& target) { target.width = -5; }},
      {"target.memory: null", [](auto&, auto& target) { target.memory = nullptr; }},
      {"target.back: null", [](auto&, auto& target) { target.back_size = 8; }},
  };
  std::array<std::uint8_t, 32> memory{};
  for (const BadCallInC& bad : bad_calls) {
    rasterproof_raster_mesh mesh = kMesh;
    rasterproof_raster_target target{
        RASTERPROOF_RASTER_COUNTS, 8, 4, 8, memory.data(), 32, nullptr, 0};
    bad.spoil(mesh, target);
    EXPECT_EQ(rasterproof_rasterize(&mesh, &target, RASTERPROOF_RASTER_BEST),
              RASTERPROOF_RASTER_BAD_ARGUMENT);
    EXPECT_EQ(std::string(rasterproof_raster_message()).substr(0, bad.message.size()), bad.message);
    EXPECT_EQ(memory, (std::array<std::uint8_t, 32>{})) << bad.message;
  }
}

TEST(RasterizeInC, RefusesNullsAndUnknownSets) {
  std::array<std::uint8_t, 32> memory{};
  const rasterproof_raster_target target{
      RASTERPROOF_RASTER_COUNTS, 8, 4, 8, memory.data(), 32, nullptr, 0};
  const auto message = [] { return std::string(rasterproof_raster_message()); };
  EXPECT_EQ(rasterproof_rasterize(nullptr, &target, RASTERPROOF_RASTER_BEST),
            RASTERPROOF_RASTER_BAD_ARGUMENT);
  EXPECT_EQ(message(), "mesh: null; give one");
  EXPECT_EQ(rasterproof_rasterize(&kMesh, nullptr, RASTERPROOF_RASTER_BEST),
            RASTERPROOF_RASTER_BAD_ARGUMENT);
  EXPECT_EQ(message(), "target: null; give one");
  EXPECT_EQ(rasterproof_raster_clear(nullptr), RASTERPROOF_RASTER_BAD_ARGUMENT);
  EXPECT_EQ(rasterproof_rasterize_spans(&kMesh, 8, 4, nullptr, nullptr, RASTERPROOF_RASTER_BEST),
            RASTERPROOF_RASTER_BAD_ARGUMENT);
  EXPECT_EQ(message(), "on_span: null; give a function to call");
  constexpr std::uint32_t kNoSet = 9;
  EXPECT_EQ(rasterproof_raster_is_supported(kNoSet), 0);
  EXPECT_EQ(rasterproof_rasterize(&kMesh, &target, kNoSet), RASTERPROOF_RASTER_BAD_ARGUMENT);
  EXPECT_EQ(message(), "set: there is no such set; give one of rasterproof_raster_set");
  EXPECT_EQ(memory, (std::array<std::uint8_t, 32>{}));
}

TEST(RasterizeInC, ExceptionsOfACallbackEndInAStatus) {
  const auto status_of = [](rasterproof_raster_on_span on_span) {
    return rasterproof_rasterize_spans(&kMesh, 8, 4, on_span, nullptr, RASTERPROOF_RASTER_BEST);
  };
  EXPECT_EQ(status_of([](void*, const rasterproof_raster_span*) -> std::int32_t {
              throw std::domain_error(std::string(1000, 'x'));
            }),
            RASTERPROOF_RASTER_FAULT);
  EXPECT_EQ(std::string(rasterproof_raster_message()), std::string(255, 'x'));
  EXPECT_EQ(status_of([](void*, const rasterproof_raster_span*) -> std::int32_t { throw 1; }),
            RASTERPROOF_RASTER_FAULT);
}

}  // namespace
}  // namespace rasterproof
