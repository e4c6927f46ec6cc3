// Outputs of pixels' squares: against the oracle of squares, by their definition, and by what an
// occluder must never do.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "core/error.h"
#include "core/square_rule.h"
#include "core/vertex.h"
#include "exact/edge.h"
#include "exact/rational.h"
#include "exact/square.h"
#include "library/rasterize.h"
#include "tests/library/owned_mesh.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

std::size_t TrianglesOf(const OwnedMesh& mesh) { return mesh.indices.size() / 3; }
std::size_t PositionOf(const OwnedMesh& mesh, std::size_t t, std::size_t k) {
  return std::size_t{3} * mesh.indices[3 * t + k];
}
std::array<Point2, 3> CornersOf(const OwnedMesh& mesh, std::size_t t) {
  std::array<Point2, 3> v{};
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t from = PositionOf(mesh, t, k);
    v[k] = {mesh.positions[from], mesh.positions[from + 1]};
  }
  return v;
}
float ZOf(const OwnedMesh& mesh, std::size_t t, std::size_t k) {
  return mesh.positions[PositionOf(mesh, t, k) + 2];
}
// 0: whole pixels, 1: half pixels, 2: small, 3: anywhere, 4: far, 5: of any exponent.
float Coordinate(reference::RandomValues& random, int kind, double from, int size) {
  if (kind == 0) return static_cast<float>(random.Integer(-1, size + 1));
  if (kind == 1) return static_cast<float>(random.Integer(-2, 2 * size + 2)) * 0.5F;
  if (kind == 2) return static_cast<float>(from + random.Uniform(-3, 3));
  if (kind == 3) return static_cast<float>(random.Uniform(-0.5 * size, 1.5 * size));
  if (kind == 4) return static_cast<float>(random.Uniform(-1e9, 1e9));
  return random.LogUniform<float>(-140, 127);
}

OwnedMesh Soup(std::uint64_t seed, int width, int height, int triangles) {
  OwnedMesh mesh{.name = "soup " + std::to_string(seed), .width = width, .height = height};
  reference::RandomValues random(seed);
  for (int t = 0; t < triangles; ++t) {
    const int kind = random.Integer(0, 6);  // 6: each coordinate of another
    const double x = random.Uniform(0, width);
    const double y = random.Uniform(0, height);
    const auto one = [&](double from, int size) {
      return Coordinate(random, kind == 6 ? random.Integer(0, 5) : kind, from, size);
    };
    for (int k = 0; k < 3; ++k) {
      const float vx = one(x, width);
      const float vy = one(y, height);
      mesh.indices.push_back(mesh.Add(vx, vy, static_cast<float>(random.Uniform(-1, 1))));
    }
  }
  return mesh;
}

// A grid of shared vertices, some folded over; quads of either diagonal, triangles of either
// winding, every vertex written once for each triangle if `is_split`.
OwnedMesh Grid(std::uint64_t seed, int columns, int rows, double step, bool is_split) {
  OwnedMesh mesh{.name = "grid " + std::to_string(seed), .width = 40, .height = 24};
  reference::RandomValues random(seed);
  const double wobble = random.Integer(0, 2) * 0.3 * step;
  const bool is_on_lattice = random.Integer(0, 2) == 0;
  std::vector<std::array<float, 3>> places;
  for (int r = 0; r <= rows; ++r) {
    for (int c = 0; c <= columns; ++c) {
      std::array<double, 2> p{2 + c * step + random.Uniform(-wobble, wobble),
                              1 + r * step + random.Uniform(-wobble, wobble)};
      if (is_on_lattice) p = {std::round(2 * p[0]) / 2, std::round(2 * p[1]) / 2};
      places.push_back({static_cast<float>(p[0]), static_cast<float>(p[1]),
                        static_cast<float>(random.Uniform(0, 1))});
    }
  }
  const auto add = [&](int c, int r) {
    const auto at = static_cast<std::uint32_t>(r * (columns + 1) + c);
    if (!is_split) return at;
    const auto& p = places[at];
    return mesh.Add(p[0], p[1], p[2]);
  };
  if (!is_split) {
    for (const auto& p : places) mesh.Add(p[0], p[1], p[2]);
  }
  for (int r = 0; r < rows; ++r) {
    for (int c = 0; c < columns; ++c) {
      std::array<std::array<int, 2>, 4> q{{{c, r}, {c + 1, r}, {c + 1, r + 1}, {c, r + 1}}};
      std::ranges::rotate(q, q.begin() + random.Integer(0, 1));
      for (std::array<std::size_t, 3> corners : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}}) {
        if (random.Integer(0, 3) == 0) std::swap(corners[0], corners[2]);
        for (const std::size_t k : corners) mesh.indices.push_back(add(q[k][0], q[k][1]));
      }
    }
  }
  return mesh;
}

OwnedMesh Hard() {
  OwnedMesh mesh{.name = "no area, no number, zeros of both signs", .width = 8, .height = 8};
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::uint32_t a = mesh.Add(0.0F, 0.0F, 0), b = mesh.Add(8, 0, 0), c = mesh.Add(8, 8, 0);
  const std::uint32_t other_a = mesh.Add(-0.0F, -0.0F, 0), d = mesh.Add(0, 8, 0);
  const std::uint32_t bad = mesh.Add(nan, 4, 0);
  mesh.indices = {a, b, c, other_a, c, d, a, b, b, a, bad, c, b, a, a};
  return mesh;
}

// The diagonal through pixels' corners, from where no guess is proved.
OwnedMesh FarDiagonal() {
  OwnedMesh mesh{.name = "far diagonal", .width = 8, .height = 8};
  const std::uint32_t a = mesh.Add(-0x1p29F, -0x1p29F, 0), b = mesh.Add(0x1p29F, 0x1p29F, 0);
  mesh.indices = {a, b, mesh.Add(0x1p29F, -0x1p29F, 0)};
  return mesh;
}

std::vector<OwnedMesh> SquareMeshes(int count) {
  std::vector<OwnedMesh> meshes{Hard(), FarDiagonal(), {.name = "empty", .width = 3, .height = 2}};
  for (int k = 0; k < Cases(count); ++k) {
    const auto seed = static_cast<std::uint64_t>(k);
    meshes.push_back(
        Soup(seed, count > 64 && k % 64 == 0 ? 65536 : 1 + k % 37, 1 + k % 19, 1 + k % 5));
    meshes.push_back(Grid(seed, 2 + k % 6, 2 + k % 4, 0.4 + 0.5 * (k % 9), k % 2 == 0));
  }
  return meshes;
}

using Pixels = std::vector<bool>;

Pixels Drawn(const OwnedMesh& mesh, RasterOutput output) {
  const auto pitch = static_cast<std::size_t>((mesh.width + 7) / 8);
  std::vector<std::byte> memory(pitch * static_cast<std::size_t>(mesh.height));
  Rasterize(mesh.Mesh(), {.output = output,
                          .width = mesh.width,
                          .height = mesh.height,
                          .pitch = pitch,
                          .memory = memory});
  Pixels pixels;
  for (int y = 0; y < mesh.height; ++y) {
    for (int x = 0; x < mesh.width; ++x) {
      const std::byte eight =
          memory[static_cast<std::size_t>(y) * pitch + static_cast<std::size_t>(x / 8)];
      pixels.push_back((std::to_integer<int>(eight) >> (x % 8) & 1) != 0);
    }
  }
  return pixels;
}

bool IsFiniteTriangle(const std::array<Point2, 3>& v) {
  return std::ranges::all_of(v, [](Point2 p) { return std::isfinite(p.x) && std::isfinite(p.y); });
}
int Turn(const std::array<Point2, 3>& v) { return exact::EdgeSign(v[0], v[1], v[2]); }
bool HasArea(const std::array<Point2, 3>& v) { return IsFiniteTriangle(v) && Turn(v) != 0; }

// The pixels whose open squares the closed triangle, or segment, meets.
void AddSquares(const OwnedMesh& mesh, const std::array<Point2, 3>& v, Pixels& pixels) {
  exact::ForEachSquareSpan(v, {.square = Closure::kOpen},
                           exact::SquareFrame{.clip = {0, 0, mesh.width, mesh.height}},
                           [&](int row, exact::Columns columns) {
                             for (int x = columns.first; x < columns.last; ++x) {
                               pixels[static_cast<std::size_t>(row * mesh.width + x)] = true;
                             }
                           });
}

Pixels None(const OwnedMesh& mesh) {
  return Pixels(static_cast<std::size_t>(mesh.width * mesh.height));
}

Pixels ExpectedOuter(const OwnedMesh& mesh) {
  Pixels outer = None(mesh);
  for (std::size_t t = 0; t < TrianglesOf(mesh); ++t) {
    if (HasArea(CornersOf(mesh, t))) AddSquares(mesh, CornersOf(mesh, t), outer);
  }
  return outer;
}

// By the words of library/rasterize.h.
Pixels ExpectedInner(const OwnedMesh& mesh) {
  using End = std::pair<double, double>;
  std::map<std::pair<End, End>, int> turns;
  for (std::size_t t = 0; t < TrianglesOf(mesh); ++t) {
    std::array<Point2, 3> v = CornersOf(mesh, t);
    if (!HasArea(v)) continue;
    if (Turn(v) < 0) std::swap(v[0], v[1]);
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 a = v[k], b = v[(k + 1) % 3];
      ++turns[{{a.x, a.y}, {b.x, b.y}}];
      --turns[{{b.x, b.y}, {a.x, a.y}}];
    }
  }
  Pixels met = None(mesh);
  for (const auto& [edge, count] : turns) {
    const Point2 a{edge.first.first, edge.first.second};
    const Point2 b{edge.second.first, edge.second.second};
    if (count != 0) AddSquares(mesh, {a, b, b}, met);
  }
  Pixels inner = Drawn(mesh, RasterOutput::kMask);
  for (std::size_t k = 0; k < inner.size(); ++k) inner[k] = inner[k] && !met[k];
  return inner;
}

std::string FirstDifference(const OwnedMesh& mesh, const Pixels& found, const Pixels& expected) {
  for (std::size_t k = 0; k < found.size(); ++k) {
    if (found[k] == expected[k]) continue;
    const auto width = static_cast<std::size_t>(mesh.width);
    return mesh.name + ": pixel " + std::to_string(k % width) + ", " + std::to_string(k / width) +
           (found[k] ? " is set" : " is not set");
  }
  return "";
}

TEST(RasterizeSquares, OuterMaskIsTheOraclesOfOpenSquares) {
  for (const OwnedMesh& mesh : SquareMeshes(1000)) {
    EXPECT_EQ(FirstDifference(mesh, Drawn(mesh, RasterOutput::kOuterMask), ExpectedOuter(mesh)),
              "");
  }
}

// One triangle each, so that no other hides a square too many.
TEST(RasterizeSquares, OuterMaskOfATriangleIsTheOracles) {
  const char* const more = std::getenv("RASTERPROOF_SQUARES");
  const int triangles = more != nullptr ? std::atoi(more) : Cases(100000);
  for (int k = 0; k < triangles; ++k) {
    const OwnedMesh mesh = Soup(static_cast<std::uint64_t>(k), 1 + k % 37, 1 + k % 19, 1);
    ASSERT_EQ(FirstDifference(mesh, Drawn(mesh, RasterOutput::kOuterMask), ExpectedOuter(mesh)),
              "");
  }
}

TEST(RasterizeSquares, InnerMaskIsItsDefinition) {
  std::size_t set = 0;
  for (const OwnedMesh& mesh : SquareMeshes(1000)) {
    const Pixels inner = Drawn(mesh, RasterOutput::kInnerMask);
    EXPECT_EQ(FirstDifference(mesh, inner, ExpectedInner(mesh)), "");
    set += static_cast<std::size_t>(std::ranges::count(inner, true));
  }
  EXPECT_GT(set, 64000U / kOneCaseIn);
}

// A closed triangle holds p.
bool Holds(std::array<Point2, 3> v, Point2 p) {
  if (!HasArea(v)) return false;
  if (Turn(v) < 0) std::swap(v[0], v[1]);
  for (std::size_t k = 0; k < 3; ++k) {
    if (exact::EdgeSign(v[k], v[(k + 1) % 3], p) < 0) return false;
  }
  return true;
}

// Whether the triangle's plane at p is farther than z, exactly.
bool IsFarther(const OwnedMesh& mesh, std::size_t t, Point2 p, float z) {
  using exact::Rational;
  const std::array<Point2, 3> v = CornersOf(mesh, t);
  const auto edge = [](Point2 a, Point2 b, Point2 c) -> Rational {
    return (Rational(c.x) - Rational(a.x)) * (Rational(b.y) - Rational(a.y)) -
           (Rational(c.y) - Rational(a.y)) * (Rational(b.x) - Rational(a.x));
  };
  const Rational area = edge(v[0], v[1], v[2]);
  const Rational sum = edge(v[1], v[2], p) * Rational(ZOf(mesh, t, 0)) +
                       edge(v[2], v[0], p) * Rational(ZOf(mesh, t, 1)) +
                       edge(v[0], v[1], p) * Rational(ZOf(mesh, t, 2));
  return sum / area > Rational(z);
}

// The definition is right: every point of an inner pixel's square lies in a triangle, and no depth
// there is farther than what kInnerDepths says.
TEST(RasterizeSquares, NoPointOfAnInnerSquareIsOpenOrFarther) {
  reference::RandomValues random(7);
  int points = 0;
  for (const OwnedMesh& mesh : SquareMeshes(64)) {
    const Pixels inner = Drawn(mesh, RasterOutput::kInnerMask);
    const auto width = static_cast<std::size_t>(mesh.width);
    std::vector<float> depths(inner.size(), std::numeric_limits<float>::infinity());
    Rasterize(mesh.Mesh(), {.output = RasterOutput::kInnerDepths,
                            .width = mesh.width,
                            .height = mesh.height,
                            .pitch = 4 * width,
                            .memory = std::as_writable_bytes(std::span(depths))});
    for (std::size_t k = 0; k < inner.size(); ++k) {
      EXPECT_EQ(inner[k], std::isfinite(depths[k])) << mesh.name;
      EXPECT_TRUE(!inner[k] || depths[k] <= 1) << mesh.name;  // no z is greater
      if (!inner[k]) continue;
      for (int n = 0; n < 4; ++n) {
        const Point2 p{static_cast<double>(k % width) + random.Integer(1, 15) / 16.0,
                       static_cast<double>(k / width) + random.Integer(1, 15) / 16.0};
        bool is_held = false;
        for (std::size_t t = 0; t < TrianglesOf(mesh); ++t) {
          if (!Holds(CornersOf(mesh, t), p)) continue;
          is_held = true;
          EXPECT_FALSE(IsFarther(mesh, t, p, depths[k])) << mesh.name;
        }
        EXPECT_TRUE(is_held) << mesh.name << " " << p.x << " " << p.y;
        ++points;
      }
    }
  }
  EXPECT_GT(points, 4000 / kOneCaseIn);
}

std::vector<float> InnerDepths(const OwnedMesh& mesh, float before) {
  std::vector<float> depths(static_cast<std::size_t>(mesh.width * mesh.height), before);
  Rasterize(mesh.Mesh(), {.output = RasterOutput::kInnerDepths,
                          .width = mesh.width,
                          .height = mesh.height,
                          .pitch = 4 * static_cast<std::size_t>(mesh.width),
                          .memory = std::as_writable_bytes(std::span(depths))});
  return depths;
}

// A quad over 8 x 8 pixels whose z is x / 16, and beside it the ends.
OwnedMesh Ramp() {
  OwnedMesh mesh{.name = "ramp", .width = 10, .height = 9};
  const std::uint32_t a = mesh.Add(0, 0, 0), b = mesh.Add(8, 0, 0.5F);
  const std::uint32_t c = mesh.Add(8, 8, 0.5F), d = mesh.Add(0, 8, 0);
  mesh.indices = {a, b, c, a, c, d};
  return mesh;
}

TEST(RasterizeSquares, DepthsAreThoseOfTheFartherSideRoundedUp) {
  const std::vector<float> depths = InnerDepths(Ramp(), 2);
  for (int y = 0; y < 9; ++y) {
    for (int x = 0; x < 10; ++x) {
      const float found = depths[static_cast<std::size_t>(10 * y + x)];
      if (x >= 8 || y >= 8) {
        EXPECT_EQ(found, 2) << x << ", " << y;
      } else {
        EXPECT_GE(found, static_cast<float>(x + 1) / 16) << x << ", " << y;
        EXPECT_LE(found, static_cast<float>(x + 1) / 16 * 1.000001F) << x << ", " << y;
      }
    }
  }
}

TEST(RasterizeSquares, DepthsKeepWhatIsNearerAndSquaresOfNoDepth) {
  for (const float nearer : InnerDepths(Ramp(), -1)) EXPECT_EQ(nearer, -1);
  OwnedMesh mesh = Ramp();
  mesh.positions[2] = std::numeric_limits<float>::infinity();  // of both triangles
  for (const float untouched : InnerDepths(mesh, 2)) EXPECT_EQ(untouched, 2);
  // Of one that lies over a part of them.
  mesh = Ramp();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  mesh.indices.insert(mesh.indices.end(),
                      {mesh.Add(0, 0, nan), mesh.Add(3, 0, 0), mesh.Add(0, 3, 0)});
  const std::vector<float> depths = InnerDepths(mesh, 2);
  EXPECT_EQ(depths[11], 2);
  EXPECT_LT(depths[44], 1);
}

TEST(RasterizeSquares, AFoldHidesNoMoreThanItsTriangles) {
  // Front and back cancel in a sum of windings; their outline is drawn twice.
  OwnedMesh mesh{.name = "fold", .width = 6, .height = 6};
  const std::uint32_t a = mesh.Add(0.5F, 0.5F, 0), b = mesh.Add(5.5F, 0.5F, 0);
  const std::uint32_t c = mesh.Add(0.5F, 5.5F, 0);
  mesh.indices = {a, b, c, a, c, b};
  const Pixels inner = Drawn(mesh, RasterOutput::kInnerMask);
  EXPECT_EQ(std::ranges::count(inner, true), 6);
  EXPECT_EQ(FirstDifference(mesh, inner, ExpectedInner(mesh)), "");
}

TEST(MarkEmptyTriangles, MarksThoseThatTheOracleSaysCoverNoCentre) {
  for (const OwnedMesh& mesh : SquareMeshes(64)) {
    std::vector<std::uint8_t> is_empty(TrianglesOf(mesh), 9);
    MarkEmptyTriangles(mesh.Mesh(), mesh.width, mesh.height, is_empty);
    for (std::size_t t = 0; t < TrianglesOf(mesh); ++t) {
      OwnedMesh one = mesh;
      one.indices.assign(mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * t),
                         mesh.indices.begin() + static_cast<std::ptrdiff_t>(3 * t + 3));
      const auto counts = Drawn(one, RasterOutput::kMask);
      EXPECT_EQ(is_empty[t] == 1, std::ranges::count(counts, true) == 0) << mesh.name << " " << t;
    }
  }
  std::vector<std::uint8_t> too_few(1);
  EXPECT_THROW(MarkEmptyTriangles(Ramp().Mesh(), 4, 4, too_few), InputError);
  EXPECT_THROW(MarkEmptyTriangles(Ramp().Mesh(), 4, 4, {static_cast<std::uint8_t*>(nullptr), 2}),
               InputError);
  OwnedMesh mesh = Ramp();
  auto* const inside = reinterpret_cast<std::uint8_t*>(mesh.indices.data()) + 2;
  EXPECT_THROW(MarkEmptyTriangles(mesh.Mesh(), 4, 4, {inside, 2}), InputError);
}

}  // namespace
}  // namespace rasterproof
