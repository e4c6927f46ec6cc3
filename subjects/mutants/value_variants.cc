// Values of channels by each of the usual forms in float32, and by one that rounds correctly: with
// each of the statements that a profile can make, and under legal sets.
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
#include "subjects/mutants/rounded_values.h"
#include "subjects/mutants/values.h"

namespace rasterproof::subjects::mutants {
namespace {

using Floats = std::array<float, 3>;
using State = std::function<void(ChannelStages&)>;

// A question in float32: the value is the sum of beta_i c_i a_i over that of beta_i e_i, times a
// power of two. Corners and numbers are scaled by powers of two, so that nothing overflows.
struct FloatForm {
  std::array<Floats, 3> v{};  ///< x, y, w
  Point2 p{};
  Floats c{};
  Floats e{};
  Floats a{};
  int exponent = 0;
};

int ExponentOf(std::initializer_list<double> numbers) {
  double most = 0;
  for (const double x : numbers) most = std::max(most, std::fabs(x));
  return most == 0 ? 0 : std::ilogb(most);
}

float Scaled(double x, int exponent) { return static_cast<float>(std::ldexp(x, exponent)); }

FloatForm FormOf(const ValueQuestion& q) {
  FloatForm form{.p = q.at};
  std::array<int, 3> exponents{};
  for (std::size_t i = 0; i < 3; ++i) {
    const HomogeneousCorner& v = q.v[i];
    exponents[i] = ExponentOf({v.x, v.y, v.w});
    form.v[i] = {Scaled(v.x, -exponents[i]), Scaled(v.y, -exponents[i]),
                 Scaled(v.w, -exponents[i])};
  }
  const int least = std::ranges::min(exponents);
  const int numbers = ExponentOf({q.a[0], q.a[1], q.a[2]});
  for (std::size_t i = 0; i < 3; ++i) {
    const float power = Scaled(1, least - exponents[i]);
    form.c[i] = q.interpolation == Interpolation::kLinear ? form.v[i][2] : power;
    form.e[i] = q.IsPerspective() ? power : form.v[i][2];
    form.a[i] = Scaled(q.a[i], -numbers);
  }
  form.exponent = numbers - (q.interpolation == Interpolation::kInverseW ? least : 0);
  return form;
}

Floats CrossProduct(const Floats& a, const Floats& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Floats FusedCrossProduct(const Floats& a, const Floats& b) {
  return {std::fma(a[1], b[2], -(a[2] * b[1])), std::fma(a[2], b[0], -(a[0] * b[2])),
          std::fma(a[0], b[1], -(a[1] * b[0]))};
}

float DotProduct(const Floats& a, const Floats& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

float At(const Floats& plane, Point2 p) {
  return plane[0] * static_cast<float>(p.x) + plane[1] * static_cast<float>(p.y) + plane[2];
}

std::array<Floats, 3> Planes(const FloatForm& form) {
  return {CrossProduct(form.v[1], form.v[2]), CrossProduct(form.v[2], form.v[0]),
          CrossProduct(form.v[0], form.v[1])};
}

Floats FloatBetas(const FloatForm& form) {
  const std::array<Floats, 3> planes = Planes(form);
  return {At(planes[0], form.p), At(planes[1], form.p), At(planes[2], form.p)};
}

Floats Times(const Floats& a, const Floats& b) { return {a[0] * b[0], a[1] * b[1], a[2] * b[2]}; }
Floats Over(const Floats& a, float d) { return {a[0] / d, a[1] / d, a[2] / d}; }
float SumOf(const Floats& a) { return a[0] + a[1] + a[2]; }

Floats FormWeights(const FloatForm& form) {
  const Floats beta = FloatBetas(form);
  return Over(Times(beta, form.c), SumOf(Times(beta, form.e)));
}

float ByProducts(const FloatForm& form) { return DotProduct(FormWeights(form), form.a); }

float DividedLast(const FloatForm& form) {
  const Floats beta = FloatBetas(form);
  return DotProduct(Times(beta, form.c), form.a) / SumOf(Times(beta, form.e));
}

// From the vertex of the least number.
float ByDifferences(const FloatForm& form) {
  if (form.c != form.e) return DividedLast(form);  // weights do not sum to one
  const auto size = [](float x) { return std::fabs(x); };
  const auto from =
      static_cast<std::size_t>(std::ranges::min_element(form.a, {}, size) - form.a.begin());
  const Floats l = FormWeights(form);
  const std::size_t j = (from + 1) % 3, k = (from + 2) % 3;
  return form.a[from] + l[j] * (form.a[j] - form.a[from]) + l[k] * (form.a[k] - form.a[from]);
}

float FromTheFirstVertex(const FloatForm& form) {
  if (form.c != form.e) return DividedLast(form);
  const Floats l = FormWeights(form);
  return form.a[0] + l[1] * (form.a[1] - form.a[0]) + l[2] * (form.a[2] - form.a[0]);
}

// A x + B y + C of the planes that are divided.
float ByPlanes(const FloatForm& form) {
  const std::array<Floats, 3> planes = Planes(form);
  const auto sum = [&](const Floats& factors) {
    Floats plane{};
    for (std::size_t k = 0; k < 3; ++k)
      plane[k] = DotProduct({planes[0][k], planes[1][k], planes[2][k]}, factors);
    return At(plane, form.p);
  };
  return sum(Times(form.c, form.a)) / sum(form.e);
}

// Olano and Greer's: the corners' matrix, inverted.
float ByInverseMatrix(const FloatForm& form) {
  std::array<Floats, 3> rows = Planes(form);
  const float determinant = DotProduct(rows[0], form.v[0]);
  if (determinant != 0) {
    for (Floats& row : rows) row = Over(row, determinant);
  }
  const Floats beta{At(rows[0], form.p), At(rows[1], form.p), At(rows[2], form.p)};
  return DotProduct(Times(beta, form.c), form.a) / SumOf(Times(beta, form.e));
}

Floats ScreenWeights(const FloatForm& form) {
  const Floats h = Times(FloatBetas(form), {form.v[0][2], form.v[1][2], form.v[2][2]});
  return Over(h, SumOf(h));
}

bool CanDivideByW(const FloatForm& form) {
  return form.v[0][2] != 0 && form.v[1][2] != 0 && form.v[2][2] != 0 &&
         std::ranges::all_of(ScreenWeights(form), [](float x) { return std::isfinite(x); });
}

// The numbers over w, and 1/w, on the screen, and one division.
float OverW(const FloatForm& form) {
  if (!CanDivideByW(form)) return DividedLast(form);
  Floats over{}, inverse{};
  for (std::size_t i = 0; i < 3; ++i) {
    over[i] = form.a[i] * form.c[i] / form.v[i][2];
    inverse[i] = form.e[i] / form.v[i][2];
  }
  const Floats l = ScreenWeights(form);
  return DotProduct(l, over) / DotProduct(l, inverse);
}

float WeightsFirst(const FloatForm& form) {
  if (!CanDivideByW(form)) return DividedLast(form);
  const Floats l = ScreenWeights(form);
  Floats weights{}, shares{};
  for (std::size_t i = 0; i < 3; ++i) {
    weights[i] = l[i] / form.v[i][2] * form.c[i];
    shares[i] = l[i] / form.v[i][2] * form.e[i];
  }
  return DotProduct(Over(weights, SumOf(shares)), form.a);
}

// 14 bits and a step of Newton's.
float ByReciprocal(const FloatForm& form) {
  const Floats beta = FloatBetas(form);
  const float total = SumOf(Times(beta, form.e));
  int exponent = 0;
  const double fraction = std::frexp(1.0 / static_cast<double>(total), &exponent);
  const float estimate = Scaled(std::nearbyint(std::ldexp(fraction, 14)), exponent - 14);
  const float reciprocal = estimate * std::fma(-total, estimate, 2.0F);
  return DotProduct(Times(beta, form.c), form.a) * reciprocal;
}

float Fused(const FloatForm& form) {
  const auto at = [&](std::size_t j, std::size_t k) {
    const Floats e = FusedCrossProduct(form.v[j], form.v[k]);
    const auto x = static_cast<float>(form.p.x), y = static_cast<float>(form.p.y);
    return std::fma(e[0], x, std::fma(e[1], y, e[2]));
  };
  const Floats beta{at(1, 2), at(2, 0), at(0, 1)};
  const Floats f = Times(beta, form.c);
  const float n = std::fma(f[0], form.a[0], std::fma(f[1], form.a[1], f[2] * form.a[2]));
  const float d = std::fma(beta[0], form.e[0], std::fma(beta[1], form.e[1], beta[2] * form.e[2]));
  return n / d;
}

// E(a, b; p) by differences from a, as most rasterizers have it: in the window alone, where c and e
// differ by a power of two.
float ByEdgeFunctions(const FloatForm& form) {
  const auto edge = [](const Floats& a, const Floats& b, float x, float y) {
    return (x - a[0]) * (b[1] - a[1]) - (y - a[1]) * (b[0] - a[0]);
  };
  std::array<Floats, 3> v = form.v;
  for (Floats& corner : v) corner = Over(corner, corner[2]);  // powers of two
  const auto x = static_cast<float>(form.p.x), y = static_cast<float>(form.p.y);
  const Floats e{edge(v[1], v[2], x, y), edge(v[2], v[0], x, y), edge(v[0], v[1], x, y)};
  return DotProduct(e, form.a) / SumOf(e) * form.c[0] / form.e[0];
}

// The plane's slopes, from the first vertex: in the window alone.
float BySlopes(const FloatForm& form) {
  std::array<Floats, 3> v = form.v;
  for (Floats& corner : v) corner = Over(corner, corner[2]);
  const float x1 = v[1][0] - v[0][0], y1 = v[1][1] - v[0][1];
  const float x2 = v[2][0] - v[0][0], y2 = v[2][1] - v[0][1];
  const float a1 = form.a[1] - form.a[0], a2 = form.a[2] - form.a[0];
  const float area = x1 * y2 - x2 * y1;
  const float by_x = (a1 * y2 - a2 * y1) / area, by_y = (a2 * x1 - a1 * x2) / area;
  const float value = form.a[0] + by_x * (static_cast<float>(form.p.x) - v[0][0]) +
                      by_y * (static_cast<float>(form.p.y) - v[0][1]);
  return value * form.c[0] / form.e[0];
}

// Whether so many terms cancel that few bits would be left in float32: double is for these.
bool IsLost(const FloatForm& form) {
  constexpr double kMost = 4096;
  FloatForm sizes = form;
  for (Floats& corner : sizes.v) {
    for (float& x : corner) x = std::fabs(x);
  }
  double size = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const Floats& a = sizes.v[(i + 1) % 3];
    const Floats& b = sizes.v[(i + 2) % 3];
    const Floats terms{a[1] * b[2] + a[2] * b[1], a[2] * b[0] + a[0] * b[2],
                       a[0] * b[1] + a[1] * b[0]};
    size += static_cast<double>(At(terms, {std::fabs(form.p.x), std::fabs(form.p.y)})) *
            std::fabs(static_cast<double>(form.e[i]));
  }
  return !(std::fabs(static_cast<double>(SumOf(Times(FloatBetas(form), form.e)))) * kMost > size);
}

double InDouble(const ValueQuestion& q) {
  const bool is_equal = q.a[0] == q.a[1] && q.a[1] == q.a[2];
  if (is_equal && q.interpolation != Interpolation::kInverseW) return q.a[0];
  return WeightedSum(WeightsOf(q), q.a);
}

// Underflow is an error of its own.
ChannelStages InFloat32(float (*form)(const FloatForm&), double conditions = kUsualConditions) {
  ChannelStages stages;
  stages.profile.values.error = {0, 0x1p-148, conditions};
  stages.plane = [form](const ValueQuestion& q) {
    if (!std::ranges::all_of(q.a, [](double x) { return std::isfinite(x); })) return InDouble(q);
    const FloatForm f = FormOf(q);
    if (IsLost(f)) return InDouble(q);
    return static_cast<double>(Scaled(static_cast<double>(form(f)), f.exponent));
  };
  return stages;
}

ChannelStages NearTheTarget(float (*form)(const FloatForm&)) {
  constexpr double kConditions = 4096;
  ChannelStages stages = InFloat32(form, kConditions);
  stages.profile.coordinate_limit = 64;
  stages.takes_clip = false;
  return stages;
}

ChannelStages Changed(ChannelStages stages, const State& state) {
  state(stages);
  return stages;
}

ChannelStages RoundingCorrectly() {
  ChannelStages stages;
  ValueRule& rule = stages.profile.values;
  rule.error = {.ulps = 0.5};
  rule.equal_stay_equal = rule.exact_at_vertices = true;
  rule.stays_in_hull = rule.agrees_along_edges = true;
  rule.same_in_any_order = rule.monotone_along_rows = true;
  stages.plane = [](const ValueQuestion& q) { return static_cast<double>(CorrectlyRounded(q)); };
  return stages;
}

// The corner of the least index first.
ChannelStages InOneOrder() {
  ChannelStages stages = InFloat32(DividedLast);
  stages.profile.values.same_in_any_order = true;
  stages.plane = [plane = stages.plane](ValueQuestion q) {
    const auto first = std::ranges::min_element(q.indices) - q.indices.begin();
    std::ranges::rotate(q.v, q.v.begin() + first);
    std::ranges::rotate(q.a, q.a.begin() + first);
    return plane(q);
  };
  return stages;
}

// Where nothing is stated of slivers: each of float32's is one vertex's.
ChannelStages OfAVertexOnSlivers() {
  ChannelStages stages;
  stages.value = [](const ValueQuestion& q, double value) {
    std::array<float, 3> x{}, y{};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(q.v[i].w > 0)) return value;
      x[i] = static_cast<float>(q.v[i].x / q.v[i].w);
      y[i] = static_cast<float>(q.v[i].y / q.v[i].w);
    }
    const float area = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
    return area == 0 && q.interpolation != Interpolation::kFlat ? q.a[0] : value;
  };
  return stages;
}

// At a place of pixel and triangle: this share of the way from Direct3D's to the sample's own.
ChannelStages TowardsOwnSamples(double share) {
  ChannelStages s;
  s.profile.pattern = *StandardPattern(4);
  s.profile.centroid = Centroid::kInside;
  s.profile.values.centroids = true;
  s.asked = [share](ValueQuestion& q) {
    const double by = q.asked_at == EvaluatedAt::kCentroid ? share : 0;
    q.at.x += by * (q.low.x + q.pattern[q.sample].x - q.at.x);
    q.at.y += by * (q.low.y + q.pattern[q.sample].y - q.at.y);
  };
  return s;
}

ChannelStages ByQuads(DerivativesBy by, int origin, QuadOrigin stated = QuadOrigin::kUnstated) {
  ChannelStages stages;
  stages.profile.values.quads = stated;
  stages.profile.values.derivatives = by;
  stages.quad_origin = origin;
  return stages;
}

ChannelStages WithDepths(DepthFormat format, DepthRounding rounding) {
  ChannelStages stages;
  stages.profile.values.depth = format;
  stages.profile.values.depth_rounding = rounding;
  return stages;
}

ChannelStages UnderPreset(std::string_view preset, ChannelStages stages, BarycentricsOf of) {
  stages.base = StagesOfPreset(preset);
  stages.barycentrics_of = of;
  return stages;
}

ChannelStages Snapped(BarycentricsOf of) {
  ChannelStages stages;
  stages.profile.snap = {8};
  stages.takes_clip = false;
  stages.barycentrics_of = of;
  return stages;
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> ByForm() {
  return {
      {"values-double", "values are sums of weighted numbers in double", "", ChannelStages{}},
      {"values-products", "values are three products in float32", "", InFloat32(ByProducts)},
      {"values-divided-last", "a sum of products is divided at the end, in float32", "",
       InFloat32(DividedLast)},
      {"values-differences", "values are differences from the vertex of the least number", "",
       Changed(InFloat32(ByDifferences),
               [](ChannelStages& s) { s.profile.values.equal_stay_equal = true; })},
      {"values-differences-first", "values are differences from the first vertex", "",
       Changed(NearTheTarget(FromTheFirstVertex),
               [](ChannelStages& s) { s.profile.values.equal_stay_equal = true; })},
      {"values-planes", "values are planes from the origin, in float32", "", InFloat32(ByPlanes)},
      {"values-slopes", "values are the plane's slopes from the first vertex, near the target", "",
       NearTheTarget(BySlopes)},
      {"values-edge-functions", "weights are edge functions in float32, near the target", "",
       NearTheTarget(ByEdgeFunctions)},
      {"values-over-w", "numbers over w are divided by 1/w once", "", InFloat32(OverW)},
      {"values-weights-first", "screen weights come first", "", InFloat32(WeightsFirst)},
      {"values-inverse-matrix", "weights are rows of the corners' inverse matrix",
       "Olano and Greer 1997", InFloat32(ByInverseMatrix)},
      {"values-reciprocal", "1/w is a reciprocal of 14 bits and one step of Newton's", "",
       InFloat32(ByReciprocal, 20)},
      {"values-fused", "products and sums are fused, in float32", "", InFloat32(Fused)},
      {"values-rounded-correctly", "values are the nearest floats", "", RoundingCorrectly()},
      {"values-in-one-order", "sums begin with the corner of the least index", "", InOneOrder()},
      {"values-on-slivers", "lost slivers hold a vertex's numbers", "", OfAVertexOnSlivers()},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> ByStatement() {
  constexpr auto kFine = DerivativesBy::kFine, kCoarse = DerivativesBy::kCoarse;
  return {
      {"values-fine", "derivatives are differences in quads", "", ByQuads(kFine, 0)},
      {"values-fine-odd", "differences in quads that begin at odd pixels", "", ByQuads(kFine, 1)},
      {"values-coarse", "derivatives are the quad's", "", ByQuads(kCoarse, 0)},
      {"values-coarse-odd", "derivatives are the quad's, which begins at odd pixels", "",
       ByQuads(kCoarse, 1)},
      {"values-quads-even", "quads begin at even pixels, as is stated", "",
       ByQuads(kFine, 0, QuadOrigin::kEven)},
      {"values-quads-odd", "coarse quads begin at odd pixels, as is stated", "",
       ByQuads(kCoarse, 1, QuadOrigin::kOdd)},
      {"values-fine-float32", "derivatives are differences of values in float32", "",
       Changed(InFloat32(DividedLast),
               [](ChannelStages& s) { s.profile.values.derivatives = DerivativesBy::kFine; })},
      {"values-provoking-last", "flat values come from the last vertex", "",
       Changed({}, [](ChannelStages& s) { s.profile.values.provoking = ProvokingVertex::kLast; })},
      {"values-provoking-unstated", "flat values come from the second vertex", "",
       Changed({},
               [](ChannelStages& s) {
                 s.profile.values.provoking = ProvokingVertex::kUnstated;
                 s.asked = [](ValueQuestion& q) { q.provoking = 1; };
               })},
      {"values-screen-weights", "barycentrics are of the screen", "",
       Changed({}, [](ChannelStages& s) { s.profile.values.weights = WeightsIn::kScreen; })},
      {"values-unstated", "nothing is stated of values", "",
       Changed({}, [](ChannelStages& s) { s.profile.values = {}; })},
      {"values-snapped", "values are of the corners on the grid", "",
       Snapped(BarycentricsOf::kSnapped)},
      {"values-given", "values are of the corners as given, coverage is not", "",
       Snapped(BarycentricsOf::kGiven)},
      {"values-four-samples", "values of four samples, at centres and centroids too", "",
       Changed({},
               [](ChannelStages& s) {
                 s.profile.pattern = *StandardPattern(4);
                 s.profile.centroid = Centroid::kDirect3D;
                 s.profile.values.centroids = true;
               })},
      {"values-centroids-anywhere", "centroids are the samples", "", TowardsOwnSamples(1)},
      {"values-centroids-between", "centroids lie between samples", "", TowardsOwnSamples(0.5)},
      {"values-y-up", "y grows upwards", "",
       Changed({}, [](ChannelStages& s) { s.profile.y_axis = YAxis::kUp; })},
      {"values-y-up-fine", "y grows upwards, and derivatives are differences in quads", "",
       Changed(ByQuads(DerivativesBy::kFine, 0),
               [](ChannelStages& s) { s.profile.y_axis = YAxis::kUp; })},
      {"values-depth-unorm24", "depths have 24 bits, the nearest", "",
       WithDepths(DepthFormat::kUnorm24, DepthRounding::kNearest)},
      {"values-depth-unorm16", "depths have 16 bits, the nearest", "",
       Changed(WithDepths(DepthFormat::kUnorm16, DepthRounding::kNearest),
               [](ChannelStages& s) { s.depth_error = 0x1p-16; })},
      {"values-depth-unorm24-below", "depths have 24 bits, rounded down", "",
       Changed(WithDepths(DepthFormat::kUnorm24, DepthRounding::kEither),
               [](ChannelStages& s) {
                 s.depth = [](const ValueQuestion&, double z) {
                   return std::floor(std::clamp(z, 0.0, 1.0) * (0x1p24 - 1)) / (0x1p24 - 1);
                 };
               })},
      {"values-depth-float32", "depths are floats", "",
       WithDepths(DepthFormat::kFloat32, DepthRounding::kNearest)},
  };
}

// NOLINTNEXTLINE(readability-function-size): a table
std::vector<Mutant> ByPreset() {
  const auto last = [](ChannelStages& s) { s.profile.values.provoking = ProvokingVertex::kLast; };
  const auto unstated = [](ChannelStages& s) { s.profile.values = {}; };
  return {
      {"vulkan-values", "values are of the corners as given, in float32", "",
       UnderPreset("vulkan", InFloat32(DividedLast), BarycentricsOf::kGiven)},
      {"vulkan-values-snapped", "values are of the snapped corners", "",
       UnderPreset("vulkan", {}, BarycentricsOf::kSnapped)},
      {"gl-values", "flat values come from the last vertex", "",
       UnderPreset("gl", Changed(InFloat32(ByProducts), last), BarycentricsOf::kGiven)},
      {"gl-values-4x", "values of four samples, in quads", "",
       UnderPreset("gl-4x",
                   Changed(ByQuads(DerivativesBy::kCoarse, 1),
                           [](ChannelStages& s) { s.profile.values.centroids = true; }),
                   BarycentricsOf::kGiven)},
      {"d3d11-values", "values of snapped corners, in quads", "",
       UnderPreset("d3d11", ByQuads(DerivativesBy::kFine, 0), BarycentricsOf::kSnapped)},
      {"d3d11-values-4x", "values of four samples", "",
       UnderPreset("d3d11-4x",
                   Changed({}, [](ChannelStages& s) { s.profile.values.centroids = true; }),
                   BarycentricsOf::kSnapped)},
      {"webgpu-values", "nothing is stated of values", "",
       UnderPreset("webgpu", Changed(InFloat32(DividedLast), unstated), BarycentricsOf::kEither)},
  };
}

std::vector<Mutant> ValueVariants() {
  std::vector<Mutant> table = ByForm();
  for (const auto part : {ByStatement, ByPreset}) {
    for (Mutant& variant : part()) table.push_back(std::move(variant));
  }
  return table;
}

}  // namespace

extern constinit const MutantTable kValueVariants{MutantKind::kLegal, 18, ValueVariants};

}  // namespace rasterproof::subjects::mutants
