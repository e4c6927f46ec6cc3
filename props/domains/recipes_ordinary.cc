// Ordinary triangles at places that matter: samples, half pixels, axes, target sizes.
#include <algorithm>
#include <array>
#include <cstdint>
#include <span>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"

namespace rasterproof::props {
namespace {

// Powers of two, where fixed-point set-up overflows or tiles change, and their neighbours.
constexpr std::array<int, 28> kSides{1,   2,    3,    7,    8,    9,    15,   16,   17,  63,
                                     64,  65,   127,  128,  129,  255,  256,  257,  511, 512,
                                     513, 1024, 2047, 2048, 2049, 4096, 8192, 16384};
constexpr int kMostSamples = 1 << 17;

}  // namespace

static Case UniformSubpixel(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 a = builder.Place();
    const Point2 b = builder.Place();
    builder.AddTriangle({a, b, builder.Place()});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kUniformSubpixelDomain{
    .number = 1,
    .bits = 0x690c8ef9c3c44a28,
    .name = "uniform-subpixel",
    .summary = "ordinary triangles, half of their coordinates on samples",
    .theme = DomainTheme::kOrdinary,
    .draw = UniformSubpixel};

static Case VerticesOnSamples(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      p = builder.Sample();
      if (!bits.Chance(64)) continue;
      p.x += static_cast<double>(bits.Int(-8, 8)) / 2;
      p.y += static_cast<double>(bits.Int(-8, 8)) / 2;
    }
    v[0] = builder.Sample();
    builder.AddTriangle(v);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kVerticesOnSamplesDomain{
    .number = 2,
    .bits = 0x4143ee6228f2987e,
    .name = "vertices-on-samples",
    .summary = "every vertex on a sample, some on half pixels",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .ties = true,
    .draw = VerticesOnSamples};

static Case AxisAligned(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t rectangles = bits.Int(1, 3);
  for (std::int64_t r = 0; r < rectangles; ++r) {
    const Point2 corner = builder.Sample();
    const Point2 other = bits.Chance(160) ? builder.Sample() : builder.Place();
    const std::int32_t a = builder.Add(corner);
    const std::int32_t b = builder.Add({other.x, corner.y});
    const std::int32_t c = builder.Add(other);
    const std::int32_t d = builder.Add({corner.x, other.y});
    builder.AddTriangle(a, b, c);
    if (bits.Chance(192)) builder.AddTriangle(a, c, d);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kAxisAlignedDomain{
    .number = 3,
    .bits = 0x7b57ac5dbf0e0ef3,
    .name = "axis-aligned",
    .summary = "rectangles and right triangles with edges along rows and columns of samples",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .ties = true,
    .draw = AxisAligned};

static Case VertexOrders(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int32_t a = builder.Add(builder.Place());
  const std::int32_t b = builder.Add(builder.Place());
  const std::int32_t c = builder.Add(builder.Place());
  std::array<std::int32_t, 3> order{a, b, c};
  do {
    builder.AddTriangle(order[0], order[1], order[2]);
  } while (std::next_permutation(order.begin(), order.end()));
  return builder.Done(Finish::kAsIs);
}

extern constinit const Domain kVertexOrdersDomain{
    .number = 28,
    .bits = 0xf04acac1f4f81f4e,
    .name = "vertex-orders",
    .summary = "one triangle in all six vertex orders",
    .theme = DomainTheme::kOrdinary,
    .in_theme = 703,
    .draw = VertexOrders};

static Case TargetSizes(BitSource& bits, const SubjectInfo& info) {
  const int side = bits.OneOf(std::span<const int>(kSides));
  const int most = std::min(side, kMostSamples / side);
  const int other = static_cast<int>(bits.Chance(128) ? most : bits.Int(1, most));
  const bool tall = bits.Chance(128);
  CaseBuilder builder(bits, info, tall ? other : side, tall ? side : other);
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // Boxes that are large both ways, even where the target is not.
    std::array<Point2, 3> v;
    for (Point2& p : v) {
      if (bits.Chance(96)) {
        p = builder.Sample();
      } else {
        p = {builder.Coordinate(side, false), builder.Coordinate(side, true)};
      }
    }
    builder.AddTriangle(v);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kTargetSizesDomain{
    .number = 39,
    .bits = 0x435d30aee11c791e,
    .name = "target-sizes",
    .summary = "targets of 1 to 16384 a side, boxes as large both ways",
    .theme = DomainTheme::kCalls,
    .draw = TargetSizes};

}  // namespace rasterproof::props
