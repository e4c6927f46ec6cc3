// Ends of numbers: sums that just fit an accumulator or just do not, products that underflow, and
// pairs of triangles that a short test takes for a rectangle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"

namespace rasterproof::props {
namespace {

// Bits of accumulators, without and with a sign, and of floats' mantissas.
constexpr std::array<int, 8> kAccumulators{15, 16, 23, 24, 31, 31, 32, 32};

// The unit of fixed point: the profile's subpixel; else a pixel, a half or 1/256 of one.
double DrawUnit(CaseBuilder& builder) {
  const Snap& snap = builder.profile().snap;
  if (!snap.IsNone() && builder.bits().Chance(192)) return std::ldexp(1.0, -snap.bits);
  constexpr std::array<int, 4> kBits{0, 0, 1, 8};
  return std::ldexp(1.0, -builder.bits().OneOf(std::span<const int>(kBits)));
}

// The smallest subnormal of the scene's numbers.
double Subnormal(const CaseBuilder& builder) {
  return builder.lattice().precision() == Precision::kFloat32
             ? double{std::numeric_limits<float>::denorm_min()}
             : std::numeric_limits<double>::denorm_min();
}

Point2 Plus(Point2 p, Point2 d) { return {p.x + d.x, p.y + d.y}; }
Point2 Minus(Point2 p, Point2 q) { return {p.x - q.x, p.y - q.y}; }
Point2 Times(double k, Point2 d) { return {k * d.x, k * d.y}; }
Point2 Turned(Point2 d) { return {-d.y, d.x}; }

// From a corner to the two beside it: of a rectangle upright or not, or of a parallelogram.
struct Sides {
  Point2 first;
  Point2 second;
};

Sides DrawSides(CaseBuilder& builder, double scale) {
  BitSource& bits = builder.bits();
  const auto part = [&](int least) {
    return scale * static_cast<double>(bits.Int(least, 24)) / 2 * builder.Sign();
  };
  const double along = part(1);
  if (bits.Chance(96)) {
    const double across = part(1);
    return {{along, 0}, {0, across}};
  }
  const Point2 first{along, part(0)};
  if (bits.Chance(128)) return {first, Turned(first)};
  return {first, {part(0), part(1)}};
}

}  // namespace

static Case AccumulatorEnds(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 2);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const double unit = DrawUnit(builder);
    const double end = std::ldexp(1.0, bits.OneOf(std::span<const int>(kAccumulators)));
    // A product m n next to the end: m and n no farther apart than a factor of 16, in units.
    // Or the end itself, or a multiple of it.
    const bool is_exact = bits.Chance(64);
    const double about = std::floor(std::sqrt(end) * std::fabs(builder.LogUniform(-2, 1)));
    const double m = is_exact ? std::ldexp(1.0, std::ilogb(about)) : about;
    const double n = is_exact ? end / m * static_cast<double>(bits.Int(1, 2))
                              : std::floor(end / m) + static_cast<double>(bits.Int(-1, 1));
    const auto little = [&] { return is_exact ? 0 : unit * static_cast<double>(bits.Int(-2, 2)); };
    const double right = builder.Sign() * m * unit;
    const double down = builder.Sign() * n * unit;
    // The sample is beside the corner at the right angle, or beside the far end of one side.
    const Point2 s = builder.Sample();
    const Point2 a{s.x + little(), s.y - (bits.Chance(128) ? down : 0) + little()};
    const Point2 b{a.x + right, a.y + little()};
    const Point2 c{a.x + little(), a.y + down};
    builder.AddTriangle({a, b, c});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kAccumulatorEndsDomain{
    .number = 67,
    .bits = 0xd5730c5f4c9f0cae,
    .listed = 601,
    .name = "accumulator-ends",
    .summary = "edge values and areas next to what 16, 24 and 32 bits hold",
    .theme = DomainTheme::kMagnitudes,
    .draw = AccumulatorEnds};

static Case UnderflowingProducts(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const double least = Subnormal(builder);
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // An edge from the origin through a sample, and a third corner so near to the origin that it is
    // told from it by products that underflow alone.
    const Point2 s = builder.Sample();
    const auto times = static_cast<double>(bits.Int(1, 5));
    const double size = std::ldexp(least, bits.Chance(128) ? 0 : static_cast<int>(bits.Int(1, 60)));
    const auto few = [&] { return size * static_cast<double>(bits.Int(-9, 9)); };
    const std::int32_t a =
        bits.Chance(192) ? builder.AddRaw({0, 0}) : builder.AddRaw({few(), few()});
    const std::int32_t b = builder.AddRaw({times * s.x, times * s.y});
    const double x = few();
    builder.AddTriangle(a, b, builder.AddRaw({x, few()}));
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kUnderflowingProductsDomain{
    .number = 62,
    .bits = 0xe1fe6215c87eb040,
    .name = "underflowing-products",
    .summary = "edges through samples, told apart by products that underflow alone",
    .theme = DomainTheme::kMagnitudes,
    .in_theme = 141,
    .off_grid = true,
    .draw = UnderflowingProducts};

static Case NearRectangles(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t pairs = bits.Int(1, 2);
  for (std::int64_t k = 0; k < pairs; ++k) {
    // A few pixels, or less than one.
    const double scale = bits.Chance(96) ? std::ldexp(1.0, -static_cast<int>(bits.Int(3, 6))) : 1;
    const Sides sides = DrawSides(builder, scale);
    const Point2 s = builder.Sample();
    // The sample is a corner, the middle of the diagonal, or beside them.
    const Point2 middle = Times(0.5, Plus(sides.first, sides.second));
    const Point2 from = scale < 1 || bits.Chance(128) ? middle : Point2{};
    const Point2 a = Minus(Nudged(builder, s, 1), from);
    Point2 b = Plus(a, sides.first);
    Point2 c = Plus(b, sides.second);
    Point2 d = Plus(a, sides.second);
    switch (bits.Int(0, 3)) {
      case 0:  // a rectangle or a parallelogram
        break;
      case 1: {  // a kite on a level diagonal, or on an upright one
        const double wide = std::fabs(sides.first.x);
        const double high = std::fabs(sides.first.y) + std::fabs(sides.second.y);
        const double more = wide + std::fabs(sides.second.x);
        const bool is_upright = bits.Chance(128);
        const auto place = [&](double x, double y) {
          return Plus(a, is_upright ? Point2{y, x} : Point2{x, y});
        };
        b = place(wide, high);
        c = place(more, 0);
        d = place(wide, -high);
        break;
      }
      case 2:  // a corner a step off
        d = Nudged(builder, d, 1);
        break;
      default:  // a trapezium, or a dart: the right angle at b alone
        d = Plus(d, Times(static_cast<double>(bits.Int(-3, 3)) / 4, sides.first));
    }
    const std::int32_t ia = builder.Add(a);
    const std::int32_t ib = builder.Add(b);
    const std::int32_t ic = builder.Add(c);
    const std::int32_t id = builder.Add(d);
    builder.AddTriangle(ia, ib, ic);
    builder.AddTriangle(ia, ic, id);
  }
  // One behind the other, as a test for rectangles meets them.
  return builder.Done(bits.Chance(192) ? Finish::kAsIs : Finish::kAnyOrder);
}

extern constinit const Domain kNearRectanglesDomain{
    .number = 68,
    .bits = 0xa2a6e262bc44f529,
    .listed = 621,
    .name = "near-rectangles",
    .summary = "pairs on a diagonal: rectangles, kites, trapezia, a step off, under a pixel",
    .theme = DomainTheme::kMeshes,
    .draw = NearRectangles};

}  // namespace rasterproof::props
