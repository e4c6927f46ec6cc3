// What the correctly rounded values of the library may be off before they are rounded: lines by
// their reach, against rationals.
#define HWY_COMPILE_ONLY_SCALAR
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "exact/rational.h"
#include "library/kernels/nearest_spans.h"
#include "library/kernels/value_errors.h"
#include "library/kernels/value_set_up.h"
#include "library/kernels/value_table.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof {
namespace {

namespace kernels = library::kernels;
namespace scalar = kernels::HWY_NAMESPACE;
using exact::Rational;

struct NearestCase {
  std::array<double, 3> x, y, w, a;
  int left, top, row, column;
};

// As far as floats go, near and far from the pixel that places are counted from.
NearestCase DrawnNearest(reference::RandomValues& random) {
  NearestCase c{};
  c.left = random.Integer(0, 65535);
  c.top = random.Integer(0, 65535);
  const int size = 1 << random.Integer(0, 12);
  c.column = c.left + random.Integer(-size, size);
  c.row = c.top + random.Integer(0, size);
  for (std::size_t k = 0; k < 3; ++k) {
    c.w[k] = static_cast<float>(std::ldexp(random.Uniform(-1, 2), random.Integer(-30, 30)));
    c.x[k] = static_cast<float>((c.left + random.Uniform(-1, 1) * size) * c.w[k]);
    c.y[k] = static_cast<float>((c.top + random.Uniform(-1, 1) * size) * c.w[k]);
    c.a[k] = static_cast<float>(std::ldexp(random.Uniform(-1, 1), random.Integer(-90, 90)));
  }
  return c;
}

// sum beta_i f_i, exactly.
Rational ExactLine(const NearestCase& c, const std::array<Rational, 3>& f) {
  Rational sum;
  const Rational px(c.column + 0.5);
  const Rational py(c.row + 0.5);
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    const std::size_t k = (i + 2) % 3;
    const auto of = [](double v) { return Rational(v); };
    const Rational beta = (of(c.y[j]) * of(c.w[k]) - of(c.w[j]) * of(c.y[k])) * px +
                          (of(c.w[j]) * of(c.x[k]) - of(c.x[j]) * of(c.w[k])) * py +
                          (of(c.x[j]) * of(c.y[k]) - of(c.y[j]) * of(c.x[k]));
    sum = sum + beta * f[i];
  }
  return sum;
}

double ShareOfError(const scalar::RowLine& line, int x, const Rational& exact) {
  const Rational off = (Rational(line.At(x + 0.5)) - exact).Abs();
  if (line.error == 0) return off.Sign() == 0 ? 0 : 2;
  return (off / Rational(line.error)).ToDouble();
}

TEST(NearestValues, LinesStayWithinTheirReach) {
  double largest = 0;
  reference::RandomValues random(7);
  for (int n = 0; n < Cases(20'000); ++n) {
    const NearestCase c = DrawnNearest(random);
    const bool is_linear = n % 2 != 0;
    kernels::ValueSetUp t{};
    std::array<Rational, 3> f;
    std::array<Rational, 3> g;
    for (std::size_t k = 0; k < 3; ++k) {
      t.x[k] = c.x[k];
      t.y[k] = c.y[k];
      t.w[k] = c.w[k];
      g[k] = Rational(is_linear ? c.w[k] : 1);
      f[k] = Rational(c.a[k]) * g[k];
    }
    scalar::MoveCorners(c.left, c.top, t);
    scalar::SetUpCorners<true>(!is_linear, t);
    kernels::ReachLine line{};
    for (std::size_t k = 0; k < 3; ++k) {
      scalar::AddLine<true>(t.beta[k], is_linear ? c.a[k] * c.w[k] : c.a[k], line);
    }
    const scalar::LocalSpan at(t, c.row, c.column, c.column + 1);
    const double share = std::max(ShareOfError(scalar::RowOf(line, at), at.x0, ExactLine(c, f)),
                                  ShareOfError(scalar::RowOf(t.d, at), at.x0, ExactLine(c, g)));
    ASSERT_LE(share, 1) << n;
    largest = std::max(largest, share);
  }
  std::printf("largest error / bound of a line: %.3f\n", largest);
  EXPECT_GT(largest, 0.05);
}

}  // namespace
}  // namespace rasterproof
