// Triangles that the snap turns over and that cover a sample on the grid: facing, and culling by
// it, are those after the snap.
//
// Random slivers that turn over cover nothing, almost always. So the grid points come first: a
// lattice triangle around a sample, so few rows of the lattice thin that moves which the snap takes
// back turn it over.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <utility>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/is_stated.h"

namespace rasterproof::props {
namespace recipes_turned {

constexpr int kTries = 12;
// Rows between the long side and the vertex opposite, at most.
constexpr std::int64_t kMostRows = 8;

// Steps of the grid along x and y.
struct GridVector {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

struct Corners3 {
  std::array<Point2, 3> snapped;
  std::array<Point2, 3> given;
};

// How far from a grid point the snap still takes a coordinate to it, in steps.
struct Reach {
  double down = 0;
  double up = 0;
  double Toward(double sign) const { return sign > 0 ? up : down; }
};

Reach ReachAt(double x, SnapRule rule) {
  switch (rule) {
    case SnapRule::kFloor:
      return {0, 1};
    case SnapRule::kTruncate:
      return {x > 0 ? 0.0 : 1.0, x < 0 ? 0.0 : 1.0};
    case SnapRule::kNearestEven:
    case SnapRule::kNearestAway:
    case SnapRule::kHalfUp:
      break;
  }
  return {0.5, 0.5};
}

// The vector e with x e.y - y e.x = 1.
//
// Domain:     x and y coprime.
GridVector OneRowOff(GridVector d) {
  std::int64_t r0 = d.x;
  std::int64_t r1 = d.y;
  GridVector s0{1, 0};  // r0 = x s0.x + y s0.y
  GridVector s1{0, 1};
  while (r1 != 0) {
    const std::int64_t q = r0 / r1;
    r0 = std::exchange(r1, r0 - q * r1);
    s0 = std::exchange(s1, GridVector{s0.x - q * s1.x, s0.y - q * s1.y});
  }
  return {-s0.y * r0, s0.x * r0};  // r0 is +1 or -1
}

class Turner {
 public:
  explicit Turner(CaseBuilder& builder)
      : builder_(builder),
        snap_(builder.profile().snap),
        step_(std::ldexp(1.0, -snap_.bits)),
        // Mostly so near that no other grid point is legal within 0.6 of a step.
        part_(builder.bits().Chance(192) ? 0.78 : 0.98) {}

  // A triangle that turns over, if one is found; it lies inside the target unless it is the last
  // that was tried.
  std::optional<Corners3> Draw() {
    for (int k = 0; k < kTries; ++k) {
      const std::optional<Corners3> drawn = Try();
      if (drawn && (k == kTries - 1 || IsInside(*drawn))) return drawn;
    }
    return std::nullopt;
  }

 private:
  BitSource& bits() { return builder_.bits(); }

  // A primitive direction, of every length up to a quarter of the target.
  GridVector Direction() {
    const double side = std::min(builder_.width(), builder_.height()) / (4 * step_);
    const double most = std::max(3.0, Exp2(builder_.Uniform(0, 1) * Log2(side + 1)));
    const auto reach = static_cast<std::int64_t>(most);
    GridVector d{bits().Int(-reach, reach), 0};
    d.y = bits().Int(-reach, reach);
    const std::int64_t divisor = std::gcd(d.x, d.y);
    if (divisor > 1) d = {d.x / divisor, d.y / divisor};
    return std::abs(d.x) + std::abs(d.y) < 3 ? GridVector{2, 1} : d;
  }

  // i along the direction and j rows off, from the grid point that the sample snaps to.
  Point2 PlaceOf(Point2 origin, GridVector d, std::int64_t i, std::int64_t j) const {
    const GridVector e = OneRowOff(d);
    return {origin.x + step_ * static_cast<double>(i * d.x + j * e.x),
            origin.y + step_ * static_cast<double>(i * d.y + j * e.y)};
  }

  // Two vertices `before` rows before the sample's own, and one `behind` rows behind it.
  std::array<Point2, 3> Around(Point2 origin, GridVector d, std::int64_t before,
                               std::int64_t behind) {
    const double length = Hypot(static_cast<double>(d.x), static_cast<double>(d.y)) * step_;
    const double room = std::max(builder_.width(), builder_.height()) / (2 * length);
    const std::int64_t most = std::clamp<std::int64_t>(static_cast<std::int64_t>(room), 1, 4096);
    const std::int64_t m = bits().Int(1, most);
    const std::int64_t n = bits().Int(1, most);
    const std::int64_t k = bits().Int(-(n * behind - 1) / before, (m * behind - 1) / before);
    return {PlaceOf(origin, d, -m, -before), PlaceOf(origin, d, n, -before),
            PlaceOf(origin, d, k, behind)};
  }

  // Moves the vertices past each other by `rows` or more, each as far as the snap takes back.
  std::array<Point2, 3> Moved(const std::array<Point2, 3>& v, GridVector d, double rows) {
    const std::array<double, 2> rise{-static_cast<double>(d.y), static_cast<double>(d.x)};
    const auto reach = [&](std::size_t corner, std::size_t axis) {
      const double sign = (corner == 2 ? -1.0 : 1.0) * (rise[axis] < 0 ? -1.0 : 1.0);
      const double x = axis == 0 ? v[corner].x : v[corner].y;
      return sign * part_ * ReachAt(x, snap_.rule).Toward(sign);
    };
    double most = 0;
    for (std::size_t axis = 0; axis < 2; ++axis) {
      most +=
          std::fabs(rise[axis]) * (std::min(std::fabs(reach(0, axis)), std::fabs(reach(1, axis))) +
                                   std::fabs(reach(2, axis)));
    }
    const double least = std::min(1.0, rows / std::max(most, 1.0));
    std::array<Point2, 3> given = v;
    for (std::size_t corner = 0; corner < 3; ++corner) {
      for (std::size_t axis = 0; axis < 2; ++axis) {
        const double moved = step_ * reach(corner, axis) * builder_.Uniform(least, 1);
        (axis == 0 ? given[corner].x : given[corner].y) += moved;
      }
    }
    return given;
  }

  std::optional<Corners3> Try() {
    const Point2 p = builder_.Sample();
    const Point2 origin{SnapCoordinate(p.x, snap_), SnapCoordinate(p.y, snap_)};
    const GridVector d = Direction();
    const std::int64_t sum = std::abs(d.x) + std::abs(d.y);
    const std::int64_t most = std::clamp<std::int64_t>(sum * 3 / 4, 2, kMostRows);
    const std::int64_t rows = bits().Int(2, bits().Chance(128) ? 2 : most);
    const std::int64_t behind = bits().Int(1, rows - 1);
    Corners3 v;
    v.snapped = Around(origin, d, rows - behind, behind);
    v.given = Moved(v.snapped, d, static_cast<double>(rows));
    for (std::size_t k = 0; k < 3; ++k) {
      Point2& given = v.given[k];
      given = {builder_.lattice().RoundToPrecision(given.x),
               builder_.lattice().RoundToPrecision(given.y)};
      v.snapped[k] = {SnapCoordinate(given.x, snap_), SnapCoordinate(given.y, snap_)};
    }
    return Turns(v) && Holds(v.snapped, p) ? std::optional(v) : std::nullopt;
  }

  static bool Turns(const Corners3& v) {
    const int snapped = exact::Facing(v.snapped);
    return snapped != 0 && exact::Facing(v.given) == -snapped;
  }
  static bool Holds(const std::array<Point2, 3>& v, Point2 p) {
    const int turn = exact::Facing(v);
    return exact::Facing({v[0], v[1], p}) == turn && exact::Facing({v[1], v[2], p}) == turn &&
           exact::Facing({v[2], v[0], p}) == turn;
  }
  bool IsInside(const Corners3& v) const {
    return std::ranges::all_of(v.given, [&](Point2 p) {
      return p.x >= 0 && p.y >= 0 && p.x <= builder_.width() && p.y <= builder_.height();
    });
  }

  CaseBuilder& builder_;
  Snap snap_;
  double step_;
  double part_;
};

}  // namespace recipes_turned

static Case TurnedBySnap(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const std::int64_t triangles = bits.Int(1, 4);
  recipes_turned::Turner turner(builder);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const auto drawn = turner.Draw();
    if (!drawn) {  // on a grid that the input is as coarse as
      const Point2 a = builder.Place();
      const Point2 b = builder.Place();
      builder.AddTriangle({a, b, builder.Place()});
      continue;
    }
    const std::int32_t first = builder.AddRaw({drawn->given[0].x, drawn->given[0].y});
    builder.AddRaw({drawn->given[1].x, drawn->given[1].y});
    builder.AddRaw({drawn->given[2].x, drawn->given[2].y});
    builder.AddTriangle(first, first + 1, first + 2);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kTurnedBySnapDomain{
    .number = 89,
    .bits = 0x9e56e5bf5d724cf9,
    .name = "turned-by-snap",
    .summary = "triangles that the snap turns over, and that cover a sample once it has",
    .theme = DomainTheme::kSnapping,
    .off_grid = true,
    .is_stated = SnapsItsInput,
    .draw = TurnedBySnap};

}  // namespace rasterproof::props
