// Bugs in the numbers that a rasterizer shows: edge values, steps, barycentrics, distances.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

#include "subjects/mutants/mutant.h"

namespace rasterproof::subjects::mutants {
namespace {

using Points3 = std::array<Point2, 3>;

double TwiceArea(const Points3& v) {
  return (v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[2].y - v[0].y) * (v[1].x - v[0].x);
}

std::vector<Mutant> EdgeValues() {
  const auto value = [](double (*change)(double sound, Point2 a, Point2 b, Point2 p)) {
    return ValueStages{.value = change};
  };
  return {
      {"edge-biased", "edge values are biased towards the inside", "",
       value([](double e, Point2, Point2, Point2) { return e + 0x1p-10 * std::fabs(e); }),
       "shown-values", "MirrorNegatesEdgeValues|ReversedEdgeChangesSign"},
      {"edge-from-one-end", "the edge's constant term takes its slope from the wrong end", "",
       value([](double e, Point2 a, Point2 b, Point2) {
         return e + 0x1p-16 * (std::fabs(a.x) - std::fabs(b.x));
       }),
       "shown-values",
       "CyclicRotationKeepsTheArea|EdgeIsZeroAtItsEnds|IntegerTranslationKeepsEdgeValues|"
       "PowerOfTwoScalingScalesEdgeValues"},
      {"edge-absolute", "edge values have no sign", "",
       value([](double e, Point2, Point2, Point2) { return std::fabs(e); }), "shown-values",
       "EdgeSignIsRightOutsideItsBand"},
      {"edge-half-float", "edge values keep 11 bits", "",
       value([](double e, Point2, Point2, Point2) {
         const double scale = std::ldexp(1.0, std::ilogb(e == 0 ? 1 : e) - 10);
         return std::nearbyint(e / scale) * scale;
       }),
       "shown-values", "EdgeErrorStaysWithinItsBound"},
      {"edge-y-up", "edge values are those of y up", "",
       value([](double e, Point2, Point2, Point2) { return -e; }), "shown-values"},
      {"edge-bound-too-small", "the stated bound on edge values is a hundredth of the proven one",
       "", ValueStages{.edge_bound = 0.01}, "shown-values", "EdgeErrorStaysWithinItsBound"},
      {"edge-states-exact", "edge values claim to be exact", "", ValueStages{.edge_bound = 0},
       "shown-values"},
  };
}

std::vector<Mutant> EdgeSteps() {
  const auto steps = [](void (*change)(std::vector<double>&, Step)) {
    return ValueStages{.method = "f32-incremental", .steps = change};
  };
  return {
      {"stepping-wrong-way", "steps along y add dX where it is subtracted", "",
       steps([](std::vector<double>& e, Step step) {
         if (!step.along_y) return;
         for (double& value : e) value = 2 * e[0] - value;
       }),
       "shown-values", "SteppingStaysWithinItsBound"},
      {"stepping-back-wrong", "stepping back begins one step late", "",
       steps([](std::vector<double>& e, Step step) {
         if (step.sign < 0) std::rotate(e.begin(), e.begin() + 1, e.end());
       }),
       "shown-values", "SteppingStaysWithinItsBound"},
      {"stepping-of-16", "a step of 16 pixels is one of 15", "",
       steps([](std::vector<double>& e, Step step) {
         if (step.length != 16) return;
         for (std::size_t n = 1; n < e.size(); ++n) e[n] -= (e[n] - e[0]) / 16;
       }),
       "shown-values", "SteppingEqualsDirectWhereExact"},
      {"stepping-loses-after-8192", "from step 8193 on the values are a step behind", "",
       steps([](std::vector<double>& e, Step) {
         for (std::size_t n = e.size() - 1; n > 8192; --n) e[n] = e[n - 1];
       }),
       "shown-values", "LongSteppingStaysWithinItsBound"},
      {"stepping-last-lost", "the value after the last step is not shown", "",
       steps([](std::vector<double>& e, Step) { e.pop_back(); }), "shown-values",
       "SteppingStaysWithinItsBound"},
      {"stepping-bound-too-small", "the stated bound on steps is a hundredth of the proven one", "",
       ValueStages{.method = "f32-incremental", .stepping_bound = 0.01}, "shown-values"},
  };
}

std::vector<Mutant> Barycentrics() {
  const auto barycentrics = [](void (*change)(Triple&, BarycentricForm, const Points3&, Point2)) {
    return ValueStages{.barycentrics = change};
  };
  return {
      {"barycentrics-rotated", "barycentrics belong to the next vertex", "",
       barycentrics([](Triple& l, BarycentricForm, const Points3&, Point2) {
         std::ranges::rotate(l, l.begin() + 1);
       }),
       "shown-values", "BarycentricIsOneAtItsVertexAndZeroOpposite|BarycentricsReproduceThePoint"},
      {"barycentrics-exchanged-back", "the barycentrics of back faces are exchanged", "",
       barycentrics([](Triple& l, BarycentricForm, const Points3& v, Point2) {
         if (TwiceArea(v) < 0) std::swap(l[1], l[2]);
       }),
       "shown-values", "BarycentricsFollowTheirVertices"},
      {"barycentrics-sum", "barycentrics over their sum are off by 16 ulps", "nvdiffrast #229",
       barycentrics([](Triple& l, BarycentricForm form, const Points3&, Point2) {
         if (form == BarycentricForm::kSum) l[1] *= 1 + 0x1p-19;
       }),
       "shown-values"},
      {"barycentrics-one-minus", "the third barycentric is one minus the first", "",
       barycentrics([](Triple& l, BarycentricForm form, const Points3&, Point2) {
         if (form == BarycentricForm::kOneMinus) l[2] = 1 - l[0];
       }),
       "shown-values", "BarycentricsSumToOne"},
      {"barycentrics-reciprocal", "the area's reciprocal has 12 bits", "PPSSPP #9686",
       barycentrics([](Triple& l, BarycentricForm form, const Points3&, Point2) {
         if (form == BarycentricForm::kOneMinus) return;
         for (double& barycentric : l) barycentric *= 1 + 0x1.8p-13;
       }),
       "shown-values", "BarycentricsStayWithinTheirBound"},
      {"barycentrics-unsigned", "barycentrics have no sign", "",
       barycentrics([](Triple& l, BarycentricForm, const Points3&, Point2) {
         for (double& barycentric : l) barycentric = std::fabs(barycentric);
       }),
       "shown-values", "BarycentricSignsAgreeWithTheEdges"},
      {"barycentrics-not-a-number", "barycentrics of thin triangles are NaN", "PPSSPP #15263",
       barycentrics([](Triple& l, BarycentricForm, const Points3& v, Point2) {
         if (std::fabs(TwiceArea(v)) < 0.125) l[0] = std::numeric_limits<double>::quiet_NaN();
       }),
       "shown-values"},
      {"barycentrics-clamped", "barycentrics are clamped to [0, 1] outside the triangle too", "",
       barycentrics([](Triple& l, BarycentricForm, const Points3&, Point2) {
         for (double& barycentric : l) barycentric = std::clamp(barycentric, 0.0, 1.0);
       }),
       "shown-values"},
      {"barycentrics-of-corner", "barycentrics are those of the pixel's corner", "PPSSPP #9681",
       barycentrics([](Triple& l, BarycentricForm, const Points3& v, Point2) {
         const double area = TwiceArea(v);
         for (std::size_t i = 0; i < 3; ++i) {
           const Point2& a = v[(i + 1) % 3];
           const Point2& b = v[(i + 2) % 3];
           l[i] -= 0.5 * ((b.y - a.y) - (b.x - a.x)) / area;
         }
       }),
       "shown-values"},
      {"barycentrics-bound-too-small",
       "the stated bounds on barycentrics are a fiftieth of the proven ones", "",
       ValueStages{.barycentric_bound = 0.02}, "shown-values"},
  };
}

std::vector<Mutant> Interpolations() {
  using Corners3 = std::array<Corner, 3>;
  const auto interpolate = [](double (*change)(const BarycentricEvaluator&, InterpolationForm,
                                               Corners3, Triple, Point2)) {
    return ValueStages{.interpolate = change};
  };
  return {
      {"depth-of-wrong-vertex", "depth by deltas takes the second vertex twice", "",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, Corners3 v,
                      Triple z, Point2 p) {
         if (form == InterpolationForm::kDeltas) z[2] = z[1];
         return sound.Interpolate(form, v, z, p);
       }),
       "shown-values", "DepthByDeltasEqualsDepthByBarycentrics"},
      {"depth-rotated", "values are interpolated from the next vertex", "",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, Corners3 v,
                      Triple z,
                      Point2 p) { return sound.Interpolate(form, v, {z[1], z[2], z[0]}, p); }),
       "shown-values"},
      {"depth-16-bits", "interpolated values keep 16 bits", "",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, Corners3 v,
                      Triple z, Point2 p) {
         return std::nearbyint(sound.Interpolate(form, v, z, p) * 65535) / 65535;
       }),
       "shown-values", "InterpolationStaysWithinItsBound"},
      {"perspective-affine", "perspective-correct interpolation is affine", "",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, Corners3 v,
                      Triple z, Point2 p) {
         const bool perspective = form == InterpolationForm::kPerspective;
         return sound.Interpolate(perspective ? InterpolationForm::kBarycentrics : form, v, z, p);
       }),
       "shown-values", "PerspectiveInterpolationStaysWithinItsBound"},
      {"perspective-times-w", "perspective-correct interpolation multiplies by w", "",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, Corners3 v,
                      Triple z, Point2 p) {
         for (Corner& corner : v) corner.w = 1 / corner.w;
         return sound.Interpolate(form, v, z, p);
       }),
       "shown-values"},
      {"hull-left", "interpolated values overshoot the largest by 2^-12", "",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, Corners3 v,
                      Triple z,
                      Point2 p) { return sound.Interpolate(form, v, z, p) * (1 + 0x1p-12); }),
       "shown-values", "InterpolatedValuesStayInTheHull"},
  };
}

std::vector<Mutant> Distances() {
  const auto distances =
      [](Triple (*change)(const BarycentricEvaluator&, WireframeForm, const Points3&, Point2)) {
        return ValueStages{.distances = change};
      };
  return {
      {"distance-of-next-edge", "heights are those over the next edge", "",
       distances(
           [](const BarycentricEvaluator& sound, WireframeForm form, const Points3& v, Point2 p) {
             Triple d = sound.EdgeDistances(form, v, p);
             if (form == WireframeForm::kHeight) std::ranges::rotate(d, d.begin() + 1);
             return d;
           }),
       "shown-values", "HeightDistanceIsTheDistanceInPixels"},
      {"distance-of-barycentrics", "the derivative is left out", "",
       distances(
           [](const BarycentricEvaluator& sound, WireframeForm form, const Points3& v, Point2 p) {
             const bool derivative = form == WireframeForm::kDerivative;
             return sound.EdgeDistances(derivative ? WireframeForm::kBarycentric : form, v, p);
           }),
       "shown-values"},
      {"distance-in-l2", "the derivative's norm is the Euclidean one", "",
       distances(
           [](const BarycentricEvaluator& sound, WireframeForm form, const Points3& v, Point2 p) {
             const bool derivative = form == WireframeForm::kDerivative;
             return sound.EdgeDistances(derivative ? WireframeForm::kHeight : form, v, p);
           }),
       "shown-values", "DerivativeDistanceMeasuresInTheL1Norm"},
      {"distance-of-barycentric-exchanged", "barycentric distances belong to the next edge", "",
       distances(
           [](const BarycentricEvaluator& sound, WireframeForm form, const Points3& v, Point2 p) {
             Triple d = sound.EdgeDistances(form, v, p);
             if (form == WireframeForm::kBarycentric) std::ranges::rotate(d, d.begin() + 1);
             return d;
           }),
       "shown-values", "BarycentricDistanceIsTheSmallestCoordinate"},
  };
}

std::vector<Mutant> ShownValueMutants() {
  std::vector<Mutant> table = EdgeValues();
  for (const auto more : {EdgeSteps, Barycentrics, Interpolations, Distances}) {
    for (Mutant& planted : more()) table.push_back(std::move(planted));
  }
  return table;
}

}  // namespace

extern constinit const MutantTable kShownValueMutants{MutantKind::kPlanted, 12, ShownValueMutants};

}  // namespace rasterproof::subjects::mutants
