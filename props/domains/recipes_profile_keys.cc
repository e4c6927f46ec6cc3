// What is next to what only some profiles state: a range that wraps, a largest extent, a
// guard-band rectangle, models of their own for some targets. Asked about a profile without it, a
// recipe takes one in its place, so that every bit string makes a case for every subject.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "core/case.h"
#include "core/subject_info.h"
#include "props/domains/bit_source.h"
#include "props/domains/case_builder.h"
#include "props/domains/domain.h"
#include "props/domains/lines.h"
#include "props/domains/recipes_range.h"

namespace rasterproof::props {
namespace {

// The step of the lattice beside x, also where that is 0.
double StepAt(const InputLattice& lattice, double x) {
  return std::max(lattice.Step(x), lattice.Step(0.5));
}

}  // namespace

static Case WrappedCoordinates(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  builder.IgnoreLimit();
  const FixedInput fixed = info.profile.fixed.value_or(FixedInput{});
  const auto most = std::min(info.profile.coordinate_limit, 3 * fixed.Span());
  const auto wrapping = [&](double x) {
    // Beside an end of the range, or an ordinary place some spans away.
    const std::int64_t kind = bits.Int(0, 7);
    if (kind == 0) x = fixed.Least() + static_cast<double>(bits.Int(-2, 2)) * fixed.Step();
    if (kind == 1) x = fixed.Largest() + static_cast<double>(bits.Int(-2, 2)) * fixed.Step();
    const double away = x + static_cast<double>(bits.Int(-2, 2)) * fixed.Span();
    return std::fabs(away) <= most ? away : x;
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    // An edge through a sample, and a place beside it: all of it taken apart by whole spans.
    const Point2 p = builder.Sample();
    const Segment edge = SegmentThrough(builder, p);
    std::array<Point2, 3> v{edge.a, edge.b, builder.Place()};
    for (Point2& corner : v) {
      const double x = wrapping(builder.lattice().Round(corner.x));
      corner = {x, wrapping(builder.lattice().Round(corner.y))};
    }
    builder.AddTriangle(v);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kWrappedCoordinatesDomain{
    .number = 50,
    .bits = 0xdb2de020fca18e05,
    .name = "wrapped-coordinates",
    .summary = "coordinates beyond a range that wraps, and beside its ends",
    .theme = DomainTheme::kMagnitudes,
    .is_stated = [](const Profile& p) { return p.fixed && p.fixed->wraps; },
    .draw = WrappedCoordinates};

static Case PrimitiveExtentEnds(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const MaxPrimitiveExtent most =
      info.profile.max_primitive_extent.value_or(MaxPrimitiveExtent{64, 32});
  // From `low` on, an extent a few steps off the largest one; in half steps, so that on a grid of
  // fewer bits than the input the snap decides. Or an ordinary extent.
  const auto high_end = [&](double low, double extent) {
    if (bits.Chance(96)) return low + extent * builder.Uniform(0.1, 0.9);
    const double step = StepAt(builder.lattice(), low + extent);
    return low + extent + static_cast<double>(bits.Int(-4, 4)) * 0.5 * step;
  };
  const auto low_end = [&](double extent, int side, bool along_y) {
    const double at = builder.Coordinate(side, along_y);
    const double back = bits.Chance(128) ? extent : 0;
    return builder.lattice().Round(at - back * builder.Uniform(0, 1));
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    const double left = low_end(most.width, builder.width(), false);
    const double right = high_end(left, most.width);
    const double top = low_end(most.height, builder.height(), true);
    const double bottom = high_end(top, most.height);
    const double part = builder.Uniform(0, 1);
    const bool right_angle = bits.Chance(128);
    const double within = builder.lattice().limit();
    const std::array<Point2, 3> v{
        Point2{left, top}, Point2{right, right_angle ? top : top + part * (bottom - top)},
        Point2{right_angle ? left : left + part * (right - left), bottom}};
    std::array<std::int32_t, 3> corner{};
    for (std::size_t k = 0; k < 3; ++k) {
      corner[k] = builder.AddRaw({std::clamp(v[k].x, builder.lattice().lowest(), within),
                                  std::clamp(v[k].y, builder.lattice().lowest(), within)});
    }
    builder.AddTriangle(corner[0], corner[1], corner[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kPrimitiveExtentEndsDomain{
    .number = 51,
    .bits = 0x4b825be7a150b730,
    .name = "primitive-extent-ends",
    .summary = "triangles of the largest extent that is drawn, a step less and more",
    .theme = DomainTheme::kMagnitudes,
    .off_grid = true,
    .is_stated = [](const Profile& p) { return p.max_primitive_extent.has_value(); },
    .draw = PrimitiveExtentEnds};

static Case GuardBandEnds(BitSource& bits, const SubjectInfo& info) {
  CaseBuilder builder(bits, info);
  const WindowBox box = UnclippedBox(info.profile, builder.width(), builder.height())
                            .value_or(WindowBox{-256, -256, 256, 256});
  // On a side of the rectangle, a step or two inside or outside it, well outside, or well inside.
  // Now and then all ends lie inside, or single samples would hardly ever be judged.
  const bool all_inside = bits.Chance(112);
  const auto end = [&](double side, double outwards) {
    const std::int64_t kind = bits.Int(0, 5);
    if (kind == 0 && !all_inside) return side + outwards * builder.Uniform(1, 64);
    if (kind == 1) return side - outwards * builder.Uniform(1, 8);
    const auto steps = static_cast<double>(bits.Int(-2, all_inside ? 0 : 2));
    return side + outwards * steps * StepAt(builder.lattice(), side);
  };
  // Two triangles on either side of an edge across the target, or a fan of four about a place in
  // it: neighbours share edges that leave the rectangle.
  const Point2 hub = bits.Chance(128) ? builder.Sample() : builder.Place();
  const Point2 left{end(box.x0, -1), builder.Coordinate(builder.height(), true)};
  const Point2 top{builder.Coordinate(builder.width(), false), end(box.y0, -1)};
  const Point2 right{end(box.x1, 1), builder.Coordinate(builder.height(), true)};
  const Point2 bottom{builder.Coordinate(builder.width(), false), end(box.y1, 1)};
  const std::array<std::int32_t, 4> around{builder.Add(left), builder.Add(top), builder.Add(right),
                                           builder.Add(bottom)};
  if (bits.Chance(128)) {
    builder.AddTriangle(around[0], around[1], around[2]);
    builder.AddTriangle(around[0], around[2], around[3]);
  } else {
    const std::int32_t middle = builder.Add(hub);
    for (std::size_t k = 0; k < 4; ++k) {
      builder.AddTriangle(around[k], around[(k + 1) % 4], middle);
    }
  }
  return builder.Done(Finish::kMesh);
}

extern constinit const Domain kGuardBandEndsDomain{
    .number = 52,
    .bits = 0xf29edd887529558a,
    .name = "guard-band-ends",
    .summary = "meshes with vertices on either side of the guard-band rectangle",
    .theme = DomainTheme::kMagnitudes,
    .mesh = true,
    .is_stated = StatesGuardBand,
    .draw = GuardBandEnds};

static Case OffGridMoves(BitSource& bits, const SubjectInfo& info) {
  // What is moved by so many pixels is not clipped either.
  constexpr int kMargin = 6;
  const auto side = [&] { return static_cast<int>(bits.Int(2 * kMargin + 2, 48)); };
  const int width = side();
  CaseBuilder builder(bits, info, width, side());
  // Some bits more than the grid has, and few enough that float32 holds all that are moved.
  const auto fraction = static_cast<int>(bits.Int(1, 16));
  const auto within = [&](int extent) {
    const double x = builder.Uniform(kMargin, extent - kMargin);
    return std::ldexp(std::floor(std::ldexp(x, fraction)), -fraction);
  };
  const std::int64_t triangles = bits.Int(1, 3);
  for (std::int64_t t = 0; t < triangles; ++t) {
    std::array<std::int32_t, 3> corner{};
    for (std::int32_t& k : corner) {
      const double x = within(builder.width());
      k = builder.AddRaw({x, within(builder.height())});
    }
    builder.AddTriangle(corner[0], corner[1], corner[2]);
  }
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kOffGridMovesDomain{
    .number = 72,
    .bits = 0xdd9e7a71873f94e,
    .listed = 521,
    .name = "off-grid-moves",
    .summary = "triangles off the grid that stay inside when moved, and exact in float32",
    .theme = DomainTheme::kSnapping,
    .off_grid = true,
    .is_stated = [](const Profile& p) { return p.translation_invariant; },
    .draw = OffGridMoves};

static Case TargetSizeEnds(BitSource& bits, const SubjectInfo& info) {
  const TargetModel any{.max_width = 64, .max_height = 64};
  const std::span<const TargetModel> models = info.profile.by_target_size.empty()
                                                  ? std::span(&any, 1)
                                                  : std::span(info.profile.by_target_size);
  const TargetModel& model = bits.OneOf(models);
  // One side of the largest size of the model, or one pixel more or less, the other small.
  const bool wide = bits.Chance(128);
  const int most = wide ? model.max_width : model.max_height;
  const std::int64_t beside = bits.Chance(128) ? 0 : bits.Int(-1, 1);
  const int side = static_cast<int>(std::clamp<std::int64_t>(most + beside, 1, kMaxTargetSide));
  const int other = static_cast<int>(bits.Int(1, 16));
  CaseBuilder builder(bits, info, wide ? side : other, wide ? other : side);
  AddDecidingTies(builder);
  return builder.Done(Finish::kAnyOrder);
}

extern constinit const Domain kTargetSizeEndsDomain{
    .number = 53,
    .bits = 0x6c2cc600d67e26bf,
    .name = "target-size-ends",
    .summary = "ties of the snap on the largest targets of each model, and on larger ones",
    .theme = DomainTheme::kCalls,
    .in_theme = 391,
    .off_grid = true,
    .is_stated = [](const Profile& p) { return !p.by_target_size.empty(); },
    .draw = TargetSizeEnds};

}  // namespace rasterproof::props
