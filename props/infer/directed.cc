#include "props/infer/directed.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string_view>

#include "core/case.h"
#include "core/ulp.h"
#include "model/snap.h"
#include "props/domains/domain.h"

namespace rasterproof::props {
namespace {

constexpr int kSide = 10;
constexpr int kFinestPlace = 8;  // sample locations are multiples of 2^-8

Point2 Snapped(Point2 p, const Snap& snap) {
  return {SnapCoordinate(p.x, snap), SnapCoordinate(p.y, snap)};
}

bool IsFloat(Point2 p) {
  return static_cast<double>(static_cast<float>(p.x)) == p.x &&
         static_cast<double>(static_cast<float>(p.y)) == p.y;
}

// A coordinate on the grid of 2^-b or half way between, exactly or a trifle beside.
double NearTie(BitSource& bits, int b) {
  double from = 0;
  double width = 0.5;  // where fl32(x - 1/2) is coarser than x
  const std::int64_t region = bits.Int(0, 2);
  if (region == 1) from = -12, width = 12;
  if (region == 2) width = kSide + 4;
  const double place = from + width * std::ldexp(static_cast<double>(bits.Bits(24)), -24);
  double x = std::ldexp(std::floor(std::ldexp(place, b)) + (bits.Chance(176) ? 0.5 : 0), -b);
  switch (bits.Int(0, 3)) {
    case 0:
      return x;
    case 1: {
      const int below = static_cast<int>(bits.Int(2, 10));
      x += std::ldexp(bits.Chance(128) ? 1.0 : -1.0, -b - below);
      break;
    }
    default: {
      const std::int64_t ulps = bits.Int(1, 3);
      const bool up = bits.Chance(128);
      return MoveByUlps(static_cast<float>(x), up ? ulps : -ulps);
    }
  }
  return static_cast<float>(x);
}

// The power of two that brings a coordinate of a sample onto the grid of 2^-b.
int DoublingsOntoGrid(double x, int b) {
  for (int k = 0; k < kFinestPlace; ++k) {
    const double scaled = std::ldexp(x, b + k);
    if (scaled == std::floor(scaled)) return k;
  }
  return kFinestPlace;
}

// The far end of an edge from g through s: s + m (s - g), on g's grid if s can be brought there.
Point2 FarEnd(BitSource& bits, Point2 g, Point2 s, int b) {
  const int doublings = std::max(DoublingsOntoGrid(s.x, b), DoublingsOntoGrid(s.y, b));
  const double period = std::ldexp(1.0, doublings);
  const double m = period * static_cast<double>(bits.Int(1, doublings > 4 ? 1 : 3)) - 1;
  const double steps = m == 0 ? 1 : m;
  return {s.x + steps * (s.x - g.x), s.y + steps * (s.y - g.y)};
}

Scene Triangle3(const std::array<Point2, 3>& corners, BitSource& bits) {
  Scene scene;
  scene.width = kSide;
  scene.height = kSide;
  for (const Point2 p : corners) scene.vertices.push_back({p.x, p.y, 0, 1});
  scene.triangles = {{0, 1, 2}};
  const auto turn = static_cast<std::ptrdiff_t>(bits.Int(0, 2));
  if (bits.Chance(128)) scene.triangles[0] = {1, 0, 2};
  std::ranges::rotate(scene.triangles[0], scene.triangles[0].begin() + turn);
  return scene;
}

int BitsOf(const Snap& snap, BitSource& bits) {
  return snap.IsNone() ? static_cast<int>(bits.Int(0, kMaxSubpixelBits)) : snap.bits;
}

}  // namespace

Scene SplittingTriangle(BitSource& bits, const ModelSpace& space, const Model& a, const Model& b) {
  const bool a_first = bits.Chance(128);
  // An edge can be brought through a sample only on a grid.
  const bool through_a = b.snap.IsNone() || (a_first && !a.snap.IsNone());
  const Model& through = through_a ? a : b;
  const SamplePattern& pattern = space.PatternOf(through);
  const int s = static_cast<int>(bits.Int(0, pattern.samples() - 1));
  const int column = static_cast<int>(bits.Int(0, kSide - 1));
  const Point2 sample = pattern.At(column, static_cast<int>(bits.Int(0, kSide - 1)), s);

  constexpr int kTries = 32;
  Point2 first;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    const int grid = BitsOf(bits.Chance(128) ? a.snap : b.snap, bits);
    const std::int64_t along = bits.Int(0, 7);  // now and then along an axis
    first.x = along == 0 ? sample.x : NearTie(bits, grid);
    first.y = along == 1 ? sample.y : NearTie(bits, grid);
    if (Snapped(first, a.snap) != Snapped(first, b.snap)) break;
    if (a.snap == b.snap) {  // then only the tie rules or the samples' places can differ
      first = Snapped(first, a.snap);
      break;
    }
  }
  const Point2 snapped = Snapped(first, through.snap);
  const Point2 far =
      FarEnd(bits, snapped, sample, through.snap.IsNone() ? kFinestPlace : through.snap.bits);
  Point2 third;
  third.x = static_cast<double>(bits.Int(-8, kSide + 8));
  third.y = static_cast<double>(bits.Int(-8, kSide + 8));
  const auto rounded = [](Point2 p) {
    return Point2{static_cast<float>(p.x), static_cast<float>(p.y)};
  };
  return Triangle3({rounded(first), IsFloat(far) ? far : rounded(far), third}, bits);
}

Scene AimlessTriangle(BitSource& bits) {
  constexpr int kAimlessSide = 16;
  const auto anywhere = [&] {
    const double share = std::ldexp(static_cast<double>(bits.Bits(24)), -24);
    return static_cast<double>(static_cast<float>(kAimlessSide * (1.5 * share - 0.25)));
  };
  const std::int64_t kind = bits.Int(0, 3);
  const double steps = std::ldexp(1.0, static_cast<int>(bits.Int(0, 4)));
  std::array<Point2, 3> corners;
  for (Point2& p : corners) {
    p.x = anywhere();
    p.y = anywhere();
    if (kind % 2 == 1)
      p = {std::nearbyint(p.x * steps) / steps, std::nearbyint(p.y * steps) / steps};
  }
  if (kind == 2) {
    Point2 sample;
    sample.x = static_cast<double>(bits.Int(0, kAimlessSide - 1)) + 0.5;
    sample.y = static_cast<double>(bits.Int(0, kAimlessSide - 1)) + 0.5;
    Point2 step;
    step.x = static_cast<double>(bits.Int(-32, 32)) / 8;
    step.y = static_cast<double>(bits.Int(-32, 32)) / 8;
    const bool by_ulps = bits.Chance(128);
    const double beside = std::ldexp(1.0, -static_cast<int>(bits.Int(6, 20)));
    const auto nudged = [&](double x) {
      const std::int64_t times = bits.Int(-2, 2);
      if (by_ulps) return double{MoveByUlps(static_cast<float>(x), times)};
      return double{static_cast<float>(x + beside * static_cast<double>(times))};
    };
    const auto before = static_cast<double>(bits.Int(1, 4));
    const auto after = static_cast<double>(bits.Int(1, 4));
    corners[0].x = nudged(sample.x - before * step.x);
    corners[0].y = nudged(sample.y - before * step.y);
    corners[1].x = nudged(sample.x + after * step.x);
    corners[1].y = nudged(sample.y + after * step.y);
  }
  Scene scene = Triangle3(corners, bits);
  scene.width = kAimlessSide;
  scene.height = kAimlessSide;
  return scene;
}

Scene OrdinaryTriangle(BitSource& bits, const SubjectInfo& info) {
  constexpr auto kDomains = std::to_array<std::string_view>(
      {"near-edge", "edges-through-samples", "snap-ties", "uniform-subpixel", "vertices-on-samples",
       "shared-snap-ties", "caps", "needles", "axis-aligned", "mixed-magnitude", "signed-zeros",
       "hardest-vertex", "ulp-extremes"});
  const Domain& domain = *FindDomain(bits.OneOf(std::span<const std::string_view>(kDomains)));
  SubjectInfo asked = info;
  asked.input = Precision::kFloat32;
  asked.takes_window = true;
  Case c = domain.draw(bits, asked);
  const auto count = static_cast<std::int64_t>(c.scene.triangles.size());
  const Triangle kept = c.scene.triangles[static_cast<std::size_t>(bits.Int(0, count - 1))];
  c.scene.triangles = {kept};
  return c.scene;
}

}  // namespace rasterproof::props
