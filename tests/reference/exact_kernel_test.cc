// The exact kernel on every domain, sink and instruction set, against the oracle.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>

#include "core/coverage.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "reference/kernels/crossing_errors.h"
#include "reference/kernels/kernel.h"
#include "reference/kernels/kernel_table.h"
#include "tests/props/faulty_subjects.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference::kernels {
namespace {

struct Given {
  std::vector<KernelVertex> vertices;
  std::vector<std::uint32_t> indices;
  KernelScene View(const Scene& scene) const {
    return {vertices, indices, scene.width, scene.height};
  }
};

Given GivenOf(const Scene& scene) {
  Given given;
  for (const Vertex& v : scene.vertices) {
    given.vertices.push_back(
        {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)});
  }
  for (const Triangle& t : scene.triangles) {
    for (const std::int32_t index : t) given.indices.push_back(static_cast<std::uint32_t>(index));
  }
  return given;
}

// The rows from `first` to before `last` alone.
void DrawBand(Target target, const KernelScene& scene, int first, int last, Surface& surface) {
  KernelView view{};
  view.vertices = &scene.vertices.data()->x;
  view.indices = scene.indices.data();
  view.triangles = scene.indices.size() / 3;
  view.width = scene.width;
  view.height = last;
  view.planes[0] = surface.plane(0);
  view.planes[1] = surface.plane(1);
  view.pitch = surface.pitch();
  view.first_row = first;
  DrawExact(target, surface.sink(), view);
}

void ExpectCounts(Surface& surface, const CoverageCounts& expected, const std::string& name) {
  for (int y = 0; y < surface.height(); ++y) {
    for (int x = 0; x < surface.width(); ++x) {
      const std::size_t k = expected.Index(x, y, 0);
      const std::uint64_t counts = expected.front[k] | std::uint64_t{expected.back[k]} << 32;
      ASSERT_EQ(surface.At(x, y), counts) << name << " (" << x << ", " << y << ")";
    }
  }
}

// Whole, and in two bands.
void ExpectExact(const Scene& scene, const std::string& name) {
  const Given given = GivenOf(scene);
  const CoverageCounts expected = exact::Coverage(scene, Profile{});
  for (const Target target : SupportedTargets()) {
    const std::string where = name + " " + std::string(NameOf(target));
    Surface surface(Sink::kFacing, scene.width, scene.height);
    Draw(KernelMethod::kExact, target, given.View(scene), surface);
    ExpectCounts(surface, expected, where);
    surface.Clear();
    const int middle = scene.height / 2;
    if (middle > 0) DrawBand(target, given.View(scene), 0, middle, surface);
    DrawBand(target, given.View(scene), middle, scene.height, surface);
    ExpectCounts(surface, expected, where + " in bands");
  }
}

TEST(ExactKernel, EqualsTheOracleOnEveryDomain) {
  const SubjectInfo info = props::testing::RealInfo();
  for (const props::Domain& domain : props::Domains()) {
    if (domain.clip) continue;
    for (int i = 0; i < Cases(60); ++i) {
      props::PhiloxSource bits(1, static_cast<std::uint64_t>(i));
      const Case c = domain.draw(bits, info);
      if (c.scene.clip_space || c.scene.precision != Precision::kFloat32) continue;
      if (static_cast<std::int64_t>(c.scene.width) * c.scene.height > 1 << 16) continue;
      ExpectExact(c.scene, std::string(domain.name) + ":" + std::to_string(i));
      if (HasFatalFailure()) return;
    }
  }
}

// Edges that miss a pixel centre by less than a guess is off, in each tier: the far end of an edge
// through a vertex and a centre, rounded to float.
TEST(ExactKernel, EqualsTheOracleWhereEdgesMissCentres) {
  RandomValues random(84);
  // Small, near, in steps, in double.
  struct Tier {
    int side;
    double left;
  };
  for (const auto& [side, left] : {Tier{6, 0}, Tier{48, 0}, Tier{200, 0}, Tier{200, 20000}}) {
    for (int i = 0; i < Cases(60); ++i) {
      Scene scene;
      scene.width = scene.height = side;
      for (int t = 0; t < 64; ++t) {
        const auto within = [&] { return random.Uniform(0, side); };
        const double x = std::floor(within()) + 0.5;
        const double y = std::floor(within()) + 0.5;
        const Vertex a{.x = static_cast<float>(within() - left), .y = static_cast<float>(within())};
        const double far = random.Uniform(1, 2);
        const double end_x = std::clamp(a.x + far * (x - a.x), 0.0, static_cast<double>(side));
        const double end_y = y == a.y ? y : a.y + (end_x - a.x) * (y - a.y) / (x - a.x);
        const Vertex b{.x = static_cast<float>(end_x), .y = static_cast<float>(end_y)};
        const Vertex c{.x = static_cast<float>(within()), .y = static_cast<float>(within())};
        const auto first = static_cast<std::int32_t>(scene.vertices.size());
        scene.vertices.insert(scene.vertices.end(), {a, b, c});
        scene.triangles.push_back({first, first + 1, first + 2});
      }
      ExpectExact(scene, std::to_string(side) + (left > 0 ? " far:" : ":") + std::to_string(i));
      if (HasFatalFailure()) return;
    }
  }
}

// The kernel's formula for one edge and row, in T, fused or not: what it is off.
template <class T>
double GuessError(const std::array<float, 4>& edge, double row, T error, bool fused) {
  const auto [ax, ay, cx, cy] = edge;
  const T slope = (T{cx} - T{ax}) / (T{cy} - T{ay});
  const T from = T{ax} + (T{0.5} + error);
  const T down = static_cast<T>(row) - T{ay};
  const T guess = fused ? std::fma(down, slope, from) : down * slope + from;
  using Long = long double;  // 64 bits: a product of differences of floats and a quotient
  const Long crossing =
      Long{ax} + (Long{row} - Long{ay}) * (Long{cx} - Long{ax}) / (Long{cy} - Long{ay});
  return static_cast<double>(std::fabs(Long{guess} - Long{0.5} - Long{error} - crossing));
}

// Of edges with both ends within [least, most], the largest error over its bound.
template <class T>
double WorstGuess(double least, double most, T error, std::uint64_t seed) {
  RandomValues random(seed);
  double worst = 0;
  for (int i = 0; i < Cases(400'000); ++i) {
    std::array<float, 4> edge{};
    for (float& v : edge) v = static_cast<float>(random.Uniform(least, most));
    if (i % 4 == 0) edge[3] = std::nextafterf(edge[1], 1e9F);  // flat
    if (i % 4 == 1) edge[2] = edge[0] + static_cast<float>(random.Uniform(-1e-3, 1e-3));
    if (!(edge[1] < edge[3])) continue;
    const double row = std::floor(random.Uniform(edge[1], edge[3])) + 0.5;
    if (!(row >= double{edge[1]} && row < double{edge[3]})) continue;
    for (const bool fused : {false, true}) {
      worst = std::max(worst, GuessError<T>(edge, row, error, fused) / double{error});
    }
  }
  return worst;
}

TEST(ExactKernel, GuessesStayWithinTheirErrors) {
  // Before it is cut off, for which there is half of it.
  const double small = WorstGuess<float>(-0.5, 8.5, kSmallCrossingError / 2, 81);
  const double near = WorstGuess<float>(-0.5, 64.5, kNearCrossingError, 82);
  const double wide =
      WorstGuess<double>(-double{kGuessDomain}, double{kGuessDomain}, kCrossingError, 83);
  std::cout << "largest error / bound: small " << small << ", near " << near << ", wide " << wide
            << '\n';
  EXPECT_LT(small, 1);
  EXPECT_LT(near, 1);
  EXPECT_LT(wide, 1);
  EXPECT_GT(small, 0.05) << "the search looks where there is no error";
  EXPECT_GT(near, 0.05);
  EXPECT_GT(wide, 0.02);
}

}  // namespace
}  // namespace rasterproof::reference::kernels
