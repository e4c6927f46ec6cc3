// Fails if the compiler fuses a * b + c, in the evaluators or in the kernels that draw.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/reference/random_values.h"
#include "tests/reference/scenes.h"

namespace rasterproof::reference {
namespace {

/// At its own end b the direct form is fl(x y) - fl(x y) = 0 bit by bit; fused, one product keeps
/// what the other rounded away.
int NonZeroAtTheEnd(const std::string& method, RandomValues random) {
  int count = 0;
  for (int n = 0; n < 1000; ++n) {
    const Point2 a{random.LogUniform<float>(-4, 10), random.LogUniform<float>(-4, 10)};
    const Point2 b{random.LogUniform<float>(-4, 10), random.LogUniform<float>(-4, 10)};
    if (FindMethod(method)->edges->Value(a, b, b) != 0) ++count;
  }
  return count;
}

TEST(ContractionTest, UnfusedEdgesVanishAtTheirEndAndFusedOnesDoNot) {
  EXPECT_EQ(NonZeroAtTheEnd("f32-direct", RandomValues(41)), 0);
  EXPECT_EQ(NonZeroAtTheEnd("f64-direct", RandomValues(41)), 0);
  EXPECT_EQ(NonZeroAtTheEnd("f32-kahan", RandomValues(41)), 0);
  EXPECT_GT(NonZeroAtTheEnd("f32-direct-fma", RandomValues(41)), 900);
}

// A kernel that the compiler fused would decide by other values than the evaluator shows. Edges of
// slope one from near a centre: the direct form is an exact tie there, the fused one is not.
TEST(ContractionTest, KernelsDecideByTheValuesTheyShow) {
  RandomValues random(42);
  int differ_from_fused = 0;
  for (int n = 0; n < 400; ++n) {
    const double c = random.Integer(1, 6) + 0.5;
    const auto near = static_cast<float>(c - random.Uniform(0, 1));
    const auto far = static_cast<float>(c + random.Uniform(1, 30));
    const Scene scene = WindowScene(8, 8, {{near, near}, {far, far}, {40, -5}});
    for (const char* const name : {"f32-direct", "f32-direct-fma", "f32-kahan", "f32-affine",
                                   "f32-affine-fma", "f64-direct", "f64-kahan"}) {
      const EdgeEvaluator& edges = *FindMethod(name)->edges;
      const CoverageCounts counts = Draw(scene, name);
      const std::array<Vertex, 3> v = Corners(scene, scene.triangles[0]);
      for (int i = 0; i < 8; ++i) {
        const Point2 p{i + 0.5, i + 0.5};
        const auto e = [&](int a, int b) {
          return edges.Value(WindowPoint(v[static_cast<std::size_t>(a)]),
                             WindowPoint(v[static_cast<std::size_t>(b)]), p);
        };
        // Positive area and the first edge is a left edge; the others are nowhere near.
        ASSERT_GT(edges.Value(WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])), 0);
        const bool inside = p.x >= near && p.x <= far && e(0, 1) >= 0 && e(1, 2) > 0 && e(2, 0) > 0;
        EXPECT_EQ(counts.Count(counts.Index(i, i)), inside ? 1U : 0U) << name;
      }
    }
    if (Draw(scene, "f32-direct") != Draw(scene, "f32-direct-fma")) ++differ_from_fused;
  }
  EXPECT_GT(differ_from_fused, 10);
}

}  // namespace
}  // namespace rasterproof::reference
