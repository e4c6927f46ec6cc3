#include "bench/grid_cases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "bench/case_scene.h"
#include "core/vertex.h"

namespace rasterproof::bench {
namespace {

__extension__ using Int128 = __int128;

// A place relative to the sample, in steps.
struct Offset {
  Int128 x = 0;
  Int128 y = 0;
};
using Offsets = std::array<Offset, 3>;

// Cases on one grid: a sample of a square target, corners relative to it.
class GridSheet {
 public:
  // The sample in the middle, or in the last pixel: far from the origin.
  GridSheet(double step, int side) : GridSheet(step, side, side / 2) {}
  GridSheet(double step, int side, int pixel) : step_(step), side_(side), pixel_(pixel) {}

  // The triangle and its images about the sample: mirrored either way, and transposed.
  void Add(const Offsets& corners, bool transposed) {
    for (const int swap : {0, 1}) {
      if (swap == 1 && !transposed) continue;
      for (const int sx : {-1, 1}) {
        for (const int sy : {-1, 1}) AddImage(corners, swap == 1, sx, sy);
      }
    }
  }
  std::vector<HardCase> Take() { return std::move(cases_); }

 private:
  void AddImage(const Offsets& corners, bool is_swapped, int sx, int sy) {
    const double middle = pixel_ + 0.5;
    std::array<Point2, 3> v;
    for (std::size_t k = 0; k < 3; ++k) {
      const Offset& at = corners[k];
      v[k] = {middle + sx * step_ * static_cast<double>(is_swapped ? at.y : at.x),
              middle + sy * step_ * static_cast<double>(is_swapped ? at.x : at.y)};
    }
    cases_.push_back({SceneOfTriangle(v, side_, side_), pixel_, pixel_, 0, std::nullopt});
  }

  double step_;
  int side_;
  int pixel_;
  std::vector<HardCase> cases_;
};

// The inverse of b modulo m; nothing if they share a factor.
std::optional<Int128> InverseModulo(Int128 b, Int128 m) {
  Int128 r0 = m, r1 = b, t0 = 0, t1 = 1;
  while (r1 != 0) {
    const Int128 q = r0 / r1;
    r0 -= q * r1;
    std::swap(r0, r1);
    t0 -= q * t1;
    std::swap(t0, t1);
  }
  if (r0 != 1) return std::nullopt;
  return t0 < 0 ? t0 + m : t0;
}

// Edges of the direction m (wide, high) that pass the sample at E = +-m units. m = 2 where corners
// lie on every second place of the grid that samples are on: then u and v are odd.
void AddNearest(GridSheet& sheet, Int128 wide, Int128 high, Int128 m, bool transposed) {
  const auto inverse = InverseModulo(high, wide);
  if (!inverse) return;
  for (const Int128 e : {Int128{1}, Int128{-1}}) {
    for (Int128 k = 0; k < m; ++k) {
      const Int128 u = (e == 1 ? *inverse : wide - *inverse) + k * wide;
      const Int128 v = (u * high - e) / wide;
      if (m == 2 && (u % 2 == 0 || v % 2 == 0)) continue;
      const Offset a{-u, -v};
      const Offset b{m * wide - u, m * high - v};
      // The third corner on either side: the edge is evaluated from either end.
      sheet.Add({a, b, Offset{b.x, a.y}}, transposed);
      sheet.Add({a, b, Offset{a.x, b.y}}, transposed);
    }
  }
}

// The sample as far from the origin as the box allows, where that is no large target: what takes
// coordinates for themselves, not their differences, finds no harder one.
void AddFarFromOrigin(double steps, double step, Int128 m, std::vector<HardCase>& cases) {
  constexpr int kLargestTarget = 64;
  const double pixels = std::floor(steps * step);
  if (pixels < 4 || pixels > kLargestTarget) return;
  const auto side = static_cast<int>(pixels);
  GridSheet sheet(step / static_cast<double>(m), side, side - 1);
  const auto n = static_cast<Int128>(steps);
  AddNearest(sheet, n, n - 1, m, false);
  for (HardCase& one : sheet.Take()) cases.push_back(std::move(one));
}

}  // namespace

std::vector<HardCase> GridCases(double steps, int bits) {
  const auto n = static_cast<Int128>(steps);
  if (n < 3) return {};
  // Samples lie on the grid from 1/2 pixel on.
  const Int128 m = bits == 0 ? 2 : 1;
  GridSheet sheet(std::ldexp(1.0, -std::max(bits, 1)), 3);
  const auto part = [&](double of) { return static_cast<Int128>(std::floor(steps * of)); };
  AddNearest(sheet, n, n - 1, m, true);
  for (const Int128 high : {n - 2, n - 3, part(0.75) + 1, part(0.618) + 1, part(0.5) + 1}) {
    if (high > 0 && high < n) AddNearest(sheet, n, high, m, false);
  }
  const Int128 near = m == 2 ? 1 : 0;
  const Int128 far = m * n - near;
  // The sample is the right angle's corner (or next to it): E of the edge opposite is n^2.
  sheet.Add({Offset{-near, -near}, Offset{far, -near}, Offset{-near, far}}, false);
  sheet.Add({Offset{-near, -near}, Offset{-near, far}, Offset{far, -near}}, false);
  // The sample is a corner at the long edge's end.
  sheet.Add({Offset{-near, -near}, Offset{far, far}, Offset{far, -near}}, false);
  sheet.Add({Offset{-near, -near}, Offset{far, far}, Offset{-near, far}}, false);
  std::vector<HardCase> cases = sheet.Take();
  AddFarFromOrigin(steps, std::ldexp(1.0, -bits), m, cases);
  return cases;
}

std::vector<HardCase> ValueCases(double steps) {
  const auto n = static_cast<Int128>(steps);
  if (n < 3) return {};
  GridSheet sheet(0x1p-8, 3);
  sheet.Add({Offset{0, 0}, Offset{n, 0}, Offset{0, n}}, true);
  // u dY - v dX = n n - 1.
  sheet.Add({Offset{-n, -1}, Offset{1 - n, n - 1}, Offset{0, 0}}, true);
  sheet.Add({Offset{-n, -1}, Offset{1 - n, n - 1}, Offset{0, n - 1}}, true);
  return sheet.Take();
}

std::vector<HardCase> ExtentCases(double pixels) {
  const auto n = static_cast<Int128>(pixels);
  if (n < 12) return {};
  std::vector<HardCase> cases;
  for (const int side : {1, 3}) {
    GridSheet sheet(0.5, side);  // half pixels: 2 n wide
    const Int128 w = 2 * n;
    // Far from the edge opposite to a right angle, and to a sharp one.
    sheet.Add({Offset{1, 1}, Offset{1 - w, 1}, Offset{1, 1 - w}}, false);
    sheet.Add({Offset{1, 3}, Offset{1 - w, -1}, Offset{-1, 3 - w}}, true);
    // Wide and ten pixels high: the sample in the middle, near the base, near the tip.
    const Int128 half = 2 * (n / 2) - 1;
    for (const Int128 left : {-half, 5 - w, Int128{-5}}) {
      sheet.Add({Offset{left, -9}, Offset{left + w, 1}, Offset{left, 11}}, true);
    }
    // All round the sample.
    sheet.Add({Offset{-half, half}, Offset{1, -half}, Offset{w - half, half}}, true);
    for (HardCase& one : sheet.Take()) cases.push_back(std::move(one));
  }
  return cases;
}

}  // namespace rasterproof::bench
