#include "bench/edge_cases.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <random>
#include <vector>

#include "bench/case_scene.h"
#include "bench/exact_triangles.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/vertex.h"
#include "props/domains/hardest.h"
#include "props/domains/input_lattice.h"

namespace rasterproof::bench {
namespace {

constexpr int kDraws = 24;
constexpr Point2 kMiddle{1.5, 1.5};  // of a target of 3 x 3

// Random numbers of one value of a parameter: the same on every machine.
class DrawnNumbers {
 public:
  explicit DrawnNumbers(double value) : random_(std::bit_cast<std::uint64_t>(value)) {}
  double Between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_() >> 11) * 0x1p-53;
  }
  int Sign() { return (random_() >> 40) % 2 == 0 ? 1 : -1; }

 private:
  std::mt19937_64 random_;
};

double Single(double x) { return static_cast<double>(static_cast<float>(x)); }
Point2 Single(Point2 p) { return {Single(p.x), Single(p.y)}; }
// What is beyond float32 stays a double.
Point2 Rounded(Point2 p, Precision precision) {
  return precision == Precision::kFloat32 ? Single(p) : p;
}

// a + t (p - a).
Point2 Beyond(Point2 a, Point2 p, double t) {
  return {a.x + t * (p.x - a.x), a.y + t * (p.y - a.y)};
}

// A place near v, nearly on the line through a and p.
Point2 NearestTo(Point2 v, Point2 a, Point2 p, Precision precision, int sign) {
  v = Rounded(v, precision);
  if (v.x == 0 || v.y == 0) return v;
  const props::InputLattice lattice(Profile{}, precision);
  return props::HardestVertex(v, a, p, lattice, sign).value_or(v);
}

// c on the side of the line from a to b that `side` says, `height` from it, beside b.
Point2 Beside(Point2 a, Point2 b, double height, int side) {
  const double length = std::hypot(b.x - a.x, b.y - a.y);
  const double by = side * height / length;
  return {b.x - by * (b.y - a.y), b.y + by * (b.x - a.x)};
}

HardCase WindowCase(Point2 a, Point2 b, Point2 c, bool is_turned, int width, int x) {
  std::array<Point2, 3> v{a, b, c};
  if (is_turned) std::swap(v[1], v[2]);
  const int height = width == 3 ? 3 : 1;
  return {SceneOfTriangle(v, width, height), x, height / 2, 0, std::nullopt};
}

// S / |E| of the edge at p; 0 where E is 0.
double Cancellation(Point2 a, Point2 b, Point2 p) {
  const double l = (p.x - a.x) * (b.y - a.y);
  const double r = (p.y - a.y) * (b.x - a.x);
  const double rounding = std::fma(p.x - a.x, b.y - a.y, -l) - std::fma(p.y - a.y, b.x - a.x, -r);
  const double e = std::fabs((l - r) + rounding);
  return e == 0 ? 0 : (std::fabs(l) + std::fabs(r)) / e;
}

// Of the places around b, up to 16 ulps off, the one whose cancellation is nearest to `ratio`.
Point2 WithCancellation(Point2 b, Point2 a, Point2 p, double ratio) {
  constexpr int kReach = 16;
  Point2 best = b;
  double least = std::numeric_limits<double>::infinity();
  const double step_x = std::ldexp(1.0, std::ilogb(b.x) - 23);
  const double step_y = std::ldexp(1.0, std::ilogb(b.y) - 23);
  for (int i = -kReach; i <= kReach; ++i) {
    for (int j = -kReach; j <= kReach; ++j) {
      const Point2 at = Single(Point2{b.x + i * step_x, b.y + j * step_y});
      const double found = Cancellation(a, at, p);
      const double off = found == 0 ? 1e300 : std::fabs(std::log2(found / ratio));
      if (off >= least) continue;
      least = off;
      best = at;
    }
  }
  return best;
}

// N_ij . (p, 1) of two corners in clip space, rounded to long double: to rank places by.
long double HomogeneousValue(const Vertex& vi, const Vertex& vj, Point2 p) {
  const auto difference = [](long double a, long double b, long double c, long double d) {
    return a * b - c * d;
  };
  return difference(vj.y, vi.w, vj.w, vi.y) * static_cast<long double>(p.x) +
         difference(vj.w, vi.x, vj.x, vi.w) * static_cast<long double>(p.y) +
         difference(vj.x, vi.y, vj.y, vi.x);
}

// The place up to 12 ulps from v for which |N . (p, 1)| with `other` is smallest but not zero.
Vertex NearestRay(const Vertex& v, const Vertex& other, Point2 p) {
  constexpr int kReach = 12;
  Vertex best = v;
  long double least = std::numeric_limits<long double>::infinity();
  const double step_x = std::ldexp(1.0, std::ilogb(v.x) - 23);
  const double step_y = std::ldexp(1.0, std::ilogb(v.y) - 23);
  for (int i = -kReach; i <= kReach; ++i) {
    for (int j = -kReach; j <= kReach; ++j) {
      const Vertex at{Single(v.x + i * step_x), Single(v.y + j * step_y), v.z, v.w};
      const long double value = std::fabs(HomogeneousValue(at, other, p));
      if (value == 0 || value >= least) continue;
      least = value;
      best = at;
    }
  }
  return best;
}

Vertex AtDepth(Point2 p, double w) { return {Single(p.x * w), Single(p.y * w), 0, w}; }

// Upright edges whose dY ends half a unit in the last place of E: every addition of the longest
// binade is a tie and rounds alike. That drifts by n^2 2^-26 pixels after n steps, the most known.
// The sample lies within that of the edge, on either side.
void AddDrifts(int n, std::vector<HardCase>& cases) {
  constexpr double kHeight = 64;
  const double drift = std::ldexp(static_cast<double>(n) * n, -26);
  for (const double units : {2.5, 3.5}) {
    const double below = kHeight * (0.5 + units * std::ldexp(n, -24));
    for (const double part : {-0.95, -0.75, -0.5, -0.25, 0.25, 0.5, 0.75, 0.95}) {
      const double x = Single(n - 0.5 + part * drift);
      HardCase one = WindowCase({x, -kHeight / 2}, {x, Single(below)}, {0.25, 0.5}, false,
                                std::max(n, 4), n - 1);
      one.steps = n - 1;
      cases.push_back(std::move(one));
    }
  }
}

}  // namespace

std::vector<HardCase> NeedleCases(double ratio) {
  constexpr double kLength = 4096;
  std::vector<HardCase> cases;
  DrawnNumbers draw(ratio);
  for (int k = 0; k < kDraws; ++k) {
    const double turn = draw.Between(0.1, 6.2);
    const Point2 a = Single(Point2{kMiddle.x + kLength * std::cos(turn),  //
                                   kMiddle.y + kLength * std::sin(turn)});
    // From 0.3 to 4 pixels behind the sample: small coordinates, so that the width is kept.
    const Point2 guess = Beyond(a, kMiddle, 1 + draw.Between(0.3, 4) / kLength);
    const Point2 b = NearestTo(guess, a, kMiddle, Precision::kFloat32, k % 2 == 0 ? 1 : -1);
    const Point2 c = Single(Beside(a, b, kLength / ratio, draw.Sign()));
    cases.push_back(WindowCase(a, b, c, k % 4 < 2, 3, 1));
  }
  return cases;
}

std::vector<HardCase> DistantCases(double pixels) {
  std::vector<HardCase> cases;
  DrawnNumbers draw(pixels);
  const Point2 p{pixels + 0.5, 0.5};
  const bool is_drawn = pixels < kMaxTargetSide;
  const int x = is_drawn ? static_cast<int>(pixels) : 0;
  for (int k = 0; k < kDraws; ++k) {
    const Point2 a = Single(Point2{p.x + draw.Sign() * draw.Between(4, 20),  //
                                   p.y + draw.Sign() * draw.Between(4, 20)});
    const Point2 guess = Beyond(a, p, draw.Between(1.5, 3));
    const Point2 b = NearestTo(guess, a, p, Precision::kFloat32, k % 2 == 0 ? 1 : -1);
    const Point2 c = Single(Beside(a, b, 16, draw.Sign()));
    HardCase one = WindowCase(a, b, c, k % 4 < 2, is_drawn ? std::max(x + 1, 4) : 4, x);
    one.undrawn = is_drawn ? std::nullopt : std::optional(p);
    cases.push_back(std::move(one));
  }
  return cases;
}

std::vector<HardCase> WalkCases(double columns) {
  std::vector<HardCase> cases;
  const auto n = static_cast<int>(columns);
  const Point2 p{n - 0.5, 0.5};
  DrawnNumbers draw(columns);
  for (int k = 0; k < kDraws; ++k) {
    const Point2 a = Single(Point2{p.x + draw.Between(-0.2, 0.2) / n, p.y - draw.Between(1, 4)});
    const Point2 guess = Beyond(a, p, draw.Between(1.5, 3));
    const Point2 b = NearestTo(guess, a, p, Precision::kFloat32, k % 2 == 0 ? 1 : -1);
    const Point2 c = Single(Point2{draw.Between(0, 0.4), draw.Between(0.2, 0.8)});
    HardCase one = WindowCase(a, b, c, k % 4 < 2, std::max(n, 4), n - 1);
    one.steps = n - 1;
    cases.push_back(std::move(one));
  }
  AddDrifts(n, cases);
  return cases;
}

std::vector<HardCase> GapCases(double ratio) {
  constexpr double kFloat32To = 0x1p120;
  const Precision precision = ratio <= kFloat32To ? Precision::kFloat32 : Precision::kFloat64;
  std::vector<HardCase> cases;
  DrawnNumbers draw(ratio);
  for (int k = 0; k < kDraws; ++k) {
    const double turn = draw.Between(0.1, 6.2);
    const double reach = draw.Between(1, 1.9) * ratio;
    const Point2 a = Rounded({kMiddle.x + reach * std::cos(turn),  //
                              kMiddle.y + reach * std::sin(turn)},
                             precision);
    const Point2 guess{kMiddle.x - std::cos(turn) * draw.Between(0.3, 3),
                       kMiddle.y - std::sin(turn) * draw.Between(0.3, 3)};
    const Point2 b = NearestTo(guess, a, kMiddle, precision, k % 2 == 0 ? 1 : -1);
    const Point2 c = Rounded(Beside(a, b, 3, draw.Sign()), precision);
    cases.push_back(WindowCase(a, b, c, k % 4 < 2, 3, 1));
  }
  return cases;
}

std::vector<HardCase> CancellingCases(double ratio) {
  constexpr int kTries = 400;
  constexpr double kByNumberTheory = 0x1p28;
  std::vector<HardCase> cases;
  DrawnNumbers draw(ratio);
  for (int k = 0; k < kTries && cases.size() < kDraws; ++k) {
    const double turn = draw.Between(0.1, 6.2);
    const Point2 a = Single(Point2{kMiddle.x + draw.Between(3, 30) * std::cos(turn),
                                   kMiddle.y + draw.Between(3, 30) * std::sin(turn)});
    Point2 guess = Beyond(a, kMiddle, draw.Between(1.5, 4));
    const int sign = k % 2 == 0 ? 1 : -1;
    // E / S = (t - 1) / (t + 1) where the first product is t times the other.
    const double t = ratio <= 1 ? 0 : (1 + sign / ratio) / (1 - sign / ratio);
    guess.y = a.y + (guess.y - a.y) * t;
    const Point2 b = ratio < kByNumberTheory
                         ? WithCancellation(Single(guess), a, kMiddle, ratio)
                         : NearestTo(guess, a, kMiddle, Precision::kFloat32, sign);
    const double found = Cancellation(a, b, kMiddle);
    if (!(found >= ratio / 2 && found <= 2 * ratio)) continue;
    const Point2 c = Single(Beside(a, b, 12, draw.Sign()));
    cases.push_back(WindowCase(a, b, c, k % 4 < 2, 3, 1));
  }
  return cases;
}

std::vector<HardCase> ClipCases(double ratio) {
  std::vector<HardCase> cases;
  DrawnNumbers draw(ratio);
  for (int k = 0; k < kDraws; ++k) {
    const Point2 a{kMiddle.x + draw.Sign() * draw.Between(2, 40),
                   kMiddle.y + draw.Sign() * draw.Between(2, 40)};
    const Point2 b = Beyond(a, kMiddle, draw.Between(1.3, 3));
    const Point2 c = Beside(a, b, 12, draw.Sign());
    const bool is_first = k % 3 == 0;
    // Not a power of two: multiplying by one rounds nothing.
    const double w = Single(ratio * draw.Between(1.01, 1.9));
    const Vertex va = AtDepth(a, is_first ? w : Single(draw.Between(1.01, 1.9)));
    const Vertex vb =
        NearestRay(AtDepth(b, is_first ? Single(draw.Between(1.01, 1.9)) : w), va, kMiddle);
    std::array<Vertex, 3> v{va, vb, AtDepth(c, Single(draw.Between(1.01, 1.9)))};
    if (k % 4 < 2) std::swap(v[1], v[2]);
    cases.push_back({SceneOfTriangle(v, 3, 3, true), 1, 1, 0, std::nullopt});
  }
  return cases;
}

}  // namespace rasterproof::bench
