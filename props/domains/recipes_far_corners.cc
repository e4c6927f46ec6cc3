// Corners on both sides of every power of two up to the stated limit: where a rasterizer leaves its
// ordinary path, clips, or runs out of bits. Edges with both ends near the target pass samples
// exactly or between grid points, so that neighbours of different paths must agree there; samples
// a step and more from every edge are decided, whatever is clipped.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/case.h"
#include "core/elementary.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/is_stated.h"

namespace rasterproof::props {
namespace recipes_far_corners {

// Real geometry has no limit: what is beyond this is the business of other domains.
constexpr double kMostFar = 0x1p40;

class FarPair {
 public:
  explicit FarPair(CaseBuilder& builder)
      : builder_(builder),
        most_(std::ilogb(std::clamp(builder.lattice().limit(), 2.0, kMostFar))),
        step_(
            std::ldexp(1.0, -(builder.profile().snap.IsNone() ? 8 : builder.profile().snap.bits))),
        at_(builder.Sample()) {
    along_ = {Component(), Component()};
    if (along_.x == 0 && along_.y == 0) along_.x = 1;
  }

  void Add() {
    const std::int64_t kind = bits().Int(0, 7);
    const double off = Offset();
    Point2 a = Corner(End(kind >= 6), off);
    Point2 b = Corner(-End(kind >= 4), off);
    const Point2 left = Third(+1);
    const Point2 right = Third(-1);
    const std::int32_t ia = AddCorner(a);
    const std::int32_t ib = AddCorner(b);
    const int turn = AddTriangle(ia, ib, a, b, left, 0);
    if (turn != 0 && bits().Chance(208)) AddTriangle(ib, ia, b, a, right, turn);
  }

  // A common edge near the target, its ends between grid points, that passes within a step of the
  // sample; of the corners beside it one is near, and one far.
  void AddNearBesideFar() {
    const double off = step_ * static_cast<double>(bits().Int(-16, 16)) / 16;
    Point2 a = Corner(Near(), off);
    Point2 b = Corner(-Near(), off);
    for (Point2* const p : {&a, &b}) {
      p->x += step_ * static_cast<double>(bits().Int(-7, 7)) / 16;
      p->y += step_ * static_cast<double>(bits().Int(-7, 7)) / 16;
      *p = {builder_.lattice().RoundToPrecision(p->x), builder_.lattice().RoundToPrecision(p->y)};
    }
    const int most = std::max(3, most_);
    const int least = bits().Chance(128) ? std::max(3, most - 3) : 3;
    const double across = std::ldexp(1.0, static_cast<int>(bits().Int(least, most)));
    const Point2 far = Beside(+1, across, builder_.Uniform(-0.5, 0.5) * across);
    const double wide = Near() + 4;
    const Point2 near = Beside(-1, wide, builder_.Uniform(-4, 4));
    const std::int32_t ia = builder_.AddRaw({a.x, a.y});
    const std::int32_t ib = builder_.AddRaw({b.x, b.y});
    const int turn = AddTriangle(ia, ib, a, b, far, 0);
    if (turn != 0) AddTriangle(ib, ia, b, a, near, turn);
  }

 private:
  BitSource& bits() { return builder_.bits(); }
  double Component() { return static_cast<double>(bits().Int(-3, 3)); }
  double Near() { return static_cast<double>(bits().Int(1, 6)); }

  // A power of two, two steps of the lattice beside it, a few pixels, or up to half of it.
  double Far() {
    const double power = std::ldexp(1.0, static_cast<int>(bits().Int(3, std::max(3, most_))));
    switch (bits().Int(0, 3)) {
      case 0:
        return builder_.lattice().Move(builder_.lattice().Round(power), bits().Int(-2, 2));
      case 1:
        return power + static_cast<double>(bits().Int(-8, 8));
      case 2:
        return power * builder_.Uniform(0.5, 1);
      default:
        return power;
    }
  }

  double End(bool is_far) {
    if (!is_far) return Near();
    return Far() / std::max(std::fabs(along_.x), std::fabs(along_.y));
  }

  // From the sample across the edge: none, about a step, or up to three pixels.
  double Offset() {
    const std::int64_t kind = bits().Int(0, 7);
    if (kind < 4) return 0;
    const double steps = static_cast<double>(bits().Int(-32, 32)) / 16;
    return kind < 6 ? steps * step_ : builder_.Uniform(-3, 3);
  }

  Point2 Corner(double along, double off) const {
    const bool steep = std::fabs(along_.y) > std::fabs(along_.x);
    return {at_.x + along * along_.x + (steep ? off : 0),
            at_.y + along * along_.y + (steep ? 0 : off)};
  }

  // On one side of the edge, near or far, level with the sample or not.
  Point2 Third(double side) {
    const double across = bits().Chance(192) ? Far() : Near() + 4;
    const double most = bits().Chance(128) ? across : Near();
    return Beside(side, across, builder_.Uniform(-1, 1) * most);
  }

  Point2 Beside(double side, double across, double along) const {
    const double length = Hypot(along_.x, along_.y);
    const Point2 unit{along_.x / length, along_.y / length};
    return {at_.x + along * unit.x - side * across * unit.y,
            at_.y + along * unit.y + side * across * unit.x};
  }

  // Half of those near the target lie between grid points.
  std::int32_t AddCorner(Point2& p) {
    const bool is_near = std::max(std::fabs(p.x), std::fabs(p.y)) < 0x1p10;
    if (is_near && bits().Chance(128)) {
      p.x += step_ * static_cast<double>(bits().Int(-9, 9)) / 16;
      p.y += step_ * static_cast<double>(bits().Int(-9, 9)) / 16;
    } else {
      p = {builder_.lattice().RoundWithinLimit(p.x), builder_.lattice().RoundWithinLimit(p.y)};
    }
    p = {builder_.lattice().RoundToPrecision(p.x), builder_.lattice().RoundToPrecision(p.y)};
    return builder_.AddRaw({p.x, p.y});
  }

  // Returns its facing. One that does not face as wanted, where the lattice is coarse, is left out.
  int AddTriangle(std::int32_t ia, std::int32_t ib, Point2 a, Point2 b, Point2 third, int wanted) {
    third = {builder_.lattice().RoundWithinLimit(third.x),
             builder_.lattice().RoundWithinLimit(third.y)};
    const int facing = exact::Facing({a, b, third});
    if (wanted != 0 && facing != wanted) return facing;
    builder_.AddTriangle(ia, ib, builder_.AddRaw({third.x, third.y}));
    return facing;
  }

  CaseBuilder& builder_;
  int most_;
  double step_;
  Point2 at_;
  Point2 along_;
};

}  // namespace recipes_far_corners

static Case FarCorners(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  recipes_far_corners::FarPair(builder).Add();
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kFarCornersDomain{
    .number = 90,
    .bits = 0x6300680f30d05176,
    .name = "far-corners",
    .summary = "pairs with corners beside every power of two up to the stated limit",
    .theme = DomainTheme::kMagnitudes,
    .in_theme = 182,
    .off_grid = true,
    .mesh = true,
    // Each power of two is a place where a path may begin.
    .in_a_round = 4,
    .draw = FarCorners};

static Case NearBesideFar(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  recipes_far_corners::FarPair(builder).AddNearBesideFar();
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kNearBesideFarDomain{
    .number = 95,
    .bits = 0xc2b6b4ad8fa55f1f,
    .name = "near-beside-far",
    .summary = "pairs that share an edge between grid points, one with a far third corner",
    .theme = DomainTheme::kMagnitudes,
    .in_theme = 183,
    .off_grid = true,
    .mesh = true,
    .in_a_round = 2,
    .is_stated = SnapsItsInput,
    .draw = NearBesideFar};

}  // namespace rasterproof::props
