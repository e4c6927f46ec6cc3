#include "legal/choices.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "core/error.h"
#include "exact/rational.h"
#include "exact/snap_clip.h"
#include "model/snap.h"
#include "model/target_profile.h"
#include "model/wrap.h"

namespace rasterproof::legal {
namespace {

// The canonical one first.
std::vector<double> CanonicalFirst(std::vector<double> points, double canonical) {
  const auto own = std::ranges::find(points, canonical);
  if (own != points.end()) std::rotate(points.begin(), own, own + 1);
  return points;
}

std::vector<double> WindowPlaces(double x, const Profile& profile, const Snap& grid) {
  const double wrapped = profile.fixed ? Wrapped(x, *profile.fixed) : x;
  return CanonicalFirst(LegalGridPoints(wrapped, grid, profile.freedom),
                        SnapCoordinate(wrapped, grid));
}

// Whether the freedom allows the grid point for some place that the transform may give x / w.
bool IsWithin(double point, double x, double w, double step, const Freedom& freedom) {
  const exact::Rational off = (exact::Rational(point) * w - x).Abs() -
                              exact::Rational(freedom.transform_error.value_or(0)) *
                                  exact::Rational(kTransformErrorUnit) * exact::Rational(x).Abs();
  const exact::Rational one_step = exact::Rational(step) * w;
  return off <= one_step * exact::Rational(freedom.snap_tolerance) ||
         (freedom.any_rounding && off < one_step);
}

std::vector<double> QuotientPlaces(double x, double w, const Profile& profile, const Snap& grid) {
  const std::optional<double> own =
      w > 0 && !grid.IsNone() ? exact::TrySnapQuotient(x, w, grid) : std::nullopt;
  if (!own) {
    throw InputError("scene", "a vertex of clip space has no place on the profile's grid",
                     "give vertices with w > 0 that project onto the target, and a profile with "
                     "subpixel_bits");
  }
  std::vector<double> points{*own};
  const double step = std::ldexp(1.0, -grid.bits);
  const int most = 2 + static_cast<int>(profile.freedom.TransformReach(x / w) / step);
  for (int k = -most; k <= most; ++k) {
    const double point = *own + k * step;
    if (k != 0 && IsWithin(point, x, w, step, profile.freedom)) points.push_back(point);
  }
  return points;
}

std::vector<Point2> Pairs(const std::vector<double>& xs, const std::vector<double>& ys,
                          YAxis y_axis) {
  std::vector<Point2> points;
  for (const double x : xs) {
    for (const double y : ys) points.push_back({x, y_axis == YAxis::kUp ? -y : y});
  }
  return points;
}

std::vector<Point2> PlacesOf(const Vertex& v, bool clip_space, const Profile& profile,
                             const Snap& grid) {
  const bool has_no_place = profile.nan_z != NanZ::kIgnored && std::isnan(v.z);
  if (!IsFinite(v) || has_no_place) return {};
  if (!clip_space) {
    return Pairs(WindowPlaces(v.x, profile, grid), WindowPlaces(v.y, profile, grid),
                 profile.y_axis);
  }
  return Pairs(QuotientPlaces(v.x, v.w, profile, grid), QuotientPlaces(v.y, v.w, profile, grid),
               profile.y_axis);
}

// Grids of more bits than this count as no grid.
constexpr int kFinestGrid = 40;

// The least number of bits at which the coordinate is a grid point.
int BitsOf(double x) {
  int bits = 0;
  while (bits < kFinestGrid && std::isfinite(x) &&
         std::ldexp(x, bits) != std::rint(std::ldexp(x, bits)))
    ++bits;
  return bits;
}

// With this many bits every coordinate lies on the grid: finer grids are equal to no grid.
int FinestGridOf(const Scene& scene) {
  int bits = 0;
  for (const Vertex& v : scene.vertices) bits = std::max({bits, BitsOf(v.x), BitsOf(v.y)});
  return bits;
}

// The grids that may differ on the scene, coarsest first and none last.
std::vector<Snap> GridsOf(const TargetProfile& model, const Scene& scene) {
  std::vector<Snap> grids = LegalGrids(model.snap, model.freedom);
  if (scene.clip_space || model.fixed || grids.size() == 1) return grids;
  const Snap none = grids.back();
  grids.pop_back();
  const int finest = FinestGridOf(scene);
  for (int bits = grids.back().bits + 1; bits <= finest; ++bits) {
    grids.push_back(model.snap);
    grids.back().bits = bits;
  }
  if (model.snap.form == SnapForm::kCoordinate) {
    std::erase_if(grids,
                  [&](const Snap& grid) { return grid.bits > std::max(finest, model.snap.bits); });
  }
  grids.push_back(none);
  return grids;
}

}  // namespace

std::vector<Family> FamiliesOf(const TargetProfile& profile, const Scene& scene) {
  std::vector<Snap> grids = GridsOf(profile, scene);
  if (scene.clip_space) std::erase_if(grids, [](const Snap& grid) { return grid.IsNone(); });
  const auto own = std::ranges::find(grids, profile.snap);
  if (own != grids.end()) std::rotate(grids.begin(), own, own + 1);
  std::vector<TieRule> rules{profile.tie_rule};
  if (profile.freedom.ties == TieOwnership::kAxisAligned) {
    std::ranges::copy_if(kConsistentRules, std::back_inserter(rules),
                         [&](const TieRule& rule) { return rule != profile.tie_rule; });
  }
  std::vector<Family> families;
  for (const Snap& grid : grids) {
    for (const TieRule& rule : rules) families.push_back({grid, rule});
  }
  return families;
}

Choices ChoicesOf(const Scene& scene, const TargetProfile& profile, const Family& family) {
  Choices choices;
  std::map<std::tuple<double, double, double>, std::size_t> known;  // -0 and +0 are one place
  for (const Vertex& v : scene.vertices) {
    const bool is_ordered = !std::isnan(v.x) && !std::isnan(v.y) && !std::isnan(v.w);
    std::size_t position = choices.places.size();
    if (is_ordered && !std::isnan(v.z)) {
      position = known.try_emplace({v.x, v.y, v.w}, position).first->second;
    }
    if (position == choices.places.size()) {
      choices.places.push_back(PlacesOf(v, scene.clip_space, profile, family.grid));
    }
    choices.position.push_back(position);
  }
  return choices;
}

}  // namespace rasterproof::legal
