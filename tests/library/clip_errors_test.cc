// What the kernel of clip space computes in double, against exact values: guesses and filters.
#include "library/kernels/clip_errors.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <utility>

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

// A triangle's corners as float32 of the kernel has them, relative to the first pixel of the box,
// and exactly.
struct ProjectedCorners {
  std::array<float, 3> x{}, y{};
  std::array<Rational, 3> exact_x, exact_y;
  bool is_told = false;
  float side = 0;

  explicit ProjectedCorners(const std::array<ClipVertex, 3>& v) {
    std::array<float, 3> reciprocal{};
    float least_x = std::numeric_limits<float>::infinity();
    float least_y = least_x;
    for (std::size_t k = 0; k < 3; ++k) {
      reciprocal[k] = 1 / v[k].w;
      least_x = std::min(least_x, v[k].x * reciprocal[k]);
      least_y = std::min(least_y, v[k].y * reciprocal[k]);
    }
    const float left = std::ceil(least_x - 0.5F);
    const float top = std::ceil(least_y - 0.5F);
    is_told = true;
    for (std::size_t k = 0; k < 3; ++k) {
      x[k] = std::fma(-v[k].w, left, v[k].x) * reciprocal[k];
      y[k] = std::fma(-v[k].w, top, v[k].y) * reciprocal[k];
      exact_x[k] = Rational(v[k].x) / Rational(v[k].w) - Rational(left);
      exact_y[k] = Rational(v[k].y) / Rational(v[k].w) - Rational(top);
      side = std::max(side, std::max(x[k], y[k]));
      const float below = y[k] - 0.5F;
      is_told = is_told && std::fabs(below - std::nearbyint(below)) >= kClipCornerRoom;
    }
  }

  // The largest error of a corner's row over the room that it has.
  double RowError() const {
    double worst = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      worst = std::max(worst, (Rational(y[k]) - exact_y[k]).Abs().ToDouble() / kClipCornerRoom);
    }
    return worst;
  }

  // The largest error over `bound` of guesses of where rows cross the edge from a to c, where they
  // are told, fused or not; `unit` is what they are cut off to, or 0.
  double GuessError(std::size_t a, std::size_t c, float bound, float unit) const {
    if (y[a] > y[c]) std::swap(a, c);
    const float slope = (x[c] - x[a]) / (y[c] - y[a]);
    if (!(std::fabs(slope) <= kClipFloatSlope)) return 0;
    const Rational exact_slope = (exact_x[c] - exact_x[a]) / (exact_y[c] - exact_y[a]);
    double worst = 0;
    for (float row = std::ceil(y[a] - 0.5F); row + 0.5F < y[c]; ++row) {
      const float centre = row + 0.5F;
      const Rational crossing = exact_x[a] + (Rational(centre) - exact_y[a]) * exact_slope;
      for (const std::size_t from : {a, c}) {  // the upper short edge begins at its lower end
        const float start = x[from] + (0.5F + bound);
        for (const float guess :
             {std::fma(centre - y[from], slope, start), (centre - y[from]) * slope + start}) {
          const float kept = unit > 0 ? std::floor(guess * unit) / unit : guess;
          const Rational off = Rational(kept) - Rational(0.5) - Rational(bound) - crossing;
          worst = std::max(worst, off.Abs().ToDouble() / bound);
        }
      }
    }
    return worst;
  }
};

// One in a box of `side` pixels; some of its edges are as flat as is told, some corners near a row.
std::array<ClipVertex, 3> TriangleBeforeTheEye(reference::RandomValues& random, double side) {
  const double left = random.Uniform(0, 1 << 14);
  const double top = random.Uniform(0, 1 << 14);
  const double height = side * std::ldexp(1, -random.Integer(0, 5));
  std::array<ClipVertex, 3> v;
  for (ClipVertex& corner : v) {
    const auto w = static_cast<float>(std::ldexp(1 + random.Uniform(0, 1), random.Integer(-3, 3)));
    corner = {static_cast<float>((left + random.Uniform(0, side)) * w),
              static_cast<float>((top + random.Uniform(0, height)) * w), 0, w};
  }
  return v;
}

constexpr int kSmallBits = std::bit_width(static_cast<unsigned>(kSmallUnit)) - 1;

// The largest error over kClipStepError of where rows cross the edge of two vertices before the
// eye, in steps of fixed point from its first row on, eight lanes at a time.
double StepError(const ClipVertex& vi, const ClipVertex& vj, int height) {
  const double n[3] = {double{vj.y} * vi.w - double{vj.w} * vi.y,
                       double{vj.w} * vi.x - double{vj.x} * vi.w,
                       double{vj.x} * vi.y - double{vj.y} * vi.x};
  const double reciprocal = -1 / n[0];
  const double slope = n[1] * reciprocal;
  const double from = n[2] * reciprocal;
  const double error = kClipCrossingError * (std::fabs(slope) * height + std::fabs(from) + 1);
  if (!(error <= kStepError) || !(std::fabs(slope) < kSteppedSlope)) return 0;
  const double ends[2] = {double{vi.y} / vi.w, double{vj.y} / vj.w};
  const int first = static_cast<int>(std::ceil(std::min(ends[0], ends[1]) - 0.5));
  const int end = static_cast<int>(std::ceil(std::max(ends[0], ends[1]) - 0.5));
  const auto fixed = [](double v) { return static_cast<std::int64_t>(v * 0x1p32); };
  const std::int64_t start = fixed((slope * (first + 0.5) + (from + (0.5 + error))) + kStepError);
  const std::int64_t step = fixed(slope);
  const auto exact = [](const ClipVertex& v, float of) { return Rational(of) / Rational(v.w); };
  const Rational exact_slope =
      (exact(vj, vj.x) - exact(vi, vi.x)) / (exact(vj, vj.y) - exact(vi, vi.y));
  double worst = 0;
  for (int row = first; row < end; ++row) {
    const int lane = (row - first) % 8;
    const std::int64_t guess =
        ((start + (row - first - lane) * step) >> kSmallBits) + ((lane * step) >> kSmallBits);
    const Rational crossing =
        exact(vi, vi.x) + (Rational(row + 0.5) - exact(vi, vi.y)) * exact_slope;
    const Rational off = Rational(static_cast<double>(guess) * 0x1p-16) - Rational(0.5) -
                         Rational(error) - Rational(kStepError) - crossing;
    worst = std::max(worst, off.Abs().ToDouble() / kClipStepError);
  }
  return worst;
}

// The error of a vertex's row in double, over the room that it has.
double RowErrorInDouble(const ClipVertex& v) {
  const Rational off = Rational(v.y * (1 / double{v.w})) - Rational(v.y) / Rational(v.w);
  return off.Abs().ToDouble() / kClipRowRoom;
}

TEST(ClipKernel, FloatGuessesStayWithinTheirErrors) {
  reference::RandomValues random(14);
  double stepped = 0;
  double row_in_double = 0;
  double row = 0;
  double small = 0;
  double near = 0;
  for (int i = 0; i < Cases(RunsMore() ? 1'000'000 : 20'000); ++i) {
    const bool is_small = i % 2 == 0;
    const ProjectedCorners corners(TriangleBeforeTheEye(random, is_small ? 8 : kNearSide));
    if (corners.side > (is_small ? 8.5F : kNearSide + 0.5F)) continue;
    row = std::max(row, corners.RowError());
    if (i % 200 == 0) {
      constexpr double kSide = kSteppedSide;
      const auto vertex = [&] {
        const auto w =
            static_cast<float>(std::ldexp(1 + random.Uniform(0, 1), random.Integer(-8, 8)));
        return ClipVertex{static_cast<float>(random.Uniform(-kSide, kSide) * w),
                          static_cast<float>(random.Uniform(0, kSide) * w), 0, w};
      };
      const ClipVertex vi = vertex();
      const ClipVertex vj = vertex();
      stepped = std::max(stepped, StepError(vi, vj, static_cast<int>(kSide)));
      row_in_double = std::max(row_in_double, RowErrorInDouble(vi));
    }
    if (!corners.is_told) continue;
    for (std::size_t k = 0; k < 3; ++k) {
      const double error = corners.GuessError(
          k, (k + 1) % 3, is_small ? kClipSmallCrossingError : kClipBoxCrossingError,
          is_small ? kSmallUnit : 0);
      double& worst = is_small ? small : near;
      worst = std::max(worst, error);
    }
  }
  std::cout << "largest error / bound: corner's row " << row << ", guess " << small
            << ", of a near triangle " << near << ", stepped " << stepped << ", a row in double "
            << row_in_double << '\n';
  EXPECT_LT(row_in_double, 1);
  EXPECT_GT(row_in_double, 0);
  for (const double worst : {row, small, near, stepped}) {
    EXPECT_LT(worst, 1);
    EXPECT_GT(worst, 0.03) << "the search looks where there is no error";
  }
}

}  // namespace
}  // namespace rasterproof::library::kernels
