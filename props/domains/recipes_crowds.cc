// What only many triangles show: numbers that are cut to a few bits, and work that is shared out to
// the lanes of a vector.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"

namespace rasterproof::props {
namespace {

constexpr int kSide = 8;  // of the target: plain rasterizers look at all of it for each triangle
constexpr int kCells = kSide * kSide / 2;

// Bits that a number may be cut to; the long ones are drawn rarely, for they take long.
int DrawCutBits(BitSource& bits) {
  const std::int64_t kind = bits.Int(0, 63);
  if (kind == 63) return 16;
  if (kind >= 61) return static_cast<int>(bits.Int(13, 15));
  return static_cast<int>(kind >= 48 ? bits.Int(11, 12) : bits.Int(8, 10));
}

// Triangles that cover the sample of one pixel each: of the target's left half, or its right one.
class Cells {
 public:
  Cells(CaseBuilder& builder, bool owns_vertices, int padding)
      : builder_(builder), owns_vertices_(owns_vertices), padding_(padding) {}

  void Add(bool on_the_right, std::int64_t number) {
    const std::int64_t cell = number % kCells + (on_the_right ? kCells : 0);
    std::int32_t first = 0;
    if (owns_vertices_ || first_of_[static_cast<std::size_t>(cell)] < 0) {
      // Down each column, so that halves of the target are halves of the cells.
      const std::int64_t column = cell / kSide;
      const auto x = static_cast<double>(column);
      const auto y = static_cast<double>(cell % kSide);
      first = builder_.Add({x, y});
      builder_.Add({x, y + 1.5});
      builder_.Add({x + 1.5, y});
      for (int k = 0; k < padding_; ++k) builder_.Add({0, 0});
      first_of_[static_cast<std::size_t>(cell)] = first;
    } else {
      first = first_of_[static_cast<std::size_t>(cell)];
    }
    builder_.AddTriangle(first, first + 1, first + 2);
  }

 private:
  CaseBuilder& builder_;
  bool owns_vertices_;
  int padding_;
  std::vector<std::int32_t> first_of_ = std::vector<std::int32_t>(std::size_t{2} * kCells, -1);
};

// One after the other; or from two places in turn whose vertices' numbers are a power of two apart,
// as a cache meets them that keeps too few bits of a number.
void AddInTurn(CaseBuilder& builder, std::int64_t apart) {
  constexpr int kPadding = 1;  // four numbers a triangle
  Cells cells(builder, true, kPadding);
  for (std::int64_t t = 0; t < apart; ++t) cells.Add(false, t);
  for (std::int64_t t = 0; t < apart; ++t) cells.Add(true, t);
}

void Interleave(std::vector<Triangle>& triangles) {
  std::vector<Triangle> mixed;
  const std::size_t half = triangles.size() / 2;
  for (std::size_t t = 0; t < half; ++t) {
    mixed.push_back(triangles[t]);
    mixed.push_back(triangles[half + t]);
  }
  triangles = mixed;
}

// Three corners of one kind or another: drawn, on samples, near an edge, outside, flat.
std::array<Point2, 3> DrawCorners(CaseBuilder& builder) {
  BitSource& bits = builder.bits();
  switch (bits.Int(0, 7)) {
    case 0: {
      const Point2 a = builder.Sample();
      const Point2 b = builder.Sample();
      return {a, b, builder.Sample()};
    }
    case 1:
    case 2: {
      const Segment edge = SegmentThrough(builder, builder.Sample());
      return {edge.a, edge.b, builder.Place()};
    }
    case 3: {
      const Segment edge = SegmentThrough(builder, builder.Sample());
      const Point2 a = Nudged(builder, edge.a, 1);
      return {a, edge.b, builder.Place()};
    }
    case 4: {  // outside the target
      const auto away = static_cast<double>(builder.width() + bits.Int(2, 64));
      const Point2 a = builder.Place();
      const Point2 b = builder.Place();
      return {Point2{a.x + away, a.y}, Point2{b.x + away, b.y}, Point2{a.x + away, b.y + 3}};
    }
    case 5: {  // flat
      const Point2 a = builder.Sample();
      const Point2 b = builder.Sample();
      return {a, b, bits.Chance(128) ? a : b};
    }
    case 6: {  // along a row and a column of samples
      const Point2 a = builder.Sample();
      const Point2 b = builder.Sample();
      return {a, Point2{b.x, a.y}, Point2{a.x, b.y}};
    }
    default: {
      const Point2 a = builder.Place();
      const Point2 b = builder.Place();
      return {a, b, builder.Place()};
    }
  }
}

constexpr int kPitch = 6;  // between the copies of a shape, in pixels
constexpr int kRowOfCopies = 8;

// Corners next to the samples of one cell, on a lattice that moves by whole pixels leave exact.
std::array<Point2, 3> DrawShape(CaseBuilder& builder) {
  BitSource& bits = builder.bits();
  const int grid_bits = std::min(8, builder.lattice().GridBits(64));
  const auto draw = [&](bool along_y) {
    const Point2 place = bits.OneOf(std::span<const Point2>(builder.profile().pattern.locations));
    const double sample = along_y ? place.y : place.x;
    const auto pixel = static_cast<double>(bits.Int(0, kPitch - 2));
    if (bits.Chance(192)) return pixel + sample;
    return pixel + OnGrid(builder.Uniform(0, 1), grid_bits);
  };
  std::array<Point2, 3> corners;
  for (Point2& p : corners) {
    const double x = draw(false);
    p = {x, draw(true)};
  }
  // Most have a side along a row or a column.
  if (bits.Chance(160)) corners[1].y = corners[0].y;
  if (bits.Chance(128)) corners[2].x = corners[0].x;
  return corners;
}

}  // namespace

static Case LongLists(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info, kSide, kSide);
  const int cut = DrawCutBits(bits);
  const std::int64_t many = std::int64_t{1} << cut;
  const std::int64_t more = bits.Int(1, kCells);
  const std::int64_t kind = bits.Int(0, 3);
  Case c;
  if (kind == 0 && cut <= 12) {
    AddInTurn(builder, many);
    c = builder.Done(Finish::kAsIs);
    Interleave(c.scene.triangles);
    return c;
  }
  // Those from a power of two on are on the right, and nothing else is: numbers of triangles, or of
  // vertices.
  const bool is_of_vertices = kind == 1;
  Cells cells(builder, is_of_vertices || bits.Chance(64), 0);
  const std::int64_t on_the_left = is_of_vertices ? many / 3 + 1 : many;
  for (std::int64_t t = 0; t < on_the_left; ++t) cells.Add(false, t);
  for (std::int64_t t = 0; t < more; ++t) cells.Add(true, t);
  return builder.Done(Finish::kAsIs);
}

extern constinit const Domain kLongListsDomain{
    .number = 69,
    .bits = 0x6bebb1b4cd9b1361,
    .listed = 581,
    .name = "many-triangles",
    .summary = "2^8 to 2^16 triangles or vertices and more, those beyond alone on their side",
    .theme = DomainTheme::kCalls,
    .draw = LongLists};

static Case Crowds(BitSource& bits, const SubjectInfo& info) {
  // One less, as many as and one more than lanes.
  constexpr std::array<int, 17> kCounts{3,  4,  5,  6,  7,  8,  9,  12, 15,
                                        16, 17, 18, 24, 31, 32, 33, 40};
  CaseBuilder builder(bits, info);
  const int count = bits.OneOf(std::span<const int>(kCounts));
  for (int t = 0; t < count; ++t) builder.AddTriangle(DrawCorners(builder));
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kCrowdsDomain{
    .number = 60,
    .bits = 0x593877c183869e9,
    .name = "crowds",
    .summary = "3 to 40 triangles of all kinds, around the numbers of lanes of a vector",
    .theme = DomainTheme::kCalls,
    .draw = Crowds};

static Case EveryLane(BitSource& bits, const SubjectInfo& info) {
  constexpr std::array<int, 16> kCounts{1, 3, 4, 5, 7, 8, 9, 12, 15, 16, 17, 17, 31, 32, 33, 33};
  const int count = bits.OneOf(std::span<const int>(kCounts));
  const int rows = (count + kRowOfCopies - 1) / kRowOfCopies;
  CaseBuilder builder(bits, info, std::min(count, kRowOfCopies) * kPitch, rows * kPitch);
  const std::array<Point2, 3> shape = DrawShape(builder);
  // Lanes that have nothing to do: none, each of some that are so many apart, or all but those.
  const std::int64_t apart = bits.Int(2, 8);
  const std::int64_t idle = bits.Int(0, 7);
  for (int t = 0; t < count; ++t) {
    const int row = t / kRowOfCopies;
    const Point2 by{static_cast<double>(t % kRowOfCopies * kPitch),
                    static_cast<double>(row * kPitch)};
    std::array<Point2, 3> v = shape;
    for (Point2& p : v) p = {p.x + by.x, p.y + by.y};
    const bool is_one_of_some = t % apart == apart - 1;
    if ((idle == 1 && is_one_of_some) || (idle == 2 && !is_one_of_some)) v[2] = v[1];
    builder.AddTriangle(v);
  }
  return builder.Done(Finish::kAsIs);
}

extern constinit const Domain kEveryLaneDomain{
    .number = 86,
    .bits = 0x2792612688570953,
    .name = "every-lane",
    .summary = "one triangle at each place of a list, around the numbers of lanes",
    .theme = DomainTheme::kCalls,
    .draw = EveryLane};

}  // namespace rasterproof::props
