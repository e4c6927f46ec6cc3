// What is hard for pixels as squares: their sides, their corners, and triangles that slip through.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/case.h"
#include "core/subject_info.h"
#include "core/ulp.h"
#include "exact/square_coverage.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/is_stated.h"

namespace rasterproof::props {
namespace {

// A grid line of the target, or one beside it.
double Line(CaseBuilder& builder, int extent) {
  return static_cast<double>(builder.bits().Int(-1, extent + 1));
}

double UlpsBeside(CaseBuilder& builder, double x, std::int64_t ulps) {
  return builder.lattice().precision() == Precision::kFloat32
             ? double{MoveByUlps(static_cast<float>(x), ulps)}
             : MoveByUlps(x, ulps);
}

// The least of what the profile grows or shrinks squares by, and how far vertices may be placed.
double Band(CaseBuilder& builder) {
  const Profile& profile = builder.profile();
  double band = 0x1p-8;
  if (profile.squares && profile.squares->may && profile.squares->may->half_width != 0) {
    band = profile.squares->may->half_width;
  }
  const bool with_tolerance = builder.bits().Chance(128) && !profile.snap.IsNone();
  return with_tolerance ? band + exact::PlacingReach(profile.snap, profile.freedom) : band;
}

// On the line, an ulp, a subpixel or the profile's band beside it, or a little beyond that.
double Beside(CaseBuilder& builder, double line) {
  BitSource& bits = builder.bits();
  const double side = builder.Sign();
  switch (bits.Int(0, 7)) {
    case 0:
    case 1:
      return UlpsBeside(builder, line, bits.Int(-2, 2));
    case 2: {
      const double steps = static_cast<double>(bits.Int(-2, 2));
      return line + steps * 0x1p-8;
    }
    case 3:
      return line + side * Band(builder);
    case 4: {
      const double band = Band(builder);
      const double farther = builder.Sign();
      return line + side * (band + std::ldexp(farther, -static_cast<int>(bits.Int(9, 20))));
    }
    default:
      return line;
  }
}

Point2 BesideLines(CaseBuilder& builder) {
  const double x = Beside(builder, Line(builder, builder.width()));
  return {x, Beside(builder, Line(builder, builder.height()))};
}

Point2 Crossing(CaseBuilder& builder) {
  const double x = Line(builder, builder.width());
  return {x, Line(builder, builder.height())};
}

// Off the subpixel grid as well: what is given and what is placed then differ.
void AddAsIs(CaseBuilder& builder, const std::array<Point2, 3>& v) {
  std::array<std::int32_t, 3> at{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double limit = builder.lattice().limit();
    at[k] = builder.AddRaw({std::clamp(v[k].x, -limit, limit), std::clamp(v[k].y, -limit, limit)});
  }
  builder.AddTriangle(at[0], at[1], at[2]);
}

}  // namespace

static Case SquareGridLines(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) p = BesideLines(builder);
    if (bits.Chance(96)) v[2] = builder.Place();
    if (bits.Chance(64)) v[1].y = v[0].y;  // an edge along a line, or beside it
    if (bits.Chance(64)) v[2].x = v[0].x;
    AddAsIs(builder, v);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSquareGridLinesDomain{
    .number = 56,
    .bits = 0xb56d2a924af36037,
    .name = "square-grid-lines",
    .summary = "corners and edges on the sides of pixels, an ulp, a subpixel, a band beside",
    .theme = DomainTheme::kPixelSides,
    .off_grid = true,
    .is_stated = StatesSquares,
    .draw = SquareGridLines};

static Case SquareCrossings(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = Crossing(builder);
    const double dx = static_cast<double>(bits.Int(-12, 12));
    const double dy = static_cast<double>(bits.Int(-12, 12));
    const double before = static_cast<double>(bits.Int(0, 12)) / 4;
    const double after = static_cast<double>(bits.Int(1, 12)) / 4;
    Point2 a{p.x - before * dx, p.y - before * dy};
    const Point2 b{p.x + after * dx, p.y + after * dy};
    if (bits.Chance(96)) a.x = Beside(builder, a.x);
    if (bits.Chance(32)) a.y = UlpsBeside(builder, a.y, bits.Int(-1, 1));
    AddAsIs(builder, {a, b, bits.Chance(64) ? BesideLines(builder) : builder.Place()});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSquareCrossingsDomain{
    .number = 57,
    .bits = 0x28c4ff9079ed50a5,
    .name = "square-crossings",
    .summary = "edges through the corners of pixels, or an ulp beside",
    .theme = DomainTheme::kPixelSides,
    .off_grid = true,
    .is_stated = StatesSquares,
    .draw = SquareCrossings};

static Case SquareInteriors(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 6);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 corner = Crossing(builder);
    const double size = std::ldexp(1.0, -static_cast<int>(bits.Int(0, 10)));
    const auto inside = [&] {
      const double x = corner.x + size * builder.Uniform(0, 1);
      return Point2{x, corner.y + size * builder.Uniform(0, 1)};
    };
    const Point2 a = bits.Chance(64) ? corner : inside();
    const Point2 b = bits.Chance(64) ? builder.Place() : inside();
    // Thin: the third corner an ulp, or less than a subpixel, beside the middle of the others.
    Point2 c = inside();
    if (bits.Chance(128)) {
      c = {(a.x + b.x) / 2, (a.y + b.y) / 2};
      c.x += bits.Chance(128) ? 0 : builder.LogUniform(-14, -6);
      c.y = UlpsBeside(builder, c.y, bits.Int(-2, 2));
    }
    AddAsIs(builder, {a, b, c});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSquareInteriorsDomain{
    .number = 58,
    .bits = 0xe7ac4a70d01393ff,
    .name = "square-interiors",
    .summary = "triangles inside one pixel, thin ones, and thin ones that leave it",
    .theme = DomainTheme::kPixelSides,
    .off_grid = true,
    .is_stated = StatesSquares,
    .draw = SquareInteriors};

}  // namespace rasterproof::props
