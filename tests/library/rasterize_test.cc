// Exact coverage as a library: every output into every kind of memory, against the oracle; spans;
// what is refused; the same in C.
#include "library/rasterize.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/error.h"
#include "library/kernels/kernel.h"
#include "tests/library/kernel_definitions.h"
#include "tests/library/owned_mesh.h"
#include "tests/library/rasterize_languages.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

namespace kernels = library::kernels;

constexpr std::array kOutputs{RasterOutput::kCounts, RasterOutput::kFacingCounts,
                              RasterOutput::kMask, RasterOutput::kIds, RasterOutput::kDepths};
constexpr std::array kSets{InstructionSet::kBest, InstructionSet::kScalar, InstructionSet::kSse4,
                           InstructionSet::kAvx2, InstructionSet::kAvx512, InstructionSet::kNeon};

using Given = OwnedMesh;

// Triangles of all sizes: on half pixels, anywhere, beside the target, of any exponent.
Given RandomMesh(std::uint64_t seed, int width, int height, int triangles) {
  Given given{.name = std::to_string(width) + "x" + std::to_string(height),
              .width = width,
              .height = height};
  reference::RandomValues random(seed);
  const auto coordinate = [&](int kind, float from, int size) {
    if (kind == 0) return static_cast<float>(random.Integer(0, 2 * size)) * 0.5F;
    if (kind == 1) return from + static_cast<float>(random.Uniform(-5, 5));
    if (kind == 2) return static_cast<float>(random.Uniform(-0.5 * size, 1.5 * size));
    if (kind == 3) return static_cast<float>(random.Uniform(-40 * size, 40 * size));
    return random.LogUniform<float>(-140, 127);
  };
  for (int i = 0; i < triangles; ++i) {
    const int kind = random.Integer(0, 4);
    const auto x = static_cast<float>(random.Uniform(0, width));
    const auto y = static_cast<float>(random.Uniform(0, height));
    for (int k = 0; k < 3; ++k) {
      const float vx = coordinate(kind, x, width);
      const float vy = coordinate(kind, y, height);
      given.AddCorner(vx, vy, static_cast<float>(random.Uniform(-1, 1)));
    }
  }
  return given;
}

Given NonFiniteMesh() {
  Given given{.name = "non-finite", .width = 9, .height = 5};
  for (const float bad : {NAN, std::numeric_limits<float>::infinity()}) {
    given.AddCorner(0, 0, 0);
    given.AddCorner(bad, 0, 0);
    given.AddCorner(0, 90, 0);
  }
  return given;
}

std::vector<Given> Meshes() {
  Given deep{.name = "more layers than a byte counts", .width = 12, .height = 20};
  for (int i = 0; i < 300; ++i) {
    deep.AddCorner(-1, -1, 0.5F);
    deep.AddCorner(30, 10, 0.25F);
    deep.AddCorner(-1, 21, 0.75F);
  }
  return {RandomMesh(1, 1, 1, Cases(100)),
          RandomMesh(2, 67, 35, Cases(150)),
          RandomMesh(3, 200, 9, Cases(80)),
          RandomMesh(4, 5, 90, Cases(100)),
          RandomMesh(5, 131, 40, Cases(60)),
          NonFiniteMesh(),
          std::move(deep),
          Given{.name = "empty", .width = 3, .height = 2}};
}

std::size_t RowBytes(RasterOutput output, int width) {
  const auto pixels = static_cast<std::size_t>(width);
  if (output == RasterOutput::kMask) return (pixels + 7) / 8;
  return output == RasterOutput::kCounts ? pixels : 4 * pixels;
}

// The memory's layout: nothing but the rows, wide rows, room after the rows and between them.
enum class Layout : std::uint8_t { kTight, kPadded, kRoomy };

constexpr std::byte kGuard{0xa5};

// Planes of a target, full of kGuard where there is no pixel.
class Memory {
 public:
  Memory(RasterOutput output, int width, int height, Layout layout) {
    const std::size_t row = RowBytes(output, width);
    target.output = output;
    target.width = width;
    target.height = height;
    target.pitch = layout == Layout::kTight ? row : row + 12;
    std::size_t bytes = static_cast<std::size_t>(height - 1) * target.pitch + row;
    if (layout == Layout::kRoomy) bytes = RoomFor(target);
    for (std::vector<std::byte>& plane : planes_) plane.assign(bytes, kGuard);
    target.memory = planes_[0];
    if (output == RasterOutput::kFacingCounts) target.back = planes_[1];
    Clear(target);
  }
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;

  /// As kernels::Surface::At gives it.
  std::uint64_t At(int x, int y) const {
    const std::size_t row = static_cast<std::size_t>(y) * target.pitch;
    const auto column = static_cast<std::size_t>(x);
    if (target.output == RasterOutput::kCounts) {
      return std::to_integer<std::uint64_t>(planes_[0][row + column]);
    }
    if (target.output == RasterOutput::kMask) {
      return std::to_integer<std::uint64_t>(planes_[0][row + column / 8] >> (x % 8)) & 1;
    }
    const std::uint64_t value = Word(planes_[0], row + 4 * column);
    return target.output == RasterOutput::kFacingCounts
               ? value | Word(planes_[1], row + 4 * column) << 32
               : value;
  }

  bool IsGuarded() const {
    const std::size_t row = RowBytes(target.output, target.width);
    for (const std::vector<std::byte>& plane : planes_) {
      for (std::size_t k = 0; k < plane.size(); ++k) {
        const bool is_pixel =
            k / target.pitch < static_cast<std::size_t>(target.height) && k % target.pitch < row;
        if (!is_pixel && plane[k] != kGuard) return false;
      }
    }
    return true;
  }

  RasterTarget target;

 private:
  static std::uint64_t Word(const std::vector<std::byte>& plane, std::size_t at) {
    std::uint32_t value = 0;
    std::memcpy(&value, plane.data() + at, sizeof value);
    return value;
  }
  std::array<std::vector<std::byte>, 2> planes_;
};

std::vector<std::uint64_t> Expected(const Given& given, RasterOutput output) {
  std::vector<kernels::KernelVertex> vertices;
  for (std::size_t k = 0; k < given.positions.size(); k += 3) {
    vertices.push_back({given.positions[k], given.positions[k + 1], given.positions[k + 2]});
  }
  return kernels::DefineSurface(kernels::kSinks[static_cast<std::size_t>(output)],
                                {vertices, given.indices, given.width, given.height},
                                [&](const kernels::KernelTriangle& t) {
                                  return kernels::definitions::Exact(t, given.width, given.height);
                                });
}

// The first pixel that differs, in words; empty if none does.
std::string FirstDifference(const Memory& memory, const std::vector<std::uint64_t>& expected) {
  const RasterTarget& target = memory.target;
  for (int y = 0; y < target.height; ++y) {
    for (int x = 0; x < target.width; ++x) {
      const std::uint64_t wanted = expected[static_cast<std::size_t>(y * target.width + x)];
      if (memory.At(x, y) == wanted) continue;
      return "pixel " + std::to_string(x) + ", " + std::to_string(y) + " is " +
             std::to_string(memory.At(x, y)) + ", not " + std::to_string(wanted);
    }
  }
  return "";
}

TEST(Rasterize, EveryOutputIsTheOraclesInEveryMemory) {
  for (const Given& given : Meshes()) {
    for (const RasterOutput output : kOutputs) {
      const auto expected = Expected(given, output);
      for (const InstructionSet set : kSets) {
        if (!IsSupported(set)) continue;
        for (const Layout layout : {Layout::kTight, Layout::kPadded, Layout::kRoomy}) {
          Memory memory(output, given.width, given.height, layout);
          Rasterize(given.Mesh(), memory.target, set);
          EXPECT_EQ(FirstDifference(memory, expected), "")
              << given.name << ", output " << static_cast<int>(output) << ", set "
              << static_cast<int>(set) << ", layout " << static_cast<int>(layout);
          EXPECT_TRUE(memory.IsGuarded()) << given.name;
        }
      }
    }
  }
}

TEST(Rasterize, MemoryKeepsWhatWasDrawnBefore) {
  const Given given = RandomMesh(6, 40, 30, 60);
  const RasterMesh mesh = given.Mesh();
  for (const RasterOutput output : kOutputs) {
    if (output == RasterOutput::kIds) continue;  // of each call's own triangles
    const auto expected = Expected(given, output);
    Memory memory(output, given.width, given.height, Layout::kTight);
    Rasterize({mesh.positions, mesh.indices.first(60)}, memory.target);
    Rasterize({mesh.positions, mesh.indices.subspan(60)}, memory.target);
    EXPECT_EQ(FirstDifference(memory, expected), "") << static_cast<int>(output);
  }
}

// A triangle on each pixel from a column on.
Given PixelsFrom(int first) {
  Given given{.name = "pixels", .width = 150, .height = 12};
  for (int y = 0; y < given.height; ++y) {
    for (int x = first; x < given.width; ++x) {
      const auto left = static_cast<float>(x);
      const auto top = static_cast<float>(y);
      given.AddCorner(left, top, 0);
      given.AddCorner(left + 1, top, 0);
      given.AddCorner(left + 0.5F, top + 1, 0);
    }
  }
  return given;
}

// All pixels in the least memory, and in memory of all sizes those that end each row, whose writes
// reach farthest: AddressSanitizer watches.
TEST(Rasterize, StaysInMemoryOfAnySize) {
  const Given all = PixelsFrom(0);
  const Given last = PixelsFrom(142);
  for (const InstructionSet set : kSets) {
    if (!IsSupported(set)) continue;
    for (const std::size_t width : {150U, 200U}) {  // the pitch; at 150 there is no room in rows
      RasterTarget target{RasterOutput::kCounts, all.width, all.height, width, {}, {}};
      const std::size_t least = 11 * width + 150;
      for (std::size_t bytes = least; bytes <= RoomFor(target); bytes += 2) {
        std::vector<std::byte> memory(bytes);
        target.memory = memory;
        Rasterize((bytes == least ? all : last).Mesh(), target, set);
        for (std::size_t y = 0; y < 12; ++y) {
          const auto row = target.memory.subspan(y * width, 150);
          ASSERT_EQ(std::ranges::count(row, std::byte{1}), bytes == least ? 150 : 8)
              << bytes << " bytes, row " << y;
        }
      }
    }
  }
}

TEST(Rasterize, SpansAddUpToTheCountsInOrder) {
  for (const Given& given : Meshes()) {
    const auto expected = Expected(given, RasterOutput::kFacingCounts);
    for (const InstructionSet set : kSets) {
      if (!IsSupported(set)) continue;
      std::vector<std::uint64_t> counts(expected.size());
      std::int64_t last = -1;  // triangle and row of the span before
      bool is_in_order = true;
      const auto add = [&](const RasterSpan& span) {
        ASSERT_TRUE(0 <= span.x0 && span.x0 < span.x1 && span.x1 <= given.width);
        ASSERT_TRUE(0 <= span.y && span.y < given.height);
        const std::int64_t now = std::int64_t{span.triangle} * 65536 + span.y;
        is_in_order &= now > last;
        last = now;
        for (int x = span.x0; x < span.x1; ++x) {
          counts[static_cast<std::size_t>(span.y * given.width + x)] +=
              span.is_front ? 1 : std::uint64_t{1} << 32;
        }
      };
      Rasterize(given.Mesh(), given.width, given.height, add, set);
      EXPECT_EQ(counts, expected) << given.name << ", set " << static_cast<int>(set);
      EXPECT_TRUE(is_in_order) << given.name << ", set " << static_cast<int>(set);
    }
  }
}

TEST(Rasterize, WhatACallbackThrowsPassesThrough) {
  const Given given = RandomMesh(7, 40, 30, 20);
  int calls = 0;
  const auto stop_at_third = [&](const RasterSpan&) {
    if (++calls == 3) throw std::domain_error("enough");
  };
  for (const InstructionSet set : kSets) {
    if (!IsSupported(set)) continue;
    calls = 0;
    EXPECT_THROW(Rasterize(given.Mesh(), 40, 30, stop_at_third, set), std::domain_error);
    EXPECT_EQ(calls, 3);
  }
}

// What a call is refused with; "" if it is not.
std::string Refusal(const std::function<void()>& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

struct BadCall {
  std::string message;  // its beginning, up to the remedy
  std::function<void(RasterMesh&, RasterTarget&)> spoil;
};

// The same from an odd address on. Never read.
template <class T>
std::span<const T> OneByteOn(std::span<const T> values) {
  return {std::bit_cast<const T*>(std::bit_cast<std::uintptr_t>(values.data()) + 1), values.size()};
}

std::vector<BadCall> BadCalls() {
  static const std::array<std::uint32_t, 3> beyond{0, 1, 3};
  static std::array<std::byte, 8> none{};
  return {
      {"mesh.positions: null; give",
       [](auto& mesh, auto&) { mesh.positions = {static_cast<const float*>(nullptr), 9}; }},
      {"mesh.positions: 8 of them; give three",
       [](auto& mesh, auto&) { mesh.positions = mesh.positions.first(8); }},
      {"mesh.positions: 536870913 vertices; draw parts",
       [](auto& mesh, auto&) { mesh.positions = {mesh.positions.data(), 3 * 536870913ULL}; }},
      {"mesh.indices: null; give",
       [](auto& mesh, auto&) { mesh.indices = {static_cast<const std::uint32_t*>(nullptr), 3}; }},
      {"mesh.indices: 2 of them; give three",
       [](auto& mesh, auto&) { mesh.indices = mesh.indices.first(2); }},
      {"mesh.indices: 4294967295 triangles; draw parts",
       [](auto& mesh, auto&) { mesh.indices = {mesh.indices.data(), 3 * 4294967295ULL}; }},
      {"mesh.indices[2]: 3, and there are 3 vertices; give",
       [](auto& mesh, auto&) { mesh.indices = beyond; }},
      {"mesh.positions: not aligned; align",
       [](auto& mesh, auto&) { mesh.positions = OneByteOn(mesh.positions); }},
      {"mesh.indices: not aligned; align",
       [](auto& mesh, auto&) { mesh.indices = OneByteOn(mesh.indices); }},
      {"target.memory: it overlaps mesh.positions; give",
       [](auto& mesh, auto& target) {
         mesh.positions = {std::bit_cast<const float*>(&target.memory[124]), 9};
       }},
      {"target.memory: it overlaps mesh.indices; give",
       [](auto& mesh, auto& target) {
         mesh.indices = {std::bit_cast<const std::uint32_t*>(target.memory.data()), 3};
       }},
      {"target.back: it overlaps mesh.indices; give",
       [](auto& mesh, auto& target) {
         target.output = RasterOutput::kFacingCounts;
         target.height = 2;
         target.back = target.memory.subspan(64);
         mesh.indices = {std::bit_cast<const std::uint32_t*>(target.back.data()), 3};
       }},
      {"target.output: there is no such output; give",
       [](auto&, auto& target) { target.output = static_cast<RasterOutput>(8); }},
      {"target.width: 0 pixels; give 1 to 65536", [](auto&, auto& target) { target.width = 0; }},
      {"target.width: 65537 pixels; give 1", [](auto&, auto& target) { target.width = 65537; }},
      {"target.height: -1 pixels; give 1", [](auto&, auto& target) { target.height = -1; }},
      {"target.height: 65537 pixels; give", [](auto&, auto& target) { target.height = 65537; }},
      {"target.pitch: 28 bytes, less than a row's; give at least 32",
       [](auto&, auto& target) { target.pitch = 28; }},
      {"target.pitch: 33 bytes, not a multiple of a pixel's; give a multiple of 4",
       [](auto&, auto& target) { target.pitch = 33; }},
      {"target.memory: null; give", [](auto&, auto& target) { target.memory = {}; }},
      {"target.memory: 127 bytes, less than its rows take; give",
       [](auto&, auto& target) { target.memory = target.memory.first(127); }},
      {"target.memory: 128 bytes, less than its rows take; give",  // a product that overflows
       [](auto&, auto& target) {
         target.height = 5;
         target.pitch = std::size_t{1} << 62;
       }},
      {"target.memory: not aligned; align it to 4 bytes",
       [](auto&, auto& target) {
         target.height = 3;
         target.memory = target.memory.subspan(1);
       }},
      {"target.back: only facing counts have one; leave",
       [](auto&, auto& target) { target.back = none; }},
      {"target.back: null; give",
       [](auto&, auto& target) { target.output = RasterOutput::kFacingCounts; }},
      {"target.back: 8 bytes, less than its rows take; give",
       [](auto&, auto& target) {
         target.output = RasterOutput::kFacingCounts;
         target.back = none;
       }},
      {"target.back: it overlaps target.memory; give",
       [](auto&, auto& target) {
         target.output = RasterOutput::kFacingCounts;
         target.height = 2;
         target.back = target.memory.subspan(60);
       }},
  };
}

TEST(Rasterize, RefusesBadInputByNameAndDrawsNothing) {
  const std::array<float, 9> positions{-9, -9, 0, 90, 0, 0, 0, 90, 0};
  const std::array<std::uint32_t, 3> indices{0, 1, 2};
  std::vector<std::byte> memory(128, kGuard);
  for (const BadCall& bad : BadCalls()) {
    RasterMesh mesh{positions, indices};
    RasterTarget target{RasterOutput::kIds, 8, 4, 32, memory, {}};
    bad.spoil(mesh, target);
    const std::string said = Refusal([&] { Rasterize(mesh, target); });
    EXPECT_EQ(said.substr(0, bad.message.size()), bad.message);
    EXPECT_EQ(std::ranges::count(memory, kGuard), 128) << bad.message;
    // Clear has no mesh to refuse, and spans no target.
    if (bad.message.find("overlaps mesh") != std::string::npos) continue;
    if (bad.message.starts_with("target")) {
      EXPECT_EQ(Refusal([&] { Clear(target); }), said);
    } else {
      EXPECT_EQ(Refusal([&] { Rasterize(mesh, 8, 4, [](const RasterSpan&) { FAIL(); }); }), said);
    }
    EXPECT_EQ(std::ranges::count(memory, kGuard), 128) << bad.message;
  }
}

TEST(Rasterize, RefusesWhatSpansAndSetsCannotBe) {
  const RasterMesh none{};
  const auto on_span = [](const RasterSpan&) {};
  EXPECT_EQ(Refusal([&] { Rasterize(none, 0, 4, on_span); }), "width: 0 pixels; give 1 to 65536");
  EXPECT_EQ(Refusal([&] { Rasterize(none, 4, 65537, on_span); }),
            "height: 65537 pixels; give 1 to 65536");
  EXPECT_EQ(Refusal([&] { Rasterize(none, 4, 4, nullptr); }),
            "on_span: empty; give a function to call");
  constexpr auto kNoSet = static_cast<InstructionSet>(77);
  EXPECT_FALSE(IsSupported(kNoSet));
  EXPECT_EQ(Refusal([&] { Rasterize(none, 4, 4, on_span, kNoSet); }),
            "set: this machine or this build does not run it; give kBest, or ask IsSupported");
  EXPECT_TRUE(IsSupported(InstructionSet::kBest));
  EXPECT_TRUE(IsSupported(InstructionSet::kScalar));
}

}  // namespace
}  // namespace rasterproof
