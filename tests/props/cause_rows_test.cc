// Suspects, one of a kind: a bug that they explain, and one beside it that they are not named for.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "core/profile.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "subjects/mutants/fixed_point.h"
#include "subjects/mutants/mutants.h"
#include "subjects/mutants/real_geometry.h"
#include "tests/props/planted_cause.h"

namespace rasterproof::props {
namespace {

using subjects::mutants::FixedStages;
using subjects::mutants::GridPoint;
using subjects::mutants::PointStages;

MakesSubject Snapping(double (*snap)(double)) {
  FixedStages stages;
  stages.snap = [snap](double x, bool) { return snap(x); };
  return Planted(stages);
}

MakesSubject Dropping(bool (*drops)(const Scene& scene, const std::array<Vertex, 3>& v)) {
  FixedStages stages;
  stages.drops = [drops](const Scene& scene, std::size_t number) {
    return drops(scene, Corners(scene, scene.triangles[number]));
  };
  return Planted(stages);
}

MakesSubject Taking(double (*number)(double)) {
  FixedStages stages;
  stages.vertices = [number](std::array<Vertex, 3>& v) {
    for (Vertex& p : v) p = {number(p.x), number(p.y), p.z, p.w};
  };
  return Planted(stages);
}

MakesSubject ClampingTo(bool to_target) {
  FixedStages stages;
  stages.place = [to_target](GridPoint& p, const Scene& scene) {
    const std::int64_t width = to_target ? scene.width * 256 : 640;
    const std::int64_t height = to_target ? scene.height * 256 : 640;
    p = {std::clamp<std::int64_t>(p.x, 0, width), std::clamp<std::int64_t>(p.y, 0, height)};
  };
  return Planted(stages);
}

// Edge values below `limit` in size count as `sign`.
MakesSubject WithABand(double limit, int sign) {
  subjects::mutants::RealStages stages;
  stages.value = [limit, sign](const PointStages::Edge& e, const PointStages::Sample& s) {
    const double left = (s.at.x - e.a.x) * (e.b.y - e.a.y);
    const double right = (s.at.y - e.a.y) * (e.b.x - e.a.x);
    if (std::fabs(left - right) < limit) return sign;
    return left > right ? 1 : -1;
  };
  return [stages] { return subjects::mutants::Make("planted", "planted", stages); };
}

MakesSubject Mutant(std::string_view name) {
  return [name] { return subjects::MakeMutant(name); };
}

double Nearest(double x) { return std::nearbyint(x * 256) / 256; }

// Eleven significant bits, by Dekker's splitting.
double ElevenBits(double x) {
  if (!std::isfinite(x) || std::fabs(x) < 0x1p-14) return Nearest(x);
  const double wide = x * (0x1p42 + 1);
  return wide - (wide - x);
}

struct Row {
  MakesSubject right;  ///< is explained so
  std::string_view cause;
  std::string_view what;
  MakesSubject other;  ///< is not
};

void PrintTo(const Row& row, std::ostream* out) { *out << row.what; }

class CauseRow : public ::testing::TestWithParam<Row> {};

Causes CausesOf(const MakesSubject& make) {
  CampaignOptions options;
  options.cases = 1500;
  options.shrink_budget = 300;
  const Property* property = FindProperty("CoverageEqualsTheModel");
  const PropertyResult result = RunCampaign(*make(), *property, options);
  EXPECT_EQ(result.outcome, Outcome::kViolated) << result.message;
  if (!result.counterexample) return {};
  const FailedProperty failure{property, {result.counterexample->value}};
  return FindCauses(make, std::span(&failure, 1), kLongestSearch);
}

TEST_P(CauseRow, IsNamedForItsBugAndNotForTheOneBeside) {
  const Row& row = GetParam();
  const Causes found = CausesOf(row.right);
  ASSERT_EQ(found.all.size(), 1U);
  EXPECT_EQ(found.all.front().name, row.cause);
  EXPECT_EQ(std::ranges::count(found.all.front().what, row.what), 1)
      << (found.all.front().what.empty() ? "nothing" : found.all.front().what.front());
  for (const Cause& cause : CausesOf(row.other).all)
    EXPECT_EQ(std::ranges::count(cause.what, row.what), 0) << cause.name;
}

INSTANTIATE_TEST_SUITE_P(
    Cause, CauseRow,
    ::testing::Values(
        Row{Snapping([](double x) { return std::ceil(x * 256) / 256; }), "truncation",
            "rounds coordinates up", Mutant("mutant:snap-floors")},
        Row{Snapping([](double x) { return std::ceil(x * 256 - 0.5) / 256; }), "rounding",
            "rounds coordinates half way between two grid points down",
            Mutant("mutant:snap-negative-mirrored")},
        Row{Snapping([](double x) {
              return x > -1 && x < 0 ? std::trunc(x * 256) / 256 : Nearest(x);
            }),
            "truncation", "truncates coordinates between -1 and 0 toward zero",
            Mutant("mutant:snap-truncates")},
        Row{Taking(ElevenBits), "subpixel-bits",
            "rounds the coordinates that it is given to float16",
            Mutant("mutant:snap-bits-lost-far-off")},
        Row{ClampingTo(true), "range", "clamps vertices to the target", ClampingTo(false)},
        Row{Dropping([](const Scene& scene, const std::array<Vertex, 3>& v) {
              const double x = v[0].x + v[1].x + v[2].x;
              const double y = v[0].y + v[1].y + v[2].y;
              return x < 0 || y < 0 || x > 3 * scene.width || y > 3 * scene.height;
            }),
            "lost-triangles", "leaves out triangles whose middle lies outside the target",
            Mutant("mutant:drop-left-of-target")},
        Row{Dropping([](const Scene&, const std::array<Vertex, 3>& v) {
              return v[0].z > 1 || v[1].z > 1 || v[2].z > 1;
            }),
            "lost-triangles", "leaves out triangles with a vertex of z above 1",
            Mutant("mutant:depth-not-finite")},
        Row{Mutant("mutant:tile-accept-one-corner"), "tile-borders",
            "fills a tile if its top left sample is inside (tiles of 8 pixels)",
            Mutant("mutant:tile-accept-off-by-one")},
        Row{Mutant("mutant:tile-reject-one-corner"), "tile-borders",
            "leaves out a tile if its top left sample is outside (tiles of 8 pixels)",
            Mutant("mutant:tile-reject-ties")},
        Row{WithABand(1e-4, 1), "edge-precision", "takes edge values near zero for inside",
            WithABand(1e-4, 0)}));

}  // namespace
}  // namespace rasterproof::props
