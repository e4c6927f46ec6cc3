// Derivatives of values, and depths, each wrong in one way.
#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

#include "core/channel.h"
#include "core/value_rule.h"
#include "subjects/mutants/mutant.h"
#include "subjects/mutants/values.h"

namespace rasterproof::subjects::mutants {
namespace {

using Slope = std::array<double, 2>;

constexpr std::string_view kDerivativesKill = "DerivativesStayWithinTheirError";
constexpr std::string_view kQuadsKill = "QuadDifferencesEqualDifferencesOfValues";
constexpr std::string_view kDepthsKill = "ClipDepthsStayWithinTheirError";
constexpr std::string_view kFormatKills = "DepthsAreOfTheirFormat";

ChannelStages Deriving(DerivativesBy by,
                       std::function<Slope(const ValueQuestion&, Slope)> derivative) {
  ChannelStages stages;
  stages.profile.values.derivatives = by;
  stages.derivative = std::move(derivative);
  return stages;
}

ChannelStages Deepening(DepthFormat format,
                        std::function<double(const ValueQuestion&, double)> depth) {
  ChannelStages stages;
  stages.profile.values.depth = format;
  stages.profile.values.depth_rounding = DepthRounding::kNearest;
  stages.depth = std::move(depth);
  return stages;
}

const ChannelStages& SoundStages() {
  static const ChannelStages stages;
  return stages;
}

double Fixed12(double x) { return std::nearbyint(x * 0x1p12) * 0x1p-12; }

// Of the plane, at the point itself.
// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> OfSlopes() {
  constexpr DerivativesBy kPlane = DerivativesBy::kAnalytic;
  return {
      {"values-dy-negated", "derivatives by y have the other sign", "",
       Deriving(kPlane, [](const ValueQuestion&, Slope d) { return Slope{d[0], -d[1]}; }),
       "wrong-derivative", kDerivativesKill},
      {"values-dx-dy-swapped", "derivatives by x and y are exchanged", "",
       Deriving(kPlane, [](const ValueQuestion&, Slope d) { return Slope{d[1], d[0]}; }),
       "wrong-derivative", kDerivativesKill},
      {"values-dx-doubled", "derivatives are twice too large", "",
       Deriving(kPlane, [](const ValueQuestion&, Slope d) { return Slope{2 * d[0], 2 * d[1]}; }),
       "wrong-derivative", kDerivativesKill},
      {"values-dx-of-affine-plane", "derivatives in perspective are of the plane on the screen", "",
       Deriving(kPlane,
                [](const ValueQuestion& q, Slope) {
                  ValueQuestion screen = q;
                  if (screen.IsPerspective()) screen.interpolation = Interpolation::kLinear;
                  return AnalyticDerivative(screen);
                }),
       "wrong-derivative", kDerivativesKill},
      {"values-dx-not-of-w", "derivatives in perspective leave out that of 1/w", "",
       Deriving(kPlane,
                [](const ValueQuestion& q, Slope sound) {
                  if (!q.IsPerspective()) return sound;
                  ValueQuestion over_w = q;
                  over_w.interpolation = Interpolation::kInverseW;
                  const Slope d = AnalyticDerivative(over_w);
                  const double w = WAt(q);
                  return Slope{d[0] * w, d[1] * w};
                }),
       "wrong-derivative", kDerivativesKill},
      {"values-dx-few-bits", "derivatives are multiples of 2^-12", "",
       Deriving(kPlane,
                [](const ValueQuestion&, Slope d) { return Slope{Fixed12(d[0]), Fixed12(d[1])}; }),
       "few-bits|shown-values", kDerivativesKill},
      {"values-dx-stale", "derivatives in the last column are those of the one before", "",
       Deriving(kPlane,
                [](const ValueQuestion& q, Slope sound) {
                  if (q.column == 0 || q.column != q.width - 1) return sound;
                  ValueQuestion before = q;
                  before.at.x -= 1;
                  return AnalyticDerivative(before);
                }),
       "wrong-derivative", kDerivativesKill},
      {"values-dx-by-difference", "derivatives are differences, where the plane's are stated", "",
       Deriving(kPlane,
                [](const ValueQuestion& q, Slope) {
                  const auto at = [&](double x, double y) {
                    ValueQuestion there = q;
                    there.at = {q.at.x + x, q.at.y + y};
                    return EvaluateChannel(SoundStages(), there);
                  };
                  return Slope{at(1, 0) - at(0, 0), at(0, 1) - at(0, 0)};
                }),
       "wrong-derivative", kDerivativesKill},
  };
}

// The difference from one pixel to another, in pixels from the question's.
double Difference(const ValueQuestion& q, std::array<int, 2> from, std::array<int, 2> to) {
  const auto at = [&](std::array<int, 2> by) {
    ValueQuestion there = q;
    there.at = {q.at.x + by[0], q.at.y + by[1]};
    return EvaluateChannel(SoundStages(), there);
  };
  return at(to) - at(from);
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> OfQuads() {
  constexpr DerivativesBy kFine = DerivativesBy::kFine;
  return {
      {"values-coarse-for-fine", "differences are the quad's first, where each row's are stated",
       "",
       Deriving(kFine,
                [](const ValueQuestion& q, Slope) {
                  const int x = -(q.column % 2);
                  const int y = -(q.row % 2);
                  return Slope{Difference(q, {x, y}, {x + 1, y}),
                               Difference(q, {x, y}, {x, y + 1})};
                }),
       "wrong-derivative", kQuadsKill},
      {"values-next-quad", "differences are those of the quad beside", "",
       Deriving(kFine,
                [](const ValueQuestion& q, Slope d) {
                  const int x = 2 - q.column % 2;
                  return Slope{Difference(q, {x, 0}, {x + 1, 0}), d[1]};
                }),
       "wrong-derivative", kQuadsKill},
      {"values-quad-across", "differences are those of the next quad on the diagonal", "",
       Deriving(kFine,
                [](const ValueQuestion& q, Slope) {
                  const int x = 2 - q.column % 2, y = 2 - q.row % 2;
                  return Slope{Difference(q, {x, 2}, {x + 1, 2}),
                               Difference(q, {2, y}, {2, y + 1})};
                }),
       "wrong-derivative", kQuadsKill},
      {"values-quads-misplaced", "quads begin at odd pixels, where even ones are stated", "",
       [] {
         ChannelStages stages;
         stages.profile.values.derivatives = kFine;
         stages.profile.values.quads = QuadOrigin::kEven;
         stages.quad_origin = 1;
         return stages;
       }(),
       "wrong-derivative", kDerivativesKill},
      {"values-difference-negated", "odd columns take the difference the other way round", "",
       Deriving(kFine, [](const ValueQuestion& q,
                          Slope d) { return q.column % 2 == 1 ? Slope{-d[0], d[1]} : d; }),
       "wrong-derivative", kQuadsKill},
      {"values-difference-forward", "each pixel's difference is to the next, of whichever quad", "",
       Deriving(kFine, [](const ValueQuestion& q,
                          Slope d) { return Slope{Difference(q, {0, 0}, {1, 0}), d[1]}; }),
       "shown-values", kQuadsKill},
      {"values-difference-central", "differences are half those over three pixels", "",
       Deriving(kFine,
                [](const ValueQuestion& q, Slope) {
                  return Slope{Difference(q, {-1, 0}, {1, 0}) / 2,
                               Difference(q, {0, -1}, {0, 1}) / 2};
                }),
       "wrong-derivative", kQuadsKill},
      {"values-coarse-by-rows", "the coarse difference along x is each row's own", "",
       Deriving(DerivativesBy::kCoarse,
                [](const ValueQuestion& q, Slope d) {
                  const int x = -(q.column % 2);
                  return Slope{Difference(q, {x, 0}, {x + 1, 0}), d[1]};
                }),
       "shown-values", kQuadsKill},
  };
}

double Depth24(double x) { return InDepthFormat(x, DepthFormat::kUnorm24); }

// NOLINTNEXTLINE(readability-function-size): a table
// A depth in double is far nearer than a step of the format: which neighbour it is can be told.
ChannelStages StatingItsError(ChannelStages stages) {
  stages.depth_error = 0x1p-32;
  return stages;
}

std::vector<Mutant> OfDepths() {
  constexpr DepthFormat k24 = DepthFormat::kUnorm24;
  constexpr double kMost = 0x1p24 - 1;
  return {
      {"values-depth-16-bits", "depths have 16 bits, where 24 are stated", "",
       Deepening(k24, [](const ValueQuestion&,
                         double z) { return InDepthFormat(z, DepthFormat::kUnorm16); }),
       "depth-rounding", kFormatKills},
      {"values-depth-truncated", "depths are rounded down, where the nearest is stated", "",
       StatingItsError(Deepening(k24,
                                 [](const ValueQuestion&, double z) {
                                   return std::floor(std::clamp(z, 0.0, 1.0) * kMost) / kMost;
                                 })),
       "depth-rounding", kFormatKills},
      {"values-depth-cut", "depths are cut to 16 bits, where floats are stated", "",
       Deepening(DepthFormat::kFloat32,
                 [](const ValueQuestion&, double z) {
                   const double cut = std::floor(std::clamp(z, 0.0, 1.0) * 0xffff) / 0xffff;
                   return static_cast<double>(static_cast<float>(cut));
                 }),
       "depth-rounding", kFormatKills},
      {"values-depth-power-of-two", "depths are multiples of 2^-24", "",
       Deepening(k24,
                 [](const ValueQuestion&, double z) {
                   return std::nearbyint(std::clamp(z, 0.0, 1.0) * 0x1p24) * 0x1p-24;
                 }),
       "depth-rounding", kFormatKills},
      {"values-depth-not-clamped", "depths outside [0, 1] are shown as they are", "",
       Deepening(k24,
                 [](const ValueQuestion&, double z) { return z < 0 || z > 1 ? z : Depth24(z); }),
       "depth-range|shown-values", kFormatKills},
      {"values-depth-perspective", "depths are perspective, where z/w is linear on the screen", "",
       Deepening(DepthFormat::kUnstated,
                 [](const ValueQuestion& q, double z) {
                   if (!q.clip_space) return z;
                   ValueQuestion over = q;
                   over.interpolation = Interpolation::kPerspective;
                   return WeightedSum(WeightsOf(over),
                                      {q.z[0] / q.v[0].w, q.z[1] / q.v[1].w, q.z[2] / q.v[2].w});
                 }),
       "affine-weights", kDepthsKill},
      {"values-depth-not-divided", "depths are z, where z/w is meant", "",
       Deepening(DepthFormat::kUnstated,
                 [](const ValueQuestion& q, double z) { return q.clip_space ? z * WAt(q) : z; }),
       "missing-division|affine-weights", kDepthsKill},
      {"values-depth-of-w", "depths are w, where z/w is meant", "",
       Deepening(DepthFormat::kUnstated,
                 [](const ValueQuestion& q, double z) { return q.clip_space ? WAt(q) : z; }),
       "wrong-quantity", kDepthsKill},
      {"values-depth-remapped", "depths are mapped from [0, 1] to [-1, 1]", "",
       Deepening(DepthFormat::kUnstated,
                 [](const ValueQuestion& q, double z) { return q.clip_space ? 2 * z - 1 : z; }),
       "depth-range", kDepthsKill},
  };
}

std::vector<Mutant> SlopeMutants() {
  std::vector<Mutant> table = OfSlopes();
  for (const auto part : {OfQuads, OfDepths}) {
    for (Mutant& planted : part()) table.push_back(std::move(planted));
  }
  return table;
}

}  // namespace

extern constinit const MutantTable kSlopeMutants{MutantKind::kPlanted, 28, SlopeMutants};

}  // namespace rasterproof::subjects::mutants
