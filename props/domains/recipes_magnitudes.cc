// Thin, far, tiny, huge, and all of them in one triangle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "props/domains/lines.h"
#include "props/domains/recipes.h"
#include "props/domains/sketch.h"

namespace rasterproof::props {
namespace {

struct Range {
  int least_exponent;   ///< of the smallest subnormal
  int normal_exponent;  ///< of the smallest normal
  int largest_exponent;
  double largest;
};

Range RangeOf(Precision precision) {
  if (precision == Precision::kFloat32) {
    return {-149, -126, 127, std::numeric_limits<float>::max()};
  }
  return {-1074, -1022, 1023, std::numeric_limits<double>::max()};
}

Range RangeOf(const Sketch& sketch) { return RangeOf(sketch.lattice().precision()); }

// The exponent up to which a recipe may draw: `wanted`, or what the limit leaves of it.
int MostExponent(const Sketch& sketch, int wanted) {
  if (!sketch.WithinLimit()) return wanted;
  const double limit = sketch.lattice().limit();
  return limit == 0 ? 0 : std::min(wanted, std::ilogb(limit) - 1);
}

void SometimesIgnoreLimit(Sketch& sketch) {
  if (sketch.bits().Chance(128)) sketch.IgnoreLimit();
}

double OrdinaryOr(Sketch& sketch, double special, bool along_y, int chance_of_ordinary) {
  if (!sketch.bits().Chance(chance_of_ordinary)) return special;
  return sketch.Coordinate(along_y ? sketch.height() : sketch.width(), along_y);
}

}  // namespace

Case Needles(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const std::int64_t needles = bits.Int(1, 6);
  const int most = std::max(4, MostExponent(sketch, 13));
  for (std::int64_t n = 0; n < needles; ++n) {
    const Point2 p = sketch.Sample();
    double dx = sketch.Uniform(-1, 1);
    const double dy = sketch.Uniform(-1, 1);
    if (dx == 0 && dy == 0) dx = 1;
    const double norm = std::hypot(dx, dy);
    const double ahead = std::fabs(sketch.LogUniform(2, most - 1)) / norm;
    const double behind = std::fabs(sketch.LogUniform(2, most - 1)) / norm;
    const double wide = sketch.LogUniform(-20, -1) / norm;
    const Point2 a{p.x + ahead * dx, p.y + ahead * dy};
    const Point2 b{p.x - behind * dx, p.y - behind * dy};
    sketch.AddTriangle({a, b, {b.x - wide * dy, b.y + wide * dx}});
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case FarSlivers(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  SometimesIgnoreLimit(sketch);
  const InputLattice& lattice = sketch.lattice();
  const double far = sketch.WithinLimit() ? std::min(1e30, lattice.limit()) : 1e30;
  const double end = lattice.Round(sketch.Sign() * far);
  const double slope = bits.Chance(128) ? sketch.Uniform(-2, 2) : 0;
  const double beside = lattice.Round(sketch.Coordinate(sketch.height(), true) + slope * far);
  const double other = lattice.Move(beside, bits.Int(1, 3));
  const Point2 apex = bits.Chance(96) ? Point2{0, 0} : sketch.Place();
  std::array<Point2, 3> v{apex, {end, beside}, {end, other}};
  if (bits.Chance(128)) {
    for (Point2& p : v) std::swap(p.x, p.y);
  }
  sketch.AddTriangle(v);
  if (bits.Chance(128)) sketch.AddTriangle({sketch.Place(), v[1], v[0]});
  return sketch.Done(Finish::kAnyOrder);
}

Case OffsetCancellation(BitSource& bits, const SubjectInfo& info) {
  if (bits.Chance(64)) {
    // A triangle of a few pixels at the far end of a wide target.
    const int width = 1 << bits.Int(13, 16);
    Sketch sketch(bits, info, width, static_cast<int>(bits.Int(1, 2)));
    const double x = width - sketch.Uniform(2, 12);
    sketch.AddTriangle({Point2{x + sketch.Uniform(-2, 2), sketch.Uniform(-2, 4)},
                        Point2{x + sketch.Uniform(-2, 2), sketch.Uniform(-2, 4)},
                        Point2{x + sketch.Uniform(-2, 2), sketch.Uniform(-2, 4)}});
    return sketch.Done(Finish::kAnyOrder);
  }
  Sketch sketch(bits, info);
  const int most = std::max(1, MostExponent(sketch, 22));
  const int least = std::min(13, most);
  const Point2 p = sketch.Sample();
  const Point2 far{sketch.LogUniform(least, most), sketch.LogUniform(least, most)};
  if (bits.Chance(64)) {
    // Out of sight: it must cover nothing, and a c term that cancels says otherwise.
    sketch.AddTriangle({far,
                        {far.x + sketch.Uniform(-2, 2), far.y + sketch.Uniform(-2, 2)},
                        {far.x + sketch.Uniform(-2, 2), far.y + sketch.Uniform(-2, 2)}});
  }
  // An edge from far off through the sample to the other side.
  const double times = -sketch.Uniform(0.25, 1);
  const Point2 opposite{p.x + times * (far.x - p.x), p.y + times * (far.y - p.y)};
  sketch.AddTriangle({far, opposite, sketch.Place()});
  return sketch.Done(Finish::kAnyOrder);
}

Case Subnormal(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const Range range = RangeOf(sketch);
  const auto tiny = [&] {
    const std::int64_t kind = bits.Int(0, 4);
    if (kind == 0)
      return std::ldexp(static_cast<double>(bits.Int(-1024, 1024)), range.least_exponent);
    if (kind == 1) return sketch.LogUniform(range.least_exponent, range.normal_exponent);
    // Differences whose products are subnormal, though they are not.
    if (kind == 2)
      return sketch.LogUniform(range.least_exponent / 2 - 6, range.least_exponent / 2 + 6);
    if (kind == 3) return sketch.Sign() * std::ldexp(1.0, range.normal_exponent);
    return 0.0;
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const int ordinary = bits.Chance(64) ? 0 : 128;
    std::array<std::int32_t, 3> index{};
    for (std::int32_t& i : index) {
      const double x = OrdinaryOr(sketch, tiny(), false, ordinary);
      i = sketch.AddRaw({x, OrdinaryOr(sketch, tiny(), true, ordinary)});
    }
    sketch.AddTriangle(index[0], index[1], index[2]);
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case ProductOverflow(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  SometimesIgnoreLimit(sketch);
  const Range range = RangeOf(sketch);
  const int most = MostExponent(sketch, range.largest_exponent - 1);
  const int least = std::min(range.largest_exponent / 2, most / 2);
  const auto far = [&] {
    return Point2{sketch.LogUniform(least, most), sketch.LogUniform(least, most)};
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 a = far();
    const Point2 third = bits.Chance(128) ? sketch.Place() : far();
    // Half of the edges pass the target.
    const double times = -sketch.Uniform(0.25, 1);
    const Point2 p = sketch.Sample();
    const Point2 opposite{p.x + times * (a.x - p.x), p.y + times * (a.y - p.y)};
    sketch.AddTriangle({a, bits.Chance(128) ? opposite : far(), third});
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case LargestAndSmallest(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  SometimesIgnoreLimit(sketch);
  const Range range = RangeOf(sketch);
  const double largest =
      sketch.WithinLimit() ? std::min(range.largest, sketch.lattice().limit()) : range.largest;
  const auto end = [&] {
    const std::int64_t kind = bits.Int(0, 4);
    const double sign = sketch.Sign();
    if (kind == 0) return sign * largest;
    if (kind == 1) return sign * sketch.lattice().Move(largest, -bits.Int(0, 2));
    if (kind == 2) return sign * std::ldexp(1.0, range.least_exponent);
    if (kind == 3) return sign * std::ldexp(1.0, range.normal_exponent);
    return 0.0;
  };
  const std::int64_t triangles = bits.Int(1, 2);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      const double x = OrdinaryOr(sketch, end(), false, 96);
      p = {x, OrdinaryOr(sketch, end(), true, 96)};
    }
    sketch.AddTriangle(v);
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case MixedMagnitude(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const int most = MostExponent(sketch, static_cast<int>(bits.Int(4, 30)));
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      // One range of magnitudes per vertex, so that a far negative corner beside two near ones is
      // as likely as any other mixture.
      const int least = static_cast<int>(bits.Int(std::min(-20, most), most));
      p = {OrdinaryOr(sketch, sketch.LogUniform(least, most), false, 64),
           OrdinaryOr(sketch, sketch.LogUniform(least, most), true, 64)};
    }
    sketch.AddTriangle(v);
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case CoordinateLimits(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  SometimesIgnoreLimit(sketch);
  const int subpixel_bits = sketch.profile().snap.IsNone() ? 8 : sketch.profile().snap.bits;
  const std::array<double, 10> boundaries{
      sketch.lattice().limit(),           0x1p13, 0x1p14, 0x1p15, 0x1p16, 0x1p23, 0x1p24, 0x1p31,
      std::ldexp(0x1p15, -subpixel_bits),   // int16 in subpixels
      std::ldexp(0x1p31, -subpixel_bits)};  // int32 in subpixels
  const auto boundary = [&] {
    const double at = sketch.lattice().Round(bits.OneOf(std::span<const double>(boundaries)));
    const double sign = sketch.Sign();
    return sign * sketch.lattice().Move(at, bits.Int(-2, 2));
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      const double x = OrdinaryOr(sketch, boundary(), false, 128);
      p = {x, OrdinaryOr(sketch, boundary(), true, 128)};
    }
    sketch.AddTriangle(v);
  }
  return sketch.Done(Finish::kAnyOrder);
}

}  // namespace rasterproof::props
