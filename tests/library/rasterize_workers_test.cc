// Threads that draw together: bit for bit what one draws, whatever their number and order.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/float_mode.h"
#include "library/rasterize.h"
#include "tests/library/owned_mesh.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

constexpr int kWidth = 150;
constexpr int kHeight = 90;

// Small triangles, far more than a worker takes at a time, every third one in a corner where they
// are more than a byte counts; of few depths, zeros of both signs among them, so that the order of
// equal ones shows.
OwnedMesh ManyTriangles(int count) {
  constexpr std::array kDepths{0.0F, -0.0F, 0.25F, 0.5F};
  OwnedMesh mesh;
  reference::RandomValues random(35);
  for (int t = 0; t < count; ++t) {
    const int part = t % 3 == 0 ? 10 : 1;
    const double x = random.Uniform(-4, kWidth / part + 4);
    const double y = random.Uniform(-4, kHeight / part + 4);
    const float z = kDepths[static_cast<std::size_t>(random.Integer(0, 3))];
    for (int k = 0; k < 3; ++k) {
      const auto vx = static_cast<float>(x + random.Uniform(-6, 6));
      const auto vy = static_cast<float>(y + random.Uniform(-6, 6));
      mesh.AddCorner(vx, vy, z);
    }
  }
  return mesh;
}

using DrawInto = std::function<void(const RasterMesh&, const RasterTarget&)>;

// All bytes of the target's memory, rows apart, onto what an earlier call drew.
std::vector<std::byte> Bytes(const OwnedMesh& mesh, RasterOutput output, const DrawInto& draw,
                             int width = kWidth) {
  const bool is_mask = output >= RasterOutput::kInnerMask ? output != RasterOutput::kInnerDepths
                                                          : output == RasterOutput::kMask;
  const std::size_t pixel = output == RasterOutput::kCounts ? 1 : 4;
  const std::size_t pitch = (is_mask ? static_cast<std::size_t>(width + 7) / 8
                                     : pixel * static_cast<std::size_t>(width)) +
                            8;
  std::vector<std::byte> memory(2 * pitch * kHeight, std::byte{0xa5});
  RasterTarget target{.output = output, .width = width, .height = kHeight, .pitch = pitch};
  target.memory = std::span(memory).first(pitch * kHeight);
  if (output == RasterOutput::kFacingCounts) {
    target.back = std::span(memory).subspan(pitch * kHeight);
  }
  Clear(target);
  Rasterize({mesh.positions, std::span(mesh.indices).first(300)}, target);
  draw(mesh.Mesh(), target);
  return memory;
}

constexpr std::array kAllOutputs{RasterOutput::kCounts,    RasterOutput::kFacingCounts,
                                 RasterOutput::kMask,      RasterOutput::kIds,
                                 RasterOutput::kDepths,    RasterOutput::kInnerMask,
                                 RasterOutput::kOuterMask, RasterOutput::kInnerDepths};

TEST(RasterWorkers, DrawTheSameBitsWhateverTheirNumber) {
  const OwnedMesh mesh = ManyTriangles(25000);
  const auto counts =
      Bytes(mesh, RasterOutput::kCounts, [](const auto& m, const auto& t) { Rasterize(m, t); });
  ASSERT_GT(std::ranges::count(counts, std::byte{255}), 40);
  for (const int count : {1, 2, 3, 7}) {
    RasterWorkers workers(count);
    for (const RasterOutput output : kAllOutputs) {
      if (output >= RasterOutput::kInnerMask && count != 2) continue;
      for (const InstructionSet set : {InstructionSet::kBest, InstructionSet::kScalar}) {
        if (set == InstructionSet::kScalar && Cases(16) == 1) continue;
        const auto one = Bytes(mesh, output, [&](const RasterMesh& m, const RasterTarget& t) {
          Rasterize(m, t, set);
        });
        const auto many = Bytes(mesh, output, [&](const RasterMesh& m, const RasterTarget& t) {
          workers.Rasterize(m, t, set);
        });
        EXPECT_TRUE(one == many) << count << " workers, output " << static_cast<int>(output);
      }
    }
  }
}

TEST(RasterWorkers, DrawTheSameBitsByThreadsOfTheCallersInAnyOrder) {
  const OwnedMesh mesh = ManyTriangles(9000);
  int calls = 0;
  RasterWorkers backwards(5, [&](int count, const std::function<void(int)>& act) {
    for (int k = count - 1; k >= 0; --k) act(k);
    ++calls;
  });
  for (const RasterOutput output : kAllOutputs) {
    const auto one =
        Bytes(mesh, output, [](const RasterMesh& m, const RasterTarget& t) { Rasterize(m, t); });
    const auto many = Bytes(mesh, output, [&](const RasterMesh& m, const RasterTarget& t) {
      backwards.Rasterize(m, t);
    });
    EXPECT_TRUE(one == many) << "output " << static_cast<int>(output);
  }
  EXPECT_EQ(calls, 15);
}

// Targets of another size or output after one another: memory is kept, and empty again.
TEST(RasterWorkers, KeepNothingOfAnEarlierCall) {
  const OwnedMesh mesh = ManyTriangles(500);
  RasterWorkers workers(3);
  for (const RasterOutput output : kAllOutputs) {
    for (const int width : {kWidth, kWidth - 40, kWidth - 40, kWidth}) {
      const auto by_workers = [&](const RasterMesh& m, const RasterTarget& t) {
        workers.Rasterize(m, t);
      };
      const auto alone = [](const RasterMesh& m, const RasterTarget& t) { Rasterize(m, t); };
      EXPECT_TRUE(Bytes(mesh, output, by_workers, width) == Bytes(mesh, output, alone, width))
          << width << ", output " << static_cast<int>(output);
    }
  }
}

TEST(RasterWorkers, RefuseWhatCannotBe) {
  const auto refusal = [](const std::function<void()>& call) -> std::string {
    try {
      call();
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([] { RasterWorkers(0); }), "count: 0 workers; give 1 to 256");
  EXPECT_EQ(refusal([] { RasterWorkers(257); }), "count: 257 workers; give 1 to 256");
  EXPECT_EQ(refusal([] { RasterWorkers(2, {}); }),
            "for_each: empty; give a function to call, or only a count");
  RasterWorkers workers(2);
  std::vector<std::byte> memory(8, std::byte{7});
  const std::array<float, 9> positions{0, 0, 0, 90, 0, 0, 0, 90, 0};
  const std::array<std::uint32_t, 6> beyond{0, 1, 2, 0, 1, 3};
  EXPECT_EQ(refusal([&] {
              workers.Rasterize({positions, beyond}, {RasterOutput::kCounts, 8, 1, 8, memory, {}});
            }),
            "mesh.indices[5]: 3, and there are 3 vertices; give indices of positions");
  EXPECT_EQ(memory, std::vector<std::byte>(8, std::byte{7}));
}

// What another call left half done is drawn by none.
TEST(RasterWorkers, KeepNothingOfACallThatFailed) {
  const OwnedMesh mesh = ManyTriangles(3000);
  int call = 0;
  RasterWorkers workers(2, [&](int count, const std::function<void(int)>& act) {
    if (++call == 3) throw std::domain_error("no merge today");
    for (int k = 0; k < count; ++k) act(k);
  });
  const auto by_workers = [&](const RasterMesh& m, const RasterTarget& t) {
    workers.Rasterize(m, t);
  };
  const auto alone = [](const RasterMesh& m, const RasterTarget& t) { Rasterize(m, t); };
  EXPECT_THROW(Bytes(mesh, RasterOutput::kCounts, by_workers), std::domain_error);
  OwnedMesh beyond = ManyTriangles(300);
  const auto spoiled = [&](const RasterMesh& m, const RasterTarget& t) {
    std::vector<std::uint32_t> indices(m.indices.begin(), m.indices.end());
    indices.back() = 1000000;
    EXPECT_THROW(workers.Rasterize({m.positions, indices}, t), InputError);
  };
  Bytes(beyond, RasterOutput::kCounts, spoiled);
  const OwnedMesh next = ManyTriangles(400);
  EXPECT_TRUE(Bytes(next, RasterOutput::kCounts, by_workers) ==
              Bytes(next, RasterOutput::kCounts, alone));
}

// Subnormal depths are compared, whatever the caller's mode.
TEST(RasterWorkers, MergeDepthsInTheUsualEnvironment) {
  constexpr std::array kNear{0x1p-148F, 0x1p-149F};
  OwnedMesh mesh;
  for (const float z : kNear) {
    for (const auto& [x, y] : {std::pair(-9.0F, -9.0F), {900.0F, -9.0F}, {-9.0F, 900.0F}}) {
      mesh.AddCorner(x, y, z);
    }
  }
  RasterWorkers workers(2, [](int count, const std::function<void(int)>& act) {
    for (int k = 0; k < count; ++k) act(k);
  });
  const auto drawn = [&](const DrawInto& draw) {
    std::vector<float> depths(8);
    const RasterTarget target{.output = RasterOutput::kDepths,
                              .width = 8,
                              .height = 1,
                              .pitch = 32,
                              .memory = std::as_writable_bytes(std::span(depths))};
    Clear(target);
    draw(mesh.Mesh(), target);
    return depths;
  };
  if (!HasFloatMode(FloatMode::kDenormalsAreZero)) GTEST_SKIP() << "it takes them for 0 never";
  const auto found = drawn([&](const RasterMesh& m, const RasterTarget& t) {
    const WithinFloatMode flushed(FloatMode::kDenormalsAreZero);
    workers.Rasterize(m, t);
  });
  EXPECT_EQ(found, drawn([](const RasterMesh& m, const RasterTarget& t) { Rasterize(m, t); }));
  EXPECT_EQ(found.front(), 0x1p-149F);
}

TEST(RasterWorkers, LetExceptionsOfTheCallersThreadsThrough) {
  const OwnedMesh mesh = ManyTriangles(50);
  RasterWorkers workers(
      2, [](int, const std::function<void(int)>&) { throw std::domain_error("no threads today"); });
  std::vector<std::byte> memory(kWidth * kHeight);
  EXPECT_THROW(
      workers.Rasterize(mesh.Mesh(), {RasterOutput::kCounts, kWidth, kHeight, kWidth, memory, {}}),
      std::domain_error);
}

}  // namespace
}  // namespace rasterproof
