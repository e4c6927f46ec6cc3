// Bugs that show in another floating-point mode of the caller alone.
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/float_environment.h"
#include "reference/exact_sign.h"
#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

int ExactSign(Point2 a, Point2 b, Point2 p) {
  const FloatEnvironment sane;
  return reference::EdgeSign(a, b, p);
}

// x y in float32 as a rounded product and what it lost, by Veltkamp's and Dekker's splitting: exact
// if operations round to nearest.
struct Product {
  float rounded;
  float lost;
};
Product Multiply(float x, float y) {
  const auto split = [](float v) {
    const float c = 4097 * v;
    return c - (c - v);
  };
  const float x_high = split(x);
  const float y_high = split(y);
  const float x_low = x - x_high;
  const float y_low = y - y_high;
  const float rounded = x * y;
  return {rounded, ((x_high * y_high - rounded) + x_high * y_low + x_low * y_high) + x_low * y_low};
}

// Each product in two words, where differences are exact and nothing over- or underflows.
int ByTwoWords(Point2 a, Point2 b, Point2 p) {
  const std::array<double, 4> differences{p.x - a.x, b.y - a.y, p.y - a.y, b.x - a.x};
  std::array<float, 4> d{};
  for (std::size_t k = 0; k < d.size(); ++k) {
    const double size = std::fabs(differences[k]);
    if (size != 0 && (size < 0x1p-40 || size > 0x1p40)) return ExactSign(a, b, p);
    d[k] = static_cast<float>(differences[k]);
    if (d[k] != differences[k]) return ExactSign(a, b, p);
  }
  const Product left = Multiply(d[0], d[1]);
  const Product right = Multiply(d[2], d[3]);
  const double e =
      (double{left.rounded} - double{right.rounded}) + (double{left.lost} - double{right.lost});
  return (e > 0) - (e < 0);
}

// Two vertices are equal if their differences are 0: so long as no difference is flushed to 0.
bool HasEqualVertices(const Points& v) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Point2& a = v[i];
    const Point2& b = v[(i + 1) % 3];
    constexpr double kMost = 0x1p100;  // no difference overflows
    if (std::fabs(a.x) > kMost || std::fabs(a.y) > kMost) continue;
    if (std::fabs(b.x) > kMost || std::fabs(b.y) > kMost) continue;
    const float dx = static_cast<float>(b.x) - static_cast<float>(a.x);
    const float dy = static_cast<float>(b.y) - static_cast<float>(a.y);
    if (dx == 0 && dy == 0) return true;
  }
  return false;
}

// Divides before it asks whether there is anything to divide by.
int DividesByTheArea(const Points& v) {
  const auto area = static_cast<float>(ExactSign(v[0], v[1], v[2]));
  const volatile float divisor = area;
  const float reciprocal = 1 / divisor;
  return std::isinf(reciprocal) ? 0 : static_cast<int>(reciprocal);
}

}  // namespace

std::vector<Mutant> ModeMutants() {
  return {
      {.name = "mode-two-words",
       .change = "its products are exact in two words, if operations round to nearest",
       .source = "Shewchuk's predicates on x87 and under directed rounding",
       .stages = RealStages{.sign = ByTwoWords},
       .takes_float_modes = true},
      {.name = "mode-needs-subnormals",
       .change = "vertices are equal if their differences in float32 are 0",
       .source = "libraries linked with -ffast-math flush subnormal numbers in the whole process",
       .stages = RealStages{.drops = HasEqualVertices, .sign = ExactSign},
       .takes_float_modes = true},
      {.name = "mode-traps",
       .change = "it divides by the area of a degenerate triangle before it leaves it out",
       .source = "",
       .stages = RealStages{.sign = ExactSign, .facing = DividesByTheArea},
       .takes_float_modes = true},
  };
}

}  // namespace rasterproof::subjects::mutants
