// Passes over the numbers of a case.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "props/shrink/cost.h"
#include "props/shrink/passes.h"

namespace rasterproof::props {
namespace {

constexpr std::array<int, 8> kMantissaBits{1, 2, 3, 5, 8, 12, 18, 24};

// x with its mantissa cut to `bits` bits: on its own side of zero, never larger, so never beyond
// the precision's range.
double Shortened(double x, int bits) {
  if (x == 0 || !std::isfinite(x)) return x;
  int exponent = 0;
  const double mantissa = std::frexp(x, &exponent);
  return std::ldexp(std::trunc(std::ldexp(mantissa, bits)), exponent - bits);
}

double ToHalfPixel(double x) { return std::floor(x) + 0.5; }

using Member = double Vertex::*;
constexpr std::array<Member, 4> kMembers{&Vertex::x, &Vertex::y, &Vertex::z, &Vertex::w};

// Every x and y at once, by one rule; a coordinate that would not be simpler stays.
template <class Rule>
void TryEverywhere(Attempts& attempts, Rule rule) {
  Case c = attempts.Current();
  for (Vertex& v : c.scene.vertices) {
    for (double* x : {&v.x, &v.y}) {
      const double simpler = rule(*x);
      if (CoordinateCost(simpler) < CoordinateCost(*x)) *x = simpler;
    }
  }
  attempts.Try(std::move(c));
}

void TryWindowSpace(Attempts& attempts) {
  Case c = attempts.Current();
  if (!c.scene.clip_space) return;
  c.scene.clip_space = false;
  for (Vertex& v : c.scene.vertices) {
    if (v.w != 1) return;
  }
  attempts.Try(std::move(c));
}

bool TryCoordinate(Attempts& attempts, std::size_t vertex, Member member, double value) {
  const Case& current = attempts.Current();
  if (CoordinateCost(value) >= CoordinateCost(current.scene.vertices[vertex].*member) &&
      !(member == &Vertex::w && value == 1)) {
    return false;
  }
  Case c = current;
  c.scene.vertices[vertex].*member = value;
  return attempts.Try(std::move(c));
}

}  // namespace

std::vector<double> SimplerCoordinates(double x) {
  if (!std::isfinite(x)) return {0.0, 1.0, std::numeric_limits<double>::infinity()};
  std::vector<double> simpler{0.0, 1.0};
  constexpr double kWholeFrom = 0x1p52;  // larger numbers have no fraction
  if (std::fabs(x) < kWholeFrom) {
    simpler.insert(simpler.end(), {std::trunc(x), std::floor(x), std::ceil(x), ToHalfPixel(x)});
    for (const int places : {1, 2, 4, 8}) {
      simpler.push_back(std::ldexp(std::nearbyint(std::ldexp(x, places)), -places));
    }
  }
  for (const int bits : kMantissaBits) simpler.push_back(Shortened(x, bits));
  simpler.push_back(std::fabs(x));
  // Half the exponent, for numbers far from 1.
  if (x != 0) {
    simpler.push_back(std::copysign(std::ldexp(1.0, std::ilogb(x) / 2), x));
    simpler.push_back(std::ilogb(x) > 0 ? x / 2 : x * 2);
  }
  return simpler;
}

void SimplifyAllCoordinates(Attempts& attempts) {
  Case flat = attempts.Current();
  for (Vertex& v : flat.scene.vertices) v.z = 0;
  attempts.Try(std::move(flat));
  TryWindowSpace(attempts);
  TryEverywhere(attempts, [](double x) { return std::isfinite(x) ? std::nearbyint(x) : x; });
  TryEverywhere(attempts, [](double x) { return std::isfinite(x) ? ToHalfPixel(x) : x; });
  for (const int bits : kMantissaBits) {
    TryEverywhere(attempts, [bits](double x) { return Shortened(x, bits); });
  }
}

void SimplifyEachCoordinate(Attempts& attempts) {
  const bool clip_space = attempts.Current().scene.clip_space;
  for (std::size_t i = 0; i < attempts.Current().scene.vertices.size(); ++i) {
    for (const Member member : kMembers) {
      if (member == &Vertex::w && !clip_space) continue;
      if (attempts.Exhausted()) return;
      for (const double value : SimplerCoordinates(attempts.Current().scene.vertices[i].*member)) {
        if (TryCoordinate(attempts, i, member, value)) break;
      }
    }
  }
}

}  // namespace rasterproof::props
