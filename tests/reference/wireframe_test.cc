#include "reference/wireframe.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>

#include "exact/rational.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::reference {
namespace {

using exact::Rational;

constexpr std::array kCoordinates{&Point3::x, &Point3::y, &Point3::z};

TEST(ReconstructVerticesTest, FindsTheTriangleOfAShadedPoint) {
  // A = (1, 2, 3), B = (5, 2, 3), C = (1, 4, 11), u = 1/4, v = 1/2.
  const SurfacePoint point{{2, 3, 7}, 0.25, 0.5, {4, 0, 0}, {0, 2, 8}};
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    const auto v = ReconstructVertices(precision, point);
    EXPECT_EQ(v[0], (Point3{1, 2, 3}));
    EXPECT_EQ(v[1], (Point3{5, 2, 3}));
    EXPECT_EQ(v[2], (Point3{1, 4, 11}));
    const auto l = UnsignedBarycentrics(precision, v, point.p);
    EXPECT_NEAR(l[0], 0.25, 1e-6);
    EXPECT_NEAR(l[1], 0.25, 1e-6);
    EXPECT_NEAR(l[2], 0.5, 1e-6);
  }
}

TEST(ReconstructVerticesTest, AnotherParametrisationGivesAnotherTriangle) {
  // Had the renderer meant P = u A + v B + (1 - u - v) C, the same numbers would not lead back to
  // A.
  const SurfacePoint point{{0.25, 0.5, 0}, 0.25, 0.5, {1, 0, 0}, {0, 1, 0}};
  SurfacePoint swapped = point;
  std::swap(swapped.u, swapped.v);
  EXPECT_EQ(ReconstructVertices(Precision::kFloat64, point)[0], (Point3{0, 0, 0}));
  EXPECT_NE(ReconstructVertices(Precision::kFloat64, swapped)[0], (Point3{0, 0, 0}));
}

TEST(ReconstructVerticesTest, StaysWithinItsBounds) {
  for (const Precision precision : {Precision::kFloat32, Precision::kFloat64}) {
    RandomValues random(21);
    double worst = 0;
    const auto value = [&](int low, int high) {
      return precision == Precision::kFloat32 ? double{random.LogUniform<float>(low, high)}
                                              : random.LogUniform<double>(low, high);
    };
    for (int n = 0; n < Cases(3000); ++n) {
      const int spread = n % 3 == 0 ? 60 : 4;
      const auto point3 = [&] {
        return Point3{value(-spread, spread), value(-spread, spread), value(-spread, spread)};
      };
      const SurfacePoint s{point3(), value(-4, 0), value(-4, 0), point3(), point3()};
      const auto computed = ReconstructVertices(precision, s);
      const auto bounds = ReconstructionErrorBounds(precision, s);
      for (double Point3::* c : kCoordinates) {
        const Rational a =
            Rational(s.p.*c) - Rational(s.u) * (s.dpdu.*c) - Rational(s.v) * (s.dpdv.*c);
        const std::array<Rational, 3> exact{a, a + (s.dpdu.*c), a + (s.dpdv.*c)};
        for (std::size_t i = 0; i < 3; ++i) {
          const Rational error = (Rational(computed[i].*c) - exact[i]).Abs();
          ASSERT_LE(error, Rational(bounds[i].*c));
          worst = std::max(worst, (error / (bounds[i].*c)).ToDouble());
        }
      }
    }
    EXPECT_GT(worst, 0.5);
  }
}

TEST(ReconstructVerticesTest, StatesNothingWhereACoordinateOverflows) {
  const double huge = std::numeric_limits<double>::max();
  const SurfacePoint s{{huge, 0, 0}, -1, 0, {huge, 0, 0}, {0, 0, 0}};
  const auto bounds = ReconstructionErrorBounds(Precision::kFloat64, s);
  EXPECT_TRUE(std::isnan(bounds[0].x));
  EXPECT_FALSE(std::isnan(bounds[0].y));
}

TEST(UnsignedBarycentricsTest, AnOutsidePointLooksLikeAnInsideOne) {
  const std::array<Point3, 3> v{Point3{0, 0, 0}, Point3{4, 0, 0}, Point3{0, 4, 0}};
  const auto l = UnsignedBarycentrics(Precision::kFloat64, v, {2, -1, 0});
  EXPECT_EQ(l, (std::array<double, 3>{0.75, 0, 0.25}));  // signed: (3/4, 1/2, -1/4)
}

}  // namespace
}  // namespace rasterproof::reference
