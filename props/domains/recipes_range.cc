// Triangles as large as the profile states, edges whose ends differ by every order of magnitude,
// ties of the snap that decide a sample, and targets that are covered all over.
#include "props/domains/recipes_range.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "core/ulp.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"

namespace rasterproof::props {
namespace {

// An end of the range or up to two steps inside, and sometimes an ordinary place.
double EndOfRange(CaseBuilder& builder, double range, bool along_y) {
  if (builder.bits().Chance(48)) {
    return builder.Coordinate(along_y ? builder.height() : builder.width(), along_y);
  }
  const double sign = builder.Sign();
  const std::int64_t steps = builder.bits().Int(0, 2);
  if (sign > 0) return builder.lattice().Move(range, -steps);
  return builder.lattice().Move(builder.LeastOfRange(), steps);
}

// Somewhere on the outline of the range.
Point2 OnOutline(CaseBuilder& builder, double range) {
  const double along = builder.Uniform(-range, range);
  const double across = builder.Sign() * range;
  return builder.bits().Chance(128) ? Point2{along, across} : Point2{across, along};
}

}  // namespace

static Case RangeEnds(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const double range = builder.Range();
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    if (bits.Chance(128)) {
      std::array<Point2, 3> v;
      for (Point2& p : v) {
        const double x = EndOfRange(builder, range, false);
        p = {x, EndOfRange(builder, range, true)};
      }
      builder.AddTriangle(v);
      continue;
    }
    if (bits.Chance(64)) {
      // Legs along a row and a column of samples, as long as any that the range allows.
      const Point2 p = builder.Sample();
      const int most = std::max(2, std::ilogb(range));
      const Point2 far{p.x + builder.LogUniform(1, most), p.y + builder.LogUniform(1, most)};
      builder.AddTriangle({p, Point2{far.x, p.y}, Point2{p.x, far.y}});
      continue;
    }
    // A needle across the range, a step or two wide, through a sample. Or as thin as the lattice
    // allows without being empty, the sample its third vertex.
    const Point2 p = builder.Sample();
    const Point2 q = OnOutline(builder, range);
    const double times = builder.Uniform(0.25, 1);
    const Point2 far{p.x - times * (q.x - p.x), p.y - times * (q.y - p.y)};
    if (bits.Chance(128)) {
      const Point2 end{builder.lattice().RoundWithinLimit(q.x),
                       builder.lattice().RoundWithinLimit(q.y)};
      builder.AddTriangle({end, Hardest(builder, far, end, p), p});
      continue;
    }
    builder.AddTriangle({q, far, Nudged(builder, bits.Chance(128) ? far : q, 2)});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kRangeEndsDomain{
    .number = 18,
    .bits = 0xfcb7fc6849ab4df6,
    .name = "range-ends",
    .summary = "triangles and needles from one end of the stated range to the other",
    .theme = DomainTheme::kMagnitudes,
    .draw = RangeEnds};

static Case FarNegativeCorners(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const double range = builder.Range();
  const int most = std::max(5, std::ilogb(range));
  const auto far = [&] { return -std::min(std::fabs(builder.LogUniform(4, most)), range); };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // One corner far to the left, one far above, either or both of them far both ways; the third on
    // the target or beyond it.
    const double left = far();
    const double above = far();
    const double y = bits.Chance(128) ? far() : builder.Coordinate(builder.height(), true);
    const double x = bits.Chance(128) ? far() : builder.Coordinate(builder.width(), false);
    const double times = bits.Chance(128) ? 1 : std::fabs(builder.LogUniform(0, most - 5));
    const Point2 third = builder.Place();
    const Point2 end{times * third.x, times * third.y};
    builder.AddTriangle({Point2{left, y}, Point2{x, above}, end});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kFarNegativeCornersDomain{
    .number = 19,
    .bits = 0xf5ccd248e0025ed9,
    .name = "far-negative-corners",
    .summary = "a corner far to the left and one far above, as where a picture is tiled",
    .theme = DomainTheme::kMagnitudes,
    .draw = FarNegativeCorners};

static Case RoundedDifferences(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const bool is_float32 = builder.lattice().precision() == Precision::kFloat32;
  const int least = is_float32 ? -149 : -1074;
  const int significant = is_float32 ? 24 : 53;
  const auto draw_scale = [&] {
    const std::int64_t kind = bits.Int(0, 3);
    // Where the difference of a float32 and a sample has more bits than a double.
    if (kind >= 2) return builder.LogUniform(-54, -26);
    // Subnormal, or anything.
    return builder.LogUniform(least, kind == 1 ? least + significant : -8);
  };
  const std::int64_t triangles = bits.Int(1, 8);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // One end on the line through a sample and the origin, next to the origin; the other end a
    // multiple of the sample. What the difference of sample and end rounds away decides the sign.
    const Point2 p = builder.Sample();
    const double scale = draw_scale();
    Point2 end{scale * p.x, scale * p.y};
    if (bits.Chance(192)) end = Nudged(builder, end, 2);
    if (bits.Chance(32)) end = {0, 0};
    const auto times = static_cast<double>(bits.Int(1, 4));
    Point2 third = builder.Place();
    if (bits.Chance(128)) {
      // A sliver whose short side is as tiny.
      const double x = scale * builder.Uniform(-2, 2) * p.x;
      third = {x, scale * builder.Uniform(-2, 2) * p.y};
    }
    builder.AddTriangle({end, Point2{times * p.x, times * p.y}, third});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kRoundedDifferencesDomain{
    .number = 20,
    .bits = 0xb852f3049d66f8b,
    .name = "rounded-differences",
    .summary = "an end next to the origin, the sample's differences with it rounded",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .exact_tier = true,
    .draw = RoundedDifferences};

static Case SubPixelTriangles(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 6);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // Around one sample, every side shorter than a pixel, down to the lattice's step.
    const Point2 p = builder.Sample();
    const double reach = std::fabs(builder.LogUniform(-12, -2));
    const auto beside = [&] {
      const double x = p.x + reach * builder.Uniform(-1, 1);
      return Point2{x, p.y + reach * builder.Uniform(-1, 1)};
    };
    const Point2 drawn = beside();
    const Point2 q{builder.lattice().RoundWithinLimit(drawn.x),
                   builder.lattice().RoundWithinLimit(drawn.y)};
    const double times = builder.Uniform(0.5, 1);
    const Point2 opposite{p.x - times * (q.x - p.x), p.y - times * (q.y - p.y)};
    const Point2 v = bits.Chance(192) ? Hardest(builder, opposite, q, p) : opposite;
    builder.AddTriangle({q, v, beside()});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSubPixelTrianglesDomain{
    .number = 21,
    .bits = 0x8544d5ee2e675b6e,
    .name = "sub-pixel-triangles",
    .summary = "triangles smaller than a pixel, an edge as near to the sample as can be",
    .theme = DomainTheme::kOrdinary,
    .in_theme = 702,
    .draw = SubPixelTriangles};

void AddDecidingTies(CaseBuilder& builder) {
  BitSource& bits = builder.bits();
  const Snap& snap = builder.profile().snap;
  const int subpixel_bits = snap.IsNone() ? 8 : snap.bits;
  // Log-uniform places: next to the origin an ulp is far below the grid's step, and forms of the
  // snap that agree elsewhere part.
  const auto grid_place = [&] {
    const auto most = static_cast<double>(subpixel_bits + 5);
    const double cells = std::floor(Exp2(builder.Uniform(0, most))) - 1;
    return builder.Sign() * std::ldexp(cells, -subpixel_bits);
  };
  // Half way to the next grid place, or a few ulps beside.
  const auto tie_beside = [&](double x) {
    const double tie =
        builder.lattice().RoundToPrecision(x + builder.Sign() * std::ldexp(0.5, -subpixel_bits));
    const std::int64_t ulps = bits.Int(-2, 2);
    return builder.lattice().precision() == Precision::kFloat32
               ? double{MoveByUlps(static_cast<float>(tie), ulps)}
               : MoveByUlps(tie, ulps);
  };
  const std::int64_t triangles = bits.Int(2, 6);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // From the grid place the edge passes through a sample; from its neighbours it does not.
    const Point2 p = builder.Sample();
    const double x = grid_place();
    const Point2 g{x, grid_place()};
    const auto times = static_cast<double>(bits.Int(1, 3));
    const std::int32_t end = builder.Add({p.x + times * (p.x - g.x), p.y + times * (p.y - g.y)});
    const bool along_x = bits.Chance(128);
    const Vertex tie{along_x ? tie_beside(g.x) : g.x, along_x ? g.y : tie_beside(g.y)};
    const std::int32_t decided = builder.AddRaw(tie);
    builder.AddTriangle(decided, end, builder.Add(builder.Place()));
  }
}

static Case DecidingSnapTies(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  AddDecidingTies(builder);
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kDecidingSnapTiesDomain{
    .number = 22,
    .bits = 0x86386b3ce65959c,
    .name = "deciding-snap-ties",
    .summary = "vertices at or beside ties of the snap that decide who owns a sample",
    .theme = DomainTheme::kSnapping,
    .in_theme = 241,
    .off_grid = true,
    .in_a_round = 3,
    // What a transform rounds otherwise by an ulp shows there, and hardly elsewhere.
    .in_a_round_behind_transforms = 8,
    .draw = DecidingSnapTies};

static Case FullCoverage(BitSource& bits, const SubjectInfo& info) {
  const auto samples = static_cast<int>(info.profile.pattern.locations.size());
  const int most = std::max(16, 512 / std::max(1, samples));
  const int width = static_cast<int>(bits.Int(most / 2, most));
  const int height = static_cast<int>(bits.Int(most / 4, most / 2));
  CaseBuilder builder(bits, info, width, height);
  const std::int64_t triangles = bits.Int(4, 8);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // The right angle outside one corner of the target, the legs about twice its sides: some cover
    // all of it, the others most.
    const bool right = bits.Chance(128);
    const bool bottom = bits.Chance(128);
    const double x = builder.Uniform(-0.25, 0) * width;
    const double y = builder.Uniform(-0.25, 0) * height;
    const double along = builder.Uniform(1.5, 2.5) * width;
    const double down = builder.Uniform(1.5, 2.5) * height;
    std::array<Point2, 3> v{Point2{x, y}, Point2{along, y}, Point2{x, down}};
    for (Point2& p : v) {
      if (right) p.x = width - p.x;
      if (bottom) p.y = height - p.y;
    }
    builder.AddTriangle(v);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kFullCoverageDomain{
    .number = 23,
    .bits = 0x9d026271490022d,
    .name = "full-coverage",
    .summary = "targets of up to 512x256, covered almost all over several times",
    .theme = DomainTheme::kOrdinary,
    .draw = FullCoverage};

}  // namespace rasterproof::props
