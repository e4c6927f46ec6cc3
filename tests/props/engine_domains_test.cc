// The recipes of cameras, viewports, frames, cracks, soups and layers draw what they say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <set>
#include <string_view>

#include "core/scene.h"
#include "exact/coverage.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace engine_domains {

using testing::RealInfo;
using testing::SnappedInfo;

// How many of 200 cases of the domain are as `holds` says. The least numbers below are about half
// of what was measured, so that a dead branch shows.
int CasesThat(std::string_view domain, const SubjectInfo& info,
              const std::function<bool(const Case&)>& holds) {
  int cases = 0;
  for (std::uint64_t i = 0; i < 200; ++i) {
    PhiloxSource bits(1, i);
    cases += holds(FindDomain(domain)->draw(bits, info)) ? 1 : 0;
  }
  return cases;
}

bool HasVertex(const Case& c, bool (*is_such)(const Vertex&)) {
  return std::ranges::any_of(c.scene.vertices, is_such);
}

bool HasPair(const Case& c, bool (*is_such)(const Vertex&, const Vertex&)) {
  return std::ranges::any_of(c.scene.vertices, [&](const Vertex& a) {
    return std::ranges::any_of(c.scene.vertices,
                               [&](const Vertex& b) { return &a < &b && is_such(a, b); });
  });
}

// The largest count of a sample.
std::uint32_t MostOften(const Case& c) {
  const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
  std::uint32_t most = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) most = std::max(most, counts.Count(k));
  return most;
}
bool CoversSomething(const Case& c) { return MostOften(c) > 0; }

SubjectInfo ClipInfo() {
  SubjectInfo info = RealInfo();
  info.takes_window = false;
  info.takes_clip = true;
  return info;
}

TEST(Cameras, SeeTheirGridsFromInFrontFromAmongThemAndFromAfar) {
  const auto cases = [](const std::function<bool(const Case&)>& holds) {
    return CasesThat("cameras", ClipInfo(), holds);
  };
  EXPECT_GE(cases(CoversSomething), 90);
  EXPECT_GE(
      cases([](const Case& c) { return HasVertex(c, [](const Vertex& v) { return v.w <= 0; }); }),
      40);
  EXPECT_GE(cases([](const Case& c) {
              return std::ranges::all_of(c.scene.vertices,
                                         [](const Vertex& v) { return v.w == 1; });
            }),
            20);
  EXPECT_GE(cases([](const Case& c) {
              return HasVertex(c, [](const Vertex& v) { return v.z < 0 || v.z > v.w; });
            }),
            70);
}

TEST(ScaledViewports, PutVerticesBetweenAllThatSamplesAreOn) {
  const auto is_between = [](const Vertex& v) { return std::fmod(v.x * 4096, 1) != 0; };
  const auto lies_between = [&](const Case& c) { return HasVertex(c, is_between); };
  EXPECT_GE(CasesThat("scaled-viewports", RealInfo(), lies_between), 65);
  EXPECT_GE(CasesThat("scaled-viewports", SnappedInfo(8), lies_between), 65);
  EXPECT_GE(CasesThat("scaled-viewports", RealInfo(), CoversSomething), 195);
}

// A sample that nothing covers between two of its row that something does.
bool HasHole(const Case& c) {
  const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
  for (int row = 0; row < c.scene.height; ++row) {
    int changes = 0;
    for (int x = 0; x <= c.scene.width; ++x) {
      const bool is_covered = x < c.scene.width && counts.Count(counts.Index(x, row, 0)) != 0;
      const bool was_covered = x > 0 && counts.Count(counts.Index(x - 1, row, 0)) != 0;
      changes += is_covered != was_covered ? 1 : 0;
    }
    if (changes > 2) return true;
  }
  return false;
}

TEST(TessellationCracks, OpenAndOverlapTheEdgeOfTwoPatches) {
  for (const SubjectInfo& info : {RealInfo(), SnappedInfo(8)}) {
    EXPECT_GE(CasesThat("tessellation-cracks", info, HasHole), 9);
    EXPECT_GE(
        CasesThat("tessellation-cracks", info, [](const Case& c) { return MostOften(c) > 1; }), 13);
  }
}

TEST(Soups, HaveFacesTwiceBothWindingsAndPlacesUnderSeveralIndices) {
  const auto cases = [](const std::function<bool(const Case&)>& holds) {
    return CasesThat("soups", SnappedInfo(8), holds);
  };
  EXPECT_GE(cases([](const Case& c) {
              std::set<std::set<std::int32_t>> faces;
              for (const Triangle& t : c.scene.triangles) faces.insert({t[0], t[1], t[2]});
              return faces.size() < c.scene.triangles.size();
            }),
            80);
  EXPECT_GE(cases([](const Case& c) {
              const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
              const auto any = [](const auto& n) {
                return std::ranges::any_of(n, std::identity{});
              };
              return any(counts.front) && any(counts.back);
            }),
            65);
  EXPECT_GE(cases([](const Case& c) {
              return HasPair(c, [](const Vertex& a, const Vertex& b) { return a == b; });
            }),
            98);
  EXPECT_GE(cases([](const Case& c) { return MostOften(c) >= 4; }), 36);
}

bool AreAtOnePlace(const Vertex& a, const Vertex& b) { return a.x == b.x && a.y == b.y; }

TEST(CoplanarDepths, CoincideNearlyCoincideAndLeaveTheUnitInterval) {
  const auto cases = [](const std::function<bool(const Case&)>& holds) {
    return CasesThat("coplanar-depths", RealInfo(), holds);
  };
  EXPECT_GE(cases([](const Case& c) { return MostOften(c) > 1; }), 90);
  EXPECT_GE(cases([](const Case& c) {
              return HasVertex(c, [](const Vertex& v) { return v.z < 0 || v.z > 1; });
            }),
            80);
  EXPECT_GE(cases([](const Case& c) {
              return HasPair(c, [](const Vertex& a, const Vertex& b) {
                return AreAtOnePlace(a, b) && a.z == b.z;
              });
            }),
            80);
  EXPECT_GE(cases([](const Case& c) {
              return HasPair(c, [](const Vertex& a, const Vertex& b) {
                return AreAtOnePlace(a, b) && a.z != b.z &&
                       std::fabs(a.z - b.z) <= 0x1p-22 * std::fabs(a.z);
              });
            }),
            68);
}

TEST(FrameSweeps, MoveAMeshWithAHubOnASampleByLessThanAPixelPerFrame) {
  const auto has_frames = [](const Case& c) { return c.scene.triangles.size() >= 16; };
  const auto has_hub_on_sample = [](const Case& c) {
    return HasVertex(c, [](const Vertex& v) { return std::fmod(v.x, 12) == 5.5 && v.y == 5.5; });
  };
  for (const SubjectInfo& info : {RealInfo(), RealInfo(Precision::kFloat64), SnappedInfo(8)}) {
    EXPECT_EQ(CasesThat("frame-sweeps", info, has_frames), 200);
    EXPECT_EQ(CasesThat("frame-sweeps", info, has_hub_on_sample), 200);
  }
  EXPECT_GE(CasesThat("frame-sweeps", SnappedInfo(0), has_frames), 100);
  // Two hubs of three are next to their sample in all frames but one.
  const auto hubs_move = [](const Case& c) {
    return HasVertex(c, [](const Vertex& v) {
      const double off = std::fabs(std::fmod(v.x, 12) - 5.5);
      return off > 0 && off < 0.125;
    });
  };
  EXPECT_GE(CasesThat("frame-sweeps", RealInfo(), hubs_move), 60);
}

}  // namespace engine_domains
}  // namespace rasterproof::props
