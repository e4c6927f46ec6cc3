// Edges of every length: along rows and columns of samples, and around the least areas there are.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "props/domains/lines.h"
#include "props/domains/recipes.h"
#include "props/domains/sketch.h"

namespace rasterproof::props {
namespace {

// The exponent of the longest length that is drawn.
int MostExponent(const Sketch& sketch) { return std::max(3, std::ilogb(sketch.Range())); }

}  // namespace

Case LeastAreas(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const int most = MostExponent(sketch);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // From one end past a sample to the other, as near to the sample as the lattice allows without
    // passing through it; the third vertex is the sample, or a step or two beside it.
    const Point2 p = sketch.Sample();
    const double x = sketch.LogUniform(0, most);
    const Point2 end{sketch.lattice().RoundWithinLimit(p.x + x),
                     sketch.lattice().RoundWithinLimit(p.y + sketch.LogUniform(0, most))};
    const double times = std::exp2(sketch.Uniform(-3, 1));
    const Point2 far{p.x - times * (end.x - p.x), p.y - times * (end.y - p.y)};
    const Point2 third = bits.Chance(192) ? p : Nudged(sketch, p, 2);
    sketch.AddTriangle({end, Hardest(sketch, far, end, p), third});
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case RowsAndColumns(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const int most = MostExponent(sketch);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // An edge along the row or the column of a sample, to both its sides or from it on.
    const Point2 p = sketch.Sample();
    const bool is_row = bits.Chance(128);
    const double ahead = std::fabs(sketch.LogUniform(-4, most));
    const double behind = bits.Chance(64) ? 0 : std::fabs(sketch.LogUniform(-4, most));
    const double sign = sketch.Sign();
    const Point2 a = is_row ? Point2{p.x + sign * ahead, p.y} : Point2{p.x, p.y + sign * ahead};
    const Point2 b = is_row ? Point2{p.x - sign * behind, p.y} : Point2{p.x, p.y - sign * behind};
    const double along = sketch.Uniform(0, 1);
    const double across = sketch.LogUniform(-4, most);
    const Point2 foot{a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)};
    const Point2 third = is_row ? Point2{foot.x, foot.y + across} : Point2{foot.x + across, foot.y};
    sketch.AddTriangle({a, b, third});
  }
  return sketch.Done(Finish::kAnyOrder);
}

}  // namespace rasterproof::props
