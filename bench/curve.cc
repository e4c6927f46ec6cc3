#include "bench/curve.h"

#include <cmath>
#include <vector>

namespace rasterproof::bench {

std::vector<BenchPoint> ErrorCurve(SceneDrawer& drawer, const Parameter& parameter,
                                   JudgedCases& cases) {
  std::vector<BenchPoint> points;
  for (int k = parameter.least_exponent; k <= parameter.most_exponent; k += parameter.curve_every) {
    const double value = std::ldexp(1.0, k);
    const CaseErrors errors = cases.Of(drawer, parameter, value, WithBounds::kYes);
    if (errors.asked == 0 && std::isnan(errors.share_of_bound)) continue;
    BenchPoint point;
    point.value = value;
    point.asked = errors.asked;
    point.wrong = errors.wrong;
    point.displacement = errors.displacement;
    point.share_of_bound = errors.share_of_bound;
    points.push_back(point);
  }
  return points;
}

}  // namespace rasterproof::bench
