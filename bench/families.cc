#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bench/bench.h"
#include "exact/coverage.h"
#include "props/domains/bit_source.h"

namespace rasterproof::bench {
namespace {

using props::PhiloxSource;

// A float32 of [low, high), with all the fractional bits that float32 has there.
double Uniform(PhiloxSource& bits, double low, double high) {
  const double unit = static_cast<double>(bits.Bits(53)) * 0x1p-53;
  return static_cast<double>(static_cast<float>(low + unit * (high - low)));
}

void AddFrontFacing(Scene& scene, std::array<Point2, 3> v) {
  if (exact::Facing(v) < 0) std::swap(v[1], v[2]);
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  for (const Point2& p : v) scene.vertices.push_back({p.x, p.y});
  scene.triangles.push_back({first, first + 1, first + 2});
}

Scene EmptyScene(std::string name, int width, int height) {
  Scene scene;
  scene.name = std::move(name);
  scene.width = width;
  scene.height = height;
  return scene;
}

// Triangles whose three vertices are uniform in a box of the given sides, itself uniform in the
// target.
Scene Boxes(std::string name, int count, int width, int height, double box_width, double box_height,
            std::uint64_t seed, std::uint64_t family) {
  Scene scene = EmptyScene(std::move(name), width, height);
  for (int k = 0; k < count; ++k) {
    PhiloxSource bits(seed, (family << 32) + static_cast<std::uint64_t>(k));
    const double x = Uniform(bits, 0, width - box_width);
    const double y = Uniform(bits, 0, height - box_height);
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      p = {Uniform(bits, x, x + box_width), Uniform(bits, y, y + box_height)};
    }
    AddFrontFacing(scene, v);
  }
  return scene;
}

Scene Needles(int count, int side, std::uint64_t seed, std::uint64_t family) {
  Scene scene = EmptyScene("needles", side, side);
  for (int k = 0; k < count; ++k) {
    PhiloxSource bits(seed, (family << 32) + static_cast<std::uint64_t>(k));
    const double angle = Uniform(bits, 0, 2 * std::numbers::pi);
    const double half = Uniform(bits, side * 0.1, side * 0.48);
    const double width = std::exp2(Uniform(bits, -10, 0));
    const double dx = std::cos(angle);
    const double dy = std::sin(angle);
    const double middle = side * 0.5 + Uniform(bits, -4, 4);
    const auto at = [&](double along, double across) {
      return Point2{static_cast<double>(static_cast<float>(middle + along * dx - across * dy)),
                    static_cast<double>(static_cast<float>(middle + along * dy + across * dx))};
    };
    AddFrontFacing(scene, {at(-half, -width / 2), at(half, 0), at(-half, width / 2)});
  }
  return scene;
}

}  // namespace

std::vector<Family> Families(std::uint64_t seed) {
  std::vector<Family> families;
  families.push_back({"medium", "1000 triangles of about 64 px",
                      Boxes("medium", 1000, 1024, 1024, 96, 96, seed, 0)});
  families.push_back(
      {"large", "4 triangles of 2048 px", Boxes("large", 4, 2100, 2100, 2048, 2048, seed, 1)});
  families.push_back(
      {"wide", "6 triangles of 16384 x 64 px", Boxes("wide", 6, 16384, 80, 16384, 64, seed, 2)});
  families.push_back(
      {"needles", "60 needles less than one pixel wide", Needles(60, 1024, seed, 3)});
  return families;
}

}  // namespace rasterproof::bench
