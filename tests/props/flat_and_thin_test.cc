// Triangles that the snap flattens, or may flatten, under the sets of the APIs: a rasterizer may
// cover the samples on their edges or nothing, and not what lies beside them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/coverage.h"
#include "core/profile.h"
#include "core/profile_keys.h"
#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "model/snap.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tests/props/faulty_subjects.h"
#include "tests/share.h"

namespace rasterproof::props {
namespace flat_and_thin {
namespace {

constexpr std::array<std::string_view, 3> kSets{"gl", "vulkan", "webgpu"};
constexpr std::uint64_t kSeeds = Cases<std::uint64_t>(5);

// What is drawn of a triangle in place of what the model draws of it.
using Instead = std::function<void(const std::array<Vertex, 3>& at, CoverageCounts& counts)>;
// Where a corner goes.
using Placing = std::function<double(double)>;

SubjectInfo InfoOf(std::string_view set) {
  SubjectInfo info;
  info.name = "fake";
  info.input = Precision::kFloat32;
  info.profile = *PresetProfile(set);
  info.takes_scissor = info.takes_culling = false;
  return info;
}

double By(SnapRule rule, double x) { return SnapCoordinate(x, {8, rule}); }

// Snaps to 1/256 of a pixel and draws by the top-left rule, but for the triangles that `is` picks.
FakeSubject DrawnBy(std::string_view set, const Placing& place,
                    const std::function<bool(const std::array<Vertex, 3>&)>& is,
                    const Instead& instead) {
  return {InfoOf(set), [=](const Scene& scene, const DrawOptions&, CoverageCounts& counts) {
            for (const Triangle& t : scene.triangles) {
              std::array<Vertex, 3> at = Corners(scene, t);
              if (!std::ranges::all_of(at, IsFinite)) continue;
              for (Vertex& v : at) v = {place(v.x), place(v.y), 0, 1};
              if (is(at)) {
                instead(at, counts);
                continue;
              }
              Scene one;
              one.width = scene.width;
              one.height = scene.height;
              one.precision = Precision::kFloat64;
              one.vertices.assign(at.begin(), at.end());
              one.triangles = {{0, 1, 2}};
              Profile plain;
              plain.pattern = InfoOf(set).profile.pattern;
              counts += exact::Coverage(one, plain);
            }
          }};
}

bool HasNoArea(const std::array<Vertex, 3>& v) {
  return exact::Facing({WindowPoint(v[0]), WindowPoint(v[1]), WindowPoint(v[2])}) == 0;
}

// Thinner than a step of 1/16 pixel.
bool IsThin(const std::array<Vertex, 3>& v) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& a = v[k];
    const Vertex& b = v[(k + 1) % 3];
    longest = std::max(longest, std::hypot(b.x - a.x, b.y - a.y));
  }
  const double area = (v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[1].y - v[0].y) * (v[2].x - v[0].x);
  return std::fabs(area) <= longest / 16;
}

void ForEachSample(const CoverageCounts& counts, const std::function<void(int, int)>& visit) {
  for (int row = 0; row < counts.height; ++row) {
    for (int x = 0; x < counts.width; ++x) visit(x, row);
  }
}

void FillTarget(const std::array<Vertex, 3>&, CoverageCounts& counts) {
  for (std::uint32_t& n : counts.back) ++n;
}

void FillBox(const std::array<Vertex, 3>& v, CoverageCounts& counts) {
  const auto [left, right] = std::minmax({v[0].x, v[1].x, v[2].x});
  const auto [top, bottom] = std::minmax({v[0].y, v[1].y, v[2].y});
  ForEachSample(counts, [&](int x, int row) {
    const bool in = left <= x + 0.5 && x + 0.5 <= right && top <= row + 0.5 && row + 0.5 <= bottom;
    if (in) ++counts.back[counts.Index(x, row)];
  });
}

// The pixels along its longest edge, as lines are drawn.
void DrawLine(const std::array<Vertex, 3>& v, CoverageCounts& counts) {
  std::vector<std::size_t> drawn;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vertex& a = v[k];
    const Vertex& b = v[(k + 1) % 3];
    const double length = std::max(std::fabs(b.x - a.x), std::fabs(b.y - a.y));
    const int steps = static_cast<int>(std::min(std::ceil(length), 4096.0));
    for (int i = 0; i <= steps; ++i) {
      const double along = steps == 0 ? 0 : static_cast<double>(i) / steps;
      const double x = std::floor(a.x + along * (b.x - a.x));
      const double y = std::floor(a.y + along * (b.y - a.y));
      if (x < 0 || y < 0 || x >= counts.width || y >= counts.height) continue;
      drawn.push_back(counts.Index(static_cast<int>(x), static_cast<int>(y)));
    }
  }
  std::ranges::sort(drawn);
  drawn.erase(std::ranges::unique(drawn).begin(), drawn.end());
  for (const std::size_t k : drawn) ++counts.back[k];
}

void DrawItsSegment(const std::array<Vertex, 3>& v, CoverageCounts& counts) {
  ForEachSample(counts, [&](int x, int row) {
    const Point2 p{x + 0.5, row + 0.5};
    for (std::size_t k = 0; k < 3; ++k) {
      const Point2 a = WindowPoint(v[k]);
      const Point2 b = WindowPoint(v[(k + 1) % 3]);
      const bool within = std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) &&
                          std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
      if (!within || exact::EdgeSign(a, b, p) != 0) continue;
      ++counts.back[counts.Index(x, row)];
      return;
    }
  });
}

void DrawNothing(const std::array<Vertex, 3>&, CoverageCounts&) {}

Outcome JointOutcome(FakeSubject& subject, std::uint64_t seed, std::uint64_t cases = 1000) {
  const Property& property = *FindProperty("OneLegalModelExplainsTheMesh");
  CampaignOptions options;
  options.cases = cases;
  options.seed = seed;
  return RunCampaign(subject, property, options).outcome;
}

struct Way {
  std::string_view words;
  std::function<bool(const std::array<Vertex, 3>&)> is;
  Instead instead;
};

TEST(FlatAndThinTriangles, AreFoundWhereTheyCoverWhatLiesBesideThem) {
  const Placing nearest = [](double x) { return By(SnapRule::kNearestEven, x); };
  for (const Way& way : {Way{"a flat one fills the target", HasNoArea, FillTarget},
                         Way{"a flat one fills its box", HasNoArea, FillBox},
                         Way{"a flat one is a line of pixels", HasNoArea, DrawLine},
                         Way{"a thin one fills its box", IsThin, FillBox},
                         Way{"a thin one is a line of pixels", IsThin, DrawLine}}) {
    for (const std::string_view set : kSets) {
      for (std::uint64_t seed = 1; seed <= std::min<std::uint64_t>(3, kSeeds); ++seed) {
        FakeSubject subject = DrawnBy(set, nearest, way.is, way.instead);
        EXPECT_EQ(JointOutcome(subject, seed), Outcome::kViolated)
            << way.words << ", " << set << ", seed " << seed;
      }
    }
  }
}

TEST(FlatAndThinTriangles, HoldWhereTheyCoverTheirEdgesOrNothing) {
  for (const Way& way : {Way{"a flat one covers nothing", HasNoArea, DrawNothing},
                         Way{"a flat one covers the samples on it", HasNoArea, DrawItsSegment}}) {
    for (const SnapRule rule : {SnapRule::kNearestEven, SnapRule::kFloor, SnapRule::kTruncate}) {
      const Placing place = [rule](double x) { return By(rule, x); };
      for (const std::string_view set : kSets) {
        for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
          FakeSubject subject = DrawnBy(set, place, way.is, way.instead);
          EXPECT_EQ(JointOutcome(subject, seed, RunsMore() ? 1000 : 100), Outcome::kHolds)
              << way.words << ", " << SnapRuleName(rule) << ", " << set << ", seed " << seed;
        }
      }
    }
  }
}

}  // namespace
}  // namespace flat_and_thin
}  // namespace rasterproof::props
