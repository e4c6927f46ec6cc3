#include "tests/legal/all_models.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/snap.h"
#include "model/snap.h"

namespace rasterproof::legal::testing {
namespace {

// E(a, b; p), exact: everything here is a small multiple of 2^-6.
double Edge(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// Whether p is on a closed edge of three points on one line.
bool LiesOnSegments(const std::array<Point2, 3>& v, Point2 p) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point2 a = v[k];
    const Point2 b = v[(k + 1) % 3];
    const bool within = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                        std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
    if (within && Edge(a, b, p) == 0) return true;
  }
  return false;
}

// What one model says of a triangle and a sample, by the definition.
enum class Says { kOut, kIn, kFree };

Says SaysOf(const Profile& profile, const TieRule& rule, const Scene& scene, const Model& model,
            std::size_t t, Point2 p) {
  std::array<Point2, 3> v{};
  for (std::size_t k = 0; k < 3; ++k) v[k] = model[static_cast<std::size_t>(scene.triangles[t][k])];
  const double area = Edge(v[0], v[1], v[2]);
  if (area == 0) {
    const bool is_open = profile.degenerate_triangles == DegenerateTriangles::kUnspecified;
    return is_open && LiesOnSegments(v, p) ? Says::kFree : Says::kOut;
  }
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
      if (Edge(a, b, at(t, i + 2)) * Edge(a, b, at(u, j + 2)) >= 0) continue;  // on one side
      const double dot = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
      const double length = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
      if (dot > 0 && dot < length) return true;
    }
  }
  return false;
}

std::size_t SamplesOf(const Scene& scene) {
  return static_cast<std::size_t>(scene.width) * static_cast<std::size_t>(scene.height);
}

Point2 SampleAt(const Scene& scene, std::size_t s) {
  const auto width = static_cast<std::size_t>(scene.width);
  return {static_cast<double>(s % width) + 0.5, static_cast<double>(s / width) + 0.5};
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
  for (std::size_t s = 0; s < SamplesOf(scene); ++s) {
    const Point2 p = SampleAt(scene, s);
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
      const Says says = SaysOf(profile, rule, scene, model, t, SampleAt(scene, s));
      fits = says == Says::kFree || (says == Says::kIn) == ((bits >> t & 1U) != 0);
      for (std::size_t u = t + 1; u < n && profile.freedom.ties == TieOwnership::kPerEdge; ++u) {
        if (!IsOwnedOnce(scene, model, t, u, SampleAt(scene, s))) continue;
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
  for (std::size_t s = 0; s < SamplesOf(scene); ++s) {
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

std::uint64_t NumbersBySearch(const Scene& scene, const Profile& profile, std::size_t s) {
  std::uint64_t numbers = 0;
  for (std::uint32_t n = 0; n <= scene.triangles.size(); ++n) {
    const bool is_legal =
        IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
          return ExplainsCountAt(scene, profile, rule, model, s, n);
        });
    if (is_legal) numbers |= std::uint64_t{1} << n;
  }
  return numbers;
}

bool ExplainsAt(const Scene& scene, const Profile& profile, const CoverageCounts& counts,
                const std::vector<std::size_t>& samples) {
  return IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
    return std::ranges::all_of(samples, [&](std::size_t s) {
      return ExplainsCountAt(scene, profile, rule, model, s, counts.Count(s));
    });
  });
}

std::vector<CoverageCounts> AsCounts(const Scene& scene, const Drawn& drawn) {
  std::vector<CoverageCounts> all;
  for (const std::vector<bool>& one : drawn) {
    CoverageCounts counts(scene.width, scene.height);
    for (std::size_t s = 0; s < one.size(); ++s) counts.front[s] = one[s] ? 1 : 0;
    all.push_back(std::move(counts));
  }
  return all;
}

bool IsJudgedAlike(const Scene& scene) { return !SharesPositions(scene); }

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

Scene Draws::AThinScene() {
  Scene scene;
  scene.width = static_cast<int>(2 + Below(4));
  scene.height = static_cast<int>(2 + Below(4));
  scene.precision = Precision::kFloat64;
  const auto anywhere = [&](int side) {
    const std::size_t eighths = 8 * static_cast<std::size_t>(side) + 1;
    const double x = static_cast<double>(Below(eighths)) / 8;
    return Below(3) == 0 ? std::floor(x) + 0.5 : x;  // on a line of samples
  };
  const auto add = [&](double x, double y) { scene.vertices.push_back({x, y, 0, 1}); };
  for (int k = 0; k < 2; ++k) add(anywhere(scene.width), anywhere(scene.height));
  const bool has_two = Below(2) == 0;
  for (int k = 0; k < (has_two ? 2 : 1); ++k) {
    const Vertex a = scene.vertices[0];
    const Vertex b = scene.vertices[1];
    if (Below(4) == 0) {
      add(anywhere(scene.width), anywhere(scene.height));
      continue;
    }
    // Near the line through the others, rounded to eighths, and at times an eighth beside.
    const double along = static_cast<double>(Below(9)) / 8;
    const auto near = [&](double from, double to) {
      const double eighths = std::rint(8 * (from + along * (to - from)));
      return (eighths + static_cast<double>(Below(3)) - 1) / 8;
    };
    const double x = near(a.x, b.x);
    add(x, near(a.y, b.y));
  }
  scene.triangles = {{0, 1, 2}};
  if (has_two) scene.triangles.push_back({1, 0, 3});
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
  if (Below(2) == 0) profile.degenerate_triangles = DegenerateTriangles::kUnspecified;
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
  Drawn drawn(scene.triangles.size(), std::vector<bool>(SamplesOf(scene)));
  for (std::size_t s = 0; s < SamplesOf(scene); ++s) {
    for (std::size_t t = 0; t < drawn.size(); ++t) {
      const Says says = SaysOf(profile, rule, scene, model, t, SampleAt(scene, s));
      drawn[t][s] = says == Says::kIn || (says == Says::kFree && Below(2) == 0);
      for (std::size_t u = 0; u < t && profile.freedom.ties == TieOwnership::kPerEdge; ++u) {
        if (IsOwnedOnce(scene, model, u, t, SampleAt(scene, s))) drawn[t][s] = !drawn[u][s];
      }
    }
  }
  return drawn;
}

CoverageCounts Draws::AMixture(const Scene& scene, const Profile& profile) {
  const auto width = static_cast<std::size_t>(scene.width);
  CoverageCounts mixed(scene.width, scene.height);
  for (std::size_t column = 0; column < width; ++column) {
    CoverageCounts sum(scene.width, scene.height);
    for (const CoverageCounts& one : AsCounts(scene, ALegalDrawing(scene, profile))) sum += one;
    for (std::size_t s = column; s < SamplesOf(scene); s += width) mixed.front[s] = sum.front[s];
  }
  return mixed;
}

CoverageCounts Draws::ANearMiss(const Scene& scene, const Profile& profile) {
  CoverageCounts sum(scene.width, scene.height);
  for (const CoverageCounts& one : AsCounts(scene, ALegalDrawing(scene, profile))) sum += one;
  for (std::size_t k = 0; k <= Below(2); ++k) {
    std::uint32_t& count = sum.front[Below(sum.size())];
    count = count == 0 ? 1 : count - 1;
  }
  return sum;
}

}  // namespace rasterproof::legal::testing
