// How near the guesses of where a row crosses an edge come to their errors. The errors leave room
// on purpose: none is tight, and the witnesses say how much of the room is needed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "core/vertex.h"
#include "exact/crossing.h"
#include "exact/homogeneous_crossing.h"
#include "exact/rational.h"
#include "exact/row_edge.h"
#include "library/kernels/crossing_errors.h"
#include "library/row_crossing.h"
#include "tests/reference/bound_witnesses.h"

namespace rasterproof::reference::witness {
namespace {

using exact::Rational;
using Numbers = std::vector<double>;

/// Where the row at y crosses the edge from (n0, n1) to (n2, n3).
Rational CrossingOf(const Numbers& n, double y) {
  const Rational slope = (Rational(n[2]) - n[0]) / (Rational(n[3]) - n[1]);
  return Rational(n[0]) + (Rational(y) - n[1]) * slope;
}

/// The guess, and what library::RowCrossing::At makes of it.
ErrorAndBound OfSpans(const Numbers& n) {
  const double guess =
      library::RowCrossing({n[0], n[1]}, {n[2], n[3]}).Guess(static_cast<int>(n[4]));
  constexpr double kAdded = 0.5 + library::RowCrossing::kCrossingError;
  const Rational crossing = CrossingOf(n, n[4] + 0.5);
  return {std::max((Rational(guess) - crossing).Abs(),
                   (Rational(guess + kAdded) - kAdded - crossing).Abs()),
          Rational(library::RowCrossing::kCrossingError)};
}

/// How much of its error a guess needs: its ends are rounded, too.
ErrorAndBound Needed(const exact::Guess& guess, const Rational& crossing) {
  const Rational left =
      std::min(crossing - (guess.at - guess.error), Rational(guess.at + guess.error) - crossing);
  return {Rational(guess.error) - left, Rational(guess.error)};
}

constexpr double kOffset = 0.5;

ErrorAndBound OfOracle(const Numbers& n) {
  return Needed(exact::RowEdge({n[0], n[1]}, {n[2], n[3]}).At(n[4], kOffset),
                CrossingOf(n, n[4]) - kOffset);
}

ErrorAndBound OfClipSpace(const Numbers& n) {
  const auto minor = [&n](std::size_t i, std::size_t j) {
    return Rational(n[3 + i]) * n[j] - Rational(n[3 + j]) * n[i];
  };
  const Rational crossing = -(minor(2, 0) * n[6] + minor(0, 1)) / minor(1, 2);
  const exact::HomogeneousCrossing edge({n[0], n[1], 0, n[2]}, {n[3], n[4], 0, n[5]});
  return Needed(edge.At(n[6], kOffset), crossing - kOffset);
}

/// The kernel's formula in one lane, its last product fused or not, whichever is further off.
template <class T>
ErrorAndBound OfKernel(const Numbers& n, T error) {
  const auto [ax, ay] = std::array{static_cast<T>(n[0]), static_cast<T>(n[1])};
  const T slope = (static_cast<T>(n[2]) - ax) / (static_cast<T>(n[3]) - ay);
  const T from = ax + (T{0.5} + error);
  const T down = static_cast<T>(n[4]) - ay;
  const Rational crossing = CrossingOf(n, n[4]) + Rational(0.5) + error;
  return {std::max((Rational(down * slope + from) - crossing).Abs(),
                   (Rational(std::fma(down, slope, from)) - crossing).Abs()),
          Rational(error)};
}

/// From either end, cut off to fixed point.
ErrorAndBound OfSmall(const Numbers& n) {
  constexpr float kError = library::kernels::kSmallCrossingError;
  constexpr float kUnit = library::kernels::kSmallUnit;
  const auto f = [&](std::size_t i) { return static_cast<float>(n[i]); };
  const float slope = (f(2) * kUnit - f(0) * kUnit) / (f(3) - f(1));
  const Rational crossing = CrossingOf(n, n[4]) + Rational(0.5) + kError;
  Rational worst(0);
  for (const std::size_t end : {std::size_t{0}, std::size_t{2}}) {
    const float from = f(end) * kUnit + (0.5F + kError) * kUnit;
    const float down = f(4) - f(end + 1);
    for (const float guess : {down * slope + from, std::fma(down, slope, from)}) {
      const double cut = std::trunc(guess) / double{kUnit};
      worst = std::max(worst, (Rational(cut) - crossing).Abs());
    }
  }
  return {worst, Rational(kError)};
}

/// The first row of the edge is n[4], its crossing with the row n[6] is asked for, n[5] rows before
/// which the vector begins.
ErrorAndBound OfSteps(const Numbers& n) {
  constexpr double kError = library::kernels::kStepError;
  const double slope = (n[2] - n[0]) / (n[3] - n[1]);
  const double first = (n[4] + 0.5 - n[1]) * slope + (n[0] + (0.5 + kError));
  const auto fixed = [](double v) { return static_cast<std::int64_t>(v * 0x1p32); };
  const auto lane = static_cast<std::int64_t>(n[5]);
  const std::int64_t start =
      fixed(first) + (static_cast<std::int64_t>(n[6] - n[4]) - lane) * fixed(slope);
  const std::int64_t guess = (start >> 16) + ((lane * fixed(slope)) >> 16);
  const Rational crossing = CrossingOf(n, n[6] + 0.5) + Rational(0.5) + kError;
  return {(Rational(std::ldexp(static_cast<double>(guess), -16)) - crossing).Abs(),
          Rational(kError)};
}
ErrorAndBound OfNear(const Numbers& n) { return OfKernel(n, library::kernels::kNearCrossingError); }
ErrorAndBound OfWide(const Numbers& n) { return OfKernel(n, library::kernels::kCrossingError); }

/// BoxEdge::Crossing of a plan in 32 bits: the bias has to be more than all that rounds.
ErrorAndBound OfPlan(const Numbers& n) {
  constexpr double kBias = 0x1p-33;
  const double changed = n[0] * (1 / n[1]) + (1 - kBias);
  return {(Rational(changed) - Rational(n[0]) / n[1] - (1 - kBias)).Abs(), Rational(kBias)};
}

constexpr std::string_view kRow = "upper.x upper.y lower.x lower.y row";
constexpr std::string_view kEdgeAndY = "upper.x upper.y lower.x lower.y y";
constexpr std::string_view kSteps = "upper.x upper.y lower.x lower.y first-row lane row";
constexpr std::string_view kClipAndY = "Vi.x Vi.y Vi.w Vj.x Vj.y Vj.w y";

}  // namespace

const std::vector<BoundWitness>& CrossingWitnesses() {
  static const std::vector<BoundWitness> all{
      {"crossing, of spans (`row_crossing.h`)",
       "RowCrossing::kCrossingError",
       false,
       kRow,
       {-0x1.ffffffea2f611p+27, -0x1.180aa71df521bp+4, 0x1.fffffffff88e6p+27, 0x1.d0000002befbcp+3,
        0x1.cp+3},
       // climbed from a construction, seed 18, 2026-11-25
       OfSpans},
      {"crossing, of the oracle (`row_edge.h`)",
       "kCrossingErrorMultiplier",
       false,
       kEdgeAndY,
       {-0x1.00a8de6d9d7f8p+18, -0x1.ffe046a6e7042p+10, 0x1.0f4e0255cbeb9p+18,
        0x1.002409d22cdcep+11, 0x1.001p+11},
       // climbed from a construction, seed 5, 2026-11-25
       OfOracle},
      {"crossing, in clip space (`homogeneous_crossing.h`)",
       "kHomogeneousCrossingErrorMultiplier",
       false,
       kClipAndY,
       {-0x1.ed02b52c93ap+0, 0x1.ae091175c06f5p+1, -0x1.e41f44a202f63p+1, 0x1.9990a730a4c58p+3,
        -0x1.0d7cad1e68444p+3, 0x1.c6518beeb3e8cp+2, 0x1.cc6066p+3},
       // climbed from a construction, seed 4, 2026-11-25
       OfClipSpace},
      {"crossing, of a kernel's small triangles",
       "kSmallCrossingError",
       true,
       kEdgeAndY,
       {0x1.2d0f18p-1, -0x1.5370eap-10, 0x1.e32b02p+2, 0x1.7d8758p+1, 0x1p-1},
       // drawn, 2026-11-26
       OfSmall},
      {"crossing, of its near ones",
       "kNearCrossingError",
       true,
       kEdgeAndY,
       {0x1.ff7d26p+5, 0x1.b01b7cp+2, -0x1.be18p-4, 0x1.a8330ap+4, 0x1.a8p+4},
       // climbed from a construction, seed 4, 2026-11-25
       OfNear},
      {"crossing, of its wide ones, in steps",
       "kStepError",
       true,
       kSteps,
       {0x1.1e2cbcp+13, 0x1.509ab6p-5, 0x1.c4d3a6p+13, 0x1.fd24bp+13, 0, 5, 0x1.f13p+13},
       // drawn, 2026-11-26
       OfSteps},
      {"crossing, of its wide ones, in double",
       "kernels::kCrossingError",
       true,
       kEdgeAndY,
       {0x1.ffff98p+25, 0x1.54fc42p-23, -0x1.fffe4p+25, 0x1.001848p+13, 0x1.fff8p+12},
       // climbed from a construction, seed 15, 2026-11-25
       OfWide},
      {"crossing, of a plan (`plan_kernel.h`)",
       "kBias",
       false,
       "from-E across",
       {0x1.ff97ff48p+29, 0x1.ff98p+13},
       // climbed from a construction, seed 8, 2026-11-25
       OfPlan},
  };
  return all;
}

}  // namespace rasterproof::reference::witness
