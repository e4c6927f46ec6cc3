// Thin, far, tiny, huge, and all of them in one triangle.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"

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

Range RangeOf(const CaseBuilder& builder) { return RangeOf(builder.lattice().precision()); }

// The exponent up to which a recipe may draw: `wanted`, or what the limit leaves of it.
int MostExponent(const CaseBuilder& builder, int wanted) {
  if (!builder.WithinLimit()) return wanted;
  const double limit = builder.lattice().limit();
  return limit == 0 ? 0 : std::min(wanted, std::ilogb(limit) - 1);
}

void SometimesIgnoreLimit(CaseBuilder& builder) {
  if (builder.bits().Chance(128)) builder.IgnoreLimit();
}

double OrdinaryOr(CaseBuilder& builder, double special, bool along_y, int chance_of_ordinary) {
  if (!builder.bits().Chance(chance_of_ordinary)) return special;
  return builder.Coordinate(along_y ? builder.height() : builder.width(), along_y);
}

}  // namespace

static Case Needles(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t needles = bits.Int(1, 6);
  const int most = std::max(4, MostExponent(builder, 13));
  for (std::int64_t n = 0; n < needles; ++n) {
    const Point2 p = builder.Sample();
    double dx = builder.Uniform(-1, 1);
    const double dy = builder.Uniform(-1, 1);
    if (dx == 0 && dy == 0) dx = 1;
    const double norm = Hypot(dx, dy);
    const double ahead = std::fabs(builder.LogUniform(2, most - 1)) / norm;
    const double behind = std::fabs(builder.LogUniform(2, most - 1)) / norm;
    const double wide = builder.LogUniform(-20, -1) / norm;
    const Point2 a{p.x + ahead * dx, p.y + ahead * dy};
    const Point2 b{p.x - behind * dx, p.y - behind * dy};
    builder.AddTriangle({a, b, {b.x - wide * dy, b.y + wide * dx}});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kNeedlesDomain{
    .number = 9,
    .bits = 0xee886acb3d800398,
    .name = "needles",
    .summary = "up to 8192 pixels long and 2^-20 to 1 pixel wide",
    .theme = DomainTheme::kThin,
    .draw = Needles};

static Case FarSlivers(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  SometimesIgnoreLimit(builder);
  const InputLattice& lattice = builder.lattice();
  const double far = builder.WithinLimit() ? std::min(1e30, lattice.limit()) : 1e30;
  const double end = lattice.Round(builder.Sign() * far);
  const double slope = bits.Chance(128) ? builder.Uniform(-2, 2) : 0;
  const double beside = lattice.Round(builder.Coordinate(builder.height(), true) + slope * far);
  const double other = lattice.Move(beside, bits.Int(1, 3));
  const Point2 apex = bits.Chance(96) ? Point2{0, 0} : builder.Place();
  std::array<Point2, 3> v{apex, {end, beside}, {end, other}};
  if (bits.Chance(128)) {
    for (Point2& p : v) std::swap(p.x, p.y);
  }
  builder.AddTriangle(v);
  if (bits.Chance(128)) builder.AddTriangle({builder.Place(), v[1], v[0]});
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kFarSliversDomain{.number = 11,
                                                .bits = 0x29a3c3a3a3c7aaf5,
                                                .name = "far-slivers",
                                                .summary = "1e30 long and one ulp wide",
                                                .theme = DomainTheme::kThin,
                                                .beyond_limits = true,
                                                .draw = FarSlivers};

static Case OffsetCancellation(BitSource& bits, const SubjectInfo& info) {
  if (bits.Chance(64)) {
    // A triangle of a few pixels at the far end of a wide target.
    const int width = 1 << bits.Int(13, 16);
    CaseBuilder builder(bits, info, width, static_cast<int>(bits.Int(1, 2)));
    const double x = width - builder.Uniform(2, 12);
    builder.AddTriangle({Point2{x + builder.Uniform(-2, 2), builder.Uniform(-2, 4)},
                         Point2{x + builder.Uniform(-2, 2), builder.Uniform(-2, 4)},
                         Point2{x + builder.Uniform(-2, 2), builder.Uniform(-2, 4)}});
    return builder.Done(Finish::kAnyOrder);
  }
  CaseBuilder builder(bits, info);
  const int most = std::max(1, MostExponent(builder, 22));
  const int least = std::min(13, most);
  const Point2 p = builder.Sample();
  const Point2 far{builder.LogUniform(least, most), builder.LogUniform(least, most)};
  if (bits.Chance(64)) {
    // Out of sight: it must cover nothing, and a c term that cancels says otherwise.
    builder.AddTriangle({far,
                         {far.x + builder.Uniform(-2, 2), far.y + builder.Uniform(-2, 2)},
                         {far.x + builder.Uniform(-2, 2), far.y + builder.Uniform(-2, 2)}});
  }
  // An edge from far off through the sample to the other side.
  const double times = -builder.Uniform(0.25, 1);
  const Point2 opposite{p.x + times * (far.x - p.x), p.y + times * (far.y - p.y)};
  builder.AddTriangle({far, opposite, builder.Place()});
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kOffsetCancellationDomain{
    .number = 12,
    .bits = 0xb9036bf66ef85de3,
    .name = "offset-cancellation",
    .summary = "small triangles and ends of near edges at 2^13 to 2^22",
    .theme = DomainTheme::kMagnitudes,
    .draw = OffsetCancellation};

static Case Subnormal(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Range range = RangeOf(builder);
  const auto tiny = [&] {
    const std::int64_t kind = bits.Int(0, 4);
    if (kind == 0)
      return std::ldexp(static_cast<double>(bits.Int(-1024, 1024)), range.least_exponent);
    if (kind == 1) return builder.LogUniform(range.least_exponent, range.normal_exponent);
    // Differences whose products are subnormal, though they are not.
    if (kind == 2)
      return builder.LogUniform(range.least_exponent / 2 - 6, range.least_exponent / 2 + 6);
    if (kind == 3) return builder.Sign() * std::ldexp(1.0, range.normal_exponent);
    return 0.0;
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const int ordinary = bits.Chance(64) ? 0 : 128;
    std::array<std::int32_t, 3> index{};
    for (std::int32_t& i : index) {
      const double x = OrdinaryOr(builder, tiny(), false, ordinary);
      i = builder.AddRaw({x, OrdinaryOr(builder, tiny(), true, ordinary)});
    }
    builder.AddTriangle(index[0], index[1], index[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSubnormalDomain{
    .number = 13,
    .bits = 0x213afcb9dc59e470,
    .name = "subnormal",
    .summary = "subnormal coordinates and products beside ordinary ones",
    .theme = DomainTheme::kMagnitudes,
    .off_grid = true,
    .draw = Subnormal};

static Case ProductOverflow(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  SometimesIgnoreLimit(builder);
  const Range range = RangeOf(builder);
  const int most = MostExponent(builder, range.largest_exponent - 1);
  const int least = std::min(range.largest_exponent / 2, most / 2);
  const auto far = [&] {
    return Point2{builder.LogUniform(least, most), builder.LogUniform(least, most)};
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 a = far();
    const Point2 third = bits.Chance(128) ? builder.Place() : far();
    // Half of the edges pass the target.
    const double times = -builder.Uniform(0.25, 1);
    const Point2 p = builder.Sample();
    const Point2 opposite{p.x + times * (a.x - p.x), p.y + times * (a.y - p.y)};
    builder.AddTriangle({a, bits.Chance(128) ? opposite : far(), third});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kProductOverflowDomain{
    .number = 14,
    .bits = 0x43d60954733de661,
    .name = "product-overflow",
    .summary = "coordinates whose products overflow, in every quadrant",
    .theme = DomainTheme::kMagnitudes,
    .beyond_limits = true,
    .draw = ProductOverflow};

static Case LargestAndSmallest(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  SometimesIgnoreLimit(builder);
  const Range range = RangeOf(builder);
  const double largest =
      builder.WithinLimit() ? std::min(range.largest, builder.lattice().limit()) : range.largest;
  const auto end = [&] {
    const std::int64_t kind = bits.Int(0, 4);
    const double sign = builder.Sign();
    if (kind == 0) return sign * largest;
    if (kind == 1) return sign * builder.lattice().Move(largest, -bits.Int(0, 2));
    if (kind == 2) return sign * std::ldexp(1.0, range.least_exponent);
    if (kind == 3) return sign * std::ldexp(1.0, range.normal_exponent);
    return 0.0;
  };
  const std::int64_t triangles = bits.Int(1, 2);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      const double x = OrdinaryOr(builder, end(), false, 96);
      p = {x, OrdinaryOr(builder, end(), true, 96)};
    }
    builder.AddTriangle(v);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kLargestAndSmallestDomain{
    .number = 15,
    .bits = 0x671b80373c51d995,
    .name = "largest-and-smallest",
    .summary = "the largest and the smallest floats in one triangle",
    .theme = DomainTheme::kMagnitudes,
    .beyond_limits = true,
    .draw = LargestAndSmallest};

static Case MixedMagnitude(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const int most = MostExponent(builder, static_cast<int>(bits.Int(4, 30)));
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      // One range of magnitudes per vertex, so that a far negative corner beside two near ones is
      // as likely as any other mixture.
      const int least = static_cast<int>(bits.Int(std::min(-20, most), most));
      p = {OrdinaryOr(builder, builder.LogUniform(least, most), false, 64),
           OrdinaryOr(builder, builder.LogUniform(least, most), true, 64)};
    }
    builder.AddTriangle(v);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kMixedMagnitudeDomain{
    .number = 16,
    .bits = 0xe65728365063bf51,
    .name = "mixed-magnitude",
    .summary = "magnitudes log-uniform per vertex, signs per quadrant",
    .theme = DomainTheme::kMagnitudes,
    .draw = MixedMagnitude};

static Case CoordinateLimits(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  SometimesIgnoreLimit(builder);
  const int subpixel_bits = builder.profile().snap.IsNone() ? 8 : builder.profile().snap.bits;
  const std::array<double, 10> boundaries{
      builder.lattice().limit(),          0x1p13, 0x1p14, 0x1p15, 0x1p16, 0x1p23, 0x1p24, 0x1p31,
      std::ldexp(0x1p15, -subpixel_bits),   // int16 in subpixels
      std::ldexp(0x1p31, -subpixel_bits)};  // int32 in subpixels
  const auto boundary = [&] {
    const double at = builder.lattice().Round(bits.OneOf(std::span<const double>(boundaries)));
    const double sign = builder.Sign();
    return sign * builder.lattice().Move(at, bits.Int(-2, 2));
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      const double x = OrdinaryOr(builder, boundary(), false, 128);
      p = {x, OrdinaryOr(builder, boundary(), true, 128)};
    }
    builder.AddTriangle(v);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kCoordinateLimitsDomain{
    .number = 17,
    .bits = 0x27d0e2f7d6e7d38c,
    .name = "coordinate-limits",
    .summary = "2^15, 2^24, the limit, int16 and int32 in subpixels, and a step beside",
    .theme = DomainTheme::kMagnitudes,
    .beyond_limits = true,
    .draw = CoordinateLimits};

}  // namespace rasterproof::props
