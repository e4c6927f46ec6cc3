#include "tests/legal/all_models.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/snap.h"
#include "model/snap.h"

namespace rasterproof::legal::testing {
namespace {

// E(a, b; p), exact: everything here is a small multiple of 2^-6.
double Edge(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// What one model says of a triangle and a sample, by the definition.
enum class Says { kOut, kIn, kFree };

Says SaysOf(const Profile& profile, const TieRule& rule, const Scene& scene, const Model& model,
            std::size_t t, Point2 p) {
  std::array<Point2, 3> v{};
  for (std::size_t k = 0; k < 3; ++k) v[k] = model[static_cast<std::size_t>(scene.triangles[t][k])];
  const double area = Edge(v[0], v[1], v[2]);
  if (area == 0) return Says::kOut;
  bool on_edge = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 a = v[k];
    const Point2 b = v[(k + 1) % 3];
    double e = Edge(a, b, p) * (area > 0 ? 1 : -1);
    const bool has_rule = profile.freedom.ties == TieOwnership::kStated ||
                          profile.freedom.ties == TieOwnership::kAxisAligned;
    if (e == 0 && has_rule) {  // shifted: E changes by dY along x and by -dX along y
      const double along_x = rule.sign_x * (b.y - a.y) * (area > 0 ? 1 : -1);
      const double along_y = rule.sign_y * -(b.x - a.x) * (area > 0 ? 1 : -1);
      const double first = rule.y_first ? along_y : along_x;
      e = first != 0 ? first : (rule.y_first ? along_x : along_y);
    }
    if (e < 0) return Says::kOut;
    on_edge = on_edge || e == 0;
  }
  return on_edge ? Says::kFree : Says::kIn;
}

// Whether the sample lies inside a segment that two triangles share, which lie on either side.
bool IsOwnedOnce(const Scene& scene, const Model& model, std::size_t t, std::size_t u, Point2 p) {
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      const auto at = [&](std::size_t of, std::size_t k) {
        return model[static_cast<std::size_t>(scene.triangles[of][k % 3])];
      };
      const auto index = [&](std::size_t of, std::size_t k) { return scene.triangles[of][k % 3]; };
      if (index(t, i) != index(u, j + 1) || index(t, i + 1) != index(u, j)) continue;
      const Point2 a = at(t, i);
      const Point2 b = at(t, i + 1);
      if (Edge(a, b, p) != 0) continue;
      const double dot = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
      const double length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
      if (dot > 0 && dot < length) return true;
    }
  }
  return false;
}

Point2 SampleAt(std::size_t s) {
  return {static_cast<double>(s % kSide) + 0.5, static_cast<double>(s / kSide) + 0.5};
}

// Visits every place of every vertex, until the visit returns true.
bool AnyModel(const Scene& scene, const Profile& profile, const Snap& grid,
              const std::function<bool(const Model&)>& visit) {
  Model model(scene.vertices.size());
  const std::function<bool(std::size_t)> choose = [&](std::size_t k) {
    if (k == model.size()) return visit(model);
    for (const double x : LegalGridPoints(scene.vertices[k].x, grid, profile.freedom)) {
      for (const double y : LegalGridPoints(scene.vertices[k].y, grid, profile.freedom)) {
        model[k] = {x, y};
        if (choose(k + 1)) return true;
      }
    }
    return false;
  };
  return choose(0);
}

bool SharesPositions(const Scene& scene) {
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.vertices.size(); ++j) {
      if (scene.vertices[i] == scene.vertices[j]) return true;
    }
  }
  return false;
}

}  // namespace

bool ExplainsAlone(const Scene& scene, const Profile& profile, const TieRule& rule,
                   const Model& model, const Drawn& drawn) {
  for (std::size_t s = 0; s < kSide * kSide; ++s) {
    const Point2 p = SampleAt(s);
    for (std::size_t t = 0; t < drawn.size(); ++t) {
      const Says says = SaysOf(profile, rule, scene, model, t, p);
      if (says != Says::kFree && (says == Says::kIn) != drawn[t][s]) return false;
    }
    if (profile.freedom.ties != TieOwnership::kPerEdge) continue;
    for (std::size_t t = 0; t < drawn.size(); ++t) {
      for (std::size_t u = t + 1; u < drawn.size(); ++u) {
        if (IsOwnedOnce(scene, model, t, u, p) && drawn[t][s] == drawn[u][s]) return false;
      }
    }
  }
  return true;
}

bool ExplainsSetAt(const Scene& scene, const Profile& profile, const TieRule& rule,
                   const Model& model, std::size_t s,
                   const std::function<bool(unsigned bits)>& accepts) {
  const std::size_t n = scene.triangles.size();
  for (unsigned bits = 0; bits < 1U << n; ++bits) {
    bool fits = accepts(bits);
    for (std::size_t t = 0; t < n && fits; ++t) {
      const Says says = SaysOf(profile, rule, scene, model, t, SampleAt(s));
      fits = says == Says::kFree || (says == Says::kIn) == ((bits >> t & 1U) != 0);
      for (std::size_t u = t + 1; u < n && profile.freedom.ties == TieOwnership::kPerEdge; ++u) {
        if (!IsOwnedOnce(scene, model, t, u, SampleAt(s))) continue;
        fits = fits && (bits >> t & 1U) != (bits >> u & 1U);
      }
    }
    if (fits) return true;
  }
  return false;
}

bool ExplainsCountAt(const Scene& scene, const Profile& profile, const TieRule& rule,
                     const Model& model, std::size_t s, std::uint32_t count) {
  return ExplainsSetAt(scene, profile, rule, model, s, [&](unsigned bits) {
    return static_cast<std::uint32_t>(std::popcount(bits)) == count;
  });
}

bool ExplainsCounts(const Scene& scene, const Profile& profile, const TieRule& rule,
                    const Model& model, const CoverageCounts& counts) {
  for (std::size_t s = 0; s < kSide * kSide; ++s) {
    if (!ExplainsCountAt(scene, profile, rule, model, s, counts.Count(s))) return false;
  }
  return true;
}

bool IsLegalBySearch(const Scene& scene, const Profile& profile,
                     const std::function<bool(const TieRule&, const Model&)>& explains) {
  std::vector<TieRule> rules{profile.tie_rule};
  if (profile.freedom.ties == TieOwnership::kAxisAligned)
    rules.assign(kConsistentRules.begin(), kConsistentRules.end());
  for (const Snap& grid : LegalGrids(profile.snap, profile.freedom)) {
    for (const TieRule& rule : rules) {
      if (AnyModel(scene, profile, grid, [&](const Model& model) { return explains(rule, model); }))
        return true;
    }
  }
  return false;
}

bool ExplainsAt(const Scene& scene, const Profile& profile, const CoverageCounts& counts,
                const std::vector<std::size_t>& samples) {
  return IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
    return std::ranges::all_of(samples, [&](std::size_t s) {
      return ExplainsCountAt(scene, profile, rule, model, s, counts.Count(s));
    });
  });
}

std::vector<CoverageCounts> AsCounts(const Drawn& drawn) {
  std::vector<CoverageCounts> all;
  for (const std::vector<bool>& one : drawn) {
    CoverageCounts counts(kSide, kSide);
    for (std::size_t s = 0; s < one.size(); ++s) counts.front[s] = one[s] ? 1 : 0;
    all.push_back(std::move(counts));
  }
  return all;
}

bool IsJudgedAlike(const Scene& scene, const Profile& profile) {
  if (SharesPositions(scene)) return false;
  if (profile.freedom.ties != TieOwnership::kPerEdge) return true;
  bool front = false;
  bool back = false;
  bool flat = false;
  for (const Snap& grid : LegalGrids(profile.snap, profile.freedom)) {
    AnyModel(scene, profile, grid, [&](const Model& model) {
      for (const Triangle& t : scene.triangles) {
        const double area =
            Edge(model[static_cast<std::size_t>(t[0])], model[static_cast<std::size_t>(t[1])],
                 model[static_cast<std::size_t>(t[2])]);
        front = front || area > 0;
        back = back || area < 0;
        flat = flat || area == 0;
      }
      return false;
    });
  }
  return !flat && !(front && back);
}

Scene Draws::AScene() {
  Scene scene;
  scene.width = kSide;
  scene.height = kSide;
  scene.precision = Precision::kFloat64;
  for (int k = 0; k < 4; ++k) {
    const auto coordinate = [&] { return static_cast<double>(Below(8 * kSide + 1)) / 8; };
    scene.vertices.push_back({coordinate(), coordinate(), 0, 1});
  }
  scene.triangles = {{0, 1, 2}, {2, 1, 3}};
  if (Below(3) == 0) scene.triangles.push_back({0, 2, 3});
  return scene;
}

Profile Draws::AProfile() {
  Profile profile;
  profile.name = "free";
  profile.snap = {static_cast<int>(Below(3)), SnapRule::kNearestEven};
  profile.freedom.any_rounding = Below(2) == 0;
  if (!profile.freedom.any_rounding) profile.freedom.snap_tolerance = Below(2) == 0 ? 0.6 : 0.75;
  if (Below(3) == 0) profile.freedom.least_bits = 0;
  profile.freedom.ties = static_cast<TieOwnership>(Below(4));
  return profile;
}

Drawn Draws::ALegalDrawing(const Scene& scene, const Profile& profile) {
  const std::vector<Snap> grids = LegalGrids(profile.snap, profile.freedom);
  const Snap grid = grids[Below(grids.size())];
  const TieRule rule = profile.freedom.ties == TieOwnership::kAxisAligned
                           ? kConsistentRules[Below(8)]
                           : profile.tie_rule;
  Model model;
  for (const Vertex& v : scene.vertices) {
    const std::vector<double> xs = LegalGridPoints(v.x, grid, profile.freedom);
    const std::vector<double> ys = LegalGridPoints(v.y, grid, profile.freedom);
    model.push_back({xs[Below(xs.size())], ys[Below(ys.size())]});
  }
  Drawn drawn(scene.triangles.size(), std::vector<bool>(kSide * kSide));
  for (std::size_t s = 0; s < kSide * kSide; ++s) {
    for (std::size_t t = 0; t < drawn.size(); ++t) {
      const Says says = SaysOf(profile, rule, scene, model, t, SampleAt(s));
      drawn[t][s] = says == Says::kIn || (says == Says::kFree && Below(2) == 0);
      for (std::size_t u = 0; u < t && profile.freedom.ties == TieOwnership::kPerEdge; ++u) {
        if (IsOwnedOnce(scene, model, u, t, SampleAt(s))) drawn[t][s] = !drawn[u][s];
      }
    }
  }
  return drawn;
}

CoverageCounts Draws::AMixture(const Scene& scene, const Profile& profile) {
  CoverageCounts mixed(kSide, kSide);
  for (std::size_t column = 0; column < kSide; ++column) {
    CoverageCounts sum(kSide, kSide);
    for (const CoverageCounts& one : AsCounts(ALegalDrawing(scene, profile))) sum += one;
    for (std::size_t s = column; s < kSide * kSide; s += kSide) mixed.front[s] = sum.front[s];
  }
  return mixed;
}

}  // namespace rasterproof::legal::testing
