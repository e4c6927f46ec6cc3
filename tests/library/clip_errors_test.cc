// What the kernel of clip space computes in double, against exact values: guesses and filters.
#include "library/kernels/clip_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iostream>

#include "exact/rational.h"
#include "library/kernels/kernel.h"
#include "tests/reference/random_values.h"
#include "tests/share.h"

namespace rasterproof::library::kernels {
namespace {

using exact::Rational;

// The largest error over its bound of the kernel's guesses of where rows cross edges, and of its
// values of N . (x, y, 1); fused or not.
struct ClipErrors {
  double guess = 0;
  double dot = 0;

  void Measure(const ClipVertex& vi, const ClipVertex& vj, int row, int column, int height) {
    using Three = std::array<Rational, 3>;
    const Three a{Rational(vi.x), Rational(vi.y), Rational(vi.w)};
    const Three b{Rational(vj.x), Rational(vj.y), Rational(vj.w)};
    const Three exact{b[1] * a[2] - b[2] * a[1], b[2] * a[0] - b[0] * a[2],
                      b[0] * a[1] - b[1] * a[0]};
    if (exact[0].Sign() == 0) return;
    const std::array n{exact[0].ToDouble(), exact[1].ToDouble(), exact[2].ToDouble()};
    const double y = row + 0.5;
    const double x = column + 0.5;
    const double reciprocal = -1 / n[0];
    const double slope = n[1] * reciprocal;
    const double from = n[2] * reciprocal;
    const double error = kClipCrossingError * (std::fabs(slope) * height + std::fabs(from) + 1);
    const Rational crossing = -(exact[1] * Rational(y) + exact[2]) / exact[0];
    const double terms[3] = {n[0] * x, n[1] * y, n[2]};
    const double sizes = (std::fabs(terms[0]) + std::fabs(terms[1])) + std::fabs(terms[2]);
    const double dots = (terms[0] + terms[1]) + terms[2];
    const Rational value = exact[0] * Rational(x) + exact[1] * Rational(y) + exact[2];
    dot = std::max(dot, (Rational(dots) - value).Abs().ToDouble() / (kClipDotError * sizes));
    if (!(error < kClipWorstGuess)) return;
    const double offset = from + (0.5 + error);
    for (const double guessed : {slope * y + offset, std::fma(slope, y, offset)}) {
      const Rational off = Rational(guessed) - Rational(0.5) - Rational(error) - crossing;
      guess = std::max(guess, off.Abs().ToDouble() / error);
    }
  }
};

// The same of the near plane's sum: over corners k the z_k, or z_k + w_k, times the opposite edge.
double NearError(const std::array<ClipVertex, 3>& v, bool has_w, double x, double y) {
  double value = 0;
  double sizes = 0;
  Rational exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const ClipVertex& a = v[(k + 1) % 3];
    const ClipVertex& b = v[(k + 2) % 3];
    const double terms[3] = {(double{b.y} * a.w - double{b.w} * a.y) * x,
                             (double{b.w} * a.x - double{b.x} * a.w) * y,
                             double{b.x} * a.y - double{b.y} * a.x};
    const double factor = has_w ? double{v[k].z} + v[k].w : double{v[k].z};
    value += factor * ((terms[0] + terms[1]) + terms[2]);
    sizes += std::fabs(factor) * (std::fabs(terms[0]) + std::fabs(terms[1]) + std::fabs(terms[2]));
    const Rational n = has_w ? Rational(v[k].z) + Rational(v[k].w) : Rational(v[k].z);
    exact += n * ((Rational(b.y) * Rational(a.w) - Rational(b.w) * Rational(a.y)) * Rational(x) +
                  (Rational(b.w) * Rational(a.x) - Rational(b.x) * Rational(a.w)) * Rational(y) +
                  (Rational(b.x) * Rational(a.y) - Rational(b.y) * Rational(a.x)));
  }
  return (Rational(value) - exact).Abs().ToDouble() / (kClipNearError * sizes);
}

// The largest error over its bound of the kernel's guess of where a row crosses the near plane,
// fused or not; nothing where it tells nothing.
double NearGuessError(const std::array<ClipVertex, 3>& v, bool has_w, int row, int height) {
  std::array<double, 3> sum{};
  std::array<double, 3> size{};
  std::array<Rational, 3> exact;
  for (std::size_t k = 0; k < 3; ++k) {
    const ClipVertex& a = v[(k + 1) % 3];
    const ClipVertex& b = v[(k + 2) % 3];
    const std::array n{double{b.y} * a.w - double{b.w} * a.y, double{b.w} * a.x - double{b.x} * a.w,
                       double{b.x} * a.y - double{b.y} * a.x};
    const std::array<Rational, 3> normal{
        Rational(b.y) * Rational(a.w) - Rational(b.w) * Rational(a.y),
        Rational(b.w) * Rational(a.x) - Rational(b.x) * Rational(a.w),
        Rational(b.x) * Rational(a.y) - Rational(b.y) * Rational(a.x)};
    const double factor = has_w ? double{v[k].z} + v[k].w : double{v[k].z};
    for (std::size_t c = 0; c < 3; ++c) {
      sum[c] += factor * n[c];
      size[c] += std::fabs(factor * n[c]);
      exact[c] += (has_w ? Rational(v[k].z) + Rational(v[k].w) : Rational(v[k].z)) * normal[c];
    }
  }
  if (exact[0].Sign() == 0) return 0;
  const double y = row + 0.5;
  const double reciprocal = -1 / sum[0];
  const double slope = sum[1] * reciprocal;
  const double from = sum[2] * reciprocal;
  const double unit = std::fabs(slope) * height + std::fabs(from) + 1;
  const double sizes = size[0] * unit + (size[1] * height + size[2]);
  const double error =
      unit * kClipCrossingError + sizes * std::fabs(reciprocal) * kClipNearCrossingError;
  if (!(error < kClipWorstGuess)) return 0;
  const Rational crossing = -(exact[1] * Rational(y) + exact[2]) / exact[0];
  const double offset = from + (0.5 + error);
  double worst = 0;
  for (const double guessed : {slope * y + offset, std::fma(slope, y, offset)}) {
    const Rational off = Rational(guessed) - Rational(0.5) - Rational(error) - crossing;
    worst = std::max(worst, off.Abs().ToDouble() / error);
  }
  return worst;
}

TEST(ClipKernel, GuessesAndFiltersStayWithinTheirErrors) {
  reference::RandomValues random(13);
  ClipErrors errors;
  double near = 0;
  double near_guess = 0;
  for (int i = 0; i < Cases(RunsMore() ? 2'000'000 : 40'000); ++i) {
    const auto vertex = [&] {
      const auto w = static_cast<float>(std::ldexp(random.Uniform(-1, 1), random.Integer(-8, 8)));
      return ClipVertex{static_cast<float>(random.Uniform(-2, 4) * 100 * w),
                        static_cast<float>(random.Uniform(-2, 4) * 100 * w),
                        static_cast<float>(random.Uniform(-1, 1) * w), w};
    };
    near = std::max(near, NearError({vertex(), vertex(), vertex()}, i % 2 == 0,
                                    random.Integer(0, 99) + 0.5, random.Integer(0, 99) + 0.5));
    errors.Measure(vertex(), vertex(), random.Integer(0, 99), random.Integer(0, 99), 100);
    near_guess = std::max(near_guess, NearGuessError({vertex(), vertex(), vertex()}, i % 2 == 0,
                                                     random.Integer(0, 99), 100));
  }
  std::cout << "largest error / bound: guess " << errors.guess << ", filter " << errors.dot
            << ", of the near plane " << near_guess << ", " << near << '\n';
  EXPECT_LT(errors.guess, 1);
  EXPECT_LT(errors.dot, 1);
  EXPECT_GT(errors.guess, 0.05) << "the search looks where there is no error";
  EXPECT_GT(errors.dot, 0.2);
  EXPECT_LT(near, 1);
  EXPECT_GT(near, 0.1);
  EXPECT_LT(near_guess, 1);
  EXPECT_GT(near_guess, 0.05) << "the search looks where there is no error";
}

}  // namespace
}  // namespace rasterproof::library::kernels
