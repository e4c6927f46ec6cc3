// The weighted sum of the vertices is the sample, up to the barycentrics' bounds times the
// coordinates.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "props/judging/values/barycentric_queries.h"
#include "props/judging/values/exact_comparison.h"
#include "props/judging/witness.h"
#include "props/placed_case.h"
#include "props/properties/domain_lists.h"
#include "props/properties/row_words.h"
#include "props/property.h"

namespace rasterproof::props {
namespace barycentrics_reproduce_the_point {

using exact::Rational;

// sum l_i v_i - p = sum (l_i - lambda_i) v_i exactly, because sum lambda_i v_i = p: so the distance
// along an axis is at most sum bound_i |v_i|.
struct Reproduced {
  Rational distance;
  Rational bound;
};

Reproduced Reproduce(const std::array<double, 3>& barycentrics, const std::array<double, 3>& bounds,
                     const std::array<double, 3>& coordinates, double p) {
  Rational sum = -Rational(p);
  Rational bound;
  for (std::size_t i = 0; i < 3; ++i) {
    sum += Rational(barycentrics[i]) * Rational(coordinates[i]);
    bound += Rational(bounds[i]) * Rational(std::fabs(coordinates[i]));
  }
  return {sum.Abs(), bound};
}

Verdict Judge(const std::vector<BarycentricAnswer>& answers) {
  std::uint64_t exercised = 0;
  for (const auto& [q, forms] : answers) {
    const Point2 p = q.place.at;
    for (const auto& [form, barycentrics, bounds] : forms) {
      if (!std::ranges::all_of(bounds, IsStated)) continue;
      ++exercised;
      const std::string property =
          "barycentrics (" + std::string(FormName(form)) + ") do not reproduce the sample";
      if (!std::ranges::all_of(barycentrics, [](double x) { return std::isfinite(x); })) {
        return BarycentricViolation(q, -1, exercised, property, Listed(barycentrics),
                                    {"finite barycentrics"});
      }
      const Reproduced x = Reproduce(barycentrics, bounds, {q.v[0].x, q.v[1].x, q.v[2].x}, p.x);
      const Reproduced y = Reproduce(barycentrics, bounds, {q.v[0].y, q.v[1].y, q.v[2].y}, p.y);
      if (x.distance <= x.bound && y.distance <= y.bound) continue;
      return BarycentricViolation(
          q, -1, exercised, property, Listed(barycentrics),
          {"off by at most (", x.bound.ToDoubleUp(), ", ", y.bound.ToDoubleUp(), "), not (",
           x.distance.ToDouble(), ", ", y.distance.ToDouble(), ")"});
    }
  }
  return Verdict::Held(exercised);
}

Checks Ask(const PlacedCase& c, const Description& subject) {
  return AskBarycentrics(SomeBarycentricQueries(c), *subject.barycentrics, Judge);
}

}  // namespace barycentrics_reproduce_the_point

extern constinit const Property kBarycentricsReproduceThePoint{
    .name = "BarycentricsReproduceThePoint",
    .group = "barycentric",
    .clause =
        "p = a p_a + b p_b + c p_c (OpenGL 4.6 section 14.6.1 and Vulkan 1.3, Basic Polygon "
        "Rasterization).",
    .tolerance = "sum of bound_i |v_i|",
    .domains = kBarycentrics,
    .gate = Where(kAsksBarycentrics, kAreaNotZero),
    .ask = barycentrics_reproduce_the_point::Ask,
};

}  // namespace rasterproof::props
