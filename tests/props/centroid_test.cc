// Centroids: the stated point and the region by hand-made cases, what lies just within and just
// beyond, and rasterizers that round and are not at fault.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "core/authority.h"
#include "core/case.h"
#include "core/coverage.h"
#include "core/drawing.h"
#include "core/profile.h"
#include "core/sample_pattern.h"
#include "core/scene.h"
#include "core/snap.h"
#include "core/subject.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "model/snap_scene.h"
#include "props/authority.h"
#include "props/judging/values/barycentric_queries.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr const char* kName = "CentroidsLieWhereStated";
using Points3 = std::array<Point2, 3>;
using Barycentric3 = std::array<double, 3>;

// A fragment of a subject: the triangle that its barycentrics belong to, its pixel, its samples.
struct Seen {
  Points3 v;
  Point2 corner;
  std::vector<Point2> samples;
  std::vector<bool> covered;

  Point2 Centre() const { return {corner.x + 0.5, corner.y + 0.5}; }
  bool IsWhole() const { return std::ranges::count(covered, false) == 0; }
  Point2 First(bool is_covered) const {
    return samples[static_cast<std::size_t>(std::ranges::find(covered, is_covered) -
                                            covered.begin())];
  }
};

Barycentric3 InDouble(const Points3& v, Point2 p) {
  const auto edge = [](Point2 a, Point2 b, Point2 at) {
    return (at.x - a.x) * (b.y - a.y) - (at.y - a.y) * (b.x - a.x);
  };
  const double area = edge(v[0], v[1], v[2]);
  return {edge(v[1], v[2], p) / area, edge(v[2], v[0], p) / area, edge(v[0], v[1], p) / area};
}

Barycentric3 InFloat(const Points3& v, Point2 p) {
  const auto edge = [](Point2 a, Point2 b, Point2 at) {
    const auto ax = static_cast<float>(a.x), ay = static_cast<float>(a.y);
    return (static_cast<float>(at.x) - ax) * (static_cast<float>(b.y) - ay) -
           (static_cast<float>(at.y) - ay) * (static_cast<float>(b.x) - ax);
  };
  const std::array<float, 3> e{edge(v[1], v[2], p), edge(v[2], v[0], p), edge(v[0], v[1], p)};
  const float sum = e[0] + e[1] + e[2];
  return {e[0] / sum, e[1] / sum, e[2] / sum};
}

Point2 Direct3D(const Seen& seen) { return seen.IsWhole() ? seen.Centre() : seen.First(true); }

struct Way {
  std::function<Point2(const Seen&)> at = Direct3D;
  Barycentric3 (*barycentrics)(const Points3&, Point2) = InDouble;
  std::function<void(Barycentric3&, std::size_t sample, const Seen&)> spoilt = {};
  double covers_beside = 0;  // in pixels to the right
};

// Draws by the exact model and shows the centroids of a way.
class ShowsCentroids final : public Subject {
 public:
  ShowsCentroids(Profile profile, Way way) : way_(std::move(way)) {
    info_.name = "shows centroids";
    info_.profile = std::move(profile);
    info_.coverage = CoverageKind::kFragments;
    info_.takes_culling = info_.takes_scissor = info_.takes_tiles = false;
    info_.fragments.shows_centroids = true;
    info_.fragments.barycentrics_of = BarycentricsOf::kGiven;
  }
  SubjectInfo& info() { return info_; }
  const SubjectInfo& OwnInfo() const override { return info_; }
  Drawing Show(const DrawJob& job) override {
    const Scene scene = SceneOf(job);
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height, job.samples);
    drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
    drawing.barycentrics.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
    if (job.wants.centroids) drawing.centroids.resize(drawing.counts.size());
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) DrawTriangle(scene, t, drawing);
    return drawing;
  }

 private:
  void DrawTriangle(const Scene& scene, std::size_t t, Drawing& drawing) const {
    Scene alone = scene;
    alone.triangles = {scene.triangles[t]};
    const bool snaps = info_.fragments.barycentrics_of == BarycentricsOf::kSnapped;
    const Scene owners = snaps ? SnapScene(alone, {info_.profile, alone}) : alone;
    Seen seen;
    for (std::size_t k = 0; k < 3; ++k)
      seen.v[k] = WindowPoint(Corners(owners, owners.triangles[0])[k]);
    for (Vertex& v : alone.vertices) v.x += way_.covers_beside;
    const CoverageCounts counts = exact::Coverage(alone, info_.profile);
    const bool up = info_.profile.y_axis == YAxis::kUp;
    for (int row = 0; row < counts.height; ++row) {
      for (int x = 0; x < counts.width; ++x) {
        const double y = up ? counts.height - 1 - row : row;
        ShowPixel(counts, counts.Index(x, row), {static_cast<double>(x), y},
                  static_cast<std::int32_t>(t), seen, drawing);
      }
    }
  }

  void ShowPixel(const CoverageCounts& counts, std::size_t first, Point2 corner, std::int32_t t,
                 Seen& seen, Drawing& drawing) const {
    seen.corner = corner;
    seen.samples.clear();
    seen.covered.clear();
    for (const Point2 location : info_.profile.pattern.locations) {
      seen.covered.push_back(counts.Count(first + seen.samples.size()) != 0);
      seen.samples.push_back({corner.x + location.x, corner.y + location.y});
    }
    if (std::ranges::count(seen.covered, true) == 0) return;
    for (std::size_t s = 0; s < seen.covered.size(); ++s) {
      if (!seen.covered[s]) continue;
      drawing.primitive_ids[first + s] = t;
      drawing.counts.front[first + s] = 1;
      if (drawing.centroids.empty()) continue;
      Barycentric3& shown = drawing.centroids[first + s];
      shown = way_.barycentrics(seen.v, way_.at(seen));
      if (way_.spoilt) way_.spoilt(shown, s, seen);
    }
  }

  Way way_;
  SubjectInfo info_;
};

Profile Canonical(Centroid rule, int samples) {
  Profile profile = *PresetProfile("gl-canonical");
  profile.name = "with centroids";
  profile.centroid = rule;
  profile.pattern = *StandardPattern(samples);
  return profile;
}

PropertyResult CampaignOf(Subject& subject, std::uint64_t cases = 200) {
  CampaignOptions options;
  options.cases = cases;
  return RunCampaign(subject, *FindProperty(kName), options);
}

void ExpectHolds(Subject& subject, const std::string& what) {
  const PropertyResult result = CampaignOf(subject, Cases(200U));
  EXPECT_EQ(result.outcome, Outcome::kHolds) << what << ": " << result.message;
  EXPECT_GT(result.cases_exercised, kOneCaseIn > 1 ? 0U : 80U) << what;
  EXPECT_LE(result.worst_ratio, 1) << what;
}

// Triangle with a vertical right edge at x = 2.5 and half a step of 1/256.
Verdict JudgedAt(Profile profile, double x, WindowBox* band = nullptr) {
  profile.pattern = *StandardPattern(4);
  profile.centroid = Centroid::kInside;
  profile.name = "mine";
  profile.guard_band.reset();
  if (band != nullptr) profile.guard_band = *band;
  ShowsCentroids subject(profile, {.at = [x](const Seen& seen) {
                           return Point2{seen.corner.x == 2 ? x : seen.Centre().x, seen.Centre().y};
                         }});
  subject.info().fragments.barycentric_error = 0x1p-40;
  Scene scene;
  scene.width = 3;
  scene.height = 3;
  scene.vertices = {{-30, -40}, {-30, 40}, {2.5 + 0x1p-9, 40}, {2.5 + 0x1p-9, -40}};
  scene.triangles = {{3, 0, 2}};
  return RunCase(subject, *FindProperty(kName), {scene, profile, {}, ""});
}

TEST(CentroidsLieWhereStated, APointMayLieWhereALegalChoicePutsTheEdge) {
  constexpr double kStep = 0x1p-8;
  // One model: the tie of the snap goes to the even point, x = 2.5.
  const Profile one = *PresetProfile("gl-canonical");
  EXPECT_EQ(JudgedAt(one, 2.5).outcome, Outcome::kHolds) << JudgedAt(one, 2.5).message;
  EXPECT_EQ(JudgedAt(one, 2.5 + kStep / 64).outcome, Outcome::kViolated);
  // Within 0.6 of a step there is the next point as well.
  const Profile wide = *PresetProfile("d3d11");
  EXPECT_EQ(JudgedAt(wide, 2.5 + kStep).outcome, Outcome::kHolds);
  EXPECT_EQ(JudgedAt(wide, 2.5 + kStep * (1 + 0x1p-6)).outcome, Outcome::kViolated);
  // A grid of four bits: 2.5 + 1/16 is less than a step away.
  const Profile coarse = *PresetProfile("vulkan");
  EXPECT_EQ(JudgedAt(coarse, 2.5 + 16 * kStep).outcome, Outcome::kHolds);
  EXPECT_EQ(JudgedAt(coarse, 2.5 + 16.25 * kStep).outcome, Outcome::kViolated);
}

TEST(CentroidsLieWhereStated, AnEdgeThatClippingMayMoveIsNotJudged) {
  const Profile one = *PresetProfile("gl-canonical");
  WindowBox narrow{-20, -50, 20, 50};
  EXPECT_EQ(JudgedAt(one, 2.75, &narrow).outcome, Outcome::kNotExercised);
  WindowBox wide{-50, -50, 50, 50};
  EXPECT_EQ(JudgedAt(one, 2.75, &wide).outcome, Outcome::kViolated);
}

// Vertices off the grid, so that given and snapped ones differ.
Verdict JudgedOffTheGrid(Centroid rule, BarycentricsOf shown, BarycentricsOf said, Way way) {
  ShowsCentroids subject(Canonical(rule, 4), std::move(way));
  subject.info().fragments = {
      .barycentrics_of = shown, .barycentric_error = 0x1p-40, .shows_centroids = true};
  SubjectInfo judged_as = subject.Info();
  judged_as.fragments.barycentrics_of = said;
  subject.JudgeAs(judged_as);
  Scene scene;
  scene.width = scene.height = 6;
  scene.vertices = {
      {0x1.0102p-1, -0x1.02p+2}, {-0x1.00fep+2, 0x1.8033p+3}, {0x1.9001p+3, 0x1.7022p+3}};
  scene.triangles = {{0, 1, 2}};
  return RunCase(subject, *FindProperty(kName), {scene, subject.Info().profile, {}, ""});
}

TEST(CentroidsLieWhereStated, BarycentricsBelongToTheVerticesThatTheSubjectNames) {
  constexpr BarycentricsOf kGiven = BarycentricsOf::kGiven;
  constexpr BarycentricsOf kSnapped = BarycentricsOf::kSnapped;
  for (const BarycentricsOf of : {kGiven, kSnapped}) {
    const Verdict verdict = JudgedOffTheGrid(Centroid::kDirect3D, of, of, {});
    EXPECT_EQ(verdict.outcome, Outcome::kHolds) << verdict.message;
  }
  EXPECT_EQ(JudgedOffTheGrid(Centroid::kDirect3D, kSnapped, kGiven, {}).outcome,
            Outcome::kViolated);
  EXPECT_EQ(JudgedOffTheGrid(Centroid::kDirect3D, kGiven, kSnapped, {}).outcome,
            Outcome::kViolated);
}

TEST(CentroidsLieWhereStated, APointMayLieOnEachSideOfItsPixelAndNotBeyond) {
  for (const Point2 side : {Point2{0, 0.5}, Point2{1, 0.5}, Point2{0.5, 0}, Point2{0.5, 1}}) {
    for (const double part : {1.0, 1 + 0x1p-20}) {
      const Verdict verdict = JudgedOffTheGrid(
          Centroid::kInside, BarycentricsOf::kSnapped, BarycentricsOf::kSnapped,
          {.at = [side, part](const Seen& seen) {
            const Point2 centre = seen.Centre();
            if (!seen.IsWhole()) return seen.First(true);
            return Point2{centre.x + part * (side.x - 0.5), centre.y + part * (side.y - 0.5)};
          }});
      EXPECT_EQ(verdict.outcome, part == 1 ? Outcome::kHolds : Outcome::kViolated)
          << side.x << ", " << side.y << ": " << verdict.message;
    }
  }
}

// It covers a column that the triangle does not reach: wrong, and no centroid there is right.
TEST(CentroidsLieWhereStated, AFragmentWithoutALegalPointIsNotJudged) {
  Scene scene;
  scene.width = 4;
  scene.height = 3;
  scene.vertices = {{-30, -40}, {-30, 40}, {1.75, 40}, {1.75, -40}};
  scene.triangles = {{3, 1, 2}};
  for (const bool is_wrong : {false, true}) {
    ShowsCentroids subject(Canonical(Centroid::kInside, 4),
                           {.at =
                                [is_wrong](const Seen& seen) {
                                  return seen.corner.x == 1 && is_wrong ? Point2{2, seen.Centre().y}
                                                                        : seen.Centre();
                                },
                            .covers_beside = 1});
    const Verdict verdict =
        RunCase(subject, *FindProperty(kName), {scene, subject.Info().profile, {}, ""});
    EXPECT_EQ(verdict.outcome, is_wrong ? Outcome::kViolated : Outcome::kHolds) << verdict.message;
  }
}

TEST(CentroidsLieWhereStated, HoldsOfBothRulesAtEveryNumberOfSamples) {
  for (const int samples : {1, 2, 4, 8, 16}) {
    for (const Centroid rule : {Centroid::kDirect3D, Centroid::kInside}) {
      for (const BarycentricsOf of : {BarycentricsOf::kGiven, BarycentricsOf::kSnapped}) {
        ShowsCentroids subject(Canonical(rule, samples), {});
        subject.info().fragments.barycentrics_of = of;
        ExpectHolds(subject, std::to_string(samples));
      }
    }
  }
}

TEST(CentroidsLieWhereStated, HoldsWhereYPointsUp) {
  for (const Centroid rule : {Centroid::kDirect3D, Centroid::kInside}) {
    Profile profile = Canonical(rule, 4);
    profile.y_axis = YAxis::kUp;
    ShowsCentroids subject(profile, {});
    ExpectHolds(subject, "y up");
  }
}

TEST(CentroidsLieWhereStated, AStatedErrorIsAllThatIsLetPass) {
  constexpr double kError = 0x1p-30;
  for (const Centroid rule : {Centroid::kDirect3D, Centroid::kInside}) {
    for (const double part : {0.99, 1.01}) {
      // At the first covered sample, also by the region's rule, every barycentric as far off as
      // it may be; that of a region in the direction that no other point makes good.
      ShowsCentroids subject(Canonical(rule, 4),
                             {.spoilt = [part](Barycentric3& l, std::size_t, const Seen&) {
                               for (double& one : l) one += part * kError;
                             }});
      subject.info().fragments.barycentric_error = kError;
      Scene scene;
      scene.width = scene.height = 6;
      scene.vertices = {{0.5, 0.25}, {0.75, 5.5}, {5.25, 4.75}};
      scene.triangles = {{0, 1, 2}};
      const Verdict result =
          RunCase(subject, *FindProperty(kName), {scene, subject.Info().profile, {}, ""});
      EXPECT_GT(result.exercised, 0U);
      EXPECT_EQ(result.outcome, part < 1 ? Outcome::kHolds : Outcome::kViolated) << result.message;
    }
  }
}

// What is judged is a point that the subject rounds and barycentrics that it rounds again.
Point2 Rounded(Point2 p) {
  return {static_cast<double>(static_cast<float>(p.x)), static_cast<float>(p.y)};
}

Point2 MeanInFloat(const Seen& seen) {
  Point2 sum;
  double n = 0;
  for (std::size_t s = 0; s < seen.samples.size(); ++s) {
    if (!seen.covered[s]) continue;
    sum = {sum.x + seen.samples[s].x, sum.y + seen.samples[s].y};
    ++n;
  }
  return Rounded({sum.x / n, sum.y / n});
}

// From a covered sample to one that is not: where the edge is crossed, rounded.
Point2 OnTheEdge(const Seen& seen) {
  if (seen.IsWhole()) return seen.Centre();
  Point2 inside = seen.First(true);
  Point2 outside = seen.First(false);
  if (!InClosedTriangle(seen.v, inside)) return inside;
  for (int k = 0; k < 60; ++k) {
    const Point2 middle{(inside.x + outside.x) / 2, (inside.y + outside.y) / 2};
    (InClosedTriangle(seen.v, middle) ? inside : outside) = middle;
  }
  return Rounded(inside);
}

TEST(CentroidsLieWhereStated, WhoRoundsToFloat32IsNotAtFault) {
  for (const char* const preset : {"d3d11", "d3d11-4x", "d3d11-8x"}) {
    ShowsCentroids subject(*PresetProfile(preset), {.barycentrics = InFloat});
    ExpectHolds(subject, preset);
  }
  for (const char* const preset : {"gl-4x", "vulkan-standard-8x", "webgpu-4x"}) {
    for (const auto at : {MeanInFloat, OnTheEdge}) {
      ShowsCentroids subject(*PresetProfile(preset), {.at = at, .barycentrics = InFloat});
      ExpectHolds(subject, preset);
    }
  }
  for (const auto at : {MeanInFloat, OnTheEdge}) {
    Profile profile = Canonical(Centroid::kInside, 4);
    profile.snap = {};
    ShowsCentroids subject(profile, {.at = at, .barycentrics = InFloat});
    ExpectHolds(subject, "no grid");
  }
}

// Far from the origin a point is rounded by more than the barycentrics of small triangles are off.
TEST(CentroidsLieWhereStated, APointMayBeRoundedFarFromTheOrigin) {
  Profile profile = Canonical(Centroid::kInside, 16);
  profile.snap = {};
  ShowsCentroids subject(profile, {.at = OnTheEdge, .barycentrics = InFloat});
  std::mt19937_64 bits(107);
  const auto draw = [&](double from, double to) {
    const double part = std::ldexp(static_cast<double>(bits() >> 11), -53);
    return static_cast<double>(static_cast<float>(from + part * (to - from)));
  };
  std::uint64_t exercised = 0;
  for (int n = 0; n < 60; ++n) {
    Scene scene;
    scene.width = 2048;
    scene.height = 2;
    for (int k = 0; k < 3; ++k) scene.vertices.push_back({draw(2040, 2043), draw(0, 2)});
    scene.triangles = {{0, 1, 2}};
    const Verdict verdict = RunCase(subject, *FindProperty(kName), {scene, profile, {}, ""});
    EXPECT_NE(verdict.outcome, Outcome::kViolated) << n << verdict.message;
    exercised += verdict.exercised;
  }
  EXPECT_GT(exercised, 100U);
}

TEST(CentroidsLieWhereStated, AppliesWhereTheProfileAndTheSubjectSayIt) {
  const auto outcome = [](const Profile& profile, auto change) {
    ShowsCentroids subject(profile, {});
    change(subject.info());
    return CampaignOf(subject).outcome;
  };
  const auto as_it_is = [](SubjectInfo&) {};
  EXPECT_EQ(outcome(Canonical(Centroid::kUnstated, 4), as_it_is), Outcome::kNotApplicable);
  Profile vary = Canonical(Centroid::kDirect3D, 4);
  vary.sample_positions = SamplePositions::kVary;
  EXPECT_EQ(outcome(vary, as_it_is), Outcome::kNotApplicable) << "which sample is nowhere said";
  vary.centroid = Centroid::kInside;
  EXPECT_EQ(outcome(vary, as_it_is), Outcome::kHolds);
  const Profile stated = Canonical(Centroid::kInside, 4);
  EXPECT_EQ(outcome(stated, [](SubjectInfo& info) { info.fragments.shows_centroids = false; }),
            Outcome::kNotApplicable);
  EXPECT_EQ(
      outcome(*PresetProfile("gl-4x"),
              [](SubjectInfo& info) { info.fragments.barycentrics_of = BarycentricsOf::kSnapped; }),
      Outcome::kNotApplicable);
}

TEST(CentroidsLieWhereStated, IsAskedForByClausesAndByWhatIsStated) {
  const Property& property = *FindProperty(kName);
  for (const char* const preset : {"gl-4x", "vulkan", "vulkan-standard-4x", "d3d11-8x", "webgpu"}) {
    EXPECT_EQ(AuthorityOf(property, *PresetProfile(preset)).authority, Authority::kClause)
        << preset;
  }
  EXPECT_EQ(AuthorityOf(property, Canonical(Centroid::kInside, 4)).authority,
            Authority::kStatedModel);
}

// Each is seen by one pixel of one triangle alone.
TEST(CentroidsLieWhereStated, OneWrongFragmentIsFound) {
  const auto found = [](const Profile& profile, auto at) {
    ShowsCentroids subject(profile, {.at = at});
    return CampaignOf(subject).outcome == Outcome::kViolated;
  };
  EXPECT_TRUE(found(Canonical(Centroid::kDirect3D, 4), [](const Seen& seen) {
    return seen.corner == Point2{3, 3} ? seen.First(true) : Direct3D(seen);
  })) << "of a whole pixel";
  EXPECT_TRUE(found(Canonical(Centroid::kInside, 4), [](const Seen& seen) {
    return seen.IsWhole() ? Point2{seen.corner.x - 0x1p-6, seen.corner.y} : seen.First(true);
  })) << "a 64th of a pixel outside it";
  ShowsCentroids by_sample(Canonical(Centroid::kDirect3D, 4),
                           {.spoilt = [](Barycentric3& l, std::size_t s, const Seen& seen) {
                             if (s == 3 && seen.IsWhole()) std::swap(l[0], l[1]);
                           }});
  EXPECT_EQ(CampaignOf(by_sample).outcome, Outcome::kViolated) << "at the last sample alone";
}

}  // namespace
}  // namespace rasterproof::props
