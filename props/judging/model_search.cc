#include "props/judging/model_search.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <utility>

#include "core/profile.h"
#include "core/scene.h"
#include "core/snap.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "model/target_model.h"
#include "model/wrap.h"
#include "props/judging/gate.h"

namespace rasterproof::props {
namespace {

std::vector<Point2> LegalPoints(const Vertex& v, const Profile& profile) {
  const double tolerance = profile.freedom.snap_tolerance;
  const auto wrapped = [&](double x) { return profile.fixed ? Wrapped(x, *profile.fixed) : x; };
  const std::vector<double> ys = GridPointsWithin(wrapped(v.y), profile.snap, tolerance);
  std::vector<Point2> points;
  for (const double x : GridPointsWithin(wrapped(v.x), profile.snap, tolerance)) {
    for (const double y : ys) points.push_back({x, y});
  }
  return points;
}

// How often each sample is covered, of either facing.
std::vector<std::uint32_t> Joined(const CoverageCounts& counts) {
  std::vector<std::uint32_t> joined(counts.size());
  for (std::size_t k = 0; k < counts.size(); ++k) joined[k] = counts.Count(k);
  return joined;
}

}  // namespace

std::vector<TieRule> AllowedRules(const Profile& profile) {
  if (!profile.freedom.any_tie_rule) return {profile.tie_rule};
  return {kConsistentRules.begin(), kConsistentRules.end()};
}

ModelSearch::ModelSearch(const Case& c) : triangles_(c.scene.triangles), one_(c) {
  const Profile profile = ForTarget(c.profile, c.scene.width, c.scene.height);
  rules_ = AllowedRules(profile);
  std::map<std::pair<double, double>, std::size_t> positions;  // -0 and +0 are one place
  for (const Vertex& v : c.scene.vertices) {
    const auto [known, is_new] = positions.try_emplace({v.x, v.y}, grid_points_.size());
    if (is_new) grid_points_.push_back(LegalPoints(v, profile));
    position_of_vertex_.push_back(known->second);
  }
  // Its corners are grid points: nothing is left to wrap or to snap.
  one_.profile = profile;
  one_.profile.snap.bits = Snap::kNone;
  one_.profile.fixed.reset();
  one_.profile.by_target_size.clear();
  one_.scene.precision = Precision::kFloat64;
  one_.scene.vertices.resize(3);
  one_.scene.triangles = {{0, 1, 2}};
  one_.options = WholeTarget(c);
}

std::uint8_t ModelSearch::RulesThatDraw(const std::array<Point2, 3>& corners,
                                        const std::vector<std::uint32_t>& seen) const {
  Scene scene = one_.scene;
  for (std::size_t k = 0; k < 3; ++k) scene.vertices[k] = {corners[k].x, corners[k].y, 0, 1};
  Profile profile = one_.profile;
  const auto draws_it = [&](const TieRule& rule) {
    profile.tie_rule = rule;
    return Joined(exact::Coverage(scene, profile, one_.options));
  };
  const auto all = static_cast<std::uint8_t>((1U << rules_.size()) - 1);
  if (profile.degenerate_triangles == DegenerateTriangles::kUnspecified &&
      exact::Facing(corners) == 0)
    return all;
  const std::vector<std::uint32_t> first = draws_it(rules_.front());
  // A triangle has no sample on its edges, and all rules draw it alike, iff `inclusive` and two
  // opposite rules do: of opposite shifts at most one leads from an edge or a vertex inside.
  const bool has_ties = rules_.size() > 1 && (draws_it({.inclusive = true}) != first ||
                                              draws_it(kConsistentRules[3]) != first);
  if (!has_ties) return first == seen ? all : std::uint8_t{0};
  unsigned explained = 0;
  for (std::size_t r = 0; r < rules_.size(); ++r) {
    if (draws_it(rules_[r]) == seen) explained |= 1U << r;
  }
  return static_cast<std::uint8_t>(explained);
}

void ModelSearch::Observe(std::size_t t, const CoverageCounts& alone) {
  const std::vector<std::uint32_t> seen = Joined(alone);
  Observation observation;
  std::array<const std::vector<Point2>*, 3> points{};
  const Triangle& triangle = triangles_[t];
  for (std::size_t k = 0; k < 3; ++k) {
    observation.vertex[k] = position_of_vertex_[static_cast<std::size_t>(triangle[k])];
    points[k] = &grid_points_[observation.vertex[k]];
  }
  for (std::size_t i = 0; i < points[0]->size(); ++i) {
    for (std::size_t j = 0; j < points[1]->size(); ++j) {
      for (std::size_t k = 0; k < points[2]->size(); ++k) {
        // Two corners at one position take one grid point.
        if (observation.vertex[0] == observation.vertex[1] && i != j) continue;
        if (observation.vertex[1] == observation.vertex[2] && j != k) continue;
        if (observation.vertex[0] == observation.vertex[2] && i != k) continue;
        const std::uint8_t rules =
            RulesThatDraw({(*points[0])[i], (*points[1])[j], (*points[2])[k]}, seen);
        if (rules == 0) continue;
        observation.explained_by.push_back(
            {{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(j),
              static_cast<std::uint8_t>(k)},
             rules});
      }
    }
  }
  observations_.push_back(std::move(observation));
}

// Keeps of every vertex only the grid points that some choice of each of its triangles uses.
bool ModelSearch::Propagate(const std::vector<std::size_t>& observations, unsigned rule,
                            Possible& possible) const {
  bool changed = true;
  while (changed) {
    changed = false;
    for (const std::size_t o : observations) {
      const Observation& observation = observations_[o];
      std::array<unsigned, 3> used{};
      for (const Choice& choice : observation.explained_by) {
        if ((choice.rules >> rule & 1U) == 0) continue;
        const auto fits = [&](std::size_t k) {
          return (possible[observation.vertex[k]] >> choice.point[k] & 1U) != 0;
        };
        if (!fits(0) || !fits(1) || !fits(2)) continue;
        for (std::size_t k = 0; k < 3; ++k) used[k] |= 1U << choice.point[k];
      }
      for (std::size_t k = 0; k < 3; ++k) {
        std::uint16_t& left = possible[observation.vertex[k]];
        const auto kept = static_cast<std::uint16_t>(left & used[k]);
        changed = changed || kept != left;
        left = kept;
        if (left == 0) return false;
      }
    }
  }
  return true;
}

bool ModelSearch::Search(const std::vector<std::size_t>& observations, unsigned rule,
                         Possible possible) const {
  if (!Propagate(observations, rule, possible)) return false;
  // Branch on the vertex with the fewest grid points left to choose from.
  std::size_t branch = possible.size();
  for (const std::size_t o : observations) {
    for (const std::size_t v : observations_[o].vertex) {
      const int open = std::popcount(possible[v]);
      if (open > 1 && (branch == possible.size() || open < std::popcount(possible[branch]))) {
        branch = v;
      }
    }
  }
  if (branch == possible.size()) return true;
  for (unsigned point = 0; point < 16; ++point) {
    if ((possible[branch] >> point & 1U) == 0) continue;
    Possible chosen = possible;
    chosen[branch] = static_cast<std::uint16_t>(1U << point);
    if (Search(observations, rule, std::move(chosen))) return true;
  }
  return false;
}

bool ModelSearch::Explains(const std::vector<std::size_t>& observations) const {
  const Possible all(grid_points_.size(), std::uint16_t{0xffff});
  for (unsigned rule = 0; rule < rules_.size(); ++rule) {
    if (Search(observations, rule, all)) return true;
  }
  return false;
}

std::vector<std::size_t> ModelSearch::Conflict() const {
  std::vector<std::size_t> all(observations_.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  if (Explains(all)) return {};
  for (const std::size_t i : all) {
    if (!Explains({i})) return {i};
  }
  for (const std::size_t i : all) {
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (!Explains({i, j})) return {i, j};
    }
  }
  for (std::size_t k = 0; k < all.size();) {
    std::vector<std::size_t> without = all;
    without.erase(without.begin() + static_cast<std::ptrdiff_t>(k));
    if (Explains(without)) {
      ++k;
    } else {
      all = std::move(without);
    }
  }
  return all;
}

std::vector<Point2> ModelSearch::PointsOf(std::size_t observation, std::size_t corner) const {
  const Observation& seen = observations_[observation];
  std::vector<Point2> points;
  for (const Choice& choice : seen.explained_by) {
    const Point2 point = grid_points_[seen.vertex[corner]][choice.point[corner]];
    if (std::ranges::find(points, point) == points.end()) points.push_back(point);
  }
  return points;
}

}  // namespace rasterproof::props
