// The recipes that reach the ends of the range, tiny ends, deciding ties and many samples do so.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>
#include <string_view>
#include <vector>

#include "core/scene.h"
#include "exact/coverage.h"
#include "exact/edge.h"
#include "props/domains/bit_source.h"
#include "props/domains/domain.h"
#include "props/property.h"
#include "props/run/campaign.h"
#include "tests/props/faulty_subjects.h"

namespace rasterproof::props {
namespace {

using testing::LosesLarge;
using testing::RealInfo;
using testing::SnappedInfo;

Case Drawn(const Domain& domain, const SubjectInfo& info, std::uint64_t index) {
  PhiloxSource bits(1, index);
  return domain.draw(bits, info);
}

// How many of 200 cases of the domain are as `holds` says.
template <class Holds>
int CasesThat(std::string_view domain, const SubjectInfo& info, Holds holds) {
  int cases = 0;
  for (std::uint64_t i = 0; i < 200; ++i)
    cases += holds(Drawn(*FindDomain(domain), info, i)) ? 1 : 0;
  return cases;
}

std::size_t CoveredOnce(const CoverageCounts& counts) {
  std::size_t once = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) once += counts.Count(k) == 1 ? 1U : 0U;
  return once;
}

// Those whose triangles reach less far than these.
std::vector<std::string_view> WithoutFar(std::span<const std::string_view> domains) {
  std::vector<std::string_view> others;
  std::ranges::copy_if(domains, std::back_inserter(others), [&](std::string_view name) {
    return name != "covering-fans" && name != "every-size" && name != "far-sides" &&
           name != "far-corners" && name != "near-beside-far";
  });
  return others;
}

double TwiceTheArea(const Scene& scene, const Triangle& t) {
  const std::array<Vertex, 3> v = Corners(scene, t);
  return std::fabs((v[2].x - v[0].x) * (v[1].y - v[0].y) - (v[2].y - v[0].y) * (v[1].x - v[0].x));
}

// Cases of which a triangle like this covers a sample.
int CasesThatCover(const SubjectInfo& info, bool (*is_like)(const Scene&, const Triangle&)) {
  return CasesThat("off-grid-fragments", info, [&](const Case& c) {
    Case some = c;
    std::erase_if(some.scene.triangles, [&](const Triangle& t) { return !is_like(c.scene, t); });
    const CoverageCounts counts = exact::Coverage(some.scene, info.profile);
    return std::ranges::any_of(counts.front, [](std::uint32_t n) { return n != 0; }) ||
           std::ranges::any_of(counts.back, [](std::uint32_t n) { return n != 0; });
  });
}

TEST(OffGridFragments, AreOfCornersBetweenGridPointsSmallAreasAndMoreThanSixteenVertices) {
  const auto is_off_the_grid = [](const Scene& scene, const Triangle& t) {
    return std::ranges::all_of(Corners(scene, t), [](const Vertex& v) {
      return std::floor(v.x * 256) != v.x * 256 && std::floor(v.y * 256) != v.y * 256;
    });
  };
  const auto is_small = [](const Scene& scene, const Triangle& t) {
    return TwiceTheArea(scene, t) < 1.0 / 64;
  };
  const auto is_late = [](const Scene&, const Triangle& t) { return std::ranges::max(t) >= 16; };
  EXPECT_GT(CasesThatCover(SnappedInfo(8), is_off_the_grid), 100);
  EXPECT_GT(CasesThatCover(SnappedInfo(8), is_small), 20);
  EXPECT_GT(CasesThatCover(SnappedInfo(8), is_late), 80);
}

TEST(RangeEnds, SpansTheStatedRangeFromEndToEnd) {
  const SubjectInfo info = SnappedInfo(8);
  const double limit = info.profile.coordinate_limit;
  EXPECT_GE(CasesThat("range-ends", info,
                      [&](const Case& c) {
                        const auto [left, right] =
                            std::ranges::minmax(c.scene.vertices, {}, &Vertex::x);
                        return right.x - left.x > 1.99 * limit;
                      }),
            50);
}

// Twice the area of the scene's first triangle.
double Area(const Scene& scene) {
  const std::array<Vertex, 3> v = Corners(scene, scene.triangles[0]);
  return std::fabs((v[1].x - v[0].x) * (v[2].y - v[0].y) - (v[2].x - v[0].x) * (v[1].y - v[0].y));
}

TEST(LeastAreas, AreSliversLongerThan64PixelsOfLessThanAPixel) {
  EXPECT_GE(CasesThat("least-areas", SnappedInfo(8),
                      [](const Case& c) {
                        const auto [left, right] =
                            std::ranges::minmax(c.scene.vertices, {}, &Vertex::x);
                        const double area = Area(c.scene);
                        return right.x - left.x > 64 && area > 0 && area < 1;
                      }),
            20);
}

TEST(RowsAndColumns, HoldEdgesLongerThan1024PixelsAlongARowThatSharesItsSamples) {
  const auto is_long_row = [](const Vertex& a, const Vertex& b) {
    return a.y == b.y && std::fabs(a.x - b.x) > 1024 && a.y - std::floor(a.y) == 0.5;
  };
  EXPECT_GE(CasesThat("rows-and-columns", SnappedInfo(8),
                      [&](const Case& c) {
                        return std::ranges::any_of(c.scene.triangles, [&](const Triangle& t) {
                          const std::array<Vertex, 3> v = Corners(c.scene, t);
                          return is_long_row(v[0], v[1]) || is_long_row(v[1], v[2]) ||
                                 is_long_row(v[2], v[0]);
                        });
                      }),
            20);
}

TEST(FarNegativeCorners, ReachTheTargetFromFarToTheLeftAndFarAbove) {
  const SubjectInfo info = SnappedInfo(8);
  const double far = -info.profile.coordinate_limit / 8;
  EXPECT_GE(CasesThat("far-negative-corners", info,
                      [&](const Case& c) {
                        const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
                        return std::ranges::min(c.scene.vertices, {}, &Vertex::x).x < far &&
                               std::ranges::min(c.scene.vertices, {}, &Vertex::y).y < far &&
                               CoveredOnce(counts) != 0;
                      }),
            30);
}

TEST(CoveringFans, CoverEverySampleOnceFromFarAway) {
  for (const SubjectInfo& info : {RealInfo(), SnappedInfo(8), SnappedInfo(4)}) {
    const double far = std::min(info.profile.coordinate_limit, 0x1p17) / 8;
    const auto covers = [](const Case& c) {
      const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
      return CoveredOnce(counts) == counts.size();
    };
    const auto comes_from_far = [&](const Case& c) {
      return std::ranges::any_of(c.scene.vertices,
                                 [&](const Vertex& v) { return v.x < -far && v.y < -far; });
    };
    EXPECT_EQ(CasesThat("covering-fans", info, covers), 200);
    EXPECT_GE(CasesThat("covering-fans", info, comes_from_far), 20);
  }
}

TEST(NearRepeats, AgreeWithTheTriangleBeforeInAllButACoordinate) {
  const auto agree = [](const Case& c) {
    const Scene& scene = c.scene;
    for (std::size_t t = 1; t < scene.triangles.size(); ++t) {
      const std::array<Vertex, 3> a = Corners(scene, scene.triangles[t - 1]);
      const std::array<Vertex, 3> b = Corners(scene, scene.triangles[t]);
      int equal = 0;
      for (std::size_t k = 0; k < 3; ++k) {
        equal += (a[k].x == b[k].x ? 1 : 0) + (a[k].y == b[k].y ? 1 : 0);
      }
      if (equal == 5) return true;
    }
    return false;
  };
  EXPECT_GE(CasesThat("near-repeats", SnappedInfo(8), agree), 100);
  EXPECT_LE(CasesThat("vertex-orders", SnappedInfo(8), agree), 20);
}

// The next triangle after one that reaches far shares two of its corners, in order.
TEST(NearRepeats, GoOnFromTrianglesThatMayBeDropped) {
  const auto goes_on = [](const Case& c) {
    const Scene& scene = c.scene;
    for (std::size_t t = 1; t < scene.triangles.size(); ++t) {
      const Triangle& last = scene.triangles[t - 1];
      const auto [left, right] = std::ranges::minmax(Corners(scene, last), {}, &Vertex::x);
      const bool shares = scene.triangles[t][0] == last[1] && scene.triangles[t][1] == last[2];
      if (shares && right.x - left.x > 1024) return true;
    }
    return false;
  };
  EXPECT_GE(CasesThat("near-repeats", SnappedInfo(8), goes_on), 5);
}

TEST(SparseIndices, AgreeInTheirLowerBits) {
  const auto agree = [](const Case& c) {
    const auto byte = [](std::int32_t index) { return index % 256; };
    for (std::size_t t = 1; t < c.scene.triangles.size(); ++t) {
      Triangle a = c.scene.triangles[t - 1];
      Triangle b = c.scene.triangles[t];
      if (std::ranges::max(a) == std::ranges::max(b)) continue;
      std::ranges::sort(a, {}, byte);
      std::ranges::sort(b, {}, byte);
      if (std::ranges::equal(a, b, {}, byte, byte)) return true;
    }
    return false;
  };
  EXPECT_GE(CasesThat("sparse-indices", SnappedInfo(8), agree), 60);
}

// What llvmpipe 22.3 does to some of them (docs/findings.md).
TEST(CoveringFans, ShowTheLossOfTrianglesThatReachFar) {
  FakeSubject subject = LosesLarge(SnappedInfo(8), 4096);
  for (const std::string_view name :
       {"EmbeddedMeshSamplesAreCoveredOnce", "SharedEdgeSamplesAreCoveredOnce",
        "NeighboursAreClippedAlike"}) {
    Property property = *FindProperty(name);
    EXPECT_EQ(RunCampaign(subject, property, {.cases = 200, .progress = {}}).outcome,
              Outcome::kViolated)
        << name;
    const std::vector<std::string_view> others = WithoutFar(property.domains);
    property.domains = others;
    EXPECT_EQ(RunCampaign(subject, property, {.cases = 200, .progress = {}}).outcome,
              Outcome::kHolds)
        << name;
  }
}

TEST(DecidingSnapTies, ChangeWhatIsCoveredWithTheRuleOfTheSnap) {
  const SubjectInfo info = SnappedInfo(8);
  const auto decided_by = [&](SnapRule rule) {
    return CasesThat("deciding-snap-ties", info, [&](const Case& c) {
      Profile other = c.profile;
      other.snap.rule = rule;
      return exact::Coverage(c.scene, c.profile) != exact::Coverage(c.scene, other);
    });
  };
  EXPECT_GE(decided_by(SnapRule::kNearestAway), 8);
  EXPECT_GE(decided_by(SnapRule::kHalfUp), 8);
  EXPECT_GE(decided_by(SnapRule::kFloor), 50);
}

TEST(FullCoverage, CoverThreeQuartersOfManySamplesSeveralTimes) {
  EXPECT_GE(CasesThat("full-coverage", RealInfo(),
                      [](const Case& c) {
                        const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
                        std::uint64_t covered = 0;
                        for (std::size_t k = 0; k < counts.size(); ++k) covered += counts.Count(k);
                        return counts.size() >= (1 << 14) && covered >= 2 * counts.size();
                      }),
            150);
}

// The direct form in double: on float32 input its sign is wrong and not zero only if differences
// round.
bool MisleadsDoubles(const Case& c, const Triangle& t) {
  const std::array<Vertex, 3> v = Corners(c.scene, t);
  for (int row = 0; row < c.scene.height; ++row) {
    for (int x = 0; x < c.scene.width; ++x) {
      const Point2 p{x + 0.5, row + 0.5};
      const double e = (p.x - v[0].x) * (v[1].y - v[0].y) - (p.y - v[0].y) * (v[1].x - v[0].x);
      const int sign = exact::EdgeSign(WindowPoint(v[0]), WindowPoint(v[1]), p);
      if (e != 0 && (e > 0 ? 1 : -1) != sign) return true;
    }
  }
  return false;
}

TEST(RoundedDifferences, RoundTheDifferencesThatDecideTheSign) {
  const auto misleads = [](const Case& c) {
    return std::ranges::any_of(c.scene.triangles,
                               [&](const Triangle& t) { return MisleadsDoubles(c, t); });
  };
  EXPECT_GE(CasesThat("rounded-differences", RealInfo(), misleads), 3);
  EXPECT_EQ(CasesThat("uniform-subpixel", RealInfo(), misleads), 0);
}

TEST(SubPixelTriangles, KeepsWithinAPixelAndCoversSamples) {
  const auto is_small = [](const Case& c) {
    const auto [left, right] = std::ranges::minmax(c.scene.vertices, {}, &Vertex::x);
    return c.scene.triangles.size() > 1 || right.x - left.x < 1;
  };
  const auto covers = [](const Case& c) {
    const CoverageCounts counts = exact::Coverage(c.scene, c.profile);
    return std::ranges::any_of(counts.front, [](auto n) { return n != 0; });
  };
  for (const SubjectInfo& info : {RealInfo(), SnappedInfo(8)}) {
    EXPECT_EQ(CasesThat("sub-pixel-triangles", info, is_small), 200);
    EXPECT_GE(CasesThat("sub-pixel-triangles", info, covers), 40);
  }
}

}  // namespace
}  // namespace rasterproof::props
