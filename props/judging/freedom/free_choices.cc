#include "props/judging/freedom/free_choices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/elementary.h"
#include "core/profile.h"
#include "core/snap.h"
#include "exact/coverage.h"
#include "exact/homogeneous.h"
#include "exact/snap_clip.h"
#include "model/drop.h"
#include "model/snap.h"
#include "model/target_profile.h"
#include "model/wrap.h"
#include "props/judging/freedom/outline.h"
#include "props/placed_case.h"

namespace rasterproof::props {
namespace {

// The distance of a sample from a triangle is computed in double: off by less than this times M,
// the largest coordinate of the triangles plus that of the samples. With u = 2^-53 the share along
// an edge is off by less than 10u of |to| / |along|, which slides the foot by 10u |to|; the foot
// and its distance round by less than 6u (|to| + |along|) + 2u M. As |to| + |along| is at most
// 3 sqrt(2) M, that is less than 70u M. The middles of the places and the sums of the reach add
// less than 16u M.
constexpr double kDistanceMarginPerCoordinate = 0x1p-46;
// A quotient of doubles is off by 2^-53 of itself: a grid point that much too far counts as near.
constexpr double kQuotientMargin = 0x1p-50;

bool MayMoveVertices(Contract contract) {
  return contract == Contract::kWatertight || contract == Contract::kClosed;
}

double LargestCoordinate(const PlacedCase& c) {
  double largest = 0;
  for (const Vertex& v : c.scene.vertices) {
    const double w = c.scene.clip_space && v.w > 0 ? v.w : 1;
    for (const double x : {v.x / w, v.y / w}) {
      if (std::isfinite(x)) largest = std::max(largest, std::fabs(x));
    }
  }
  return largest;
}

// How far the legal models of a case may put its vertices.
struct Reach {
  Freedom freedom;                                    ///< of grids and of their points
  double slack = 0;                                   ///< in pixels, on each axis, beyond that
  double beside = 0;                                  ///< in pixels: all vertices alike
  std::optional<WindowBox> unclipped = std::nullopt;  ///< window space
  double clipped = 0;  ///< in pixels, on each axis: a triangle that leaves `unclipped`
};

// How far clipping may move an edge: by less than a step, where its new vertices go to grid points.
double ReachOfClipping(const Profile& profile) {
  if (!MovesClippedEdges(profile)) return kMovedOutlineMargin;
  return std::ldexp(1.0, -LegalGrids(profile.snap, profile.freedom).front().bits);
}

Reach ReachOfVertices(const PlacedCase& c, const Profile& profile) {
  if (!MayMoveVertices(profile.contract)) return {profile.freedom, 0, 0};
  const double rounding = kOutlineMarginPerCoordinate * LargestCoordinate(c);
  if (profile.snap.IsNone()) return {{}, kMovedOutlineMargin + rounding, 0};
  return {{.snap_tolerance = 1}, rounding, kMovedOutlineMargin};
}

Reach ReachOf(const PlacedCase& c, const Profile& profile) {
  Reach reach = ReachOfVertices(c, profile);
  reach.unclipped = UnclippedBox(profile, c.scene.width, c.scene.height);
  reach.clipped = ReachOfClipping(profile);
  return reach;
}

// A coordinate's least and greatest legal value, the canonical one between them, and the given one.
struct Span {
  double low = 0;
  double high = 0;
  double given = 0;
};

Span Widened(Span span, double slack) { return {span.low - slack, span.high + slack, span.given}; }

Span WindowSpan(double unwrapped, const Profile& profile, const Reach& reach) {
  const double x = profile.fixed ? Wrapped(unwrapped, *profile.fixed) : unwrapped;
  const double own = SnapCoordinate(x, profile.snap);
  Span span{own, own, x};
  for (const Snap& grid : LegalGrids(profile.snap, reach.freedom)) {
    const std::vector<double> points = LegalGridPoints(x, grid, reach.freedom);
    span.low = std::min(span.low, points.front());
    span.high = std::max(span.high, points.back());
  }
  return Widened(span, reach.slack);
}

// Nothing if x / w has no place on the grid.
std::optional<Span> QuotientSpan(double x, double w, const Profile& profile, const Reach& reach) {
  const double quotient = x / w;
  if (!std::isfinite(quotient)) return std::nullopt;
  const Snap& snap = profile.snap;
  if (snap.IsNone()) return Widened({quotient, quotient, quotient}, reach.slack);
  const std::optional<double> own = exact::TrySnapQuotient(x, w, snap);
  if (!own) return std::nullopt;
  const double steps = reach.freedom.any_rounding ? 1 : reach.freedom.snap_tolerance;
  Span span{*own, *own, quotient};
  for (const Snap& grid : LegalGrids(snap, reach.freedom)) {
    if (grid.IsNone()) continue;  // the quotient lies between points of the others
    const double step = std::ldexp(1.0, -grid.bits);
    const double far = steps * step + kQuotientMargin * std::fabs(quotient) +
                       reach.freedom.TransformReach(quotient);
    span.low = std::min(span.low, std::ceil((quotient - far) / step) * step);
    span.high = std::max(span.high, std::floor((quotient + far) / step) * step);
  }
  return Widened(span, reach.slack);
}

struct PlacedVertex {
  LegalPlaces legal;
  Point2 given;
};

PlacedVertex Joined(const Span& x, const Span& y) {
  return {{{x.low, y.low}, {x.high, y.high}}, {x.given, y.given}};
}

std::optional<PlacedVertex> Placed(const Vertex& v, bool clip_space, const Profile& profile,
                                   const Reach& reach) {
  if (!clip_space) return Joined(WindowSpan(v.x, profile, reach), WindowSpan(v.y, profile, reach));
  if (!(v.w > 0)) return std::nullopt;
  const std::optional<Span> x = QuotientSpan(v.x, v.w, profile, reach);
  const std::optional<Span> y = QuotientSpan(v.y, v.w, profile, reach);
  if (!x || !y) return std::nullopt;
  return Joined(*x, *y);
}

using Places = std::array<LegalPlaces, 3>;

enum class Drops : std::uint8_t { kNever, kAlways, kInSomeModels };

Drops DropsOf(const Places& places, const std::optional<MaxPrimitiveExtent>& most) {
  if (!most) return Drops::kNever;
  const auto low = [](const LegalPlaces& p) { return p.low; };
  const auto high = [](const LegalPlaces& p) { return p.high; };
  const auto least = [&](auto of, auto axis) {
    return std::min({axis(of(places[0])), axis(of(places[1])), axis(of(places[2]))});
  };
  const auto greatest = [&](auto of, auto axis) {
    return std::max({axis(of(places[0])), axis(of(places[1])), axis(of(places[2]))});
  };
  const auto x = [](Point2 p) { return p.x; };
  const auto y = [](Point2 p) { return p.y; };
  const Point2 first{least(low, x), least(low, y)};
  const Point2 last{greatest(high, x), greatest(high, y)};
  if (!Exceeds({first, last, last}, *most)) return Drops::kNever;
  // The least extent is between the ends that are nearest to each other.
  const Point2 begin{least(high, x), least(high, y)};
  const Point2 end{std::max(begin.x, greatest(low, x)), std::max(begin.y, greatest(low, y))};
  return Exceeds({begin, end, end}, *most) ? Drops::kAlways : Drops::kInSomeModels;
}

// Window axes turn the other way than the screen's where y is up.
bool AlwaysCullsTurn(const Profile& profile, int turn) {
  return AlwaysCulls(profile, profile.y_axis == YAxis::kUp ? -turn : turn);
}

// Whether no legal model draws a triangle of these places, for its extent or its facing.
bool IsDrawnByNone(const Places& places, const Profile& profile) {
  if (DropsOf(places, profile.max_primitive_extent) == Drops::kAlways) return true;
  return profile.culls != Cull::kNone && AlwaysCullsTurn(profile, FacingOfAll(places).value_or(0));
}

bool LeavesBy(const LegalPlaces& places, const Vertex& v, const std::optional<WindowBox>& box) {
  return box && !(box->Contains(places.low.x, places.low.y) &&
                  box->Contains(places.high.x, places.high.y) && box->Contains(v.x, v.y));
}

double Apart(Point2 a, Point2 b) { return Hypot(a.x - b.x, a.y - b.y); }

double SegmentDistance(Point2 a, Point2 b, Point2 p) {
  const Point2 d{b.x - a.x, b.y - a.y};
  const double along = ((p.x - a.x) * d.x + (p.y - a.y) * d.y) / (d.x * d.x + d.y * d.y);
  const double part = along > 0 ? std::min(along, 1.0) : 0.0;
  return Apart(p, {a.x + part * d.x, a.y + part * d.y});
}

// 0 inside.
double TriangleDistance(const std::array<Point2, 3>& v, Point2 p) {
  const auto value = [&](std::size_t i) {
    const Point2 a = v[i];
    const Point2 b = v[(i + 1) % 3];
    return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
  };
  const auto [least, most] = std::minmax({value(0), value(1), value(2)});
  if (least >= 0 || most <= 0) return 0;  // a flat one's line as well: more than it covers
  return std::min({SegmentDistance(v[0], v[1], p), SegmentDistance(v[1], v[2], p),
                   SegmentDistance(v[2], v[0], p)});
}

Point2 Middle(const LegalPlaces& p) {
  return {p.low.x + 0.5 * (p.high.x - p.low.x), p.low.y + 0.5 * (p.high.y - p.low.y)};
}

bool HaveOnePlace(const Vertex& a, const Vertex& b) {
  return a.x == b.x && a.y == b.y && a.w == b.w;
}

// A triangle's legal places. Clipping may move its edges further.
struct PlacedTriangle {
  Places places{};
  double most_moved = 0;
  bool is_clipped = false;
  std::array<bool, 3> is_outside{};  ///< by corner
};

std::optional<PlacedTriangle> PlacedCorners(const std::array<Vertex, 3>& v, bool clip_space,
                                            const Profile& profile, const Reach& reach) {
  std::array<PlacedVertex, 3> placed;
  PlacedTriangle triangle;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::optional<PlacedVertex> corner = Placed(v[k], clip_space, profile, reach);
    if (!corner) return std::nullopt;
    placed[k] = *corner;
    const bool leaves = !clip_space && LeavesBy(corner->legal, v[k], reach.unclipped);
    triangle.is_clipped = triangle.is_clipped || leaves;
    triangle.is_outside[k] = leaves;
  }
  const double clipped = triangle.is_clipped ? reach.clipped : 0;
  for (std::size_t k = 0; k < 3; ++k) {
    auto& [low, high] = placed[k].legal;
    low = {low.x - clipped, low.y - clipped};
    high = {high.x + clipped, high.y + clipped};
    triangle.places[k] = placed[k].legal;
    for (const Point2 corner : CornersOf(placed[k].legal)) {
      triangle.most_moved = std::max(triangle.most_moved, Apart(corner, placed[k].given));
    }
  }
  return triangle;
}

}  // namespace

std::vector<Point2> CornersOf(const LegalPlaces& places) {
  const auto [low, high] = places;
  std::vector<Point2> corners{low};
  if (high.x != low.x) corners.push_back({high.x, low.y});
  if (high.y == low.y) return corners;
  corners.push_back({low.x, high.y});
  if (high.x != low.x) corners.push_back(high);
  return corners;
}

std::optional<int> FacingOfAll(std::span<const Point2> a, std::span<const Point2> b,
                               std::span<const Point2> c) {
  std::optional<int> facing;
  for (const Point2 p : a) {
    for (const Point2 q : b) {
      for (const Point2 r : c) {
        const int sign = exact::Facing({p, q, r});
        if (facing && *facing != sign) return std::nullopt;
        facing = sign;
      }
    }
  }
  return facing;
}

ClippedEdges::ClippedEdges(const PlacedCase& c) {
  const TargetProfile& profile = c.profile;
  if (c.scene.clip_space || !MovesClippedEdges(profile)) return;
  const Reach reach = ReachOf(c, profile);
  const Snap coarsest = LegalGrids(profile.snap, profile.freedom).front();
  for (const Triangle& t : c.scene.triangles) {
    const std::array<Vertex, 3> v = Corners(c.scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    const auto placed = PlacedCorners(v, false, profile, reach);
    if (!placed->is_clipped) continue;
    triangles_.emplace_back(std::array{WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])},
                            placed->is_outside, *reach.unclipped, coarsest);
  }
}

OpenTriangles::OpenTriangles(const PlacedCase& c) {
  const TargetProfile& profile = c.profile;
  const Reach reach = ReachOf(c, profile);
  const double margin = kDistanceMarginPerCoordinate *
                        (LargestCoordinate(c) + std::max(c.scene.width, c.scene.height));
  const auto add_fixed = [&](int facing) {
    front_ = front_ || facing > 0;
    back_ = back_ || facing < 0;
  };
  for (const Triangle& t : c.scene.triangles) {
    const std::array<Vertex, 3> v = Corners(c.scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    // Real geometry in clip space has one model: that of homogeneous coordinates.
    if (c.scene.clip_space && profile.snap.IsNone() && reach.slack == 0) {
      const int facing = exact::HomogeneousFacing(v);
      if (!AlwaysCullsTurn(profile, facing)) add_fixed(facing);
      continue;
    }
    const auto placed = PlacedCorners(v, c.scene.clip_space, profile, reach);
    if (!placed) {
      open_.push_back({.has_place = false});
      continue;
    }
    most_moved_ = std::max(most_moved_, placed->most_moved);
    const Drops drops = DropsOf(placed->places, profile.max_primitive_extent);
    if (drops == Drops::kAlways) continue;
    if (HaveOnePlace(v[0], v[1]) || HaveOnePlace(v[1], v[2]) || HaveOnePlace(v[2], v[0])) continue;
    const std::optional<int> facing = FacingOfAll(placed->places);
    if (facing && AlwaysCullsTurn(profile, *facing)) continue;
    if (facing && drops == Drops::kNever) {
      add_fixed(*facing);
      continue;
    }
    // A triangle that a legal choice turns is culled in some models.
    Open open{.is_dropped = drops != Drops::kNever || profile.culls != Cull::kNone,
              .reach = reach.beside + margin + SampleReach(profile)};
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      open.at[k] = Middle(placed->places[k]);
      farthest = std::max(farthest, Apart(open.at[k], placed->places[k].high));
    }
    open.reach += farthest;
    open_.push_back(open);
  }
}

bool OpenTriangles::CanCover(Point2 p) const {
  return std::ranges::any_of(open_, [&](const Open& open) {
    // Not a number: overflow, and so not judged.
    return !open.has_place || !(TriangleDistance(open.at, p) > open.reach);
  });
}

void OpenTriangles::ForgetTurned() {
  std::erase_if(open_, [](const Open& open) { return !open.is_dropped; });
}

std::optional<std::array<LegalPlaces, 3>> LegalPlacesOf(const PlacedCase& c, const Triangle& t) {
  const TargetProfile& profile = c.profile;
  const Reach reach = ReachOf(c, profile);
  auto placed = PlacedCorners(Corners(c.scene, t), false, profile, reach);
  if (placed->is_clipped && !MovesClippedEdges(profile)) return std::nullopt;
  for (auto& [low, high] : placed->places) {
    low = {low.x - reach.beside, low.y - reach.beside};
    high = {high.x + reach.beside, high.y + reach.beside};
  }
  return placed->places;
}

bool StaysWhereGiven(const PlacedCase& c, const Triangle& t) {
  const auto places = LegalPlacesOf(c, t);
  if (!places) return false;
  const std::array<Vertex, 3> v = Corners(c.scene, t);
  for (std::size_t k = 0; k < 3; ++k) {
    const auto& [low, high] = (*places)[k];
    if (low != WindowPoint(v[k]) || high != low) return false;
  }
  return true;
}

bool TellsFacings(const Description& subject) {
  return subject.info.coverage == CoverageKind::kFacingCounts;
}

Scene UnsnappedScene(const PlacedCase& c) {
  const TargetProfile& profile = c.profile;
  const Reach reach = ReachOf(c, profile);
  Scene scene = c.scene;
  for (Triangle& t : scene.triangles) {
    const std::array<Vertex, 3> v = Corners(c.scene, t);
    if (!std::ranges::all_of(v, IsFinite)) continue;
    if (!profile.max_primitive_extent && profile.culls == Cull::kNone) continue;
    if (IsDrawnByNone(PlacedCorners(v, false, profile, reach)->places, profile))
      t = {t[0], t[0], t[0]};
  }
  if (!profile.fixed) return scene;
  for (Vertex& v : scene.vertices) {
    v = {Wrapped(v.x, *profile.fixed), Wrapped(v.y, *profile.fixed), v.z, v.w};
  }
  return scene;
}

}  // namespace rasterproof::props
