#include "props/domains/lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "props/domains/hardest.h"

namespace rasterproof::props {
namespace {

// Coordinates of GridPlace and the small multiples that recipes take of them stay below this.
constexpr double kReach = 512;

// How often x must be doubled to be a multiple of 2^-grid_bits; sample locations need at most 8.
int DoublingsOntoGrid(double x, int grid_bits) {
  int doublings = 0;
  while (doublings < 8 && OnGrid(x, grid_bits + doublings) != x) ++doublings;
  return doublings;
}

// The point of the line through q and p whose x is that of `at`, or whose y is, for a steep line.
// In long double: q can be far off.
Point2 OntoLine(Point2 at, Point2 q, Point2 p) {
  const long double dx = static_cast<long double>(p.x) - q.x;
  const long double dy = static_cast<long double>(p.y) - q.y;
  if (std::fabs(dx) >= std::fabs(dy)) {
    if (dx == 0) return at;
    return {at.x, static_cast<double>(p.y + (at.x - p.x) * (dy / dx))};
  }
  return {static_cast<double>(p.x + (at.y - p.y) * (dx / dy)), at.y};
}

}  // namespace

double OnGrid(double x, int grid_bits) {
  return std::ldexp(std::nearbyint(std::ldexp(x, grid_bits)), -grid_bits);
}

Point2 GridPlace(CaseBuilder& builder) {
  const int grid_bits = builder.lattice().GridBits(kReach);
  const int bits = builder.bits().Chance(64) ? std::min(1, grid_bits) : grid_bits;
  return {OnGrid(builder.Uniform(-4, builder.width() + 4), bits),
          OnGrid(builder.Uniform(-4, builder.height() + 4), bits)};
}

Point2 ThroughSample(CaseBuilder& builder, Point2 a, Point2 p) {
  const int grid_bits = builder.lattice().GridBits(kReach);
  const int doublings =
      std::max(DoublingsOntoGrid(p.x, grid_bits), DoublingsOntoGrid(p.y, grid_bits));
  const auto times = static_cast<double>(doublings == 0 ? builder.bits().Int(2, 5)
                                                        : builder.bits().Int(1, 2) << doublings);
  return {a.x + times * (p.x - a.x), a.y + times * (p.y - a.y)};
}

Segment SegmentThrough(CaseBuilder& builder, Point2 p) {
  const Point2 a = GridPlace(builder);
  const Point2 b = ThroughSample(builder, a, p);
  return builder.bits().Chance(128) ? Segment{a, b} : Segment{b, a};
}

Point2 Nudged(CaseBuilder& builder, Point2 p, int most) {
  const std::int64_t steps = builder.bits().Int(-most, most);
  double& coordinate = builder.bits().Chance(128) ? p.x : p.y;
  coordinate = builder.lattice().Move(builder.lattice().Round(coordinate), steps);
  return p;
}

Point2 OnLattice(const CaseBuilder& builder, Point2 p) {
  return {builder.lattice().RoundWithinLimit(p.x), builder.lattice().RoundWithinLimit(p.y)};
}

Point2 Hardest(CaseBuilder& builder, Point2 guess, Point2 q, Point2 p) {
  const InputLattice& lattice = builder.lattice();
  const Point2 on_line = OntoLine({lattice.Round(guess.x), lattice.Round(guess.y)}, q, p);
  const Point2 start{lattice.Round(on_line.x), lattice.Round(on_line.y)};
  const int sign = builder.bits().Chance(128) ? 1 : -1;
  return HardestVertex(start, q, p, lattice, sign).value_or(start);
}

}  // namespace rasterproof::props
