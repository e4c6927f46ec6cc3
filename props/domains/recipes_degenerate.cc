// Ties of the snap, zero areas, signed zeros, and what is no number.
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>

#include "core/case.h"
#include "core/subject_info.h"
#include "core/ulp.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"

namespace rasterproof::props {
namespace {

constexpr std::array<double, 3> kNotNumbers{std::numeric_limits<double>::quiet_NaN(),
                                            std::numeric_limits<double>::infinity(),
                                            -std::numeric_limits<double>::infinity()};

double MovedInPrecision(double x, std::int64_t n, Precision precision) {
  if (precision == Precision::kFloat64) return MoveByUlps(x, n);
  return MoveByUlps(static_cast<float>(x), n);
}

}  // namespace

static Case SnapTies(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Snap& snap = builder.profile().snap;
  const int subpixel_bits = snap.IsNone() ? (bits.Chance(128) ? 8 : 4) : snap.bits;
  const auto tie = [&](double near) {
    const double cell = std::floor(std::ldexp(near, subpixel_bits));
    const double x = std::ldexp(cell + 0.5, -subpixel_bits);
    return MovedInPrecision(x, bits.Int(-1, 1), builder.lattice().precision());
  };
  // Half of the coordinates are ties, a quarter anywhere between two subpixels.
  const auto coordinate = [&](double near) {
    const std::int64_t kind = bits.Int(0, 3);
    if (kind < 2) return tie(near);
    return kind == 2 ? near + std::ldexp(builder.Uniform(0, 1), -subpixel_bits) : near;
  };
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<std::int32_t, 3> index{};
    for (std::int32_t& i : index) {
      const Point2 p = builder.Place();
      const double x = coordinate(p.x);
      i = builder.AddRaw({x, coordinate(p.y)});
    }
    builder.AddTriangle(index[0], index[1], index[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSnapTiesDomain{
    .number = 24,
    .bits = 0x4f204425accba998,
    .name = "snap-ties",
    .summary = "vertices half way between subpixels, one ulp beside, and anywhere between",
    .theme = DomainTheme::kSnapping,
    .off_grid = true,
    .draw = SnapTies};

static Case Degenerate(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = bits.Chance(128) ? builder.Sample() : GridPlace(builder);
    const Point2 q = GridPlace(builder);
    const Point2 d{q.x - p.x, q.y - p.y};
    const auto times = static_cast<double>(bits.Int(-2, 3));
    switch (bits.Int(0, 5)) {
      case 0:
        builder.AddTriangle({p, p, p});
        break;
      case 1:
        builder.AddTriangle({p, q, p});
        break;
      case 2: {
        const std::int32_t a = builder.Add(p);
        builder.AddTriangle(a, builder.Add(q), a);
        break;
      }
      case 3:
        builder.AddTriangle({p, q, {p.x + times * d.x, p.y + times * d.y}});
        break;
      case 4:  // along an axis
        builder.AddTriangle({p, Point2{q.x, p.y}, Point2{p.x + times, p.y}});
        break;
      default:  // not quite
        builder.AddTriangle({p, q, Nudged(builder, {p.x + times * d.x, p.y + times * d.y}, 1)});
    }
    // A neighbour that shares the degenerate one's first vertices: its samples stay its own.
    if (bits.Chance(64)) builder.AddTriangle({p, q, builder.Place()});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kDegenerateDomain{.number = 25,
                                                .bits = 0xf51c7d032c605b01,
                                                .name = "degenerate",
                                                .summary = "equal, repeated and collinear vertices",
                                                .theme = DomainTheme::kNothing,
                                                .draw = Degenerate};

static Case SignedZeros(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const auto coordinate = [&](int extent, bool along_y) {
    switch (bits.Int(0, 4)) {
      case 0:
        return 0.0;
      case 1:
      case 2:
        return -0.0;
      case 3:
        return builder.Coordinate(extent, along_y);
      default:
        return static_cast<double>(bits.Int(-1, 1) * extent);
    }
  };
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<std::int32_t, 3> index{};
    for (std::int32_t& i : index) {
      const double x = coordinate(builder.width(), false);
      i = builder.AddRaw({x, coordinate(builder.height(), true)});
    }
    builder.AddTriangle(index[0], index[1], index[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSignedZerosDomain{.number = 26,
                                                 .bits = 0x1250c27886f2730e,
                                                 .name = "signed-zeros",
                                                 .summary = "-0 beside +0",
                                                 .theme = DomainTheme::kNothing,
                                                 .draw = SignedZeros};

static Case NonFiniteDepths(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<std::int32_t, 3> index{};
    const std::int64_t replaced = bits.Int(0, 7);  // a bit for each vertex
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 p = builder.Place();
      const double z =
          (replaced >> k & 1) != 0 ? bits.OneOf(std::span<const double>(kNotNumbers)) : 0.5;
      index[k] = builder.AddRaw({p.x, p.y, z});
    }
    builder.AddTriangle(index[0], index[1], index[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kNonFiniteDepthsDomain{.number = 64,
                                                     .bits = 0xea505ce0d86ea282,
                                                     .name = "non-finite-depths",
                                                     .summary = "NaN and infinities in z alone",
                                                     .theme = DomainTheme::kNothing,
                                                     .non_finite = true,
                                                     .draw = NonFiniteDepths};

static Case NonFinite(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Vertex, 3> v;
    for (Vertex& vertex : v) {
      const Point2 p = builder.Place();
      vertex = {p.x, p.y};
    }
    const std::int64_t replaced = t == 0 ? bits.Int(1, 3) : bits.Int(0, 2);
    for (std::int64_t r = 0; r < replaced; ++r) {
      Vertex& vertex = v[static_cast<std::size_t>(bits.Int(0, 2))];
      double* const members[] = {&vertex.x, &vertex.y, &vertex.z};
      *members[bits.Int(0, bits.Chance(32) ? 2 : 1)] =
          bits.OneOf(std::span<const double>(kNotNumbers));
    }
    const std::int32_t a = builder.AddRaw(v[0]);
    const std::int32_t b = builder.AddRaw(v[1]);
    builder.AddTriangle(a, b, builder.AddRaw(v[2]));
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kNonFiniteDomain{.number = 27,
                                               .bits = 0xed0bc9be91ef3ee5,
                                               .name = "non-finite",
                                               .summary = "NaN and infinities in some coordinates",
                                               .theme = DomainTheme::kNothing,
                                               .off_grid = true,
                                               .beyond_limits = true,
                                               .non_finite = true,
                                               .draw = NonFinite};

}  // namespace rasterproof::props
