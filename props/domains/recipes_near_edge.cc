// Samples on an edge, a step off it, or as near as number theory allows.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/case.h"
#include "core/sample_pattern.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/hardest.h"
#include "props/domains/lines.h"

namespace rasterproof::props {
namespace {

constexpr std::array<int, 6> kNudges{0, 0, 1, 1, 2, 16};

Point2 Plus(Point2 p, double times, Point2 d) { return {p.x + times * d.x, p.y + times * d.y}; }

// The largest power of two that is at most `most` and within the profile's limit.
double Reach(const CaseBuilder& builder, double most) {
  const double limit = std::max(1.0, builder.lattice().limit());
  return std::min(most, std::ldexp(1.0, std::ilogb(limit)));
}

// How many samples within four pixels of p lie on the line through p along d.
int SamplesAlong(const SamplePattern& pattern, Point2 p, Point2 d) {
  constexpr int kAround = 4;
  const Point2 pixel{std::floor(p.x), std::floor(p.y)};
  int on_line = 0;
  for (int j = -kAround; j <= kAround; ++j) {
    for (int i = -kAround; i <= kAround; ++i) {
      for (const Point2& place : pattern.locations) {
        const Point2 q{pixel.x + i + place.x - p.x, pixel.y + j + place.y - p.y};
        on_line += d.x * q.y == d.y * q.x ? 1 : 0;
      }
    }
  }
  return on_line;
}

// Of four directions from p to samples near it, the one that passes the most.
Point2 DirectionOfMostSamples(CaseBuilder& builder, Point2 p) {
  const SamplePattern& pattern = builder.profile().pattern;
  Point2 best{1, 0};
  int most = 0;
  for (int k = 0; k < 4; ++k) {
    const Point2 place = builder.bits().OneOf(std::span<const Point2>(pattern.locations));
    const auto i = static_cast<double>(builder.bits().Int(-2, 2));
    const auto j = static_cast<double>(builder.bits().Int(-2, 2));
    const Point2 d{std::floor(p.x) + i + place.x - p.x, std::floor(p.y) + j + place.y - p.y};
    const int samples = d.x == 0 && d.y == 0 ? 0 : SamplesAlong(pattern, p, d);
    if (samples > most) {
      most = samples;
      best = d;
    }
  }
  return best;
}

}  // namespace

static Case EdgesThroughSamples(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = builder.Sample();
    Segment edge = SegmentThrough(builder, p);
    if (builder.lattice().Round(p.x) == p.x && builder.lattice().Round(p.y) == p.y) {
      // Every period of d from p is a sample again.
      const Point2 d{static_cast<double>(bits.Int(-5, 5)), static_cast<double>(bits.Int(-5, 5))};
      const double half = bits.Chance(64) ? 0.5 : 1.0;
      edge = {Plus(p, -half * static_cast<double>(bits.Int(1, 9)), d),
              Plus(p, half * static_cast<double>(bits.Int(1, 9)), d)};
    }
    const Point2 q = builder.Sample();
    const Point2 third =
        bits.Chance(128) ? Plus(edge.b, 2, {q.x - edge.b.x, q.y - edge.b.y}) : builder.Place();
    builder.AddTriangle({edge.a, edge.b, third});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kEdgesThroughSamplesDomain{
    .number = 4,
    .bits = 0x82501df505f3892,
    .name = "edges-through-samples",
    .summary = "edges that pass exactly through many samples",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .ties = true,
    .draw = EdgesThroughSamples};

static Case NearEdge(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Segment edge = SegmentThrough(builder, builder.Sample());
    const Point2 third =
        bits.Chance(128) ? ThroughSample(builder, edge.b, builder.Sample()) : builder.Place();
    const int most = bits.OneOf(std::span<const int>(kNudges));
    const Point2 a = Nudged(builder, edge.a, most);
    const Point2 b = bits.Chance(128) ? Nudged(builder, edge.b, most) : edge.b;
    builder.AddTriangle({a, b, third});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kNearEdgeDomain{
    .number = 5,
    .bits = 0xfcc525f375a435f6,
    .name = "near-edge",
    .summary = "samples 0, 1, 2, ... lattice steps off an edge, by construction",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .ties = true,
    .draw = NearEdge};

static Case HardestSamples(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  // A long edge on a uniform grid, moved by whole pixels: its hardest pixel goes into the target.
  const double reach = Reach(builder, std::ldexp(1.0, static_cast<int>(bits.Int(11, 15))));
  const int grid_bits = std::min(24, builder.lattice().GridBits(reach));
  const auto draw = [&] { return OnGrid(builder.Uniform(0, reach / 2), grid_bits); };
  const Point2 a{draw(), draw()};
  const Point2 b{draw(), draw()};
  const Point2 p = builder.Sample();
  const Point2 location{p.x - std::floor(p.x), p.y - std::floor(p.y)};
  const HardPixel pixel =
      HardestPixel(a, b, location, bits.Chance(128) ? 1 : -1).value_or(HardPixel{});
  const Point2 by{std::floor(p.x) - static_cast<double>(pixel.i),
                  std::floor(p.y) - static_cast<double>(pixel.j)};
  const Point2 third = bits.Chance(128) ? builder.Place() : Plus({draw(), draw()}, 1, by);
  builder.AddTriangle({Plus(a, 1, by), Plus(b, 1, by), third});
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kHardestSamplesDomain{
    .number = 6,
    .bits = 0x6b7a4bd57c50acc8,
    .name = "hardest-sample",
    .summary = "the sample of smallest non-zero |E| along an edge of up to 16384 pixels",
    .theme = DomainTheme::kNearEdges,
    .draw = HardestSamples};

static Case HardestVertices(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 2);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = builder.Sample();
    const Point2 drawn = builder.Place();
    const Point2 q{builder.lattice().Round(drawn.x), builder.lattice().Round(drawn.y)};
    const double times = builder.Uniform(0.25, 4);
    const Point2 v = Hardest(builder, Plus(p, times, {p.x - q.x, p.y - q.y}), q, p);
    builder.AddTriangle({q, v, builder.Place()});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kHardestVerticesDomain{
    .number = 7,
    .bits = 0xe4edd05b6b7a9e96,
    .name = "hardest-vertex",
    .summary = "the vertex of smallest non-zero |E| at a sample, by extended Euclid",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .draw = HardestVertices};

static Case UlpExtremes(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  // From next to the target's corner, where an ulp is smallest, through a sample, to far away,
  // where it is largest: the differences need more bits than the products leave.
  const Point2 p = builder.Sample();
  const int least = builder.lattice().precision() == Precision::kFloat32 ? -20 : -40;
  const Point2 near{std::fabs(builder.LogUniform(least, -4)),
                    std::fabs(builder.LogUniform(least, -4))};
  const double far = Reach(builder, std::ldexp(1.0, static_cast<int>(bits.Int(8, 14)))) / 2;
  const double times = far / std::max(p.x, p.y) * builder.Uniform(1, 1.9);
  const Point2 beyond = Plus(near, times, {p.x - near.x, p.y - near.y});
  const Point2 q{builder.lattice().RoundWithinLimit(beyond.x),
                 builder.lattice().RoundWithinLimit(beyond.y)};
  const Point2 v = Hardest(builder, near, q, p);
  const Point2 third = bits.Chance(128) ? Point2{q.x, -q.y} : builder.Place();
  builder.AddTriangle({v, q, third});
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kUlpExtremesDomain{
    .number = 8,
    .bits = 0x98d5e16434f09c93,
    .name = "ulp-extremes",
    .summary = "hardest vertices whose edge runs from the smallest ulp to the largest",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .draw = UlpExtremes};

static Case Caps(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = builder.Sample();
    const Segment edge = SegmentThrough(builder, p);
    builder.AddTriangle({edge.a, edge.b, Nudged(builder, p, 1)});
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kCapsDomain{
    .number = 10,
    .bits = 0x5c03bfae181c0847,
    .name = "caps",
    .summary = "the apex on a sample, one step off the opposite edge",
    .theme = DomainTheme::kThin,
    .near_edge = true,
    .draw = Caps};

static Case LongRows(BitSource& bits, const SubjectInfo& info) {
  const int longest = 1 << bits.Int(9, 14);
  const int widest = static_cast<int>(bits.Int(1, 4));
  const bool along_y = bits.Chance(64);
  CaseBuilder builder(bits, info, along_y ? widest : longest, along_y ? longest : widest);
  const int length = along_y ? builder.height() : builder.width();
  const int across = along_y ? builder.width() : builder.height();
  const auto place = [&](double along, double beside) {
    return along_y ? Point2{beside, along} : Point2{along, beside};
  };
  // Stepping from the box's corner rounds once a step: an edge at the far end sees them all.
  // With dY = (odd) 2^-k next to 1 every rounding goes the same way.
  const double end = std::min<double>(length, builder.lattice().limit());
  const double slant = 1 + std::ldexp(static_cast<double>(bits.Int(1, 64)), -11);
  const double top = builder.Uniform(0, 1);
  builder.AddTriangle({place(0, top), place(end, top), place(end, top + slant)});
  // And an edge along all the steps that passes a sample near its far end as closely as it can.
  const Point2 p = builder.profile().pattern.At(along_y ? across / 2 : length - 1 - length / 64,
                                                along_y ? length - 1 - length / 64 : across / 2);
  const double ahead = builder.Uniform(0.25, 1);
  const Point2 drawn = place(ahead, builder.Uniform(0.25, across));
  const Point2 q{builder.lattice().Round(drawn.x), builder.lattice().Round(drawn.y)};
  const Point2 v = Hardest(builder, place(end, builder.Uniform(0.25, across)), q, p);
  builder.AddTriangle({q, v, place(builder.Uniform(0, end), across + 1.0)});
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kLongRowsDomain{
    .number = 38,
    .bits = 0x5a6f72d35c827e89,
    .name = "long-rows",
    .summary = "rows and columns of up to 16384 samples, hard at their far end",
    .theme = DomainTheme::kNearEdges,
    .in_theme = 551,
    .near_edge = true,
    .draw = LongRows};

static Case PatternLines(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const Point2 p = builder.Sample();
  const Point2 d = DirectionOfMostSamples(builder, p);
  Segment edge = SegmentThrough(builder, p);
  if (OnLattice(builder, p) == p && OnLattice(builder, Plus(p, 1, d)) == Plus(p, 1, d)) {
    const auto before = static_cast<double>(bits.Int(1, 12));
    const auto after = static_cast<double>(bits.Int(1, 12));
    edge = {OnLattice(builder, Plus(p, -before, d)), OnLattice(builder, Plus(p, after, d))};
  }
  // A triangle on either side: at least a pixel high, the second the first turned about the middle.
  const Point2 run{edge.b.x - edge.a.x, edge.b.y - edge.a.y};
  const double longer = std::max(std::abs(run.x), std::abs(run.y));
  const double unit = longer == 0 ? 0 : std::ldexp(1.0, -std::ilogb(longer));
  const double across = unit * static_cast<double>(bits.Int(1, 8));
  const double along = unit * static_cast<double>(bits.Int(-2, 2));
  const Point2 apex = OnLattice(builder, Plus(Plus(edge.a, along, run), across, {-run.y, run.x}));
  const Point2 turned{edge.a.x + edge.b.x - apex.x, edge.a.y + edge.b.y - apex.y};
  const std::int32_t a = builder.Add(edge.a);
  const std::int32_t b = builder.Add(edge.b);
  builder.AddTriangle(a, b, builder.Add(apex));
  if (OnLattice(builder, turned) == turned) builder.AddTriangle(b, a, builder.Add(turned));
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kPatternLinesDomain{
    .number = 88,
    .bits = 0xe99927507394bffd,
    .name = "pattern-lines",
    .summary = "edges that pass exactly through many samples of a pattern of several",
    .theme = DomainTheme::kNearEdges,
    .near_edge = true,
    .ties = true,
    .mesh = true,
    .is_stated = [](const Profile& p) { return p.pattern.samples() > 1; },
    .draw = PatternLines};

}  // namespace rasterproof::props
