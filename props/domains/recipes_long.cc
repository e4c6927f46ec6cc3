// Edges of every length: along rows and columns of samples, and around the least areas there are.
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"

namespace rasterproof::props {
namespace {

// The exponent of the longest length that is drawn.
int MostExponent(const CaseBuilder& builder) { return std::max(3, std::ilogb(builder.Range())); }

}  // namespace

static Case LeastAreas(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const int most = MostExponent(builder);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // From one end past a sample to the other, as near to the sample as the lattice allows without
    // passing through it; the third vertex is the sample, or a step or two beside it.
    const Point2 p = builder.Sample();
    const double x = builder.LogUniform(0, most);
    const Point2 end{builder.lattice().RoundWithinLimit(p.x + x),
                     builder.lattice().RoundWithinLimit(p.y + builder.LogUniform(0, most))};
    const double times = Exp2(builder.Uniform(-3, 1));
    const Point2 far{p.x - times * (end.x - p.x), p.y - times * (end.y - p.y)};
    const Point2 third = bits.Chance(192) ? p : Nudged(builder, p, 2);
    builder.AddTriangle({end, Hardest(builder, far, end, p), third});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kLeastAreasDomain{
    .number = 99,
    .bits = 0x72f7c7b9484cb03,
    .listed = 531,
    .name = "least-areas",
    .summary = "slivers of every length, as thin as the lattice allows, around a sample",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .draw = LeastAreas};

static Case RowsAndColumns(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const int most = MostExponent(builder);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // An edge along the row or the column of a sample, to both its sides or from it on.
    const Point2 p = builder.Sample();
    const bool is_row = bits.Chance(128);
    const double ahead = std::fabs(builder.LogUniform(-4, most));
    const double behind = bits.Chance(64) ? 0 : std::fabs(builder.LogUniform(-4, most));
    const double sign = builder.Sign();
    const Point2 a = is_row ? Point2{p.x + sign * ahead, p.y} : Point2{p.x, p.y + sign * ahead};
    const Point2 b = is_row ? Point2{p.x - sign * behind, p.y} : Point2{p.x, p.y - sign * behind};
    const double along = builder.Uniform(0, 1);
    const double across = builder.LogUniform(-4, most);
    const Point2 foot{a.x + along * (b.x - a.x), a.y + along * (b.y - a.y)};
    const Point2 third = is_row ? Point2{foot.x, foot.y + across} : Point2{foot.x + across, foot.y};
    builder.AddTriangle({a, b, third});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kRowsAndColumnsDomain{
    .number = 55,
    .bits = 0xc30d7c15af224857,
    .name = "rows-and-columns",
    .summary = "edges of every length along a row or a column of samples",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .ties = true,
    .draw = RowsAndColumns};

}  // namespace rasterproof::props
