#include "bench/kernel_scenes.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <string_view>

#include "core/error.h"
#include "core/scene.h"
#include "reference/kernels/kernel.h"

namespace rasterproof::bench {
namespace {

using reference::kernels::KernelVertex;

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

KernelVertex At(double x, double y, double z) {
  return {static_cast<float>(x), static_cast<float>(y), static_cast<float>(z)};
}

KernelInput Empty(int width, int height) {
  KernelInput input;
  input.width = width;
  input.height = height;
  return input;
}

void AddVertex(KernelInput& input, const KernelVertex& v) {
  input.indices.push_back(static_cast<std::uint32_t>(input.vertices.size()));
  input.vertices.push_back(v);
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

// Triangles of the mean `area` around random centres.
KernelInput Scattered(int count, double area, int width, int height, std::uint64_t seed) {
  KernelInput input = Empty(width, height);
  Random random(seed);
  // The sum of sines of three angles of the centre is 3 sin(120 degrees) (sin(0.5) / 0.5)^2.
  const double radius = std::sqrt(area / 1.1945);
  for (int i = 0; i < count; ++i) {
    const double x = random.Between(0, width);
    const double y = random.Between(0, height);
    double z = random.Between(0, 1);
    const bool clockwise = random.Between(0, 1) < 0.5;
    for (const double angle : ThreeAngles(random)) {
      AddVertex(input, At(x + radius * std::cos(angle),
                          y + (clockwise ? radius : -radius) * std::sin(angle), z));
      z += 0.01;
    }
  }
  return input;
}

KernelInput Tiny(int width, int height, std::uint64_t seed) {
  return Scattered(1'000'000, 5, width, height, seed);
}

KernelInput Medium(int width, int height, std::uint64_t seed) {
  return Scattered(20'000, 493, width, height, seed);
}

// Three corners around the centre of the target, beyond its sides for the most part.
KernelInput Huge(int width, int height, std::uint64_t seed) {
  KernelInput input = Empty(width, height);
  Random random(seed);
  for (int i = 0; i < 200; ++i) {
    double z = random.Between(0, 1);
    for (const double angle : ThreeAngles(random)) {
      AddVertex(input, At(width * (0.5 + 0.6 * std::cos(angle)),
                          height * (0.5 + 0.6 * std::sin(angle)), z));
      z += 0.1;
    }
  }
  return input;
}

// 100 to 900 px long, 0.05 to 1 px wide.
KernelInput Sliver(int width, int height, std::uint64_t seed) {
  KernelInput input = Empty(width, height);
  Random random(seed);
  for (int i = 0; i < 100'000; ++i) {
    const double x = random.Between(0, width);
    const double y = random.Between(0, height);
    const double z = random.Between(0, 1);
    const double angle = random.Between(0, 2 * std::numbers::pi);
    const double dx = std::cos(angle);
    const double dy = std::sin(angle);
    const double half = 0.5 * random.Between(100, 900);
    const double wide = random.Between(0.05, 1);
    const double along = random.Between(-half, half);
    AddVertex(input, At(x - half * dx, y - half * dy, z));
    AddVertex(input, At(x + half * dx, y + half * dy, z + 0.1));
    AddVertex(input, At(x + along * dx - wide * dy, y + along * dy + wide * dx, z + 0.2));
  }
  return input;
}

void AddQuad(KernelInput& input, std::uint32_t a, std::uint32_t b, std::uint32_t c,
             std::uint32_t d) {
  input.indices.insert(input.indices.end(), {a, b, c, a, c, d});
}

// Quads of a grid of (columns + 1) x (rows + 1) vertices, row by row.
void AddGrid(KernelInput& input, int columns, int rows) {
  const auto vertex = [columns](int i, int j) {
    return static_cast<std::uint32_t>(j * (columns + 1) + i);
  };
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      AddQuad(input, vertex(i, j), vertex(i, j + 1), vertex(i + 1, j + 1), vertex(i + 1, j));
    }
  }
}

// A grid that covers the target, each vertex inside moved by up to a third of its cell.
KernelInput Partition(int width, int height, std::uint64_t seed) {
  KernelInput input = Empty(width, height);
  Random random(seed);
  constexpr double kCell = 6.3246;  // two triangles of 20 px
  const int columns = static_cast<int>(std::lround(width / kCell));
  const int rows = static_cast<int>(std::lround(height / kCell));
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      const double z = random.Between(0, 1);
      const double dx = i == 0 || i == columns ? 0 : random.Between(-0.33, 0.33);
      const double dy = j == 0 || j == rows ? 0 : random.Between(-0.33, 0.33);
      input.vertices.push_back(At((i + dx) * width / columns, (j + dy) * height / rows, z));
    }
  }
  AddGrid(input, columns, rows);
  return input;
}

// A torus of 1024 x 256 quads in perspective, tilted, both sides drawn.
KernelInput Torus(int width, int height, std::uint64_t /*seed*/) {
  KernelInput input = Empty(width, height);
  constexpr int kAround = 1024;
  constexpr int kThrough = 256;
  const double tilt = 1.0;
  for (int j = 0; j <= kThrough; ++j) {
    for (int i = 0; i <= kAround; ++i) {
      const double u = 2 * std::numbers::pi * (i % kAround) / kAround;
      const double v = 2 * std::numbers::pi * (j % kThrough) / kThrough;
      const double ring = 1 + 0.45 * std::cos(v);
      const double x = ring * std::cos(u);
      const double flat = ring * std::sin(u);
      const double up = 0.45 * std::sin(v);
      const double y = flat * std::cos(tilt) - up * std::sin(tilt);
      const double depth = 4 + flat * std::sin(tilt) + up * std::cos(tilt);
      const double scale = 1.34 * height / depth;
      input.vertices.push_back(
          At(0.5 * width + scale * x, 0.5 * height + scale * y, 1 - 1 / depth));
    }
  }
  AddGrid(input, kAround, kThrough);
  return input;
}

// Right triangles of 4 px sides with their vertices on pixel centres: so are all edges.
KernelInput TieGrid(int width, int height, std::uint64_t seed) {
  KernelInput input = Empty(width, height);
  Random random(seed);
  const int columns = (width - 1) / 4;
  const int rows = (height - 1) / 4;
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      input.vertices.push_back(At(4 * i + 0.5, 4 * j + 0.5, random.Between(0, 1)));
    }
  }
  AddGrid(input, columns, rows);
  return input;
}

// 20,000 triangles at one vertex.
KernelInput Fan(int width, int height, std::uint64_t seed) {
  KernelInput input = Empty(width, height);
  Random random(seed);
  constexpr int kTriangles = 20'000;
  input.vertices.push_back(At(0.5 * width + 0.3, 0.5 * height + 0.2, 0.5));
  for (int i = 0; i < kTriangles; ++i) {
    const double angle = 2 * std::numbers::pi * i / kTriangles;
    const double radius = random.Between(0.4, 0.48) * height;
    input.vertices.push_back(At(0.5 * width + radius * std::cos(angle),
                                0.5 * height + radius * std::sin(angle), random.Between(0, 1)));
  }
  for (std::uint32_t i = 0; i < kTriangles; ++i) {
    input.indices.insert(input.indices.end(), {0, 1 + (i + 1) % kTriangles, 1 + i});
  }
  return input;
}

template <KernelInput (*kMake)(int, int, std::uint64_t)>
constexpr KernelSceneKind Kind(std::string_view name, std::string_view summary) {
  return {name, summary, kMake};
}

constexpr std::array kKinds{
    Kind<Tiny>("tiny", "1,000,000 scattered triangles of about 5 px"),
    Kind<Medium>("medium", "20,000 scattered triangles of about 500 px"),
    Kind<Huge>("huge", "200 triangles of about 0.4 of the target"),
    Kind<Sliver>("sliver", "100,000 triangles 100 to 900 px long, 0.05 to 1 px wide"),
    Kind<Partition>("partition", "a jittered grid over the target, triangles of about 20 px"),
    Kind<Torus>("torus", "524,288 triangles of a torus in perspective"),
    Kind<TieGrid>("tie-grid", "triangles of 8 px whose edges all pass through pixel centres"),
    Kind<Fan>("fan", "20,000 slivers at one vertex"),
};

}  // namespace

std::span<const KernelSceneKind> KernelSceneKinds() { return kKinds; }

KernelInput KernelInputFrom(const Scene& scene) {
  if (scene.clip_space || scene.precision != Precision::kFloat32) {
    throw InputError(scene.name, "kernels draw float32 vertices in window space",
                     "give such a scene");
  }
  KernelInput input = Empty(scene.width, scene.height);
  input.name = scene.name;
  for (const Vertex& v : scene.vertices) input.vertices.push_back(At(v.x, v.y, v.z));
  for (const Triangle& t : scene.triangles) {
    for (const auto index : t) input.indices.push_back(static_cast<std::uint32_t>(index));
  }
  return input;
}

Scene SceneFrom(const KernelInput& input) {
  Scene scene;
  scene.name = input.name;
  scene.width = input.width;
  scene.height = input.height;
  scene.vertices.reserve(input.vertices.size());
  for (const KernelVertex& v : input.vertices) {
    Vertex vertex;
    vertex.x = v.x;
    vertex.y = v.y;
    vertex.z = v.z;
    scene.vertices.push_back(vertex);
  }
  for (std::size_t i = 0; i + 2 < input.indices.size(); i += 3) {
    Triangle triangle;
    for (std::size_t k = 0; k < 3; ++k) {
      triangle[k] = static_cast<Triangle::value_type>(input.indices[i + k]);
    }
    scene.triangles.push_back(triangle);
  }
  return scene;
}

}  // namespace rasterproof::bench
