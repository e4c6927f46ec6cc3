// Bugs in the numbers that a rasterizer shows: edge values, walks, weights, distances.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "subjects/mutants/planted.h"

namespace rasterproof::subjects::mutants {
namespace {

using Points3 = std::array<Point2, 3>;

double TwiceArea(const Points3& v) {
  return (v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[2].y - v[0].y) * (v[1].x - v[0].x);
}

std::vector<Planted> EdgeValues() {
  const auto value = [](double (*change)(double sound, Point2 a, Point2 b, Point2 p)) {
    return ValueStages{.value = change};
  };
  return {
      {"edge-biased", "edge values are biased towards the inside", "",
       value([](double e, Point2, Point2, Point2) { return e + 0x1p-10 * std::fabs(e); })},
      {"edge-from-one-end", "the edge's constant term takes its slope from the wrong end", "",
       value([](double e, Point2 a, Point2 b, Point2) {
         return e + 0x1p-16 * (std::fabs(a.x) - std::fabs(b.x));
       })},
      {"edge-absolute", "edge values have no sign", "",
       value([](double e, Point2, Point2, Point2) { return std::fabs(e); })},
      {"edge-half-float", "edge values keep 11 bits", "",
       value([](double e, Point2, Point2, Point2) {
         const double scale = std::ldexp(1.0, std::ilogb(e == 0 ? 1 : e) - 10);
         return std::nearbyint(e / scale) * scale;
       })},
      {"edge-y-up", "edge values are those of y up", "",
       value([](double e, Point2, Point2, Point2) { return -e; })},
      {"edge-bound-too-small", "the claimed bound on edge values is a hundredth of the proven one",
       "", ValueStages{.edge_bound = 0.01}},
      {"edge-claims-exact", "edge values are claimed to be exact", "",
       ValueStages{.edge_bound = 0}},
  };
}

std::vector<Planted> EdgeWalks() {
  const auto walk = [](void (*change)(std::vector<double>&, Step)) {
    return ValueStages{.method = "f32-incremental", .walk = change};
  };
  return {
      {"walk-wrong-way", "walks along y add dX where it is subtracted", "",
       walk([](std::vector<double>& e, Step step) {
         if (!step.along_y) return;
         for (double& value : e) value = 2 * e[0] - value;
       })},
      {"walk-back-wrong", "a walk back begins one step late", "",
       walk([](std::vector<double>& e, Step step) {
         if (step.sign < 0) std::rotate(e.begin(), e.begin() + 1, e.end());
       })},
      {"walk-of-16", "a step of 16 pixels is one of 15", "",
       walk([](std::vector<double>& e, Step step) {
         if (step.length != 16) return;
         for (std::size_t n = 1; n < e.size(); ++n) e[n] -= (e[n] - e[0]) / 16;
       })},
      {"walk-loses-after-8192", "from step 8193 on a walk is a step behind", "",
       walk([](std::vector<double>& e, Step) {
         for (std::size_t n = e.size() - 1; n > 8192; --n) e[n] = e[n - 1];
       })},
      {"walk-bound-too-small", "the claimed bound on walks is a hundredth of the proven one", "",
       ValueStages{.method = "f32-incremental", .walk_bound = 0.01}},
  };
}

std::vector<Planted> Weights() {
  const auto weights = [](void (*change)(Triple&, BarycentricForm, const Points3&, Point2)) {
    return ValueStages{.weights = change};
  };
  return {
      {"weights-rotated", "weights belong to the next vertex", "",
       weights([](Triple& l, BarycentricForm, const Points3&, Point2) {
         std::ranges::rotate(l, l.begin() + 1);
       })},
      {"weights-exchanged-back", "the weights of back faces are exchanged", "",
       weights([](Triple& l, BarycentricForm, const Points3& v, Point2) {
         if (TwiceArea(v) < 0) std::swap(l[1], l[2]);
       })},
      {"weights-sum", "weights over their sum are off by 16 ulps", "nvdiffrast #229",
       weights([](Triple& l, BarycentricForm form, const Points3&, Point2) {
         if (form == BarycentricForm::kSum) l[1] *= 1 + 0x1p-19;
       })},
      {"weights-one-minus", "the third weight is one minus the first", "",
       weights([](Triple& l, BarycentricForm form, const Points3&, Point2) {
         if (form == BarycentricForm::kOneMinus) l[2] = 1 - l[0];
       })},
      {"weights-reciprocal", "the area's reciprocal has 12 bits", "PPSSPP #9686",
       weights([](Triple& l, BarycentricForm form, const Points3&, Point2) {
         if (form == BarycentricForm::kOneMinus) return;
         for (double& weight : l) weight *= 1 + 0x1.8p-13;
       })},
      {"weights-unsigned", "weights have no sign", "",
       weights([](Triple& l, BarycentricForm, const Points3&, Point2) {
         for (double& weight : l) weight = std::fabs(weight);
       })},
      {"weights-not-a-number", "weights of thin triangles are NaN", "PPSSPP #15263",
       weights([](Triple& l, BarycentricForm, const Points3& v, Point2) {
         if (std::fabs(TwiceArea(v)) < 0.125) l[0] = std::numeric_limits<double>::quiet_NaN();
       })},
      {"weights-clamped", "weights are clamped to [0, 1] outside the triangle too", "",
       weights([](Triple& l, BarycentricForm, const Points3&, Point2) {
         for (double& weight : l) weight = std::clamp(weight, 0.0, 1.0);
       })},
      {"weights-of-corner", "weights are those of the pixel's corner", "PPSSPP #9681",
       weights([](Triple& l, BarycentricForm, const Points3& v, Point2) {
         const double area = TwiceArea(v);
         for (std::size_t i = 0; i < 3; ++i) {
           const Point2& a = v[(i + 1) % 3];
           const Point2& b = v[(i + 2) % 3];
           l[i] -= 0.5 * ((b.y - a.y) - (b.x - a.x)) / area;
         }
       })},
      {"weights-bound-too-small", "the claimed bounds on weights are a fiftieth of the proven ones",
       "", ValueStages{.weight_bound = 0.02}},
  };
}

std::vector<Planted> Interpolations() {
  using Corners3 = std::array<Corner, 3>;
  const auto interpolate =
      [](double (*change)(const WeightEvaluator&, InterpolationForm, Corners3, Triple, Point2)) {
        return ValueStages{.interpolate = change};
      };
  return {
      {"depth-of-wrong-vertex", "depth by deltas takes the second vertex twice", "",
       interpolate([](const WeightEvaluator& sound, InterpolationForm form, Corners3 v, Triple z,
                      Point2 p) {
         if (form == InterpolationForm::kDeltas) z[2] = z[1];
         return sound.Interpolate(form, v, z, p);
       })},
      {"depth-rotated", "values are interpolated from the next vertex", "",
       interpolate([](const WeightEvaluator& sound, InterpolationForm form, Corners3 v, Triple z,
                      Point2 p) { return sound.Interpolate(form, v, {z[1], z[2], z[0]}, p); })},
      {"depth-16-bits", "interpolated values keep 16 bits", "",
       interpolate([](const WeightEvaluator& sound, InterpolationForm form, Corners3 v, Triple z,
                      Point2 p) {
         return std::nearbyint(sound.Interpolate(form, v, z, p) * 65535) / 65535;
       })},
      {"perspective-affine", "perspective-correct interpolation is affine", "",
       interpolate([](const WeightEvaluator& sound, InterpolationForm form, Corners3 v, Triple z,
                      Point2 p) {
         const bool perspective = form == InterpolationForm::kPerspective;
         return sound.Interpolate(perspective ? InterpolationForm::kWeights : form, v, z, p);
       })},
      {"perspective-times-w", "perspective-correct interpolation multiplies by w", "",
       interpolate([](const WeightEvaluator& sound, InterpolationForm form, Corners3 v, Triple z,
                      Point2 p) {
         for (Corner& corner : v) corner.w = 1 / corner.w;
         return sound.Interpolate(form, v, z, p);
       })},
      {"hull-left", "interpolated values overshoot the largest by 2^-12", "",
       interpolate([](const WeightEvaluator& sound, InterpolationForm form, Corners3 v, Triple z,
                      Point2 p) { return sound.Interpolate(form, v, z, p) * (1 + 0x1p-12); })},
  };
}

std::vector<Planted> Distances() {
  const auto distances = [](Triple (*change)(const WeightEvaluator&, WireframeForm, const Points3&,
                                             Point2)) { return ValueStages{.distances = change}; };
  return {
      {"distance-of-next-edge", "heights are those over the next edge", "",
       distances([](const WeightEvaluator& sound, WireframeForm form, const Points3& v, Point2 p) {
         Triple d = sound.EdgeDistances(form, v, p);
         if (form == WireframeForm::kHeight) std::ranges::rotate(d, d.begin() + 1);
         return d;
       })},
      {"distance-of-weights", "the derivative is left out", "",
       distances([](const WeightEvaluator& sound, WireframeForm form, const Points3& v, Point2 p) {
         const bool derivative = form == WireframeForm::kDerivative;
         return sound.EdgeDistances(derivative ? WireframeForm::kWeight : form, v, p);
       })},
      {"distance-in-l2", "the derivative's norm is the Euclidean one", "",
       distances([](const WeightEvaluator& sound, WireframeForm form, const Points3& v, Point2 p) {
         const bool derivative = form == WireframeForm::kDerivative;
         return sound.EdgeDistances(derivative ? WireframeForm::kHeight : form, v, p);
       })},
      {"distance-of-weight-exchanged", "weight distances belong to the next edge", "",
       distances([](const WeightEvaluator& sound, WireframeForm form, const Points3& v, Point2 p) {
         Triple d = sound.EdgeDistances(form, v, p);
         if (form == WireframeForm::kWeight) std::ranges::rotate(d, d.begin() + 1);
         return d;
       })},
  };
}

}  // namespace

std::vector<Planted> ShownValueMutants() {
  std::vector<Planted> table = EdgeValues();
  for (const auto more : {EdgeWalks, Weights, Interpolations, Distances}) {
    for (Planted& planted : more()) table.push_back(std::move(planted));
  }
  return table;
}

}  // namespace rasterproof::subjects::mutants
