// The joint verdict against a search through all legal models, one after the other.
#include "legal/joint.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <random>
#include <vector>

#include "core/coverage.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/scene.h"
#include "core/tie_rule.h"
#include "exact/coverage.h"
#include "legal/decided.h"
#include "model/snap.h"

namespace rasterproof::legal {
namespace {

constexpr int kSide = 3;

// E(a, b; p), exact: everything here is a small multiple of 2^-6.
double Edge(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

// A vertex of each scene, as one model has it.
using Model = std::vector<Point2>;

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

// Drawings of each triangle alone: [triangle][sample].
using Drawn = std::vector<std::vector<bool>>;

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

// Whether the model lets so many triangles cover the sample, by some owners.
bool ExplainsCountAt(const Scene& scene, const Profile& profile, const TieRule& rule,
                     const Model& model, std::size_t s, std::uint32_t count) {
  const std::size_t n = scene.triangles.size();
  for (unsigned bits = 0; bits < 1U << n; ++bits) {
    if (static_cast<std::uint32_t>(std::popcount(bits)) != count) continue;
    bool fits = true;
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

class Draws {
 public:
  explicit Draws(std::uint64_t seed) : bits_(seed) {}
  std::size_t Below(std::size_t n) { return static_cast<std::size_t>(bits_() % n); }

  // Two or three triangles around shared edges, their coordinates on eighths of a pixel.
  Scene AScene() {
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

  Profile AProfile() {
    Profile profile;
    profile.name = "free";
    profile.snap = {static_cast<int>(Below(3)), SnapRule::kNearestEven};
    profile.freedom.any_rounding = Below(2) == 0;
    if (!profile.freedom.any_rounding) profile.freedom.snap_tolerance = Below(2) == 0 ? 0.6 : 0.75;
    if (Below(3) == 0) profile.freedom.least_bits = 0;
    profile.freedom.ties = static_cast<TieOwnership>(Below(4));
    return profile;
  }

  // What a random legal model draws, as a rule with random owners.
  Drawn ALegalDrawing(const Scene& scene, const Profile& profile) {
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

 private:
  std::mt19937_64 bits_;
};

std::vector<CoverageCounts> AsCounts(const Drawn& drawn) {
  std::vector<CoverageCounts> all;
  for (const std::vector<bool>& one : drawn) {
    CoverageCounts counts(kSide, kSide);
    for (std::size_t s = 0; s < one.size(); ++s) counts.front[s] = one[s] ? 1 : 0;
    all.push_back(std::move(counts));
  }
  return all;
}

bool SharesPositions(const Scene& scene) {
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
    for (std::size_t j = i + 1; j < scene.vertices.size(); ++j) {
      if (scene.vertices[i] == scene.vertices[j]) return true;
    }
  }
  return false;
}

// A pair that some legal model folds or flattens: owners on its common edge are not judged, which
// the search here does not know.
bool IsJudgedAlike(const Scene& scene, const Profile& profile) {
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

TEST(JointVerdict, EqualsASearchThroughAllModelsForTrianglesDrawnAlone) {
  Draws draws(20261123);
  int legal = 0;
  int illegal = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (SharesPositions(scene) || !IsJudgedAlike(scene, profile)) continue;
    Drawn drawn = draws.ALegalDrawing(scene, profile);
    if (n % 2 == 0) {
      const std::size_t t = draws.Below(drawn.size());
      const std::size_t s = draws.Below(kSide * kSide);
      drawn[t][s] = !drawn[t][s];
    }
    const std::vector<CoverageCounts> counts = AsCounts(drawn);
    Observed observed;
    for (const CoverageCounts& one : counts) observed.alone.push_back(&one);
    const bool is_legal =
        IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
          return ExplainsAlone(scene, profile, rule, model, drawn);
        });
    const JointVerdict verdict = JudgeJointly(scene, profile, observed);
    ASSERT_EQ(verdict.legality, is_legal ? Legality::kLegal : Legality::kNotLegal) << n;
    ASSERT_EQ(verdict.core.has_value(), !is_legal) << n;
    ++(is_legal ? legal : illegal);
  }
  EXPECT_GT(legal, 100);
  EXPECT_GT(illegal, 60);
}

TEST(JointVerdict, EqualsASearchThroughAllModelsForCounts) {
  Draws draws(7);
  int legal = 0;
  int illegal = 0;
  for (int n = 0; n < 400; ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (SharesPositions(scene) || !IsJudgedAlike(scene, profile)) continue;
    CoverageCounts sum(kSide, kSide);
    for (const CoverageCounts& one : AsCounts(draws.ALegalDrawing(scene, profile))) sum += one;
    if (n % 2 == 0) {
      std::uint32_t& count = sum.front[draws.Below(kSide * kSide)];
      count = count == 0 || draws.Below(2) == 0 ? count + 1 : count - 1;
    }
    Observed observed;
    observed.together = &sum;
    const bool is_legal =
        IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
          return ExplainsCounts(scene, profile, rule, model, sum);
        });
    const JointVerdict verdict = JudgeJointly(scene, profile, observed);
    ASSERT_EQ(verdict.legality, is_legal ? Legality::kLegal : Legality::kNotLegal) << n;
    ++(is_legal ? legal : illegal);
  }
  EXPECT_GT(legal, 100);
  EXPECT_GT(illegal, 60);
}

// Which counts some model of some owners has at the sample, a bit each.
std::uint64_t CountsBySearch(const Scene& scene, const Profile& profile, std::size_t s) {
  std::uint64_t counts = 0;
  for (std::uint32_t n = 0; n <= scene.triangles.size(); ++n) {
    // Other samples are open: their places and owners are independent of these.
    const auto explains = [&](const TieRule& rule, const Model& model) {
      return ExplainsCountAt(scene, profile, rule, model, s, n);
    };
    if (IsLegalBySearch(scene, profile, explains)) counts |= std::uint64_t{1} << n;
  }
  return counts;
}

// What a triangle must and may cover is what counts of it alone say.
void ExpectAsIfAlone(const Decided& decided, const Scene& scene, const Profile& profile) {
  std::size_t open = 0;
  for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
    Scene alone = scene;
    alone.triangles = {scene.triangles[t]};
    const Decided counts = DecidedSamples(alone, profile);
    TriangleDecided expected;
    for (std::size_t s = 0; s < counts.counts.size(); ++s) {
      if (counts.Least(s) > 0) expected.must.push_back(s);
      if (!counts.IsDecided(s)) expected.may.push_back(s);
    }
    EXPECT_EQ(decided.triangles[t].must, expected.must);
    EXPECT_EQ(decided.triangles[t].may, expected.may);
    open += expected.may.size();
  }
  EXPECT_EQ(decided.open.size(), open);
}

TEST(DecidedSamples, OfTwoGridsOnlyOneOfWhichCoversASampleItIsOpen) {
  // The common edge goes to 0.5, where the right one has the sample; from two bits on beyond it.
  Scene scene;
  scene.width = 2;
  scene.height = 1;
  scene.vertices = {{0.7, -3, 0, 1}, {4, -3, 0, 1}, {0.7, 4, 0, 1}, {-4, -3, 0, 1}};
  scene.triangles = {{0, 1, 2}, {3, 0, 2}};
  Profile profile;
  profile.snap.bits = 1;
  profile.freedom.least_bits = 1;
  const Decided decided = DecidedSamples(scene, profile);
  ASSERT_EQ(decided.open.size(), 2U);
  for (std::size_t t = 0; t < 2; ++t) {
    EXPECT_TRUE(std::ranges::find(decided.triangles[t].must, 0U) ==
                decided.triangles[t].must.end());
    EXPECT_EQ(decided.triangles[t].may, std::vector<std::size_t>{0});
    EXPECT_EQ(decided.open[t].triangle, t);
    EXPECT_EQ(decided.open[t].sample, 0U);
  }
  EXPECT_EQ(decided.Least(0), 1);  // whichever of the two it is
  EXPECT_EQ(decided.Most(0), 1);
}

TEST(DecidedSamples, AreTheCountsOfASearchThroughAllModels) {
  Draws draws(11);
  int decided = 0;
  int open = 0;
  for (int n = 0; n < 260; ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (SharesPositions(scene) || !IsJudgedAlike(scene, profile)) continue;
    const Decided samples = DecidedSamples(scene, profile);
    EXPECT_EQ(samples.bounded, 0U);
    ExpectAsIfAlone(samples, scene, profile);
    for (std::size_t s = 0; s < samples.counts.size(); ++s) {
      ASSERT_EQ(samples.counts[s], CountsBySearch(scene, profile, s)) << n << ", sample " << s;
      ++(samples.IsDecided(s) ? decided : open);
    }
  }
  EXPECT_GT(decided, 300);
  EXPECT_GT(open, 300);
}

// Whether some model explains the counts at these samples, by any search.
bool ExplainsAt(const Scene& scene, const Profile& profile, const CoverageCounts& counts,
                const std::vector<std::size_t>& samples) {
  return IsLegalBySearch(scene, profile, [&](const TieRule& rule, const Model& model) {
    return std::ranges::all_of(samples, [&](std::size_t s) {
      return ExplainsCountAt(scene, profile, rule, model, s, counts.Count(s));
    });
  });
}

TEST(Core, IsOneSampleThatNoModelHasOrAMinimalSetOverAllGrids) {
  Draws draws(20261124);
  int alone = 0;
  int together = 0;
  int over_grids = 0;
  for (int n = 0; n < 1500; ++n) {
    const Scene scene = draws.AScene();
    Profile profile = draws.AProfile();
    if (n % 2 == 0) profile.freedom.least_bits = 0;
    if (SharesPositions(scene) || !IsJudgedAlike(scene, profile)) continue;
    CoverageCounts mixed(kSide, kSide);
    for (std::size_t column = 0; column < kSide; ++column) {
      CoverageCounts sum(kSide, kSide);
      for (const CoverageCounts& one : AsCounts(draws.ALegalDrawing(scene, profile))) sum += one;
      for (std::size_t s = column; s < kSide * kSide; s += kSide) mixed.front[s] = sum.front[s];
    }
    if (n % 5 == 0) ++mixed.front[draws.Below(kSide * kSide)];
    Observed observed;
    observed.together = &mixed;
    const JointVerdict verdict = JudgeJointly(scene, profile, observed);
    if (verdict.legality != Legality::kNotLegal) continue;
    std::vector<std::size_t> samples;
    for (const Requirement& seen : verdict.core->requirements) samples.push_back(seen.sample);
    ASSERT_TRUE(verdict.core->is_minimal);
    ASSERT_FALSE(ExplainsAt(scene, profile, mixed, samples)) << n;
    std::size_t wrong = 0;
    for (std::size_t s = 0; s < mixed.size(); ++s)
      wrong += ExplainsAt(scene, profile, mixed, {s}) ? 0 : 1;
    ASSERT_EQ(verdict.core->wrong_by_themselves, wrong) << n;
    ASSERT_EQ(samples.size() == 1, wrong != 0) << n;
    ++(wrong != 0 ? alone : together);
    for (std::size_t k = 0; wrong == 0 && k < samples.size(); ++k) {
      std::vector<std::size_t> others = samples;
      others.erase(others.begin() + static_cast<std::ptrdiff_t>(k));
      ASSERT_TRUE(ExplainsAt(scene, profile, mixed, others)) << n << ", without " << samples[k];
    }
    over_grids += wrong == 0 && profile.freedom.least_bits ? 1 : 0;
  }
  EXPECT_GT(alone, 50);
  EXPECT_GT(together, 10);
  RecordProperty("over several grids", over_grids);
}

// A vertex whose place two samples pin between two lines, where no grid of 18 bits has a point, and
// an edge beside a sample, which covers it once its end is rounded down.
Scene PinnedScene(double beside) {
  const double e = std::ldexp(1.0, -19);
  Scene scene;
  scene.width = 8;
  scene.height = 8;
  scene.precision = Precision::kFloat64;
  scene.vertices = {{3, 1, 0, 1},
                    {4 + e, 4 + 4 * e, 0, 1},
                    {8, 1, 0, 1},
                    {3, -1, 0, 1},
                    {8, -1, 0, 1},
                    {1.5 + beside, 6, 0, 1},
                    {1.5 + beside, 8, 0, 1},
                    {6, 7, 0, 1}};
  scene.triangles = {{0, 1, 2}, {3, 1, 4}, {5, 6, 7}};
  return scene;
}

Legality OfVulkan(const Scene& scene, const Scene& drawn) {
  const CoverageCounts counts = exact::Coverage(drawn, *PresetProfile("real"));
  Observed observed;
  observed.together = &counts;
  return JudgeJointly(scene, *PresetProfile("vulkan"), observed).legality;
}

TEST(JointVerdict, GridsOfMoreThanSixteenBitsAreLegal) {
  const Scene scene = PinnedScene(0x1p-22);
  for (int bits = 19; bits <= 23; ++bits) {
    Scene drawn = scene;
    for (Vertex& v : drawn.vertices) {
      v.x = std::ldexp(std::floor(std::ldexp(v.x, bits)), -bits);
      v.y = std::ldexp(std::floor(std::ldexp(v.y, bits)), -bits);
    }
    EXPECT_EQ(OfVulkan(scene, drawn), Legality::kLegal) << bits;
  }
}

TEST(JointVerdict, NothingIsSaidBeyondTheCoordinateLimit) {
  Scene scene = PinnedScene(0);
  scene.vertices[2].x = 32768.5;
  EXPECT_TRUE(WhyNotJoint(scene, *PresetProfile("vulkan")).has_value());
  scene.vertices[2].x = 32768;
  EXPECT_FALSE(WhyNotJoint(scene, *PresetProfile("vulkan")).has_value());
}

// A rasterizer that places vertices anew for each column of samples, legally every time.
TEST(JointVerdict, ConvictsWhatEverySampleByItselfAcquits) {
  Draws draws(20261123);
  int convicted = 0;
  for (int n = 0; n < 3000; ++n) {
    const Scene scene = draws.AScene();
    const Profile profile = draws.AProfile();
    if (SharesPositions(scene) || !IsJudgedAlike(scene, profile)) continue;
    CoverageCounts mixed(kSide, kSide);
    for (std::size_t column = 0; column < kSide; ++column) {
      CoverageCounts sum(kSide, kSide);
      for (const CoverageCounts& one : AsCounts(draws.ALegalDrawing(scene, profile))) sum += one;
      for (std::size_t s = column; s < kSide * kSide; s += kSide) mixed.front[s] = sum.front[s];
    }
    const Decided decided = DecidedSamples(scene, profile);
    for (std::size_t s = 0; s < decided.counts.size(); ++s) {
      ASSERT_NE(decided.counts[s] >> mixed.front[s] & 1U, 0U) << n << ", sample " << s;
    }
    Observed observed;
    observed.together = &mixed;
    convicted += JudgeJointly(scene, profile, observed).legality == Legality::kNotLegal ? 1 : 0;
  }
  EXPECT_GT(convicted, 20);
}

// Two triangles on either side of an edge from (0, 4) that leaves the target for (64, 8).
Scene LeavingNeighbours() {
  Scene scene;
  scene.width = 8;
  scene.height = 8;
  scene.vertices = {{0, 4}, {64, 8}, {0, 8}, {64, 0}};
  scene.triangles = {{0, 1, 2}, {0, 3, 1}};
  return scene;
}

// `below`, and `above`: how often each sample is covered under y = 4 + x / 16, and over it, but for
// the sample (column, 4), which `there` triangles cover.
Legality LegalityOfLeaving(const Profile& profile, int column, std::uint32_t there) {
  CoverageCounts counts(8, 8, 1);
  for (int row = 0; row < 8; ++row) {
    for (int x = 0; x < 8; ++x) {
      const double at = row + 0.5;
      const bool lower = at > 4 + (x + 0.5) / 16;
      const bool upper = !lower && at > 4 - (x + 0.5) / 16;
      counts.front[counts.Index(x, row, 0)] = lower || upper ? 1 : 0;
    }
  }
  counts.front[counts.Index(column, 4, 0)] = there;
  Observed observed;
  observed.together = &counts;
  return JudgeJointly(LeavingNeighbours(), profile, observed).legality;
}

TEST(JudgeJointly, LetsClippingMoveAnEdgeThatLeavesByLessThanAStep) {
  Profile set = *PresetProfile("vulkan");
  // (7.5, 4.5) is 1/32 of a pixel below the edge, half a step of the coarsest grid.
  for (const std::uint32_t there : {0U, 1U, 2U}) {
    EXPECT_EQ(LegalityOfLeaving(set, 7, there), Legality::kLegal) << there;
  }
  // (3.5, 4.5) is more than four steps off: a gap there, or an overlap, is none of clipping's.
  EXPECT_EQ(LegalityOfLeaving(set, 3, 1), Legality::kLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 3, 0), Legality::kNotLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 3, 2), Legality::kNotLegal);
  // (6.5, 4.5) is 3/32 off: a step and a half.
  EXPECT_EQ(LegalityOfLeaving(set, 6, 0), Legality::kNotLegal);
  EXPECT_EQ(LegalityOfLeaving(set, 6, 2), Legality::kNotLegal);
}

TEST(JudgeJointly, KeepsEdgesWithinTheGuardBand) {
  Profile set = *PresetProfile("vulkan");
  for (const std::optional<GuardBand>& band :
       {std::optional<GuardBand>(), std::optional<GuardBand>(AroundTarget{64}),
        std::optional<GuardBand>(WindowBox{-1, -1, 64, 9})}) {
    set.guard_band = band;
    EXPECT_EQ(LegalityOfLeaving(set, 7, 1), Legality::kLegal);
    EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kNotLegal);
    EXPECT_EQ(LegalityOfLeaving(set, 7, 2), Legality::kNotLegal);
  }
  set.guard_band = AroundTarget{55};
  EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kLegal);
  set = *PresetProfile("d3d11");  // a step is 1/256
  EXPECT_EQ(LegalityOfLeaving(set, 7, 0), Legality::kNotLegal);
}

}  // namespace
}  // namespace rasterproof::legal
