// Barycentrics under legal sets, by a subject that states its error: equal ones, exchanged ones and
// those of places that are not legal are violations of a clause; those of legal places are none.
#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/profile.h"
#include "core/sample_pattern.h"
#include "core/subject_info.h"
#include "exact/coverage.h"
#include "model/snap.h"
#include "model/snap_scene.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tests/fake_subject.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace {

constexpr const char* kStaysWithin = "FragmentBarycentricsStayWithinTheirError";
constexpr double kError = 1e-5;

using Corners3 = std::array<Point2, 3>;
using Weights = std::array<double, 3>;

double Edge(Point2 a, Point2 b, Point2 p) {
  return (p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x);
}

Weights WeightsOf(const Corners3& v, Point2 p) {
  const double area = Edge(v[0], v[1], v[2]);
  return {Edge(v[1], v[2], p) / area, Edge(v[2], v[0], p) / area, Edge(v[0], v[1], p) / area};
}

// A triangle and a sample that it covers.
struct Shown {
  Corners3 given{};
  Corners3 snapped{};  ///< by the canonical model
  const Profile* profile = nullptr;
  Point2 at{};
};

using Way = std::function<Weights(const Shown&)>;

Weights Equal(const Shown&) { return {1.0 / 3, 1.0 / 3, 1.0 / 3}; }

Weights Exchanged(const Shown& f) {
  const Weights l = WeightsOf(f.snapped, f.at);
  return {l[1], l[0], l[2]};
}

Weights OffByAlmostTheError(const Weights& l) {
  return {l[0] + 0.9 * kError, l[1] - 0.9 * kError, l[2]};
}

Weights OfGiven(const Shown& f) { return OffByAlmostTheError(WeightsOf(f.given, f.at)); }
Weights OfSnapped(const Shown& f) { return OffByAlmostTheError(WeightsOf(f.snapped, f.at)); }

// An end of the legal points on the coarsest grid: one for each corner, by its place.
Weights OfOtherLegalPoints(const Shown& f) {
  const Profile& profile = *f.profile;
  const Snap coarsest = LegalGrids(profile.snap, profile.freedom).front();
  const auto moved = [&](double x, bool up) {
    const std::vector<double> points = LegalGridPoints(x, coarsest, profile.freedom);
    return up ? points.back() : points.front();
  };
  Corners3 v;
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = {moved(f.given[k].x, k != 0), moved(f.given[k].y, k != 1)};
  }
  return Edge(v[0], v[1], v[2]) == 0 ? OfSnapped(f) : OffByAlmostTheError(WeightsOf(v, f.at));
}

// Off the given places by so many pixels: more than is legal under the set.
Way MovedBy(double pixels) {
  return [=](const Shown& f) {
    Corners3 v = f.given;
    for (Point2& p : v) p.x += pixels;
    return WeightsOf(v, f.at);
  };
}

FakeSubject ShowingWeights(std::string_view set, BarycentricsOf of, Way way,
                           const SamplePattern* elsewhere = nullptr) {
  SubjectInfo info;
  info.name = "shows weights";
  info.profile = *PresetProfile(set);
  info.coverage = CoverageKind::kFragments;
  info.takes_culling = info.takes_scissor = info.takes_tiles = false;
  info.fragments.barycentrics_of = of;
  info.fragments.barycentric_error = kError;
  Profile drawn = info.profile;
  if (elsewhere != nullptr) drawn.pattern = *elsewhere;
  return FakeSubject::Showing(info, [drawn, way = std::move(way)](const DrawJob& job) {
    const Scene scene = SceneOf(job);
    const Scene snapped = SnapScene(scene, {drawn, scene});
    const auto width = static_cast<std::size_t>(scene.width);
    const auto samples = static_cast<std::size_t>(drawn.pattern.samples());
    Drawing drawing;
    drawing.counts = CoverageCounts(scene.width, scene.height, job.samples);
    drawing.primitive_ids.assign(drawing.counts.size(), kNoPrimitive);
    drawing.barycentrics.resize(drawing.counts.size());
    drawing.depths.resize(drawing.counts.size());
    for (std::size_t t = 0; t < scene.triangles.size(); ++t) {
      Scene alone = scene;
      alone.triangles = {scene.triangles[t]};
      const CoverageCounts covered = exact::Coverage(alone, drawn);
      Shown shown;
      shown.profile = &drawn;
      for (std::size_t k = 0; k < 3; ++k) {
        shown.given[k] = WindowPoint(Corners(scene, scene.triangles[t])[k]);
        shown.snapped[k] = WindowPoint(Corners(snapped, snapped.triangles[t])[k]);
      }
      if (Edge(shown.given[0], shown.given[1], shown.given[2]) == 0) continue;
      for (std::size_t k = 0; k < covered.size(); ++k) {
        if (covered.Count(k) == 0) continue;
        const int row = static_cast<int>(k / samples / width);
        const int line = drawn.y_axis == YAxis::kUp ? scene.height - 1 - row : row;
        shown.at = drawn.pattern.At(static_cast<int>(k / samples % width), line,
                                    static_cast<int>(k % samples));
        drawing.counts.front[k] = 1;
        drawing.primitive_ids[k] = static_cast<std::int32_t>(t);
        drawing.barycentrics[k] = way(shown);
      }
    }
    return drawing;
  });
}

PropertyResult Found(FakeSubject subject, std::uint64_t cases = 100) {
  CampaignOptions options;
  options.cases = cases;
  options.shrink_budget = 20;
  return RunCampaign(subject, *FindProperty(kStaysWithin), options);
}

constexpr std::array kSets{
    std::pair{"gl", "gl.barycentric"}, std::pair{"vulkan", "vulkan.barycentric"},
    std::pair{"d3d11", "d3d11.interpolator"}, std::pair{"webgpu", "webgpu.barycentric"}};
constexpr std::array kOwners{BarycentricsOf::kEither, BarycentricsOf::kSnapped,
                             BarycentricsOf::kGiven};

void ExpectBrokenClause(const PropertyResult& result, const std::string& clause) {
  EXPECT_EQ(result.outcome, Outcome::kViolated) << clause << ": " << result.message;
  EXPECT_EQ(result.authority, Authority::kClause) << clause;
  EXPECT_EQ(result.required_by, std::vector{clause});
}

TEST(FragmentChoices, WeightsOfNoLegalChoiceBreakAClause) {
  for (const auto& [set, clause] : kSets) {
    for (const BarycentricsOf of : kOwners) {
      SCOPED_TRACE(std::string(set) + ", barycentrics of " + std::to_string(static_cast<int>(of)));
      ExpectBrokenClause(Found(ShowingWeights(set, of, Equal)), clause);
      ExpectBrokenClause(Found(ShowingWeights(set, of, Exchanged)), clause);
    }
  }
}

TEST(FragmentChoices, WeightsOfPlacesJustBeyondTheLegalOnesAreFound) {
  for (const auto& [set, pixels] :
       {std::pair{"gl", 0.2}, {"vulkan", 0.2}, {"d3d11", 0x1p-6}, {"webgpu", 2.5}}) {
    for (const BarycentricsOf of : {BarycentricsOf::kEither, BarycentricsOf::kSnapped}) {
      EXPECT_EQ(Found(ShowingWeights(set, of, MovedBy(pixels))).outcome, Outcome::kViolated) << set;
    }
  }
}

TEST(FragmentChoices, WeightsOfLegalPlacesHold) {
  const auto expect_holds = [](std::string_view set, BarycentricsOf of, const Way& way) {
    const PropertyResult result = Found(ShowingWeights(set, of, way), Cases(200U));
    EXPECT_EQ(result.outcome, Outcome::kHolds) << set << ": " << result.message;
    EXPECT_GT(result.cases_exercised, kOneCaseIn > 1 ? 0U : 30U) << set;
  };
  for (const auto& [set, clause] : kSets) {
    expect_holds(set, BarycentricsOf::kGiven, OfGiven);
    expect_holds(set, BarycentricsOf::kEither, OfGiven);
    for (const BarycentricsOf of : {BarycentricsOf::kEither, BarycentricsOf::kSnapped}) {
      expect_holds(set, of, OfSnapped);
      expect_holds(set, of, OfOtherLegalPoints);
    }
  }
}

// Where nobody says where samples lie, weights are of any place of the pixel.
TEST(FragmentChoices, SamplesThatMayLieElsewhereAreNotTakenForMisplaced) {
  SamplePattern elsewhere = *StandardPattern(4);
  elsewhere.locations = {{0.0625, 0.5}, {0.5, 0.9375}, {0.9375, 0.5}, {0.5, 0.0625}};
  for (const char* const set : {"vulkan-4x", "gl-4x"}) {
    for (const auto& [of, way] : {std::pair<BarycentricsOf, Way>{BarycentricsOf::kGiven, OfGiven},
                                  {BarycentricsOf::kSnapped, OfSnapped},
                                  {BarycentricsOf::kEither, OfSnapped}}) {
      const PropertyResult legal = Found(ShowingWeights(set, of, way, &elsewhere));
      EXPECT_EQ(legal.outcome, Outcome::kHolds) << set << ": " << legal.message;
      const PropertyResult equal = Found(ShowingWeights(set, of, Equal, &elsewhere));
      EXPECT_EQ(equal.outcome, Outcome::kViolated) << set << ": " << equal.message;
    }
  }
}

}  // namespace
}  // namespace rasterproof::props
