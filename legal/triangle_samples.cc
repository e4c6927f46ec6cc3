#include "legal/triangle_samples.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/coverage.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "legal/clipped_triangle.h"
#include "legal/flat_triangle.h"
#include "legal/straight_edges.h"
#include "model/drop.h"
#include "model/snap_scene.h"
#include "model/target_profile.h"
#include "model/wrap.h"

namespace rasterproof::legal {
namespace {

using Corners3 = std::array<const std::vector<Point2>*, 3>;

// One edge of a triangle, over all places of its two ends.
class EdgeOverPlaces {
 public:
  EdgeOverPlaces(const std::vector<Point2>& from, const std::vector<Point2>& to,
                 std::optional<TieRule> rule)
      : from_(from), to_(to), rule_(rule), reach_(std::max(Reach(from), Reach(to))) {}

  // The sign that E(from, to; p) has for every choice of places; nothing if they differ, or may.
  std::optional<int> Constant(Point2 p) const {
    const Point2 a = from_[0];
    const Point2 d{to_[0].x - a.x, to_[0].y - a.y};
    const Point2 q{p.x - a.x, p.y - a.y};
    const double value = q.x * d.y - q.y * d.x;
    const double across = std::fabs(d.x) + std::fabs(d.y);
    const double away = std::fabs(q.x) + std::fabs(q.y);
    // Each end moves by at most the reach on each axis; the differences and products round,
    // by 4u away across at most. What this cannot tell is decided below, by exact signs: a larger
    // constant costs time and no verdict.
    constexpr double kRounding = 0x1p-48;
    const double change = reach_ * (2 * away + across + 8 * reach_) +
                          kRounding * (away + reach_) * (across + reach_) + 0x1p-900;
    if (value > change) return 1;
    if (value < -change) return -1;
    std::optional<int> sign;
    for (std::size_t i = 0; i < from_.size(); ++i) {
      for (std::size_t j = 0; j < to_.size(); ++j) {
        const int here = Sign(i, j, p);
        if (here == 0 || (sign && *sign != here)) return std::nullopt;
        sign = here;
      }
    }
    return sign;
  }
  // 0 on the edge's line, unless a rule decides; and if both ends are one.
  int Sign(std::size_t i, std::size_t j, Point2 p) const {
    return rule_ ? exact::ShiftedEdgeSign(from_[i], to_[j], p, *rule_)
                 : exact::EdgeSign(from_[i], to_[j], p);
  }
  // How far a place of an end lies from its first one, at most, on each axis.
  double reach() const { return reach_; }

 private:
  static double Reach(const std::vector<Point2>& places) {
    double reach = 0;
    for (const Point2 p : places) {
      reach = std::max({reach, std::fabs(p.x - places[0].x), std::fabs(p.y - places[0].y)});
    }
    return reach;
  }

  const std::vector<Point2>& from_;
  const std::vector<Point2>& to_;
  std::optional<TieRule> rule_;
  double reach_;
};

// One triangle, over all places of its corners.
class TriangleOverPlaces {
 public:
  TriangleOverPlaces(const Corners3& places, const Profile& profile,
                     const std::optional<TieRule>& rule)
      : places_(places),
        edges_{EdgeOverPlaces(*places[0], *places[1], rule),
               EdgeOverPlaces(*places[1], *places[2], rule),
               EdgeOverPlaces(*places[2], *places[0], rule)},
        unshifted_{EdgeOverPlaces(*places[0], *places[1], std::nullopt),
                   EdgeOverPlaces(*places[1], *places[2], std::nullopt),
                   EdgeOverPlaces(*places[2], *places[0], std::nullopt)},
        flat_covers_(profile.degenerate_triangles == DegenerateTriangles::kUnspecified) {
    if (rule && rule->inclusive) on_edge_ = Status::kIn;
    if (rule && rule->exclusive) on_edge_ = Status::kOut;
    ForEachChoice([&](std::size_t i, std::size_t j, std::size_t k) {
      const std::array<Point2, 3> v{(*places[0])[i], (*places[1])[j], (*places[2])[k]};
      const int facing = exact::Facing(v);
      const bool is_dropped =
          AlwaysCulls(profile, facing) ||
          (profile.max_primitive_extent && Exceeds(v, *profile.max_primitive_extent));
      facings_.push_back(static_cast<std::int8_t>(facing));
      dropped_.push_back(is_dropped);
      has_one_shape_ = has_one_shape_ && !is_dropped && facing != 0 && facing == facings_.front();
    });
  }

  int facing() const { return has_one_shape_ ? facings_.front() : 0; }

  // The status that every choice gives the sample; nothing if they differ.
  std::optional<Status> Constant(Point2 p) const {
    // A flat choice may cover samples on its edges, whatever a rule of ties says of them.
    const auto& edges = has_one_shape_ || !flat_covers_ ? edges_ : unshifted_;
    const std::array<std::optional<int>, 3> signs{edges[0].Constant(p), edges[1].Constant(p),
                                                  edges[2].Constant(p)};
    const bool on_left = std::ranges::any_of(signs, [](const auto& s) { return s && *s > 0; });
    const bool on_right = std::ranges::any_of(signs, [](const auto& s) { return s && *s < 0; });
    // Outside for either side of the third edge and either facing, and off all edges of flat ones.
    if (on_left && on_right) return Status::kOut;
    if (!has_one_shape_) return std::nullopt;
    if (facing() > 0 ? on_right : on_left) return Status::kOut;
    const bool is_sure = signs[0] && signs[1] && signs[2];
    return is_sure ? std::optional(Status::kIn) : std::nullopt;
  }

  // Whether the sample is outside however the triangle is clipped.
  bool IsOutIfClipped(const ClippedTriangle& clipped, Point2 p) const {
    if (clipped.IsFarFrom(p, Moved())) return true;
    for (std::size_t e = 0; e < 3 && has_one_shape_; ++e) {
      if (clipped.Keeps(e, p) && edges_[e].Constant(p) == -facing()) return true;
    }
    return false;
  }

  // The edge that clipping moves and that alone decides the sample.
  std::optional<std::size_t> OnlyMovedEdge(const ClippedTriangle& clipped, Point2 p) const {
    const std::optional<std::size_t> only =
        has_one_shape_ ? clipped.OnlyMovedEdge(p) : std::nullopt;
    for (std::size_t e = 0; only && e < 3; ++e) {
      if (e != *only && edges_[e].Constant(p) != facing()) return std::nullopt;
    }
    return only;
  }

  // By choice, the last corner's places fastest.
  std::vector<Status> ByChoice(Point2 p) const {
    std::array<std::vector<std::int8_t>, 3> signs;
    for (std::size_t e = 0; e < 3; ++e) {
      const std::size_t to = (e + 1) % 3;
      for (std::size_t i = 0; i < places_[e]->size(); ++i) {
        for (std::size_t j = 0; j < places_[to]->size(); ++j) {
          signs[e].push_back(static_cast<std::int8_t>(edges_[e].Sign(i, j, p)));
        }
      }
    }
    std::vector<Status> by_choice;
    std::size_t choice = 0;
    ForEachChoice([&](std::size_t i, std::size_t j, std::size_t k) {
      const std::array<int, 3> s{signs[0][i * places_[1]->size() + j],
                                 signs[1][j * places_[2]->size() + k],
                                 signs[2][k * places_[0]->size() + i]};
      by_choice.push_back(
          facings_[choice] == 0 && flat_covers_ && !dropped_[choice]
              ? StatusOfFlat({(*places_[0])[i], (*places_[1])[j], (*places_[2])[k]}, p)
              : StatusOf(choice, s));
      ++choice;
    });
    return by_choice;
  }

 private:
  template <typename Visit>
  void ForEachChoice(Visit visit) const {
    for (std::size_t i = 0; i < places_[0]->size(); ++i) {
      for (std::size_t j = 0; j < places_[1]->size(); ++j) {
        for (std::size_t k = 0; k < places_[2]->size(); ++k) {
          // Two corners at one position take one place: the other choices are not legal, and copy
          // the status of the legal one.
          visit(i, places_[1] == places_[0] ? i : j,
                places_[2] == places_[0] ? i : (places_[2] == places_[1] ? j : k));
        }
      }
    }
  }

  static Status StatusOfFlat(const std::array<Point2, 3>& corners, Point2 p) {
    return LiesOnFlat(corners, p) ? Status::kFree : Status::kOut;
  }

  // How far a place of a corner lies from the first one, at most, on each axis.
  double Moved() const {
    return std::max({edges_[0].reach(), edges_[1].reach(), edges_[2].reach()});
  }

  Status StatusOf(std::size_t choice, const std::array<int, 3>& signs) const {
    if (dropped_[choice]) return Status::kOut;
    const int facing{facings_[choice]};
    if (facing == 0) return Status::kOut;
    if (std::ranges::any_of(signs, [&](int s) { return s == -facing; })) return Status::kOut;
    const bool on_edge = std::ranges::any_of(signs, [](int s) { return s == 0; });
    return on_edge ? on_edge_ : Status::kIn;
  }

  Corners3 places_;
  std::array<EdgeOverPlaces, 3> edges_;
  std::array<EdgeOverPlaces, 3> unshifted_;  // without a rule of ties
  bool flat_covers_;                         // a flat choice may cover samples on its edges
  Status on_edge_ = Status::kFree;           // where no consistent rule decides
  std::vector<std::int8_t> facings_;         // by choice
  std::vector<bool> dropped_;
  bool has_one_shape_ = true;
};

// Leaves out the corners that decide nothing.
void Reduce(OpenSample& open, const Corners3& places) {
  std::array<std::size_t, 3> size{places[0]->size(), places[1]->size(), places[2]->size()};
  open.corner = {0, 1, 2};
  for (std::size_t n = 3; n-- > 0;) {
    // The corners from `n + 1` on are those that are left.
    std::size_t inner = 1;
    for (std::size_t m = n + 1; m < 3; ++m) inner *= size[m];
    const std::size_t outer = open.by_choice.size() / (inner * size[n]);
    const auto at = [&](std::size_t o, std::size_t k, std::size_t i) {
      return open.by_choice[(o * size[n] + k) * inner + i];
    };
    bool decides = false;
    for (std::size_t o = 0; o < outer && !decides; ++o) {
      for (std::size_t k = 1; k < size[n] && !decides; ++k) {
        for (std::size_t i = 0; i < inner && !decides; ++i) decides = at(o, k, i) != at(o, 0, i);
      }
    }
    if (decides) continue;
    std::vector<Status> fewer;
    for (std::size_t o = 0; o < outer; ++o) {
      for (std::size_t i = 0; i < inner; ++i) fewer.push_back(at(o, 0, i));
    }
    open.by_choice = std::move(fewer);
    std::erase(open.corner, n);
    size[n] = 1;
  }
}

struct Box {
  int x0, y0, x1, y1;  // pixels [x0, x1) x [y0, y1)
};

Box BoxOf(const Corners3& places, const exact::SampleFrame& frame, double margin) {
  double low_x = (*places[0])[0].x;
  double high_x = low_x;
  double low_y = (*places[0])[0].y;
  double high_y = low_y;
  for (const auto* of : places) {
    for (const Point2 p : *of) {
      low_x = std::min(low_x, p.x);
      high_x = std::max(high_x, p.x);
      low_y = std::min(low_y, p.y);
      high_y = std::max(high_y, p.y);
    }
  }
  const double up = frame.offsets[0].y;  // with y up, rows are counted from another place
  const double row0 = std::floor(up);
  const auto clamp = [](double x, int low, int high) {
    return static_cast<int>(std::clamp(x, static_cast<double>(low), static_cast<double>(high)));
  };
  const PixelRect& clip = frame.clip;
  return {clamp(std::floor(low_x - margin) - 1, clip.x0, clip.x1),
          clamp(std::floor(low_y - margin - row0) - 1, clip.y0, clip.y1),
          clamp(std::ceil(high_x + margin) + 1, clip.x0, clip.x1),
          clamp(std::ceil(high_y + margin - row0) + 1, clip.y0, clip.y1)};
}

// In screen axes.
ClippedTriangle ClippedTo(const std::optional<WindowBox>& window_box, YAxis y_axis,
                          const std::array<Point2, 3>& given, const Corners3& places,
                          const Snap& grid) {
  if (!window_box) return {given, {}, {}, grid};
  WindowBox box = *window_box;
  if (y_axis == YAxis::kUp) box = {box.x0, -box.y1, box.x1, -box.y0};
  std::array<bool, 3> is_outside{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto leaves = [&](Point2 p) { return !box.Contains(p.x, p.y); };
    is_outside[k] = leaves(given[k]) || std::ranges::any_of(*places[k], leaves);
  }
  return {given, is_outside, box, grid};
}

}  // namespace

FamilyView::FamilyView(const Scene& scene, const TargetProfile& profile, const Family& family)
    : scene_(scene),
      profile_(profile),
      family_(family),
      frame_(scene, profile, {}),
      choices_(ChoicesOf(scene, profile_, family)),
      has_rule_(HasOneTieRule(profile_)) {}

// The given vertex, or for clip space its quotient, rounded.
Point2 FamilyView::OnScreen(const Vertex& v) const {
  const double w = scene_.clip_space ? v.w : 1;
  const auto unwrapped = [&](double x) {
    return profile_.fixed ? Wrapped(x, *profile_.fixed) : x / w;
  };
  const double y = unwrapped(v.y);
  return {unwrapped(v.x), profile_.y_axis == YAxis::kUp ? -y : y};
}

bool FamilyView::IsInTarget(std::size_t triangle) const {
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (const Point2 p : PlacesOf(triangle, corner)) {
      const double y = profile_.y_axis == YAxis::kUp ? -p.y : p.y;
      if (p.x < 0 || p.x > scene_.width || y < 0 || y > scene_.height) return false;
    }
  }
  return true;
}

int FamilyView::SideOf(std::size_t triangle) const {
  Corners3 places{};
  for (std::size_t k = 0; k < 3; ++k) {
    places[k] = &PlacesOf(triangle, k);
    if (places[k]->empty()) return 0;
  }
  if (!family_.grid.IsNone() && !IsInTarget(triangle)) return 0;
  return TriangleOverPlaces(places, profile_, std::nullopt).facing();
}

namespace {

// Decides the sample, or adds it to the open ones.
void AddSample(const TriangleOverPlaces& over, const ClippedTriangle& clipped,
               const Corners3& places, OpenSample open, TriangleSamples& samples) {
  open.is_clipped = clipped.MayDecide(open.at);
  if (open.is_clipped) {
    if (over.IsOutIfClipped(clipped, open.at)) return;
    open.by_choice = {Status::kFree};
    open.moved_edge = over.OnlyMovedEdge(clipped, open.at);
  } else if (const std::optional<Status> status = over.Constant(open.at)) {
    if (*status == Status::kIn) samples.covered.push_back(open.sample);
    return;
  } else {
    open.by_choice = over.ByChoice(open.at);
    Reduce(open, places);
  }
  if (open.by_choice.size() > 1 || open.by_choice[0] == Status::kFree) {
    samples.open.push_back(std::move(open));
  } else if (open.by_choice[0] == Status::kIn) {
    samples.covered.push_back(open.sample);
  }
}

}  // namespace

TriangleSamples FamilyView::Of(std::size_t triangle, const std::vector<bool>* only) const {
  TriangleSamples samples;
  const std::array<Vertex, 3> given = Corners(scene_, scene_.triangles[triangle]);
  Corners3 places{};
  for (std::size_t k = 0; k < 3; ++k) places[k] = &PlacesOf(triangle, k);
  if (std::ranges::any_of(places, [](const auto* of) { return of->empty(); })) {
    samples.covers_anything = FinitenessOf(given, profile_) == Finiteness::kUnstated;
    return samples;
  }
  const std::optional<TieRule> rule = has_rule_ ? std::optional(family_.rule) : std::nullopt;
  const TriangleOverPlaces over(places, profile_, rule);
  samples.facing = over.facing();
  const ClippedTriangle clipped = ClippedTo(
      UnclippedBox(profile_, scene_.width, scene_.height), profile_.y_axis,
      {OnScreen(given[0]), OnScreen(given[1]), OnScreen(given[2])}, places,
      // Without a grid new vertices are off by rounding alone: a step of the canonical one.
      family_.grid.IsNone() ? profile_.snap : family_.grid);
  const Box box = BoxOf(places, frame_, clipped.IsClipped() ? clipped.reach() : 0);
  for (int row = box.y0; row < box.y1; ++row) {
    for (int x = box.x0; x < box.x1; ++x) {
      for (std::size_t s = 0; s < frame_.offsets.size(); ++s) {
        const std::size_t index =
            (static_cast<std::size_t>(row) * static_cast<std::size_t>(scene_.width) +
             static_cast<std::size_t>(x)) *
                frame_.offsets.size() +
            s;
        if (only != nullptr && !(*only)[index]) continue;
        AddSample(over, clipped, places, {triangle, index, frame_.At(x, row, s), {}, {}, {}, {}},
                  samples);
      }
    }
  }
  if (clipped.IsClipped()) samples.exclusions = ExclusionsOf(clipped, over.facing(), samples.open);
  return samples;
}

}  // namespace rasterproof::legal
