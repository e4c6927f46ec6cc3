#include "subjects/mutants/rounded_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <limits>
#include <vector>

namespace rasterproof::subjects::mutants {
namespace {

// A sum of doubles that do not overlap, the smallest first. Products of nine floats neither
// overflow nor underflow in it.
//
// Source: Shewchuk, "Adaptive precision floating-point arithmetic and fast robust geometric
//         predicates" (1997), grow-expansion and scale-expansion.
class ExactSum {
 public:
  void Add(double x) {
    for (double& part : parts_) {
      const double sum = x + part;
      const double virtual_part = sum - x;
      part = (x - (sum - virtual_part)) + (part - virtual_part);
      x = sum;
    }
    parts_.push_back(x);
    std::erase(parts_, 0.0);
  }
  void Add(const ExactSum& other) {
    for (const double part : other.parts_) Add(part);
  }
  ExactSum Times(double factor) const {
    ExactSum product;
    for (const double part : parts_) {
      const double high = part * factor;
      product.Add(std::fma(part, factor, -high));
      product.Add(high);
    }
    return product;
  }
  int Sign() const { return parts_.empty() ? 0 : parts_.back() > 0 ? 1 : -1; }
  double Approximately() const {
    double sum = 0;
    for (const double part : parts_) sum += part;
    return sum;
  }

 private:
  std::vector<double> parts_;
};

ExactSum Product(std::initializer_list<double> factors) {
  ExactSum product;
  product.Add(1);
  for (const double factor : factors) product = product.Times(factor);
  return product;
}

ExactSum ExactBeta(const HomogeneousCorner& a, const HomogeneousCorner& b, Point2 p) {
  ExactSum beta;
  for (const auto& factors :
       {std::array{a.y, b.w, p.x}, std::array{-a.w, b.y, p.x}, std::array{a.w, b.x, p.y},
        std::array{-a.x, b.w, p.y}, std::array{a.x, b.y, 1.0}, std::array{-a.y, b.x, 1.0}})
    beta.Add(Product({factors[0], factors[1], factors[2]}));
  return beta;
}

// The sign of n / d - x.
int SignOfDifference(const ExactSum& n, const ExactSum& d, double x) {
  ExactSum difference = n;
  difference.Add(d.Times(-x));
  return difference.Sign() * d.Sign();
}

bool IsEven(float x) { return (std::bit_cast<std::uint32_t>(x) & 1U) == 0; }

float RoundedQuotient(const ExactSum& n, const ExactSum& d) {
  constexpr float kInfinity = std::numeric_limits<float>::infinity();
  const auto guess = static_cast<float>(n.Approximately() / d.Approximately());
  if (!std::isfinite(guess)) return guess;
  for (const float away : {-kInfinity, kInfinity}) {
    const float next = std::nextafter(guess, away);
    if (!std::isfinite(next)) continue;
    const double middle = (static_cast<double>(guess) + static_cast<double>(next)) / 2;
    const int beyond = SignOfDifference(n, d, middle) * (away > 0 ? 1 : -1);
    if (beyond > 0 || (beyond == 0 && !IsEven(guess))) return next;
  }
  return guess;
}

}  // namespace

float CorrectlyRounded(const ValueQuestion& q) {
  if (!std::ranges::all_of(q.a, [](double x) { return std::isfinite(x); }))
    return std::numeric_limits<float>::quiet_NaN();
  ExactSum n, d;
  for (std::size_t i = 0; i < 3; ++i) {
    const ExactSum beta = ExactBeta(q.v[(i + 1) % 3], q.v[(i + 2) % 3], q.at);
    const ExactSum times_w = beta.Times(q.v[i].w);
    n.Add((q.interpolation == Interpolation::kLinear ? times_w : beta).Times(q.a[i]));
    d.Add(q.IsPerspective() ? beta : times_w);
  }
  if (d.Sign() == 0) return std::numeric_limits<float>::quiet_NaN();
  return RoundedQuotient(n, d);
}

}  // namespace rasterproof::subjects::mutants
