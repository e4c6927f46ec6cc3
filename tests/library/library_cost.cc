// What the library's outputs of squares take, beside a mask of the same triangles in this run;
// which triangles the usual test for small ones drops wrongly; and what two workers gain.
//
// usage: library_cost
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <random>
#include <span>
#include <vector>

#include "library/rasterize.h"
#include "tests/library/owned_mesh.h"

namespace rasterproof {
namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr int kTimes = 9;
// Of what most machines have.
const InstructionSet kWorkersSet =
    IsSupported(InstructionSet::kAvx2) ? InstructionSet::kAvx2 : InstructionSet::kBest;

// A grid of quads in two triangles each; vertices moved by a part of a step, on a lattice if it is
// not 0.
OwnedMesh GridMesh(const char* name, double step_x, double step_y, double lattice) {
  OwnedMesh mesh{.name = name};
  std::mt19937_64 bits(35);
  const auto near = [&](double c, double step) {
    const double moved = c + (static_cast<double>(bits() >> 11) * 0x1p-53 - 0.5) * 0.4 * step;
    return static_cast<float>(lattice > 0 ? std::round(moved / lattice) * lattice : moved);
  };
  const auto columns = static_cast<std::uint32_t>(1900 / step_x);
  const auto rows = static_cast<std::uint32_t>(1060 / step_y);
  for (std::uint32_t r = 0; r <= rows; ++r) {
    for (std::uint32_t c = 0; c <= columns; ++c) {
      mesh.positions.insert(mesh.positions.end(),
                            {near(10 + c * step_x, step_x), near(10 + r * step_y, step_y), 0});
      if (r == rows || c == columns) continue;
      const std::uint32_t a = r * (columns + 1) + c, b = a + columns + 1;
      mesh.indices.insert(mesh.indices.end(), {a, a + 1, b + 1, a, b + 1, b});
    }
  }
  return mesh;
}

// As far from one another as in no mesh: each worker reaches all of its target.
OwnedMesh ScatteredMesh(const char* name, std::uint32_t triangles, double side) {
  OwnedMesh mesh{.name = name};
  std::mt19937_64 bits(36);
  const auto uniform = [&](double most) {
    return static_cast<float>(static_cast<double>(bits() >> 11) * 0x1p-53 * most);
  };
  for (std::uint32_t t = 0; t < triangles; ++t) {
    const float x = uniform(kWidth - side);
    const float y = uniform(kHeight - side);
    for (std::uint32_t k = 0; k < 3; ++k) {
      mesh.positions.insert(mesh.positions.end(), {x + uniform(side), y + uniform(side), 0});
      mesh.indices.push_back(3 * t + k);
    }
  }
  return mesh;
}

// The test of many engines: a box that rounds to no pixel in x or in y has no centre in it.
void DropSmallTriangles(const RasterMesh& mesh, std::span<std::uint8_t> is_empty) {
  for (std::size_t t = 0; t < is_empty.size(); ++t) {
    std::array<float, 2> least{}, most{};
    for (std::size_t axis = 0; axis < 2; ++axis) {
      const auto at = [&](std::size_t k) {
        return mesh.positions[std::size_t{3} * mesh.indices[3 * t + k] + axis];
      };
      least[axis] = std::rint(std::min({at(0), at(1), at(2)}));
      most[axis] = std::rint(std::max({at(0), at(1), at(2)}));
    }
    is_empty[t] = least[0] == most[0] || least[1] == most[1] ? 1 : 0;
  }
}

template <class Act>
double Least(const Act& act) {
  double least = 1e9;
  for (int k = 0; k < kTimes; ++k) {
    const auto begun = std::chrono::steady_clock::now();
    act();
    least = std::min(
        least, std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count());
  }
  return least;
}

void Print(const OwnedMesh& mesh) {
  const std::size_t triangles = mesh.indices.size() / 3;
  std::vector<std::byte> memory(std::size_t{4} * kWidth * (kHeight + 8));
  const auto seconds_of = [&](RasterOutput output) {
    const std::size_t pitch = output == RasterOutput::kInnerDepths ? 4 * kWidth : kWidth / 8;
    const RasterTarget target{
        .output = output, .width = kWidth, .height = kHeight, .pitch = pitch, .memory = memory};
    return Least([&] { Rasterize(mesh.Mesh(), target); });
  };
  const double mask = seconds_of(RasterOutput::kMask);
  std::vector<std::uint8_t> exact(triangles), rounded(triangles);
  const double marked = Least([&] { MarkEmptyTriangles(mesh.Mesh(), kWidth, kHeight, exact); });
  const double dropped = Least([&] { DropSmallTriangles(mesh.Mesh(), rounded); });
  std::size_t empty = 0, found = 0, wrong = 0;
  for (std::size_t t = 0; t < triangles; ++t) {
    empty += exact[t];
    found += exact[t] & rounded[t];
    wrong += rounded[t] & (1U - exact[t]);
  }
  const auto per_triangle = [&](double seconds) {
    return seconds * 1e9 / static_cast<double>(triangles);
  };
  std::printf(
      "%-9s %8zu triangles; ns each: mask %.1f, inner mask %.1f, inner depths %.1f, outer mask "
      "%.1f\n          empty: %zu, MarkEmptyTriangles %.1f ns; the box test %.1f ns finds %zu and "
      "drops %zu that cover a centre\n",
      mesh.name.c_str(), triangles, per_triangle(mask),
      per_triangle(seconds_of(RasterOutput::kInnerMask)),
      per_triangle(seconds_of(RasterOutput::kInnerDepths)),
      per_triangle(seconds_of(RasterOutput::kOuterMask)), empty, per_triangle(marked),
      per_triangle(dropped), found, wrong);
}

// Pairs by turns: one thread's time over two workers'.
double Gain(const OwnedMesh& mesh, RasterOutput output, RasterWorkers& two) {
  const std::size_t row = output == RasterOutput::kMask     ? kWidth / 8
                          : output == RasterOutput::kCounts ? kWidth
                                                            : 4 * kWidth;
  std::vector<std::byte> memory(row * (kHeight + 8));
  const RasterTarget target{
      .output = output, .width = kWidth, .height = kHeight, .pitch = row, .memory = memory};
  Clear(target);
  const auto seconds = [](const auto& act) {
    const auto begun = std::chrono::steady_clock::now();
    act();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - begun).count();
  };
  std::array<double, 15> gains{};
  for (double& gain : gains) {
    const double one = seconds([&] { Rasterize(mesh.Mesh(), target, kWorkersSet); });
    gain = one / seconds([&] { two.Rasterize(mesh.Mesh(), target, kWorkersSet); });
  }
  std::ranges::sort(gains);
  return gains[gains.size() / 2];
}

void PrintGains(const OwnedMesh& mesh, RasterWorkers& two) {
  std::printf(
      "%-9s %8zu triangles; two workers gain: mask %.2f, counts %.2f, ids %.2f, depths %.2f\n",
      mesh.name.c_str(), mesh.indices.size() / 3, Gain(mesh, RasterOutput::kMask, two),
      Gain(mesh, RasterOutput::kCounts, two), Gain(mesh, RasterOutput::kIds, two),
      Gain(mesh, RasterOutput::kDepths, two));
}

void PrintAll() {
  Print(GridMesh("tiny", 2.5, 2.5, 0));
  Print(GridMesh("half", 2.5, 2.5, 0.5));
  Print(GridMesh("subpixel", 1.3, 1.3, 0x1p-4));
  Print(GridMesh("slivers", 0.15, 60, 0));
  Print(GridMesh("medium", 30, 30, 0));
  Print(GridMesh("large", 300, 300, 0));
  RasterWorkers two(2);
  PrintGains(GridMesh("tiny", 2.5, 2.5, 0), two);
  PrintGains(GridMesh("small", 6, 6, 0), two);
  PrintGains(GridMesh("medium", 20, 20, 0), two);
  PrintGains(ScatteredMesh("scattered", 50'000, 5), two);
  PrintGains(ScatteredMesh("scattered", 400'000, 5), two);
}

}  // namespace
}  // namespace rasterproof

int main() { rasterproof::PrintAll(); }
