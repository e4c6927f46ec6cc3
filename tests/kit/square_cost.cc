// What the library's outputs of squares take, beside a mask of the same triangles in this run; and
// which triangles the usual test for small ones drops wrongly.
//
// usage: square_cost
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <random>
#include <span>
#include <string_view>
#include <vector>

#include "kit/rasterize.h"

namespace rasterproof {
namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;
constexpr int kTimes = 9;

struct NamedMesh {
  std::string_view name;
  std::vector<float> positions = {};
  std::vector<std::uint32_t> indices = {};

  RasterMesh Mesh() const { return {positions, indices}; }
};

// A grid of quads in two triangles each; vertices moved by a part of a step, on a lattice if it is
// not 0.
NamedMesh GridMesh(std::string_view name, double step_x, double step_y, double lattice) {
  NamedMesh mesh{.name = name};
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

void Print(const NamedMesh& mesh) {
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
      "%-9.*s %8zu triangles; ns each: mask %.1f, inner mask %.1f, inner depths %.1f, outer mask "
      "%.1f\n          empty: %zu, MarkEmptyTriangles %.1f ns; the box test %.1f ns finds %zu and "
      "drops %zu that cover a centre\n",
      static_cast<int>(mesh.name.size()), mesh.name.data(), triangles, per_triangle(mask),
      per_triangle(seconds_of(RasterOutput::kInnerMask)),
      per_triangle(seconds_of(RasterOutput::kInnerDepths)),
      per_triangle(seconds_of(RasterOutput::kOuterMask)), empty, per_triangle(marked),
      per_triangle(dropped), found, wrong);
}

void PrintAll() {
  Print(GridMesh("tiny", 2.5, 2.5, 0));
  Print(GridMesh("half", 2.5, 2.5, 0.5));
  Print(GridMesh("subpixel", 1.3, 1.3, 0x1p-4));
  Print(GridMesh("slivers", 0.15, 60, 0));
  Print(GridMesh("medium", 30, 30, 0));
  Print(GridMesh("large", 300, 300, 0));
}

}  // namespace
}  // namespace rasterproof

int main() { rasterproof::PrintAll(); }
