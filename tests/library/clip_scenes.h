// Scenes of clip space for the tests of its kernel, and what is true of them in rationals.
#ifndef RASTERPROOF_TESTS_LIBRARY_CLIP_SCENES_H_
#define RASTERPROOF_TESTS_LIBRARY_CLIP_SCENES_H_

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "exact/rational.h"
#include "library/kernels/kernel.h"
#include "tests/reference/random_values.h"

namespace rasterproof::library::kernels {

using reference::RandomValues;

using exact::Rational;

struct OwnedClipScene {
  std::vector<ClipVertex> vertices;
  std::vector<std::uint32_t> indices;
  int width = 1;
  int height = 1;
  NearPlane near_plane = NearPlane::kNone;

  ClipScene View() const { return {vertices, indices, width, height, near_plane}; }
  /// The triangle alone.
  ClipScene Only(std::size_t triangle) const {
    ClipScene scene = View();
    scene.indices = scene.indices.subspan(3 * triangle, 3);
    return scene;
  }
  std::array<ClipVertex, 3> Corners(std::size_t triangle) const {
    return {vertices[indices[3 * triangle]], vertices[indices[3 * triangle + 1]],
            vertices[indices[3 * triangle + 2]]};
  }
};

inline float RandomCoordinate(RandomValues& random, int kind, int side, double w) {
  switch (kind) {
    case 0:  // ties
      return static_cast<float>(random.Integer(-side, side)) * 0.5F;
    case 1:
      return static_cast<float>(random.Uniform(-0.5 * side, 1.5 * side) * w);
    case 2:
      return random.LogUniform<float>(-140, 127);
    default:
      return static_cast<float>(random.Uniform(-side, side));
  }
}

// Triangles of all signs of w, with z around 0 and ties among them.
inline OwnedClipScene RandomClipScene(std::uint64_t seed, int side, int triangles) {
  RandomValues random(seed);
  OwnedClipScene owned;
  owned.width = side + static_cast<int>(seed % 5);
  owned.height = side;
  for (int t = 0; t < triangles; ++t) {
    const int kind = random.Integer(0, 3);
    for (int k = 0; k < 3; ++k) {
      double w = 1;
      if (kind == 0) w = random.Integer(-2, 3);
      if (kind == 1) w = std::ldexp(1 + random.Uniform(0, 1), random.Integer(-12, 3));
      if (kind == 2) w = random.LogUniform<float>(-140, 127);
      if (kind == 3) w = random.Uniform(-1, 1);
      const float z = kind == 0 ? static_cast<float>(random.Integer(-2, 2))
                                : static_cast<float>(random.Uniform(-1, 1) * w);
      owned.vertices.push_back({RandomCoordinate(random, kind, side, w),
                                RandomCoordinate(random, kind, side, w), z, static_cast<float>(w)});
      owned.indices.push_back(static_cast<std::uint32_t>(owned.indices.size()));
    }
  }
  return owned;
}

// Triangles before the eye in boxes of up to `side`: edges pass samples, and corners lie beside
// rows and columns of them, as closely as float32 has them in clip space, or on them; some edges
// are flat.
inline OwnedClipScene ScenesBeforeTheEye(std::uint64_t seed, int side, int triangles) {
  RandomValues random(seed);
  OwnedClipScene owned;
  owned.width = side + 30;
  owned.height = side + 25;
  const auto beside = [&](double v) {
    if (random.Integer(0, 2) == 0) return v;
    return v + std::ldexp(random.Uniform(-1, 1), -random.Integer(6, 34));
  };
  for (int t = 0; t < triangles; ++t) {
    const int box = random.Integer(1, side);
    const bool is_flat = random.Integer(0, 2) == 0;
    const double flat = is_flat ? std::ldexp(1, -random.Integer(0, 16)) : 1;
    const double left = random.Integer(-3, 33);
    const double first = random.Integer(-3, 28);
    const double middle = first + random.Integer(0, box - 1) + 0.5;
    const double top = is_flat ? middle - 0.5 * box * flat : first;
    const auto point = [&] {
      const double x = left + random.Uniform(0, box);
      const double y = top + random.Uniform(0, box * flat);
      const bool is_rounded = !is_flat && random.Integer(0, 2) == 0;
      return std::array{is_rounded ? beside(std::floor(x) + 0.5) : x,
                        is_rounded ? beside(std::floor(y) + 0.5) : y};
    };
    std::array<std::array<double, 2>, 3> corner{point(), point(), point()};
    // The second is as far from a sample as the first one, on its other side.
    if (random.Integer(0, 1) == 0) {
      for (std::size_t c = 0; c < 2; ++c) {
        corner[1][c] = beside(2 * (std::floor(corner[1][c]) + 0.5) - corner[0][c]);
      }
    }
    if (random.Integer(0, 1) == 0) corner[2][1] = first + random.Uniform(0, box);
    const bool is_one = random.Integer(0, 3) == 0;
    for (const auto& [x, y] : corner) {
      const double w = is_one ? 1 : std::ldexp(1 + random.Uniform(0, 1), random.Integer(-4, 4));
      const auto as_float = static_cast<float>(w);
      owned.indices.push_back(static_cast<std::uint32_t>(owned.vertices.size()));
      owned.vertices.push_back({static_cast<float>(x * as_float), static_cast<float>(y * as_float),
                                static_cast<float>(random.Uniform(0, 1) * w), as_float});
    }
  }
  return owned;
}

// What Cramer's rule says of a triangle: f = (by_x x + by_y y + by_1) / area takes the values n_k
// at corners (x, y, w), so its sign at (x, y, 1) is that of n where the ray meets the plane.
struct Affine {
  Rational by_x, by_y, by_1, area;

  Affine(const std::array<ClipVertex, 3>& v, const std::array<Rational, 3>& n) {
    using Row = std::array<Rational, 3>;
    const Row x{Rational(v[0].x), Rational(v[1].x), Rational(v[2].x)};
    const Row y{Rational(v[0].y), Rational(v[1].y), Rational(v[2].y)};
    const Row w{Rational(v[0].w), Rational(v[1].w), Rational(v[2].w)};
    const auto determinant = [](const Row& a, const Row& b, const Row& c) {
      return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
             a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    area = determinant(x, y, w);
    by_x = determinant(n, y, w);
    by_y = determinant(x, n, w);
    by_1 = determinant(x, y, n);
  }

  Rational At(int x, int y) const {
    return (by_x * Rational(x + 0.5) + by_y * Rational(y + 0.5) + by_1) / area;
  }
};

inline std::array<Rational, 3> Depths(const std::array<ClipVertex, 3>& v) {
  return {Rational(v[0].z), Rational(v[1].z), Rational(v[2].z)};
}

__extension__ using Int128 = __int128;
using Integers = std::array<Int128, 3>;

inline Integers Cross(const Integers& a, const Integers& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// u and v with a u + b v = gcd(a, b), which is returned.
inline Int128 Bezout(Int128 a, Int128 b, Int128& u, Int128& v) {
  if (b == 0) {
    u = 1;
    v = 0;
    return a;
  }
  Int128 x = 0;
  const Int128 gcd = Bezout(b, a % b, x, u);
  v = x - a / b * u;
  return gcd;
}

inline long double Dot(const Integers& a, const Integers& b) {
  long double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    sum += static_cast<long double>(a[k]) * static_cast<long double>(b[k]);
  }
  return sum;
}

// A point as near to the plane of a and b as integers come, and not far from them.
inline Integers BesidePlane(const Integers& a, const Integers& b) {
  const Integers n = Cross(a, b);
  Int128 u = 0, v = 0, s = 0, t = 0;
  const Int128 gcd = Bezout(n[0], n[1], u, v);
  Bezout(gcd, n[2], s, t);
  Integers c{s * u, s * v, t};
  const long double aa = Dot(a, a), ab = Dot(a, b), bb = Dot(b, b);
  for (int pass = 0; pass < 4; ++pass) {
    const long double ac = Dot(a, c), bc = Dot(b, c);
    const long double determinant = aa * bb - ab * ab;
    const auto by_a = static_cast<Int128>(std::round((ac * bb - bc * ab) / determinant));
    const auto by_b = static_cast<Int128>(std::round((bc * aa - ac * ab) / determinant));
    for (std::size_t k = 0; k < 3; ++k) c[k] -= by_a * a[k] + by_b * b[k];
  }
  return c;
}

inline ClipVertex VertexOf(const Integers& v, float z) {
  return {static_cast<float>(v[0]), static_cast<float>(v[1]), z, static_cast<float>(v[2])};
}

// Two of either facing with a determinant of 1 or so between products of 2^59, and a sample on an
// edge of theirs; some corners lie behind the eye. Empty if the drawn edge has no length.
inline OwnedClipScene Slivers(RandomValues& random) {
  OwnedClipScene owned;
  owned.width = 4001;
  owned.height = 13;
  const Integers p{2 * random.Integer(2000, 4000) + 1, 2 * random.Integer(0, 12) + 1, 2};
  const Integers a{random.Integer(-(1 << 23), 1 << 23), random.Integer(-(1 << 23), 1 << 23),
                   random.Integer(1, 1 << 23)};
  const Integers b{p[0] - a[0], p[1] - a[1], p[2] - a[2]};
  if (Dot(Cross(a, b), Cross(a, b)) == 0) return owned;
  const auto z = [&] { return static_cast<float>(random.Uniform(0, 1 << 16)); };
  owned.vertices = {VertexOf(a, z()), VertexOf(b, z()), VertexOf(BesidePlane(a, b), z())};
  owned.indices = {0, 1, 2, 1, 0, 2};
  return owned;
}

}  // namespace rasterproof::library::kernels

#endif  // RASTERPROOF_TESTS_LIBRARY_CLIP_SCENES_H_
