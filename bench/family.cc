#include "bench/family.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/sample_pattern.h"
#include "core/scene.h"
#include "reference/whole_scene.h"

namespace rasterproof::bench {
namespace {

constexpr int kWidth = 1920;
constexpr int kHeight = 1080;

// splitmix64: the same scenes everywhere.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  /// Of [low, high), with 24 random bits.
  double Between(double low, double high) {
    return low + (high - low) * (static_cast<double>(Next() >> 40) * 0x1p-24);
  }

 private:
  std::uint64_t Next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15U);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebU;
    return z ^ (z >> 31);
  }
  std::uint64_t state_;
};

double Rounded(double x) { return static_cast<double>(static_cast<float>(x)); }

Vertex At(double x, double y, double z, double w = 1) {
  return {Rounded(x), Rounded(y), Rounded(z), Rounded(w)};
}

Scene Empty(int width = kWidth, int height = kHeight) {
  Scene scene;
  scene.width = width;
  scene.height = height;
  return scene;
}

void AddTriangle(Scene& scene, const std::array<Vertex, 3>& v) {
  const auto first = static_cast<std::int32_t>(scene.vertices.size());
  scene.vertices.insert(scene.vertices.end(), v.begin(), v.end());
  scene.triangles.push_back({first, first + 1, first + 2});
}

// The angles of three corners about a centre: a third of a turn apart, give or take 0.5.
std::array<double, 3> ThreeAngles(Random& random) {
  const double turn = random.Between(0, 2 * std::numbers::pi);
  std::array<double, 3> angles{};
  for (std::size_t k = 0; k < 3; ++k) {
    angles[k] =
        turn + static_cast<double>(k) * 2 * std::numbers::pi / 3 + random.Between(-0.5, 0.5);
  }
  return angles;
}

// Triangles of the mean `area` around random centres of [x0, width) x [0, height).
Scene Scattered(int count, double area, double x0, Scene scene, std::uint64_t seed) {
  Random random(seed);
  // The sum of sines of three angles of the centre is 3 sin(120 degrees) (sin(0.5) / 0.5)^2.
  const double radius = std::sqrt(area / 1.1945);
  for (int i = 0; i < count; ++i) {
    const double x = random.Between(x0, scene.width);
    const double y = random.Between(0, scene.height);
    const double z = random.Between(0, 1);
    const bool clockwise = random.Between(0, 1) < 0.5;
    const std::array<double, 3> angles = ThreeAngles(random);
    std::array<Vertex, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      v[k] = At(x + radius * std::cos(angles[k]),
                y + (clockwise ? radius : -radius) * std::sin(angles[k]),
                z + 0.01 * static_cast<double>(k));
    }
    AddTriangle(scene, v);
  }
  return scene;
}

Scene Px5(int part, std::uint64_t seed) { return Scattered(240'000 / part, 5, 0, Empty(), seed); }
Scene Px100(int part, std::uint64_t seed) {
  return Scattered(32'000 / part, 100, 0, Empty(), seed);
}
Scene Px1m(int part, std::uint64_t seed) {
  return Scattered(24 / part, 1e6, 0, Empty(2048, 2048), seed);
}
Scene Far(int part, std::uint64_t seed) {
  return Scattered(32'000 / part, 50, 16384 - 2048, Empty(16384, 256), seed);
}

// Three corners anywhere in a band 64 pixels high.
Scene Walks(int part, std::uint64_t seed) {
  Scene scene = Empty(16384, 64);
  Random random(seed);
  for (int i = 0; i < 64 / part; ++i) {
    std::array<Vertex, 3> v;
    for (Vertex& corner : v) {
      corner = At(random.Between(0, scene.width), random.Between(0, scene.height), 0.5);
    }
    AddTriangle(scene, v);
  }
  return scene;
}

// 100 to 900 px long, 0.05 to 1 px wide.
Scene Needles(int part, std::uint64_t seed) {
  Scene scene = Empty();
  Random random(seed);
  for (int i = 0; i < 512 / part; ++i) {
    const double x = random.Between(0, scene.width);
    const double y = random.Between(0, scene.height);
    const double z = random.Between(0, 1);
    const double angle = random.Between(0, 2 * std::numbers::pi);
    const double dx = std::cos(angle);
    const double dy = std::sin(angle);
    const double half = 0.5 * random.Between(100, 900);
    const double wide = random.Between(0.05, 1);
    const double along = random.Between(-half, half);
    AddTriangle(scene, {At(x - half * dx, y - half * dy, z), At(x + half * dx, y + half * dy, z),
                        At(x + along * dx - wide * dy, y + along * dy + wide * dx, z)});
  }
  return scene;
}

// Neighbouring slices of a fan of 16,000 around one vertex.
Scene Fan(int part, std::uint64_t seed) {
  Scene scene = Empty();
  Random random(seed);
  constexpr int kAllSlices = 16'000;
  const int slices = 2048 / part;
  const double x = 0.5 * scene.width + 0.3;
  const double y = 0.5 * scene.height + 0.2;
  scene.vertices.push_back(At(x, y, 0.5));
  for (int i = 0; i <= slices; ++i) {
    const double angle = 2 * std::numbers::pi * i / kAllSlices;
    const double radius = random.Between(0.8, 0.96) * scene.width / 2;
    scene.vertices.push_back(At(x + radius * std::cos(angle), y + radius * std::sin(angle), 0.5));
  }
  for (int i = 0; i < slices; ++i) scene.triangles.push_back({0, 2 + i, 1 + i});
  return scene;
}

// Quads of a grid of (columns + 1) x (rows + 1) vertices, row by row.
void AddGrid(Scene& scene, int columns, int rows) {
  const auto vertex = [columns](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      scene.triangles.push_back({vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1)});
      scene.triangles.push_back({vertex(i, j), vertex(i + 1, j + 1), vertex(i + 1, j)});
    }
  }
}

// A grid that covers the target, each vertex inside moved by up to a third of its cell, then
// rounded to 2^-bits.
Scene JitteredGrid(int part, int bits, std::uint64_t seed) {
  Scene scene = Empty(kWidth, kHeight / part);
  Random random(seed);
  constexpr double kCell = 6.3246;  // two triangles of 20 px
  const int columns = static_cast<int>(std::lround(scene.width / kCell));
  const int rows = static_cast<int>(std::lround(scene.height / kCell));
  const auto placed = [bits](double x) {
    return std::ldexp(std::round(std::ldexp(x, bits)), -bits);
  };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double z = random.Between(0, 1);
      const double dx = i == 0 || i == columns ? 0 : random.Between(-0.33, 0.33);
      const double dy = j == 0 || j == rows ? 0 : random.Between(-0.33, 0.33);
      scene.vertices.push_back(
          At(placed((i + dx) * scene.width / columns), placed((j + dy) * scene.height / rows), z));
    }
  }
  AddGrid(scene, columns, rows);
  return scene;
}

Scene Mesh(int part, std::uint64_t seed) { return JitteredGrid(part, 40, seed); }
Scene Snapped4(int part, std::uint64_t seed) { return JitteredGrid(part, 4, seed); }
Scene Snapped8(int part, std::uint64_t seed) { return JitteredGrid(part, 8, seed); }

// Right triangles of 4 px sides with their vertices on pixel centres: so are all edges.
Scene Ties(int part, std::uint64_t /*seed*/) {
  Scene scene = Empty(kWidth, kHeight / part);
  const int columns = (scene.width - 1) / 4;
  const int rows = (scene.height - 1) / 4;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) scene.vertices.push_back(At(4 * i + 0.5, 4 * j + 0.5, 0.5));
  }
  AddGrid(scene, columns, rows);
  return scene;
}

// A tilted torus, in clip space already scaled to the viewport; `divided` by w in double, then
// rounded to float32.
Scene TorusOf(int part, bool divided) {
  Scene scene = Empty();
  scene.clip_space = !divided;
  const int around = 1024 / part;
  const int through = 256;
  const double tilt = 1.0;
  for (int j = 0; j <= through; ++j) {
    for (int i = 0; i <= around; ++i) {
      const double u = 2 * std::numbers::pi * (i % around) / around;
      const double v = 2 * std::numbers::pi * (j % through) / through;
      const double ring = 1 + 0.45 * std::cos(v);
      const double flat = ring * std::sin(u);
      const double up = 0.45 * std::sin(v);
      const double x = ring * std::cos(u);
      const double y = flat * std::cos(tilt) - up * std::sin(tilt);
      const double w = 4 + flat * std::sin(tilt) + up * std::cos(tilt);
      const double scale = 1.34 * scene.height;
      const double by = divided ? w : 1;
      scene.vertices.push_back(At((0.5 * scene.width * w + scale * x) / by,
                                  (0.5 * scene.height * w + scale * y) / by, 1 - 1 / w,
                                  divided ? 1 : w));
    }
  }
  AddGrid(scene, around, through);
  return scene;
}

Scene Torus(int part, std::uint64_t /*seed*/) { return TorusOf(part, true); }
Scene Perspective(int part, std::uint64_t /*seed*/) { return TorusOf(4 * part, false); }

// One pass for each of the standard four samples: the scene moved so that the sample lies on the
// pixel's centre, beside the others. Vertices on 1/256 move exactly.
Scene FourSamples(int part, std::uint64_t seed) {
  const Scene once = JitteredGrid(4 * part, 8, seed);
  Scene scene = Empty(once.width, 4 * once.height);
  const SamplePattern pattern = *StandardPattern(4);
  for (std::size_t s = 0; s < pattern.locations.size(); ++s) {
    const auto first = static_cast<std::int32_t>(scene.vertices.size());
    const Point2 at = pattern.locations[s];
    const double below = static_cast<double>(s) * once.height;
    for (const Vertex& v : once.vertices) {
      scene.vertices.push_back(At(v.x + 0.5 - at.x, v.y + 0.5 - at.y + below, v.z));
    }
    for (const Triangle& t : once.triangles) {
      scene.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    }
  }
  return scene;
}

// Pairs of triangles whose shared edge passes within a rounding of a pixel's centre: its far end is
// the first one's continuation through the centre, rounded to float32.
Scene Grazing(int part, std::uint64_t seed) {
  Scene scene = Empty();
  Random random(seed);
  for (int i = 0; i < 8192 / part; ++i) {
    const double x = std::floor(random.Between(32, scene.width - 32)) + 0.5;
    const double y = std::floor(random.Between(32, scene.height - 32)) + 0.5;
    const double angle = random.Between(0, 2 * std::numbers::pi);
    const double near = random.Between(4, 24);
    const Vertex a = At(x + near * std::cos(angle), y + near * std::sin(angle), 0.25);
    const double beyond = random.Between(0.3, 3);
    const Vertex b = At(x + beyond * (x - a.x), y + beyond * (y - a.y), 0.75);
    const double side = random.Between(2, 6) / std::hypot(b.x - a.x, b.y - a.y);
    const Vertex left = At(x - side * (b.y - a.y), y + side * (b.x - a.x), 0.5);
    const Vertex right = At(x + side * (b.y - a.y), y - side * (b.x - a.x), 0.5);
    const auto first = static_cast<std::int32_t>(scene.vertices.size());
    scene.vertices.insert(scene.vertices.end(), {a, b, left, right});
    scene.triangles.push_back({first, first + 1, first + 2});
    scene.triangles.push_back({first + 1, first, first + 3});
  }
  return scene;
}

constexpr std::array kKinds{
    FamilyKind{"px5", "Scattered triangles of one to ten pixels, 5 on average", true, Px5},
    FamilyKind{"px100", "Scattered triangles of about a hundred pixels", true, Px100},
    FamilyKind{"px1m", "Triangles of about a million pixels, partly outside the target", true,
               Px1m},
    FamilyKind{"walks",
               "Triangles up to 16,384 pixels wide in a band of 64 rows: long steps along "
               "the row",
               true, Walks},
    FamilyKind{"needles", "Needles 100 to 900 pixels long and 0.05 to 1 pixel wide", true, Needles},
    FamilyKind{
        "fan",
        "Neighbouring slivers of a fan, 800 pixels long and a third of a pixel wide at its rim",
        false, Fan},
    FamilyKind{"mesh", "A jittered grid that partitions the target, triangles of about 20 pixels",
               false, Mesh},
    FamilyKind{"ties",
               "A grid of triangles of 8 pixels whose edges all pass through pixel "
               "centres",
               false, Ties},
    FamilyKind{"snapped-4", "The jittered grid with its vertices on 1/16 pixel", false, Snapped4},
    FamilyKind{"snapped-8", "The jittered grid with its vertices on 1/256 pixel", false, Snapped8},
    FamilyKind{"far", "Triangles of about 50 pixels, 14,336 to 16,384 pixels from the origin", true,
               Far},
    FamilyKind{"torus",
               "A torus in perspective, divided and rounded to float32: triangles of 2 to "
               "3 pixels",
               false, Torus},
    FamilyKind{"perspective",
               "The torus in clip space: a method divides, or uses homogeneous "
               "edges",
               false, Perspective},
    FamilyKind{"four-samples",
               "The grid on 1/256 pixel at the four standard samples of each "
               "pixel, a pass each",
               false, FourSamples},
    FamilyKind{"grazing",
               "Pairs of triangles made so that their shared edge passes within a rounding of a "
               "pixel's centre",
               false, Grazing, true},
};

// 1 / part of a family is drawn, by FamilySize.
constexpr std::array kParts{8, 2, 1};

}  // namespace

std::span<const FamilyKind> FamilyKinds() { return kKinds; }

FamilyInput MakeFamily(const FamilyKind& kind, FamilySize size, std::uint64_t seed) {
  Scene scene = kind.make(kParts[static_cast<std::size_t>(size)], seed);
  scene.name = kind.name;
  FamilyInput input = FamilyOf(std::move(scene), std::string(kind.summary));
  input.is_random = kind.is_random;
  input.is_constructed = kind.is_constructed;
  return input;
}

FamilyInput FamilyOf(Scene scene, std::string summary) {
  FamilyInput input;
  input.name = scene.name;
  input.summary = std::move(summary);
  input.scene = std::move(scene);
  const bool is_clip = reference::ClipKernelTakes(input.scene);
  if (!is_clip && !reference::KernelsTake(input.scene)) return input;
  for (const Vertex& v : input.scene.vertices) {
    const auto x = static_cast<float>(v.x);
    const auto y = static_cast<float>(v.y);
    const auto z = static_cast<float>(v.z);
    if (is_clip) {
      input.clip_vertices.push_back({x, y, z, static_cast<float>(v.w)});
    } else {
      input.vertices.push_back({x, y, z});
    }
  }
  for (const Triangle& t : input.scene.triangles) {
    for (const std::int32_t index : t) input.indices.push_back(static_cast<std::uint32_t>(index));
  }
  return input;
}

}  // namespace rasterproof::bench
