// Bugs in barycentrics and in what is computed from them.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "tests/props/planted_bugs.h"

namespace rasterproof::props {

std::vector<PlantedBug> BarycentricPlantedBugs() {
  using Triple = std::array<double, 3>;
  using Points = std::array<Point2, 3>;
  const auto barycentrics = [](BarycentricsBug bug) {
    Bug planted;
    planted.barycentrics = std::move(bug);
    return planted;
  };
  const auto interpolate = [](InterpolationBug bug) {
    Bug planted;
    planted.interpolate = std::move(bug);
    return planted;
  };
  return {
      {"BarycentricsStayWithinTheirBound", "an approximate reciprocal", "spans-exact",
       barycentrics([](Triple& l, BarycentricForm, const Points&) { l[0] *= 1 + 0x1p-12; })},
      {"BarycentricsSumToOne", "one minus one of them", "spans-exact",
       barycentrics([](Triple& l, BarycentricForm form, const Points&) {
         if (form == BarycentricForm::kOneMinus) l[2] = 1 - l[0];
       })},
      {"BarycentricIsOneAtItsVertexAndZeroOpposite", "a bias", "spans-exact",
       barycentrics([](Triple& l, BarycentricForm, const Points&) { l[1] += 0x1p-6; })},
      {"BarycentricSignsAgreeWithTheEdges", "lengths of cross products", "spans-exact",
       barycentrics([](Triple& l, BarycentricForm, const Points&) {
         for (double& barycentric : l) barycentric = std::fabs(barycentric);
       })},
      {"BarycentricsReproduceThePoint", "barycentrics of the edges, not the vertices",
       "spans-exact",
       barycentrics([](Triple& l, BarycentricForm, const Points&) { l = {l[2], l[0], l[1]}; })},
      {"BarycentricsFollowTheirVertices", "the first vertex weighs more", "spans-exact",
       barycentrics([](Triple& l, BarycentricForm, const Points&) { l[0] *= 1 + 0x1p-12; })},
      {"InterpolatedValuesStayInTheHull", "no clamp, a quarter too much", "spans-exact",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, const auto& v,
                      Triple z, Point2 p) { return 1.25 * sound.Interpolate(form, v, z, p); })},
      {"InterpolationStaysWithinItsBound", "half the mantissa", "spans-exact",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, const auto& v,
                      Triple z,
                      Point2 p) { return (1 + 0x1p-12) * sound.Interpolate(form, v, z, p); })},
      {"DepthByDeltasEqualsDepthByBarycentrics", "the wrong delta", "spans-exact",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, const auto& v,
                      Triple z, Point2 p) {
         if (form == InterpolationForm::kDeltas) z[2] = z[1];
         return sound.Interpolate(form, v, z, p);
       })},
      {"PerspectiveInterpolationStaysWithinItsBound", "no division by w", "spans-exact",
       interpolate([](const BarycentricEvaluator& sound, InterpolationForm form, const auto& v,
                      Triple z, Point2 p) {
         const bool perspective = form == InterpolationForm::kPerspective;
         return sound.Interpolate(perspective ? InterpolationForm::kBarycentrics : form, v, z, p);
       })},
  };
}

std::vector<PlantedBug> WireframePlantedBugs() {
  using Points = std::array<Point2, 3>;
  const auto distances = [](DistancesBug bug) {
    Bug planted;
    planted.distances = std::move(bug);
    return planted;
  };
  // The height over edge i is the height form's distance at vertex i.
  const auto swapped_heights = [](const BarycentricEvaluator& sound, WireframeForm, const Points& v,
                                  Point2 p) {
    const std::array<double, 3> l = sound.EdgeDistances(WireframeForm::kBarycentric, v, p);
    std::array<double, 3> distances{};
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t other = (i + 1) % 3;
      distances[i] = l[i] * sound.EdgeDistances(WireframeForm::kHeight, v, v[other])[other];
    }
    return distances;
  };
  return {
      {"BarycentricDistanceIsTheSmallestCoordinate", "pixels", "spans-exact",
       distances([](const BarycentricEvaluator& sound, WireframeForm, const Points& v, Point2 p) {
         return sound.EdgeDistances(WireframeForm::kHeight, v, p);
       })},
      {"DerivativeDistanceMeasuresInTheL1Norm", "the L2 norm", "spans-exact",
       distances([](const BarycentricEvaluator& sound, WireframeForm, const Points& v, Point2 p) {
         return sound.EdgeDistances(WireframeForm::kHeight, v, p);
       })},
      {"HeightDistanceIsTheDistanceInPixels", "heights of other vertices", "spans-exact",
       distances(swapped_heights)},
  };
}

}  // namespace rasterproof::props
