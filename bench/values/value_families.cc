#include "bench/values/value_families.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "library/rasterize.h"

namespace rasterproof::bench {
namespace {

constexpr int kMostValueTriangles = 60'000;

// SplitMix64 by Steele, Lea and Flood 2014: one stream a triangle.
class ValueRandom {
 public:
  ValueRandom(std::uint64_t seed, int index)
      : state_(seed * 0x9e3779b97f4a7c15U +
               static_cast<std::uint64_t>(index) * 0xd1b54a32d192ed03U) {}
  double Uniform(double low, double high) {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    z ^= z >> 31;
    return low + (high - low) * std::ldexp(static_cast<double>(z >> 11), -53);
  }

 private:
  std::uint64_t state_;
};

void SetCorner(ValueTriangle& t, int k, double x, double y, double w, double a) {
  t.w[k] = static_cast<float>(w);
  t.x[k] = static_cast<float>(x * t.w[k]);
  t.y[k] = static_cast<float>(y * t.w[k]);
  t.a[k] = static_cast<float>(a);
}

// Anywhere on a target of 512 x 512, of this size.
ValueTriangle Somewhere(ValueRandom& random, double size) {
  ValueTriangle t{};
  const double x = random.Uniform(0, 512 - size);
  const double y = random.Uniform(0, 512 - size);
  for (int k = 0; k < 3; ++k) {
    SetCorner(t, k, x + random.Uniform(0, size), y + random.Uniform(0, size), 1,
              random.Uniform(0, 1));
  }
  return t;
}

// The same with other w.
void SetW(ValueTriangle& t, const std::array<double, 3>& w) {
  for (int k = 0; k < 3; ++k) {
    SetCorner(t, k, t.x[k], t.y[k], w[static_cast<std::size_t>(k)], t.a[k]);
  }
}

ValueTriangle Screen(std::uint64_t seed, int index, double /*value*/) {
  ValueRandom random(seed, index);
  return Somewhere(random, 256);
}
ValueTriangle Tiny(std::uint64_t seed, int index, double /*value*/) {
  ValueRandom random(seed, index);
  return Somewhere(random, 2.5);
}
// One corner so many pixels from the line through the others.
ValueTriangle Needle(ValueRandom& random, double aside) {
  ValueTriangle t = Somewhere(random, 400);
  const double along = random.Uniform(0, 1);
  const double x = t.x[1] - t.x[0];
  const double y = t.y[1] - t.y[0];
  const double length = std::hypot(x, y);
  SetCorner(t, 2, t.x[0] + along * x + aside * y / length, t.y[0] + along * y - aside * x / length,
            1, t.a[2]);
  return t;
}
ValueTriangle Sliver(std::uint64_t seed, int index, double /*value*/) {
  ValueRandom random(seed, index);
  return Needle(random, std::exp2(random.Uniform(-12, -3)));
}
// 2^value times as long as wide.
ValueTriangle Aspect(std::uint64_t seed, int index, double value) {
  ValueRandom random(seed, index);
  return Needle(random, 256 * std::exp2(-value));
}
ValueTriangle Cancelling(std::uint64_t seed, int index, double /*value*/) {
  ValueRandom random(seed, index);
  ValueTriangle t = Somewhere(random, 256);
  for (float& a : t.a) a = static_cast<float>(1e6 + random.Uniform(-1, 1));
  return t;
}
// Up to 2^value pixels right of the origin, on few rows.
ValueTriangle FarTriangle(std::uint64_t seed, int index, double value) {
  ValueRandom random(seed, index);
  ValueTriangle t{};
  const double x = std::exp2(value) - random.Uniform(48, 512);
  for (int k = 0; k < 3; ++k) {
    SetCorner(t, k, x + random.Uniform(0, 48), random.Uniform(0, 64), 1, random.Uniform(0, 1));
  }
  return t;
}
// w in a ratio of 2^value.
ValueTriangle Ratio(std::uint64_t seed, int index, double value) {
  ValueRandom random(seed, index);
  ValueTriangle t = Somewhere(random, 256);
  const double half = value / 2;
  SetW(t, {std::exp2(-half), std::exp2(random.Uniform(-half, half)), std::exp2(half)});
  return t;
}
// One corner just before or behind the eye: the triangle runs to the horizon.
ValueTriangle NearZeroW(std::uint64_t seed, int index, double /*value*/) {
  ValueRandom random(seed, index);
  ValueTriangle t = Somewhere(random, 256);
  const double sign = random.Uniform(-1, 1) < 0 ? -1 : 1;
  SetW(t, {1, random.Uniform(0.5, 2), sign * std::exp2(random.Uniform(-24, -8))});
  return t;
}
// A floor of 64 x 64 squares in perspective, u along it.
ValueTriangle Floor(std::uint64_t /*seed*/, int index, double /*value*/) {
  ValueTriangle t{};
  const int square = index / 2 % 4096;
  constexpr std::array<std::array<std::array<int, 2>, 3>, 2> kHalves{
      {{{{0, 0}, {1, 0}, {0, 1}}}, {{{1, 0}, {1, 1}, {0, 1}}}}};
  for (int k = 0; k < 3; ++k) {
    const auto& at = kHalves[static_cast<std::size_t>(index % 2)][static_cast<std::size_t>(k)];
    const int row = square / 64 + at[1];
    const double across = (square % 64 + at[0]) / 32.0 - 1;
    const double along = 1 + row / 4.0;  // from the eye
    SetCorner(t, k, 256 + 400 * across / along, 120 + 390 / along, along, row / 64.0);
  }
  return t;
}

void AddValueTriangle(const ValueTriangle& t, ValueScene& scene) {
  for (std::size_t k = 0; k < 3; ++k) {
    scene.indices.push_back(static_cast<std::uint32_t>(scene.numbers.size()));
    scene.positions.insert(scene.positions.end(), {t.x[k], t.y[k], 0});
    if (scene.space != RasterSpace::kWindow) scene.positions.push_back(t.w[k]);
    scene.numbers.push_back(t.a[k]);
  }
  scene.triangles.push_back(t);
}

}  // namespace

std::span<const ValueFamilyKind> ValueFamilyKinds() {
  static constexpr std::array kKinds{
      ValueFamilyKind{"screen", "Triangles of up to 256 pixels a side.", false, 512, 512, 0,
                      &Screen},
      ValueFamilyKind{"slivers", "One corner within 2^-12 to 2^-3 pixels of the opposite edge.",
                      false, 512, 512, 0, &Sliver},
      ValueFamilyKind{"cancelling", "Numbers of 1e6 +- 1 at the corners.", false, 512, 512, 0,
                      &Cancelling},
      ValueFamilyKind{"far", "Triangles of 48 pixels up to 16384 pixels from the origin.", false,
                      16384, 64, 14, &FarTriangle},
      ValueFamilyKind{"tiny", "Triangles of up to 2.5 pixels a side.", false, 512, 512, 0, &Tiny},
      ValueFamilyKind{"w-4", "w at the corners in a ratio of 2^4.", true, 512, 512, 4, &Ratio},
      ValueFamilyKind{"w-20", "w at the corners in a ratio of 2^20.", true, 512, 512, 20, &Ratio},
      ValueFamilyKind{"w-60", "w at the corners in a ratio of 2^60.", true, 512, 512, 60, &Ratio},
      ValueFamilyKind{"near-zero-w", "One corner's w within 2^-8 of 0, of either sign.", true, 512,
                      512, 0, &NearZeroW},
      ValueFamilyKind{"mesh", "A floor of 4096 squares in perspective.", true, 512, 512, 0,
                      &Floor}};
  return kKinds;
}

std::span<const ValueParameter> ValueParameters() {
  static constexpr std::array kParameters{
      ValueParameter{{"w-ratio", "of w at the corners", true, 512, 512, 0, &Ratio}, 0, 60},
      ValueParameter{{"distance", "from the origin, pixels; triangles of 48", false, 65536, 64, 0,
                      &FarTriangle},
                     9,
                     16},
      ValueParameter{
          {"aspect", "length over width, of 256 pixels", false, 512, 512, 0, &Aspect}, 0, 20}};
  return kParameters;
}

ValueScene MakeValueScene(const ValueFamilyKind& kind, std::uint64_t covered, std::uint64_t seed) {
  ValueScene scene;
  scene.space = kind.is_clip_space ? RasterSpace::kClip : RasterSpace::kWindow;
  for (int index = 0; index < kMostValueTriangles && scene.covered < covered; ++index) {
    const ValueTriangle t = kind.draw(seed, index, kind.value);
    ValueScene alone;
    alone.space = scene.space;
    AddValueTriangle(t, alone);
    const auto triangle = static_cast<std::uint32_t>(scene.triangles.size());
    const std::size_t runs = scene.runs.size();
    Rasterize(alone.Mesh(), kind.width, kind.height, [&](const RasterSpan& span) {
      scene.runs.push_back({triangle, span.y, span.x0, span.x1});
      scene.covered += static_cast<std::uint64_t>(span.x1 - span.x0);
    });
    if (scene.runs.size() > runs) AddValueTriangle(t, scene);
  }
  return scene;
}

}  // namespace rasterproof::bench
