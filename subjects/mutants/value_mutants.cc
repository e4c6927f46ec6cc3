// Values of channels: weights, places, precision and flat values, each wrong in one way.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include "core/channel.h"
#include "core/sample_pattern.h"
#include "core/value_rule.h"
#include "subjects/mutants/mutant.h"
#include "subjects/mutants/values.h"

namespace rasterproof::subjects::mutants {
namespace {

using Question = ValueQuestion;

constexpr std::string_view kValuesKill = "ValuesStayWithinTheirError";
constexpr std::string_view kBarycentricsKill = "ClipBarycentricsStayWithinTheirError";
constexpr std::string_view kCentroidsKill = "CentroidValuesStayWithinTheirError";
constexpr std::string_view kNumbersKill = "CoveredSamplesHoldNumbers";
constexpr std::string_view kFlatKills = "FlatValuesComeFromTheProvokingVertex";

ChannelStages Asking(std::function<void(Question&)> asked) {
  ChannelStages stages;
  stages.asked = std::move(asked);
  return stages;
}

// Of the values alone.
ChannelStages AskingOfChannels(std::function<void(Question&)> asked) {
  return Asking([asked = std::move(asked)](Question& q) {
    if (q.channel) asked(q);
  });
}

ChannelStages Weighing(std::function<Weights(const Question&)> weights) {
  ChannelStages stages;
  stages.weights = std::move(weights);
  return stages;
}

ChannelStages ChangingValues(std::function<double(const Question&, double)> value) {
  ChannelStages stages;
  stages.value = std::move(value);
  return stages;
}

ChannelStages Stated(ChannelStages stages, void (*state)(ChannelStages&)) {
  state(stages);
  return stages;
}

// Without a stated error, triangles that reach the plane of the eye are not judged, nor subnormals.
void StateTheError(ChannelStages& stages) {
  stages.profile.values.error.conditions = kUsualConditions;
}

void StateFourSamples(ChannelStages& stages) { stages.profile.pattern = *StandardPattern(4); }

void StateSnapping(ChannelStages& stages) {
  stages.profile.snap = {8};
  stages.takes_clip = false;
}

void OnTheScreen(Question& q) {
  if (q.IsPerspective()) q.interpolation = Interpolation::kLinear;
}

// Perspective weights, each changed by its w, that sum to one again.
Weights Reweighted(const Question& q, double (*factor)(double w)) {
  Weights weights = WeightsOf(q);
  if (!q.IsPerspective()) return weights;
  double sum = 0;
  for (std::size_t i = 0; i < 3; ++i) sum += weights[i] *= factor(q.v[i].w);
  for (double& weight : weights) weight /= sum;
  return weights;
}

// To so many significant bits.
double RoundedToBits(double x, int bits) {
  if (x == 0 || !std::isfinite(x)) return x;
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  return std::ldexp(std::nearbyint(std::ldexp(fraction, bits)), exponent - bits);
}

double Half(double x) {
  constexpr double kMost = 65504;
  const double least = 0x1p-24;
  if (std::fabs(x) < 0x1p-14) return std::nearbyint(x / least) * least;
  return std::clamp(RoundedToBits(x, 11), -kMost, kMost);
}

Weights RoundedTo(const Question& q, double unit) {
  Weights weights = WeightsOf(q);
  if (q.interpolation == Interpolation::kInverseW) return weights;
  for (double& weight : weights) weight = std::nearbyint(weight / unit) * unit;
  return weights;
}

float Float(double x) { return static_cast<float>(x); }

// In float32, of weights that are multiplied by the reciprocal of their sum.
double SumInFloat32(const Question& q) {
  const Weights beta = BetasAt(q.v, q.at);
  if (!q.IsPerspective()) return Float(WeightedSum(WeightsOf(q), q.a));
  const float reciprocal = 1 / Float(beta[0] + beta[1] + beta[2]);
  return Float(beta[0]) * reciprocal * Float(q.a[0]) + Float(beta[1]) * reciprocal * Float(q.a[1]) +
         Float(beta[2]) * reciprocal * Float(q.a[2]);
}

ChannelStages SummingInFloat32(bool ValueRule::* stated) {
  ChannelStages stages;
  stages.profile.values.*stated = true;
  stages.plane = SumInFloat32;
  return stages;
}

double LargestRatioOfW(const Question& q) {
  const auto [least, most] =
      std::minmax({std::fabs(q.v[0].w), std::fabs(q.v[1].w), std::fabs(q.v[2].w)});
  return most / least;
}

bool ReachesBehindTheEye(const Question& q) {
  return std::ranges::any_of(q.v, [](const HomogeneousCorner& c) { return c.w <= 0; });
}

bool HasNegativeArea(const Question& q) {
  const HomogeneousCorners& v = q.placed;
  return (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x) < 0;
}

// In float32, of corners in front of the eye.
bool LosesItsArea(const Question& q) {
  std::array<float, 3> x{}, y{};
  for (std::size_t i = 0; i < 3; ++i) {
    if (!(q.v[i].w > 0)) return false;
    x[i] = Float(q.v[i].x / q.v[i].w);
    y[i] = Float(q.v[i].y / q.v[i].w);
  }
  return (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]) == 0;
}

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

void StateCentroids(ChannelStages& stages) {
  StateFourSamples(stages);
  stages.profile.centroid = Centroid::kDirect3D;
  stages.profile.values.centroids = true;
}

void AtOwnSample(Question& q) {
  const Point2 own = q.pattern[q.sample];
  if (q.asked_at == EvaluatedAt::kCentroid) q.at = {q.low.x + own.x, q.low.y + own.y};
}

void AtCentre(Question& q) {
  if (q.asked_at == EvaluatedAt::kCentroid) q.at = q.Centre();
}

bool IsLate(const Question& q) {
  return std::ranges::any_of(q.indices, [](std::int32_t index) { return index >= 32; });
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> OfWeights() {
  return {
      {"values-affine", "perspective values and weights are affine on the screen", "",
       Asking(OnTheScreen), "affine-weights", kValuesKill},
      {"values-affine-alone", "values are affine on the screen, barycentrics are not", "",
       AskingOfChannels(OnTheScreen), "affine-weights", kValuesKill},
      {"values-affine-barycentrics", "barycentrics are affine on the screen, values are not", "",
       Asking([](Question& q) {
         if (!q.channel) OnTheScreen(q);
       }),
       "affine-weights", kBarycentricsKill},
      {"values-affine-odd-channels", "every second channel is affine on the screen", "",
       AskingOfChannels([](Question& q) {
         if (*q.channel % 2 == 1) OnTheScreen(q);
       }),
       "affine-weights", kValuesKill},
      {"values-affine-far", "values are affine where one w is 1024 times another", "",
       AskingOfChannels([](Question& q) {
         if (LargestRatioOfW(q) > 1024) OnTheScreen(q);
       }),
       "affine-weights", kValuesKill},
      {"values-exchanged", "the numbers of two vertices are exchanged", "",
       AskingOfChannels([](Question& q) { std::swap(q.a[1], q.a[2]); }), "exchanged-weights",
       kValuesKill},
      {"values-rotated", "each weight belongs to the next vertex", "",
       Weighing([](const Question& q) {
         const Weights l = WeightsOf(q);
         return Weights{l[1], l[2], l[0]};
       }),
       "exchanged-weights", kValuesKill},
      {"values-exchanged-in-back", "the numbers of two vertices are exchanged in one winding", "",
       AskingOfChannels([](Question& q) {
         if (HasNegativeArea(q)) std::swap(q.a[0], q.a[1]);
       }),
       "exchanged-weights", kValuesKill},
      {"values-divided-twice", "perspective weights are divided by w twice", "",
       Weighing([](const Question& q) { return Reweighted(q, [](double w) { return 1 / w; }); }),
       "weights-by-w", kValuesKill},
      {"values-times-w", "screen weights are multiplied by w instead of divided", "",
       Weighing([](const Question& q) { return Reweighted(q, [](double w) { return w * w; }); }),
       "weights-by-w", kValuesKill},
      {"values-over-depth", "weights are divided by z instead of w where z is positive", "",
       Weighing([](const Question& q) {
         Weights weights = WeightsOf(q);
         if (!q.IsPerspective() || !q.clip_space || std::ranges::min(q.z) <= 0) return weights;
         double sum = 0;
         for (std::size_t i = 0; i < 3; ++i) sum += weights[i] *= q.v[i].w / q.z[i];
         for (double& weight : weights) weight /= sum;
         return weights;
       }),
       "weights-by-w|shown-values", kValuesKill},
      {"values-not-divided", "values over w are not divided by 1/w at the end", "",
       AskingOfChannels([](Question& q) {
         if (q.IsPerspective()) q.interpolation = Interpolation::kInverseW;
       }),
       "missing-division", kValuesKill},
      {"values-behind-the-eye", "weights are of positive w", "",
       Stated(Weighing([](const Question& q) {
                return Reweighted(q, [](double w) { return w < 0 ? -1.0 : 1.0; });
              }),
              StateTheError),
       "weights-by-w", kValuesKill},
      {"values-behind-affine", "values are affine where a vertex lies behind the eye", "",
       Stated(AskingOfChannels([](Question& q) {
                if (ReachesBehindTheEye(q)) OnTheScreen(q);
              }),
              StateTheError),
       "affine-weights", kValuesKill},
      {"values-linear-in-perspective", "linear values are perspective", "",
       AskingOfChannels([](Question& q) {
         if (q.interpolation == Interpolation::kLinear)
           q.interpolation = Interpolation::kPerspective;
       }),
       "affine-weights", kValuesKill},
      {"values-w-for-inverse-w", "w is shown, where 1/w is asked for", "",
       ChangingValues([](const Question& q, double value) {
         return q.interpolation == Interpolation::kInverseW ? 1 / value : value;
       }),
       "wrong-quantity", kValuesKill},
      {"values-of-affine-w", "1/w is that of w interpolated on the screen", "",
       ChangingValues([](const Question& q, double value) {
         if (q.interpolation != Interpolation::kInverseW) return value;
         Question screen = q;
         screen.interpolation = Interpolation::kLinear;
         return 1 / WeightedSum(WeightsOf(screen), {q.v[0].w, q.v[1].w, q.v[2].w});
       }),
       "affine-weights", kValuesKill},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> OfPrecision() {
  return {
      {"values-12-bits-of-inverse-w", "w is the reciprocal of 1/w to 12 bits", "rcpss alone",
       ChangingValues([](const Question& q, double value) {
         if (!q.IsPerspective() || !q.clip_space) return value;
         const double w = WAt(q);
         return value / w * RoundedToBits(w, 12);
       }),
       "few-bits", kValuesKill},
      {"values-half", "values are half floats", "",
       ChangingValues([](const Question&, double value) { return Half(value); }), "few-bits",
       kValuesKill},
      {"values-bfloat", "values have eight significant bits", "",
       ChangingValues([](const Question&, double value) { return RoundedToBits(value, 8); }),
       "few-bits", kValuesKill},
      {"values-half-numbers", "numbers at the vertices are rounded to half floats", "",
       AskingOfChannels([](Question& q) {
         for (double& number : q.a) number = Half(number);
       }),
       "few-bits", kValuesKill},
      {"values-8-bit-weights", "weights have eight fractional bits", "",
       Weighing([](const Question& q) { return RoundedTo(q, 0x1p-8); }), "few-bits", kValuesKill},
      {"values-16-bit-weights", "weights have sixteen fractional bits", "",
       Weighing([](const Question& q) { return RoundedTo(q, 0x1p-16); }), "few-bits", kValuesKill},
      {"values-large-lost", "values beyond 65504 are infinite", "",
       ChangingValues([](const Question&, double value) {
         return std::fabs(value) > 65504 ? std::copysign(HUGE_VAL, value) : value;
       }),
       "few-bits", kValuesKill},
      {"values-flushed", "values below the normal floats are zero", "",
       Stated(ChangingValues([](const Question& q, double value) {
                const bool is_small = std::fabs(value) < std::numeric_limits<float>::min();
                return is_small && q.interpolation != Interpolation::kFlat ? 0.0 : value;
              }),
              StateTheError),
       "subnormals", kValuesKill},
      {"values-clamped", "values are clamped to [0, 1]", "",
       ChangingValues([](const Question& q, double value) {
         return q.interpolation == Interpolation::kInverseW ? value : std::clamp(value, 0.0, 1.0);
       }),
       "clamped-values", kValuesKill},
      {"values-ninth-channel", "channels beyond the eighth are zero", "",
       ChangingValues(
           [](const Question& q, double value) { return *q.channel >= 8 ? 0.0 : value; }),
       "shown-values", kValuesKill},
      {"values-late-vertices", "the numbers of vertices from the 33rd on are the first 32's", "",
       AskingOfChannels([](Question& q) {
         if (IsLate(q)) q.a = {q.a[2], q.a[2], q.a[2]};
       }),
       "shown-values", kValuesKill},
      {"values-equal-off", "three equal numbers are summed with weights that are not one together",
       "PlayStation 2 emulators: 0xfffe becomes 0xfffd",
       SummingInFloat32(&ValueRule::equal_stay_equal), "shown-values", "EqualValuesStayEqual"},
      {"values-vertex-off", "weights at a vertex are off by 2^-24", "",
       [] {
         ChannelStages stages;
         stages.profile.values.exact_at_vertices = true;
         stages.plane = [](const Question& q) {
           Weights weights = WeightsOf(q);
           weights[0] -= 0x1p-24;
           weights[1] += 0x1p-24;
           return static_cast<double>(Float(WeightedSum(weights, q.a)));
         };
         return stages;
       }(),
       "shown-values", "VerticesKeepTheirValues"},
      {"values-edges-disagree", "a value on an edge is a rounded sum that the third vertex is in",
       "", SummingInFloat32(&ValueRule::agrees_along_edges), "shown-values",
       "ValuesAlongAnEdgeDependOnItsEnds"},
      {"values-nan-on-slivers", "values are NaN where float32 loses the area", "llvmpipe",
       ChangingValues([](const Question& q, double value) {
         const bool is_flat = q.interpolation == Interpolation::kFlat;
         return LosesItsArea(q) && !is_flat ? kNaN : value;
       }),
       "shown-values", kNumbersKill},
      {"values-nan-weights", "barycentrics are NaN where float32 loses the area", "",
       Weighing([](const Question& q) {
         const bool is_lost = !q.channel && LosesItsArea(q);
         return is_lost ? Weights{kNaN, kNaN, kNaN} : WeightsOf(q);
       }),
       "shown-values", kNumbersKill},
      {"values-of-an-order", "a value is a rounded sum in the order of the corners", "",
       SummingInFloat32(&ValueRule::same_in_any_order), "shown-values",
       "PermutedVerticesKeepTheirValues"},
      {"values-turn-back", "values are rounded sums, which turn back along a row", "",
       SummingInFloat32(&ValueRule::monotone_along_rows), "shown-values",
       "ValuesAreMonotoneAlongRows"},
      {"values-hull-left", "values are rounded away from zero, one float further than need be", "",
       [] {
         ChannelStages stages;
         stages.profile.values.stays_in_hull = true;
         stages.value = [](const Question& q, double value) {
           if (q.interpolation == Interpolation::kFlat) return value;
           const float away = std::copysign(std::numeric_limits<float>::infinity(), Float(value));
           return static_cast<double>(std::nextafter(Float(value), away));
         };
         return stages;
       }(),
       "shown-values", "ValuesStayInTheHull"},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> OfCentroids() {
  return {
      {"values-centroids-at-centres", "what is asked for at the centroid is the centre's", "",
       Stated(AskingOfChannels(AtCentre), StateCentroids), "shown-values", kCentroidsKill},
      {"values-centroids-at-samples", "what is asked for at the centroid is each sample's own", "",
       Stated(AskingOfChannels(AtOwnSample), StateCentroids), "shown-values", kCentroidsKill},
      {"values-centroids-outside", "what may be of any point of pixel and triangle is the centre's",
       "",
       Stated(AskingOfChannels(AtCentre),
              [](ChannelStages& stages) {
                StateCentroids(stages);
                stages.profile.centroid = Centroid::kInside;
              }),
       "shown-values", kCentroidsKill},
      {"values-centroids-apart", "of two channels, one is of the centroid, the other of the sample",
       "",
       Stated(AskingOfChannels([](Question& q) {
                if (q.channel && *q.channel % 2 == 0) AtOwnSample(q);
              }),
              [](ChannelStages& stages) {
                StateCentroids(stages);
                stages.profile.centroid = Centroid::kInside;
              }),
       "shown-values", kCentroidsKill},
      {"values-centroids-affine", "what is asked for at the centroid is affine on the screen", "",
       Stated(AskingOfChannels([](Question& q) {
                if (q.asked_at == EvaluatedAt::kCentroid) OnTheScreen(q);
              }),
              StateCentroids),
       "shown-values", kCentroidsKill},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> OfPlaces() {
  return {
      {"values-at-corners", "values are evaluated at the pixel's corner", "",
       AskingOfChannels([](Question& q) { q.at = {q.at.x - 0.5, q.at.y - 0.5}; }), "wrong-place",
       kValuesKill},
      {"values-at-centres", "values of four samples are evaluated at the centre", "",
       Stated(AskingOfChannels([](Question& q) { q.at = q.Centre(); }), StateFourSamples),
       "wrong-place", kValuesKill},
      {"values-at-next-sample", "values of four samples are evaluated at the next one", "",
       Stated(AskingOfChannels([](Question& q) {
                if (q.asked_at != EvaluatedAt::kSample) return;
                const Point2 next = q.pattern[(q.sample + 1) % q.pattern.size()];
                q.at = {q.low.x + next.x, q.low.y + next.y};
              }),
              StateFourSamples),
       "wrong-place", kValuesKill},
      {"values-centres-at-samples", "what is asked for at the centre is the sample's", "",
       Stated(AskingOfChannels([](Question& q) {
                const Point2 own = q.pattern[q.sample];
                q.at = {q.low.x + own.x, q.low.y + own.y};
              }),
              StateFourSamples),
       "wrong-place", kValuesKill},
      {"values-upside-down", "y counts from the top, where it grows upwards", "",
       Stated(AskingOfChannels([](Question& q) { q.at.y = q.height - q.at.y; }),
              [](ChannelStages& stages) { stages.profile.y_axis = YAxis::kUp; }),
       "wrong-place|shown-values", kValuesKill},
      {"values-of-snapped", "values are of the snapped corners, where the given are meant", "",
       Stated(AskingOfChannels([](Question& q) { q.v = q.placed; }), StateSnapping),
       "other-corners", kValuesKill},
      {"values-of-given", "values are of the given corners, where the snapped are meant", "",
       Stated(AskingOfChannels([](Question& q) { q.v = q.given; }),
              [](ChannelStages& stages) {
                StateSnapping(stages);
                stages.barycentrics_of = BarycentricsOf::kSnapped;
              }),
       "other-corners", kValuesKill},
      {"values-flat-last", "flat values come from the last vertex, where the first is stated", "",
       AskingOfChannels([](Question& q) { q.provoking = 2; }), "wrong-provoking-vertex",
       kFlatKills},
      {"values-flat-first", "flat values come from the first vertex, where the last is stated", "",
       Stated(
           AskingOfChannels([](Question& q) { q.provoking = 0; }),
           [](ChannelStages& stages) { stages.profile.values.provoking = ProvokingVertex::kLast; }),
       "wrong-provoking-vertex", kFlatKills},
      {"values-flat-by-winding", "flat values of one winding come from the second vertex", "",
       AskingOfChannels([](Question& q) {
         if (HasNegativeArea(q)) q.provoking = 1;
       }),
       "wrong-provoking-vertex", kFlatKills},
      {"values-flat-interpolated", "flat values are interpolated", "",
       AskingOfChannels([](Question& q) {
         if (q.interpolation == Interpolation::kFlat) q.interpolation = Interpolation::kLinear;
       }),
       "wrong-provoking-vertex|shown-values", kFlatKills},
  };
}

std::vector<Mutant> ValueMutants() {
  std::vector<Mutant> table = OfWeights();
  for (const auto part : {OfPrecision, OfPlaces, OfCentroids}) {
    for (Mutant& planted : part()) table.push_back(std::move(planted));
  }
  return table;
}

}  // namespace

extern constinit const MutantTable kValueMutants{MutantKind::kPlanted, 27, ValueMutants};

}  // namespace rasterproof::subjects::mutants
