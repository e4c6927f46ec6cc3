// What is hard for pixels as squares: their sides, their corners, and triangles that slip through.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "core/ulp.h"
#include "exact/square_coverage.h"
#include "props/domains/recipes.h"
#include "props/domains/sketch.h"

namespace rasterproof::props {
namespace {

// A grid line of the target, or one beside it.
double Line(Sketch& sketch, int extent) {
  return static_cast<double>(sketch.bits().Int(-1, extent + 1));
}

double UlpsBeside(Sketch& sketch, double x, std::int64_t ulps) {
  return sketch.lattice().precision() == Precision::kFloat32
             ? double{MoveByUlps(static_cast<float>(x), ulps)}
             : MoveByUlps(x, ulps);
}

// The least of what the profile grows or shrinks squares by, and how far vertices may be placed.
double Band(Sketch& sketch) {
  const Profile& profile = sketch.profile();
  double band = 0x1p-8;
  if (profile.squares && profile.squares->may && profile.squares->may->half_width != 0) {
    band = profile.squares->may->half_width;
  }
  const bool with_tolerance = sketch.bits().Chance(128) && !profile.snap.IsNone();
  return with_tolerance ? band + exact::PlacingReach(profile.snap, profile.freedom) : band;
}

// On the line, an ulp, a subpixel or the profile's band beside it, or a little beyond that.
double Beside(Sketch& sketch, double line) {
  BitSource& bits = sketch.bits();
  const double side = sketch.Sign();
  switch (bits.Int(0, 7)) {
    case 0:
    case 1:
      return UlpsBeside(sketch, line, bits.Int(-2, 2));
    case 2: {
      const double steps = static_cast<double>(bits.Int(-2, 2));
      return line + steps * 0x1p-8;
    }
    case 3:
      return line + side * Band(sketch);
    case 4: {
      const double band = Band(sketch);
      const double farther = sketch.Sign();
      return line + side * (band + std::ldexp(farther, -static_cast<int>(bits.Int(9, 20))));
    }
    default:
      return line;
  }
}

Point2 BesideLines(Sketch& sketch) {
  const double x = Beside(sketch, Line(sketch, sketch.width()));
  return {x, Beside(sketch, Line(sketch, sketch.height()))};
}

Point2 Crossing(Sketch& sketch) {
  const double x = Line(sketch, sketch.width());
  return {x, Line(sketch, sketch.height())};
}

// Off the subpixel grid as well: what is given and what is placed then differ.
void AddAsIs(Sketch& sketch, const std::array<Point2, 3>& v) {
  std::array<std::int32_t, 3> at{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double limit = sketch.lattice().limit();
    at[k] = sketch.AddRaw({std::clamp(v[k].x, -limit, limit), std::clamp(v[k].y, -limit, limit)});
  }
  sketch.AddTriangle(at[0], at[1], at[2]);
}

}  // namespace

Case SquareGridLines(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) p = BesideLines(sketch);
    if (bits.Chance(96)) v[2] = sketch.Place();
    if (bits.Chance(64)) v[1].y = v[0].y;  // an edge along a line, or beside it
    if (bits.Chance(64)) v[2].x = v[0].x;
    AddAsIs(sketch, v);
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case SquareCrossings(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = Crossing(sketch);
    const double dx = static_cast<double>(bits.Int(-12, 12));
    const double dy = static_cast<double>(bits.Int(-12, 12));
    const double before = static_cast<double>(bits.Int(0, 12)) / 4;
    const double after = static_cast<double>(bits.Int(1, 12)) / 4;
    Point2 a{p.x - before * dx, p.y - before * dy};
    const Point2 b{p.x + after * dx, p.y + after * dy};
    if (bits.Chance(96)) a.x = Beside(sketch, a.x);
    if (bits.Chance(32)) a.y = UlpsBeside(sketch, a.y, bits.Int(-1, 1));
    AddAsIs(sketch, {a, b, bits.Chance(64) ? BesideLines(sketch) : sketch.Place()});
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case SquareInteriors(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const std::int64_t triangles = bits.Int(1, 6);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 corner = Crossing(sketch);
    const double size = std::ldexp(1.0, -static_cast<int>(bits.Int(0, 10)));
    const auto inside = [&] {
      const double x = corner.x + size * sketch.Uniform(0, 1);
      return Point2{x, corner.y + size * sketch.Uniform(0, 1)};
    };
    const Point2 a = bits.Chance(64) ? corner : inside();
    const Point2 b = bits.Chance(64) ? sketch.Place() : inside();
    // Thin: the third corner an ulp, or less than a subpixel, beside the middle of the others.
    Point2 c = inside();
    if (bits.Chance(128)) {
      c = {(a.x + b.x) / 2, (a.y + b.y) / 2};
      c.x += bits.Chance(128) ? 0 : sketch.LogUniform(-14, -6);
      c.y = UlpsBeside(sketch, c.y, bits.Int(-2, 2));
    }
    AddAsIs(sketch, {a, b, c});
  }
  return sketch.Done(Finish::kAnyOrder);
}

}  // namespace rasterproof::props
