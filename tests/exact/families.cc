#include "tests/exact/families.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string_view>
#include <utility>

#include "core/draw_options.h"
#include "core/tie_rule.h"
#include "core/ulp.h"

namespace rasterproof::exact {
namespace {

constexpr std::array<std::string_view, kFamilies> kNames{
    "uniform",      "lattice",         "half-pixels",   "collinear",   "mixed-exponents",
    "float32-bits", "float64-bits",    "subnormal",     "underflow",   "largest",
    "needle",       "hardest-lattice", "moved-hardest", "signed-zeros"};

double ToFloat32(double x) { return static_cast<double>(static_cast<float>(x)); }

// u, v with u dy - v dx = 1 for coprime dx, dy > 0, |u| <= dx, |v| <= dy.
std::pair<std::int64_t, std::int64_t> Bezout(std::int64_t dx, std::int64_t dy) {
  std::int64_t r0 = dy;
  std::int64_t r1 = dx;
  std::int64_t u0 = 1;
  std::int64_t u1 = 0;
  std::int64_t v0 = 0;
  std::int64_t v1 = 1;
  while (r1 != 0) {
    const std::int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    u0 = std::exchange(u1, u0 - q * u1);
    v0 = std::exchange(v1, v0 - q * v1);
  }
  return {u0, -v0};
}

}  // namespace

std::string_view FamilyName(Family family) { return kNames[static_cast<std::size_t>(family)]; }

double Draw::Coordinate(Family family) {
  switch (family) {
    case Family::kUniform:
    case Family::kCollinear:
      return ToFloat32(Unit() * 16 - 2);
    case Family::kLattice:
      return (Below(4096) - 1024) / 256.0;
    case Family::kHalfPixels:
      return (Below(24) - 4) * 0.5;
    case Family::kMixedExponents:
      return ToFloat32(Magnitude(Below(60) - 40));
    case Family::kFloat32Bits:
      for (;;) {
        const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(Bits()));
        if (std::isfinite(x)) return double{x};
      }
    case Family::kFloat64Bits:
      for (;;) {
        const auto x = std::bit_cast<double>(Bits());
        if (std::isfinite(x)) return x;
      }
    case Family::kSubnormal:
      return Subnormal();
    case Family::kUnderflow:
      return Magnitude(-511 - Below(8));
    case Family::kLargest: {
      const double largest = Below(2) == 0 ? double{std::numeric_limits<float>::max()}
                                           : std::numeric_limits<double>::max();
      const double nearly = MoveByUlps(largest, -Below(4));
      const double scale = Below(3) == 0 ? 0.5 : 1;
      return Sign() * nearly * scale;
    }
    case Family::kNeedle:
      return Below(2) == 0 ? ToFloat32(Sign() * 1e30) : ToFloat32(Unit() * 12);
    case Family::kHardestLattice:
    case Family::kMovedHardest:
      return std::ldexp(static_cast<double>(Bits() >> 11), -49);
    case Family::kSignedZeros:
    case Family::kCount:
      break;
  }
  const double sign = Sign();
  return sign * Below(3);
}

double Draw::Magnitude(int exponent) {
  const double mantissa = 1 + Unit();
  return Sign() * std::ldexp(mantissa, exponent);
}

double Draw::Subnormal() {
  const double sign = Sign();
  if (Below(3) == 0) return sign * MoveByUlps(0x1p-1022, Below(9) - 4);
  const int mantissa = Below(1 << 20);
  return sign * std::ldexp(mantissa, Below(2) == 0 ? -149 : -1074);
}

// With a at the origin, E = p.x b.y - p.y b.x: by Bezout's identity some p of the lattice makes it
// 1.
std::array<Point2, 3> Draw::Hardest(bool moved) {
  const int bits = 24 + Below(30);
  std::int64_t dx = 0;
  std::int64_t dy = 0;
  do {
    dx = static_cast<std::int64_t>(Bits() >> (64 - bits)) | 1;
    dy = static_cast<std::int64_t>(Bits() >> (64 - bits)) | 2;
  } while (std::gcd(dx, dy) != 1);
  const auto [u, v] = Bezout(dx, dy);
  // Now and then so small that a residual underflows, or so large that products nearly overflow.
  const int scale = Below(3) != 0 ? 0 : (Below(2) == 0 ? -470 - Below(60) : 500);
  const double unit = std::ldexp(1.0, 4 - bits + scale);
  const double sign = Sign();
  Point2 a{0, 0};
  if (moved) {
    const auto nudge = [&] {
      const double mantissa = Unit() - 0.5;
      return std::ldexp(mantissa, scale - bits - Below(60));
    };
    a = {nudge(), nudge()};
  }
  return {a, Point2{static_cast<double>(dx) * unit, static_cast<double>(dy) * unit},
          Point2{sign * static_cast<double>(u) * unit, sign * static_cast<double>(v) * unit}};
}

std::array<Point2, 3> Draw::EdgeAndPoint(Family family) {
  if (family == Family::kHardestLattice || family == Family::kMovedHardest) {
    return Hardest(family == Family::kMovedHardest);
  }
  const auto point = [&] { return Point2{Coordinate(family), Coordinate(family)}; };
  std::array<Point2, 3> v{point(), point(), point()};
  const int kind = Below(8);
  if (family == Family::kCollinear || kind == 0 || (family == Family::kUnderflow && kind < 6)) {
    // Near the line: a rounded combination of the ends, then up to two ulp aside.
    const double t = Below(2) == 0 ? 0.5 : Unit();
    const auto between = [&](double from, double to) {
      double x = from * (1 - t) + to * t;
      if (family == Family::kCollinear) x = ToFloat32(x);
      return std::isfinite(x) ? MoveByUlps(x, Below(5) - 2) : to;
    };
    v[2] = {between(v[0].x, v[1].x), between(v[0].y, v[1].y)};
  } else if (kind == 1) {
    v[2] = v[static_cast<std::size_t>(Below(2))];
  } else if (kind == 2) {
    v[2] = {0.5 + Below(16), 0.5 + Below(16)};
  }
  return v;
}

Scene Draw::SmallScene(Family family, bool clip_space) {
  Scene scene;
  scene.name = FamilyName(family);
  scene.width = 1 + Below(9);
  scene.height = 1 + Below(9);
  scene.precision = Precision::kFloat64;
  scene.clip_space = clip_space;
  while (scene.vertices.size() < 6) {
    for (Point2 p : EdgeAndPoint(family)) {
      double w = 1;
      if (clip_space && Below(4) != 0) {
        w = Below(2) == 0 ? Coordinate(Family::kSignedZeros) : Coordinate(family);
      }
      // Now and then an ordinary vertex, or the triangles would all miss the target.
      if (Below(3) == 0) p = {Coordinate(Family::kHalfPixels), Coordinate(Family::kHalfPixels)};
      scene.vertices.push_back({p.x, p.y, 0, w});
    }
  }
  for (int t = 0; t < 3; ++t) scene.triangles.push_back({Below(6), Below(6), Below(6)});
  return scene;
}

Profile Draw::AnyProfile() {
  Profile profile;
  profile.tie_rule = {static_cast<std::int8_t>(Sign()), static_cast<std::int8_t>(Sign()),
                      Below(2) == 0, Below(9) == 0};
  profile.y_axis = Below(2) == 0 ? YAxis::kDown : YAxis::kUp;
  if (Below(3) == 0) profile.pattern.locations = {{0.25, 0.5}, {0, 0}, {0.99609375, 0.125}};
  return profile;
}

DrawOptions Draw::AnyOptions() {
  DrawOptions options;
  options.cull = static_cast<Cull>(Below(3));
  if (Below(4) == 0) {
    options.scissor = PixelRect{Below(8) - 2, Below(8) - 2, Below(12) - 1, Below(12) - 1};
  }
  return options;
}

}  // namespace rasterproof::exact
