// Samples on an edge, a step off it, or as near as number theory allows.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "props/domains/hardest.h"
#include "props/domains/lines.h"
#include "props/domains/recipes.h"
#include "props/domains/sketch.h"

namespace rasterproof::props {
namespace {

constexpr std::array<int, 6> kNudges{0, 0, 1, 1, 2, 16};

Point2 Plus(Point2 p, double times, Point2 d) { return {p.x + times * d.x, p.y + times * d.y}; }

// The largest power of two that is at most `most` and within the profile's limit.
double Reach(const Sketch& sketch, double most) {
  const double limit = std::max(1.0, sketch.lattice().limit());
  return std::min(most, std::ldexp(1.0, std::ilogb(limit)));
}

}  // namespace

Case EdgesThroughSamples(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = sketch.Sample();
    Segment edge = SegmentThrough(sketch, p);
    if (sketch.lattice().Round(p.x) == p.x && sketch.lattice().Round(p.y) == p.y) {
      // Every period of d from p is a sample again.
      const Point2 d{static_cast<double>(bits.Int(-5, 5)), static_cast<double>(bits.Int(-5, 5))};
      const double half = bits.Chance(64) ? 0.5 : 1.0;
      edge = {Plus(p, -half * static_cast<double>(bits.Int(1, 9)), d),
              Plus(p, half * static_cast<double>(bits.Int(1, 9)), d)};
    }
    const Point2 q = sketch.Sample();
    const Point2 third =
        bits.Chance(128) ? Plus(edge.b, 2, {q.x - edge.b.x, q.y - edge.b.y}) : sketch.Place();
    sketch.AddTriangle({edge.a, edge.b, third});
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case NearEdge(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Segment edge = SegmentThrough(sketch, sketch.Sample());
    const Point2 third =
        bits.Chance(128) ? ThroughSample(sketch, edge.b, sketch.Sample()) : sketch.Place();
    const int most = bits.OneOf(std::span<const int>(kNudges));
    const Point2 a = Nudged(sketch, edge.a, most);
    const Point2 b = bits.Chance(128) ? Nudged(sketch, edge.b, most) : edge.b;
    sketch.AddTriangle({a, b, third});
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case HardestSamples(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  // A long edge on a uniform grid, moved by whole pixels: its hardest pixel goes into the target.
  const double reach = Reach(sketch, std::ldexp(1.0, static_cast<int>(bits.Int(11, 15))));
  const int grid_bits = std::min(24, sketch.lattice().GridBits(reach));
  const auto draw = [&] { return OnGrid(sketch.Uniform(0, reach / 2), grid_bits); };
  const Point2 a{draw(), draw()};
  const Point2 b{draw(), draw()};
  const Point2 p = sketch.Sample();
  const Point2 location{p.x - std::floor(p.x), p.y - std::floor(p.y)};
  const HardPixel pixel =
      HardestPixel(a, b, location, bits.Chance(128) ? 1 : -1).value_or(HardPixel{});
  const Point2 by{std::floor(p.x) - static_cast<double>(pixel.i),
                  std::floor(p.y) - static_cast<double>(pixel.j)};
  const Point2 third = bits.Chance(128) ? sketch.Place() : Plus({draw(), draw()}, 1, by);
  sketch.AddTriangle({Plus(a, 1, by), Plus(b, 1, by), third});
  return sketch.Done(Finish::kAnyOrder);
}

Case HardestVertices(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const std::int64_t triangles = bits.Int(1, 2);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = sketch.Sample();
    const Point2 drawn = sketch.Place();
    const Point2 q{sketch.lattice().Round(drawn.x), sketch.lattice().Round(drawn.y)};
    const double times = sketch.Uniform(0.25, 4);
    const Point2 v = Hardest(sketch, Plus(p, times, {p.x - q.x, p.y - q.y}), q, p);
    sketch.AddTriangle({q, v, sketch.Place()});
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case UlpExtremes(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  // From next to the target's corner, where an ulp is smallest, through a sample, to far away,
  // where it is largest: the differences need more bits than the products leave.
  const Point2 p = sketch.Sample();
  const int least = sketch.lattice().precision() == Precision::kFloat32 ? -20 : -40;
  const Point2 near{std::fabs(sketch.LogUniform(least, -4)),
                    std::fabs(sketch.LogUniform(least, -4))};
  const double far = Reach(sketch, std::ldexp(1.0, static_cast<int>(bits.Int(8, 14)))) / 2;
  const double times = far / std::max(p.x, p.y) * sketch.Uniform(1, 1.9);
  const Point2 beyond = Plus(near, times, {p.x - near.x, p.y - near.y});
  const Point2 q{sketch.lattice().RoundWithinLimit(beyond.x),
                 sketch.lattice().RoundWithinLimit(beyond.y)};
  const Point2 v = Hardest(sketch, near, q, p);
  const Point2 third = bits.Chance(128) ? Point2{q.x, -q.y} : sketch.Place();
  sketch.AddTriangle({v, q, third});
  return sketch.Done(Finish::kAnyOrder);
}

Case Caps(BitSource& bits, const SubjectInfo& info) {
  Sketch sketch(bits, info);
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const Point2 p = sketch.Sample();
    const Segment edge = SegmentThrough(sketch, p);
    sketch.AddTriangle({edge.a, edge.b, Nudged(sketch, p, 1)});
  }
  return sketch.Done(Finish::kAnyOrder);
}

Case LongRows(BitSource& bits, const SubjectInfo& info) {
  const int length = 1 << bits.Int(9, 14);
  const int across = static_cast<int>(bits.Int(1, 4));
  const bool along_y = bits.Chance(64);
  Sketch sketch(bits, info, along_y ? across : length, along_y ? length : across);
  const auto place = [&](double along, double beside) {
    return along_y ? Point2{beside, along} : Point2{along, beside};
  };
  // Stepping from the box's corner rounds once a step: an edge at the far end sees them all.
  // With dY = (odd) 2^-k next to 1 every rounding goes the same way.
  const double end = std::min<double>(length, sketch.lattice().limit());
  const double slant = 1 + std::ldexp(static_cast<double>(bits.Int(1, 64)), -11);
  const double top = sketch.Uniform(0, 1);
  sketch.AddTriangle({place(0, top), place(end, top), place(end, top + slant)});
  // And an edge along all the steps that passes a sample near its far end as closely as it can.
  const Point2 p = sketch.profile().pattern.At(along_y ? across / 2 : length - 1 - length / 64,
                                               along_y ? length - 1 - length / 64 : across / 2);
  const double ahead = sketch.Uniform(0.25, 1);
  const Point2 drawn = place(ahead, sketch.Uniform(0.25, across));
  const Point2 q{sketch.lattice().Round(drawn.x), sketch.lattice().Round(drawn.y)};
  const Point2 v = Hardest(sketch, place(end, sketch.Uniform(0.25, across)), q, p);
  sketch.AddTriangle({q, v, place(sketch.Uniform(0, end), across + 1.0)});
  return sketch.Done(Finish::kAnyOrder);
}

}  // namespace rasterproof::props
