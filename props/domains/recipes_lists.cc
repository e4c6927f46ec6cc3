// What a list of triangles can go wrong by, whatever they are: one taken for the one before it, and
// indices taken for others.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"

namespace rasterproof::props {
namespace {

constexpr std::array<int, 6> kStrides{8, 16, 64, 256, 256, 1024};

// A triangle's corners with the indices of their vertices: a corner that stays keeps its index.
struct ListedCorner {
  Point2 at;
  std::int32_t index = 0;
};
using TriangleCorners = std::array<ListedCorner, 3>;

ListedCorner Placed(CaseBuilder& builder, Point2 p) { return {p, builder.Add(p)}; }

Point2 Far(CaseBuilder& builder) {
  const int most = std::max(5, std::ilogb(builder.Range()));
  const auto far = [&] { return builder.LogUniform(4, most); };
  const double x = far();
  return {x, far()};
}

// One coordinate of a corner anew.
void ChangeCoordinate(CaseBuilder& builder, ListedCorner& corner) {
  const bool along_y = builder.bits().Chance(128);
  Point2 p = corner.at;
  (along_y ? p.y : p.x) = builder.Coordinate(along_y ? builder.height() : builder.width(), along_y);
  corner = Placed(builder, p);
}

void Write(CaseBuilder& builder, const TriangleCorners& v) {
  builder.AddTriangle(v[0].index, v[1].index, v[2].index);
}

// A corner for an index that agrees with that of `base` in its low bits: half of the time it agrees
// in a coordinate, too.
Point2 BesideIn(CaseBuilder& builder, Point2 base) {
  const std::int64_t kind = builder.bits().Int(0, 3);
  const Point2 other = builder.Place();
  if (kind == 0) return {base.x, other.y};
  if (kind == 1) return {other.x, base.y};
  return kind == 2 ? Point2{base.y, base.x} : other;
}

}  // namespace

static Case NearRepeats(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  TriangleCorners v;
  for (ListedCorner& corner : v) corner = Placed(builder, builder.Place());
  Write(builder, v);
  const std::int64_t more = bits.Int(1, 7);
  for (std::int64_t n = 0; n < more; ++n) {
    const std::int64_t kind = bits.Int(0, 7);
    const auto k = static_cast<std::size_t>(bits.Int(0, 2));
    // The neighbour across the edge opposite corner k: what a strip or a fan goes on with.
    const auto across = [&] {
      v = {v[(k + 1) % 3], v[(k + 2) % 3], Placed(builder, builder.Place())};
    };
    if (kind < 4) {
      ChangeCoordinate(builder, v[k]);
    } else if (kind == 4) {
      across();
    } else if (kind == 5) {
      std::swap(v[k], v[(k + 1) % 3]);
    } else {
      // One that may not be drawn, too large or without area, and its neighbour.
      v[k] = kind == 6 ? Placed(builder, Far(builder)) : v[(k + 1) % 3];
      Write(builder, v);
      across();
    }
    Write(builder, v);
  }
  return builder.Done(bits.Chance(48) ? Finish::kAnyOrder : Finish::kAsIs);
}

extern constinit const Domain kNearRepeatsDomain{
    .number = 43,
    .bits = 0x72b9650315360868,
    .name = "near-repeats",
    .summary = "each triangle the one before but for a coordinate or a corner, or beside it",
    .theme = DomainTheme::kCalls,
    .draw = NearRepeats};

static Case SparseIndices(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int32_t stride = bits.OneOf(std::span<const int>(kStrides));
  const std::int64_t triangles = bits.Int(2, stride < 1024 ? 5 : 3);
  const Point2 between = builder.Place();
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<std::int32_t, 3> v{};
    for (std::int32_t& index : v) index = builder.Add(builder.Place());
    builder.AddTriangle(v[0], v[1], v[2]);
    for (std::int32_t unused = 3; unused < stride && t + 1 < triangles; ++unused) {
      builder.Add(between);
    }
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kSparseIndicesDomain{
    .number = 44,
    .bits = 0x6ea3043e9d4d20be,
    .name = "sparse-indices",
    .summary = "indices of vertices that agree in their lower bits",
    .theme = DomainTheme::kCalls,
    .draw = SparseIndices};

static Case AliasedIndices(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const bool is_long = bits.Chance(24);
  const std::int32_t stride = is_long ? 1 << 16 : 1 << 8;
  const std::int64_t triangles = is_long ? 2 : bits.Int(2, 6);
  std::array<Point2, 3> corners{};
  for (Point2& p : corners) p = builder.Place();
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<std::int32_t, 3> v{};
    for (std::size_t k = 0; k < 3; ++k) {
      if (t != 0) corners[k] = BesideIn(builder, corners[k]);
      v[k] = builder.Add(corners[k]);
    }
    builder.AddTriangle(v[0], v[1], v[2]);
    for (std::int32_t unused = 3; unused < stride && t + 1 < triangles; ++unused) {
      builder.Add(corners[0]);
    }
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kAliasedIndicesDomain{
    .number = 91,
    .bits = 0xb897b7c8653ed4d8,
    .name = "aliased-indices",
    .summary = "vertices that agree in 8 or 16 bits of their index, and in a coordinate",
    .theme = DomainTheme::kCalls,
    .in_theme = 441,
    .draw = AliasedIndices};

}  // namespace rasterproof::props
